// Prints docs/scenes-reference.md.

#include "solver/scene/SceneReference.h"

#include <iostream>

int main()
{
  std::cout << vesicle::scene_reference();
}
