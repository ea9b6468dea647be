#pragma once
// Which of several choices nothing beats in both cost and error.

#include <cstddef>
#include <vector>

namespace vesicle::tradeoff
{

struct Choice
{
  double cost, error;
};

/// Indices of the choices than which none costs at most as much and errs less, or costs less and errs at
/// most as much; the cheapest first. Of equals the first. Choices that aren't finite never count.
std::vector<std::size_t> pareto_front(const std::vector<Choice>& choices);

}
