#include "apps/tradeoff/ParetoFront.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle::tradeoff
{

std::vector<std::size_t> pareto_front(const std::vector<Choice>& choices)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (std::isfinite(choices[i].cost) && std::isfinite(choices[i].error))
      order.push_back(i);
  std::ranges::stable_sort(order,
    [&](std::size_t i, std::size_t j)
    {
      const Choice &a = choices[i], &b = choices[j];
      return a.cost < b.cost || (a.cost == b.cost && a.error < b.error);
    });
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (choices[i].error < least)
    {
      least = choices[i].error;
      front.push_back(i);
    }
  return front;
}

}
