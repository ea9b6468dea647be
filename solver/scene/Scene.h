#pragma once
// What to model. Plain data in the units of the scene (dimensionless or SI alike); see
// data/scenes/ for examples and SceneFile.h for the TOML format.

#include "solver/dynamics/Method.h"
#include "solver/flow/FlowHistory.h"
#include "solver/flow/ImposedFlow.h"
#include "solver/membrane/BendingScheme.h"
#include "solver/membrane/ElasticLaw.h"
#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/stokes/Wall.h"
#include "solver/surface/SurfaceBasis.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// What the numbers of a scene are in.
enum class Units
{
  any, ///< one system of units, which the scene doesn't name
  si
};

struct Scene
{
  std::string name = "vesicle";
  std::filesystem::path file; ///< where it was read from; empty: made in memory
  Units units = Units::any;   ///< of all numbers below

  struct Vesicle
  {
    ShapeRequest shape;                             ///< unless mesh_file is given
    std::optional<std::filesystem::path> mesh_file; ///< absolute; instead of shape
    std::optional<double> mesh_merge;  ///< points of a mesh file nearer than this become one
    std::optional<double> mesh_radius; ///< rescales a mesh file to this r0; empty: taken as it is
    std::optional<int> mesh_triangles; ///< resamples a mesh file; empty: taken as it is
    double radius = 1;                 ///< r0 = (3V/4π)^{1/3} of a shape
    Vector3 axis{ 0, 0, 1 };           ///< unit, where the shape's own z axis points to
    /// Unit axis x, y, z and angle in degrees; instead of `axis`, or to turn a mesh file.
    std::optional<std::array<double, 4>> rotation;
    Vector3 center{ 0, 0, 0 };          ///< the volume's centroid at the start (shapes only)
    std::optional<Vector3> mesh_center; ///< that of a mesh file; empty: where it is
  } vesicle;

  struct Membrane
  {
    std::optional<double> bending_rigidity;          ///< EB; empty: no bending
    double spontaneous_curvature = 0;                ///< c0 of E = (EB/2) ∮ (2H − c0)² dS
    std::optional<double> area_difference_stiffness; ///< α, in EB; empty: no such elasticity
    double area_difference = 1;                      ///< m0 of ∮ H dS/√(4πA), 1 on a sphere
    bool incompressible = true;                      ///< false: no tension
    std::optional<double> shear_modulus;             ///< G; empty: a fluid
    ElasticLaw elasticity = ElasticLaw::neo_hookean; ///< of G
    double dilation_modulus = 1;                     ///< C of Skalak's law, over G
    /// The shape without stress of an elastic sheet, before its lengths are divided by `prestretch`.
    enum class Reference
    {
      start,  ///< the start's own
      sphere, ///< a sphere on which each patch of the start has its area
      file
    };
    Reference reference = Reference::start;
    std::optional<std::filesystem::path> reference_file; ///< absolute; with Reference::file
    double prestretch = 1;        ///< lengths of the start over those without stress
    double surface_viscosity = 0; ///< η of a fluid membrane, a viscosity times a length; 0: none
  } membrane;

  struct Fluid
  {
    double viscosity = 1;        ///< μ of the fluid outside
    double viscosity_ratio = 1;  ///< λ, inside to outside
    double temperature = 298.15; ///< K; only of kT, where a scene has units
  } fluid;

  std::shared_ptr<const ImposedFlow> flow; ///< empty: fluid at rest
  FlowHistory flow_history;                ///< of its strength

  std::optional<Wall> wall; ///< empty: unbounded

  struct Gravity
  {
    std::optional<double> bond_number; ///< Bo = Δρ g r0⁴ / EB
    double density_difference = 0; ///< Δρ (outside − inside: > 0 rises), with `acceleration`
    double acceleration = 0;       ///< g
  };
  std::optional<Gravity> gravity; ///< empty: no buoyancy

  /// Between vesicles, beside what the fluid does.
  struct Interaction
  {
    double repulsion = 0; ///< ε, an energy an area, above 0
    double range = 0;     ///< δ, a length, above 0
  };
  std::optional<Interaction> interaction; ///< empty: none

  /// A vesicle beside the first one, with what of it may be another's.
  struct Companion
  {
    Vesicle vesicle;
    Membrane membrane;
    double viscosity_ratio = 1;
    std::optional<Gravity> gravity;
  };
  /// The second vesicle and so on; all that stands above is the first one's.
  std::vector<Companion> companions;

  std::size_t vesicles() const { return 1 + companions.size(); }
  /// Some membrane has a viscosity, or some fluid inside another than that outside: where the power goes
  /// is told of each.
  bool splits_power() const;
  /// The first one as one beside others. A load of nothing is none there.
  Companion companion() const;
  /// The same scene with one of its vesicles, by its number from 0, and no other.
  Scene alone(std::size_t vesicle) const;

  struct Time
  {
    std::optional<double> end;  ///< empty: until steady
    bool equilibrium = false;   ///< no run at all: the shape at rest, without a fluid
    double output_every = 0;    ///< hit exactly; 0 (not in files): only start and end
    std::optional<double> step; ///< empty: adaptive
    double tolerance = 1e-3;    ///< position error a step, in r0
  } time;

  enum class Preset
  {
    paper,
    fast,
    balanced,
    accurate
  };
  using Basis = SurfaceBasis;
  using Bending = BendingScheme;
  using Integrator = vesicle::Integrator;
  using LayerMethod = vesicle::LayerMethod;
  using LayerPrecision = vesicle::LayerPrecision;
  enum class MeshMotion
  {
    equidistribute, ///< vertices spread by the membrane's curvature
    adaptive,       ///< the same, and laid anew where they no longer hold the shape
    material        ///< with the lipids
  };
  using Scheme = vesicle::Scheme;
  struct Accuracy
  {
    Preset preset = Preset::balanced;
    Scheme scheme = Scheme::robust; ///< follows from the preset
    Basis basis = Basis::loop;
    Bending bending = Bending::variational;
    Integrator integrator = Integrator::imex_midpoint;
    MeshMotion mesh_motion = MeshMotion::equidistribute;
    /// Of meshes that are laid anew; empty: the start's, and four times as many.
    std::optional<int> least_triangles, most_triangles;
    int quadrature = 3; ///< points a triangle of the regular rule: 1, 3, 6 or 12
    LayerMethod layer = LayerMethod::automatic; ///< key "operator"
    LayerPrecision precision = LayerPrecision::mixed;
    double tree_tolerance = LayerSettings{}.tree_tolerance;
    /// Relative residual of the linear solves; on Loop's surface a ten-thousandth of time.tolerance,
    /// about: a step moves by a few hundredths of r0.
    double linear_tolerance = 1e-7;
  } accuracy;
  /// The settings that a preset stands for.
  static Accuracy preset(Preset preset);
  /// The bending scheme that goes with a basis.
  static Bending bending_of(Basis basis);
  /// The time.tolerance of a preset, for scenes that don't give one.
  static double preset_tolerance(Preset preset);

  struct Movie
  {
    std::string color = "Mean_Curvature";
    std::optional<std::array<double, 2>> range; ///< empty: of the whole series
    std::array<int, 2> size{ 1280, 720 };
    std::string view = "auto";     ///< one of view_names: auto, front, side, top, iso, …
    std::string camera = "follow"; ///< follow (the vesicle's centroid) or fixed
    bool smooth = false;           ///< Loop's limit surface through the points, for display
    bool arrows = false;           ///< the flow of lipids along the membrane
    bool flow_lines = false;       ///< the flow of the fluid, in the plane through the middle
    int markers = 0;               ///< dots on each vesicle that the membrane carries along
    bool edges = false;            ///< mesh edges
    std::string chart = "none";    ///< at the side: none, or one of chart_names against time
  } movie;

  struct Output
  {
    std::vector<std::string> fields; ///< point arrays to write; empty: all
    std::optional<std::filesystem::path> directory;
  } output;
};

/// The flow with its history, in the scene's units; empty: at rest.
std::shared_ptr<const ImposedFlow> imposed_flow(const Scene& scene);

}
