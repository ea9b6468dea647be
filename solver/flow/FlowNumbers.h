#pragma once
// A flow as plain numbers, as data sets hold it, and back.

#include "solver/flow/ImposedFlow.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vesicle
{

/// The name of a parameter, and one number or the three of a vector.
struct FlowNumbers
{
  std::string name;
  std::vector<double> values;
};

/// The parameters of a flow, in the order of its kind; but a speed along an axis is one vector,
/// `velocity`, and the axis isn't among them; nor are names of files.
std::vector<FlowNumbers> numbers_of(const ImposedFlow& flow);

/// The flow of a kind's number (0, at rest: none) from what `read` puts into the values of each
/// name. Directions are brought to length 1; throws InputError for one that is zero. The number
/// must be one that there is.
std::shared_ptr<const ImposedFlow> flow_of(
  int kind, const std::function<void(const std::string& name, std::span<double> values)>& read);

}
