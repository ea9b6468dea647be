#pragma once
// The words that a scene uses for its choices, for reading and writing alike.

#include "solver/scene/Scene.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

template<class Choice>
struct NamedChoice
{
  std::string_view name;
  Choice choice;
};
template<class Choice>
NamedChoice(std::string_view, Choice) -> NamedChoice<Choice>; // clang 14 doesn't deduce it

inline constexpr std::array units_names{
  NamedChoice{ "any", Units::any },
  NamedChoice{ "SI", Units::si },
};

inline constexpr std::array preset_names{
  NamedChoice{ "paper", Scene::Preset::paper },
  NamedChoice{ "fast", Scene::Preset::fast },
  NamedChoice{ "balanced", Scene::Preset::balanced },
  NamedChoice{ "accurate", Scene::Preset::accurate },
};

inline constexpr std::array basis_names{
  NamedChoice{ "linear", Scene::Basis::linear },
  NamedChoice{ "loop", Scene::Basis::loop },
};

inline constexpr std::array bending_names{
  NamedChoice{ "cotan", Scene::Bending::cotan },
  NamedChoice{ "variational", Scene::Bending::variational },
};

inline constexpr std::array elasticity_names{
  NamedChoice{ "neo-hookean", ElasticLaw::neo_hookean },
  NamedChoice{ "skalak", ElasticLaw::skalak },
};

inline constexpr std::array integrator_names{
  NamedChoice{ "imex-midpoint", Scene::Integrator::imex_midpoint },
  NamedChoice{ "imex-euler", Scene::Integrator::imex_euler },
};

inline constexpr std::array layer_method_names{
  NamedChoice{ "auto", LayerMethod::automatic },
  NamedChoice{ "dense", LayerMethod::dense },
  NamedChoice{ "direct", LayerMethod::direct },
  NamedChoice{ "tree", LayerMethod::tree },
};
inline constexpr std::array layer_precision_names{
  NamedChoice{ "mixed", LayerPrecision::mixed },
  NamedChoice{ "double", LayerPrecision::full },
};
inline constexpr std::array mesh_motion_names{
  NamedChoice{ "equidistribute", Scene::MeshMotion::equidistribute },
  NamedChoice{ "adaptive", Scene::MeshMotion::adaptive },
  NamedChoice{ "material", Scene::MeshMotion::material },
};

inline constexpr std::array shape_kinds{
  ShapeRequest::Kind::sphere,
  ShapeRequest::Kind::prolate,
  ShapeRequest::Kind::oblate,
  ShapeRequest::Kind::ellipsoid,
  ShapeRequest::Kind::discocyte,
  ShapeRequest::Kind::perturbed,
  ShapeRequest::Kind::stomatocyte,
};

inline const std::vector<std::string> view_names{ "auto", "front", "side", "top", "iso", "xz", "yz",
  "xy", "x", "y", "z", "isometric" };

inline const std::vector<std::string> camera_names{ "follow", "fixed" };

inline const std::vector<std::string> chart_names{ "none", "energy", "inclination", "velocity",
  "tension" };

/// The point arrays that a run can write; the last one only and always where there are several
/// vesicles.
inline const std::vector<std::string> field_names{ "Mean_Curvature", "Gauss_Curvature",
  "Laplacian_Mean_Curvature", "Normals", "Bending_Force", "Area_Difference_Force", "Elastic_Force",
  "Viscous_Force", "Tension", "Tension_Force", "Membrane_Force", "Gravity_Force", "Velocity",
  "Surface_Divergence", "Repulsion_Force", "Vesicle_Id" };

template<class Choices, class Choice>
std::string name_of(const Choices& choices, Choice choice)
{
  const auto found = std::find_if(choices.begin(), choices.end(),
    [&](const auto& candidate) { return candidate.choice == choice; });
  return std::string(found->name);
}

}
