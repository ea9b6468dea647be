#pragma once
// Ctrl-C: finish what is being done, save everything, then end.

namespace vesicle
{

/// From now on the first SIGINT or SIGTERM only sets a flag; the second one ends the program.
void watch_for_interrupts();
bool interrupted();

}
