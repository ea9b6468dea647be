#include "apps/Interrupt.h"

#include <csignal>

namespace vesicle
{
namespace
{

volatile std::sig_atomic_t asked_to_stop = 0;

void note_signal(int)
{
  asked_to_stop = 1;
}

}

void watch_for_interrupts()
{
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted()
{
  return asked_to_stop != 0;
}

}
