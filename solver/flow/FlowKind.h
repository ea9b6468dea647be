#pragma once
// What a kind of flow says of itself, once: scenes, data sets and documentation follow from it.

#include "solver/flow/ImposedFlow.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace vesicle
{

/// What a parameter measures, which gives its unit.
enum class Dimension
{
  rate,     ///< 1 over a time
  velocity, ///< a length over a time
  length,
  direction, ///< no unit; of length 1
  number,    ///< no unit
  file       ///< no number but the absolute path of a file
};

struct FlowParameter
{
  std::string name; ///< the key in scenes: "rate"
  Dimension dimension;
  std::variant<double ImposedFlow::*, Vector3 ImposedFlow::*, std::string ImposedFlow::*> member;
  std::string help;
  bool required = true;  ///< false: a scene may leave it out, for what `make` gives
  bool positive = false; ///< a number above 0
  std::string missing{}; ///< what to say is wanted where it is missing; empty: what its type says
};

/// A parameter that is the member of a kind's own class.
template<class Flow, class Value>
FlowParameter flow_parameter(
  const std::string& name, Dimension dimension, Value Flow::*member, const std::string& help)
{
  return { name, dimension, static_cast<Value ImposedFlow::*>(member), help };
}

struct FlowKind
{
  std::string name;    ///< the scene's word: "shear"
  std::string type;    ///< a second word where kinds share the first ("planar"); otherwise empty
  std::string axes;    ///< what tells the type from the others: "x, −z"
  std::string title;   ///< for people: "planar extension"
  std::string formula; ///< in terms of the parameters: "u = rate z e_x"
  std::vector<FlowParameter> parameters;
  std::unique_ptr<ImposedFlow> (*make)(); ///< a flow with every parameter at its default
};

/// Whether flows of the kind are read from a file, and are known only then.
bool is_from_file(const FlowKind& kind);

/// A kind's `make`.
template<class Flow>
std::unique_ptr<ImposedFlow> make_flow()
{
  return std::make_unique<Flow>();
}

}
