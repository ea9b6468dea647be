// Ends with a window alive that has just been asked to draw: `leave_window HOW`. A process that
// hangs is ended by SIGALRM.

#include "TestSurfaces.h"

#include "vtkRenderWindow.h"

#include <future>
#include <memory>
#include <thread>
#include <unistd.h>
#include <vector>

// What is leaked here is so on purpose.
extern "C" int __lsan_is_turned_off()
{
  return 1;
}

using namespace vesicle;
using namespace vesicle::test;

namespace
{

constexpr unsigned patience = 60; // seconds; a second or less is needed

std::vector<Picture*> leaked;             // seen by leak checkers
std::unique_ptr<Picture> an_early_static; // destroyed after what drawing registers for the exit

std::unique_ptr<Picture> drawn()
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  auto picture = std::make_unique<Picture>(settings);
  picture->draw(make_surface());
  return picture;
}

void leak()
{
  leaked.push_back(drawn().release());
}

void leave(const std::string& how)
{
  if (how == "leaked")
  {
    leak();
  }
  else if (how == "leaked-twice")
  {
    leak();
    leak();
    leaked.front()->draw(make_surface());
  }
  else if (how == "static")
  {
    static const auto picture = drawn();
  }
  else if (how == "early-static")
  {
    an_early_static = drawn();
  }
  else if (how == "released")
  {
    leak();
    leaked.front()->window()->ReleaseCurrent();
  }
  else if (how == "ended-thread")
  {
    std::thread(leak).join();
  }
  else if (how == "living-thread")
  {
    std::promise<void> done;
    std::thread(
      [&]
      {
        leak();
        done.set_value();
        pause(); // current here until the process ends
      })
      .detach();
    done.get_future().wait();
  }
  else
  {
    std::exit(2);
  }
}

}

int main(int count, char** arguments)
{
  alarm(patience);
  leave(count > 1 ? arguments[1] : "");
  return 0;
}
