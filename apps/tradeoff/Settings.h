#pragma once
// How a scene is computed: one point of the grid that a trade-off goes over.

#include "solver/scene/Scene.h"

#include <array>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

/// What decides a run's error in time.
struct TimeSetting
{
  bool fixed_step = false; ///< time.step instead of time.tolerance
  double value = 0;

  const char* key() const { return fixed_step ? "step" : "tolerance"; }
  bool operator==(const TimeSetting&) const = default;
};

struct Settings
{
  Scene::Preset preset = Scene::Preset::balanced;
  int triangles = 0;
  TimeSetting time;
  /// Of the table accuracy, beside what the preset stands for: "quadrature=6".
  std::string knob;

  /// Of its folder and in tables: balanced-320-0.001, with -quadrature-6 behind it.
  std::string label() const;
  std::string preset_name() const;
  std::array<std::string, 2> knob_halves() const; ///< key and value
  /// As of `vesicle run --set`.
  std::vector<std::string> overrides() const;
  /// As part of a scene; of several vesicles what each one's table takes is a remark.
  std::string toml(std::size_t vesicles) const;
  /// Whether another differs in nothing but triangles and time.
  bool same_method(const Settings& other) const
  {
    return preset == other.preset && knob == other.knob;
  }
};

}
