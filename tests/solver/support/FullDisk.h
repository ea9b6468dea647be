#pragma once

#include <csignal>

#include <sys/resource.h>

namespace vesicle::test
{

/// While in scope, no file may grow beyond a number of bytes: it stands for a full disk.
class FullDisk
{
public:
  explicit FullDisk(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{ bytes, before_.rlim_max };
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  rlimit before_{};
};

}
