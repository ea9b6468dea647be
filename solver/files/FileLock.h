#pragma once
// Keeps two programs from writing to the same folder.

#include <filesystem>
#include <string>

namespace vesicle
{

/// Holds a lock file from construction to destruction; it is removed in the end. The lock is the
/// system's (flock, which Linux makes a lock of the server on NFS): it goes with the program that
/// holds it, however that ends, and a file that was left behind locks nothing. Where a file system
/// knows no locks, the file itself is the lock: one of a program of this machine that has ended is
/// taken over, one of another machine has to be removed by hand.
class FileLock
{
public:
  /// Throws IoError naming the file: locked by another run, or it can't be written.
  explicit FileLock(std::filesystem::path file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

private:
  bool try_to_lock();
  void remove_leftover();
  void take_down_holder();
  void release();

  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// Who holds a lock, "process 12 on host"; empty where nobody does. Disturbs nobody: another
/// machine's program counts as holding a file that it left behind.
std::string lock_holder(const std::filesystem::path& file);

}
