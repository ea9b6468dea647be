/**
 * @class   vtkVesicleSceneAlgorithm
 * @brief   what surrounds a vesicle and what its membrane is made of, as properties
 *
 * The superclass of the classes that solve for a vesicle's motion. Any consistent set of units does
 * (all numbers 1: dimensionless; or metre, joule, pascal second): with lengths in m, energies in J
 * and viscosity in Pa s, rates are in 1/s, velocities in m/s, tensions in N/m and force densities
 * in N/m².
 *
 * The membrane has the energy E = (EB/2) ∮ (2H)² dS and, while Incompressible is on, a tension that
 * keeps every patch's area. The fluid is the same inside and outside.
 */

#ifndef vtkVesicleSceneAlgorithm_h
#define vtkVesicleSceneAlgorithm_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#ifndef __VTK_WRAP__
#include <memory>

namespace vesicle
{
struct ImposedFlow;
struct Scene;
}
#endif

class VESICLEFILTERS_EXPORT vtkVesicleSceneAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkVesicleSceneAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FlowKinds
  {
    AtRest,
    Uniform,               ///< u = velocity
    Shear,                 ///< u = rate z e_x
    PlanarExtension,       ///< u = rate (x e_x − z e_z)
    AxisymmetricExtension, ///< u = rate (z e_z − x/2 e_x − y/2 e_y)
    Poiseuille,            ///< u = velocity (1 − d²/radius²), d the distance to the tube's axis
    Rotation,              ///< u = rate axis × x
    FourRollMill,          ///< the plane flow of type α between extension and rotation
    VelocityField          ///< u of FlowFile
  };

  enum ElasticLaws
  {
    NeoHookean = 0,
    Skalak
  };

  enum References
  {
    StartReference = 0,
    SphereReference,
    FileReference
  };

  enum Presets
  {
    Paper,    ///< flat elements, forces as the paper prints them (misprints corrected)
    Fast,     ///< flat elements, forces in weak form
    Balanced, ///< Loop's limit surface
    Accurate  ///< the same with a finer quadrature
  };

  ///@{
  /**
   * EB, an energy, 0 or more; 0: no bending. Default: 1.
   */
  vtkSetClampMacro(BendingRigidity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BendingRigidity, double);
  ///@}

  ///@{
  /**
   * c0 of the bending energy (EB/2) times the integral of (2H - c0)^2, one over a length. Default: 0.
   */
  vtkSetMacro(SpontaneousCurvature, double);
  vtkGetMacro(SpontaneousCurvature, double);
  ///@}

  ///@{
  /**
   * Area-difference elasticity: alpha of the energy 8 pi^2 alpha EB (m - m0)^2, m the integral of H
   * over sqrt(4 pi A), 1 on a sphere. Default: 0, none.
   */
  vtkSetClampMacro(AreaDifferenceStiffness, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(AreaDifferenceStiffness, double);
  ///@}

  ///@{
  /**
   * m0 of that energy. Default: 1.
   */
  vtkSetMacro(AreaDifference, double);
  vtkGetMacro(AreaDifference, double);
  ///@}

  ///@{
  /**
   * Whether the membrane's area is kept everywhere by a tension. Default: on.
   */
  vtkSetMacro(Incompressible, bool);
  vtkGetMacro(Incompressible, bool);
  vtkBooleanMacro(Incompressible, bool);
  ///@}

  ///@{
  /**
   * G of an elastic sheet, a force a length, 0 or more; 0: a fluid membrane. Above 0 with the presets
   * balanced and accurate only, and points then stay with the material. Default: 0.
   */
  vtkSetMacro(ShearModulus, double);
  vtkGetMacro(ShearModulus, double);
  ///@}

  ///@{
  /**
   * The law of the sheet, one of ElasticLaws: NeoHookean or Skalak. Default: NeoHookean.
   */
  vtkSetClampMacro(Elasticity, int, NeoHookean, Skalak);
  vtkGetMacro(Elasticity, int);
  ///@}

  ///@{
  /**
   * C of Skalak's law, in ShearModulus, above 0. Default: 1.
   */
  vtkSetMacro(DilationModulus, double);
  vtkGetMacro(DilationModulus, double);
  ///@}

  ///@{
  /**
   * The sheet's shape without stress, one of References: the input's own (StartReference), a sphere
   * on which each of its patches has its area (SphereReference), or that of ReferenceFile. Default:
   * StartReference.
   */
  vtkSetClampMacro(Reference, int, StartReference, FileReference);
  vtkGetMacro(Reference, int);
  ///@}

  ///@{
  /**
   * The mesh of FileReference, with the points and triangles of the input, or of each of its vesicles, in
   * their order. Default: none.
   */
  vtkSetFilePathMacro(ReferenceFile);
  vtkGetFilePathMacro(ReferenceFile);
  ///@}

  ///@{
  /**
   * Lengths of the input over those without stress, beside what the reference differs by, above 0.
   * Default: 1.
   */
  vtkSetMacro(Prestretch, double);
  vtkGetMacro(Prestretch, double);
  ///@}

  ///@{
  /**
   * η of the membrane's resistance to shear within itself, a viscosity times a length, 0 or more; above 0
   * with the presets balanced and accurate only. Default: 0.
   */
  vtkSetMacro(SurfaceViscosity, double);
  vtkGetMacro(SurfaceViscosity, double);
  ///@}

  ///@{
  /**
   * μ of the fluid outside, a pressure times a time, above 0. Default: 1.
   */
  vtkSetMacro(Viscosity, double);
  vtkGetMacro(Viscosity, double);
  ///@}

  ///@{
  /**
   * λ, the viscosity of the fluid inside over that outside, 0 or more; other than 1 with the presets
   * balanced and accurate only. Default: 1.
   */
  vtkSetMacro(ViscosityRatio, double);
  vtkGetMacro(ViscosityRatio, double);
  ///@}

  ///@{
  /**
   * Whether there is a wall, a plane at which the fluid sticks and the flow is zero, with the presets
   * balanced and accurate only. Default: off.
   */
  vtkSetMacro(Wall, bool);
  vtkGetMacro(Wall, bool);
  vtkBooleanMacro(Wall, bool);
  ///@}

  ///@{
  /**
   * A point of the wall. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(WallPoint, double);
  vtkGetVector3Macro(WallPoint, double);
  ///@}

  ///@{
  /**
   * The wall's normal, into the fluid, of any length but 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(WallNormal, double);
  vtkGetVector3Macro(WallNormal, double);
  ///@}

  ///@{
  /**
   * The flow far away, one of FlowKinds. Default: AtRest.
   */
  vtkSetClampMacro(FlowKind, int, AtRest, VelocityField);
  vtkGetMacro(FlowKind, int);
  ///@}

  ///@{
  /**
   * Rate of Shear, extensions, Rotation and FourRollMill, 1 over a time, of any sign. Default: 1.
   */
  vtkSetMacro(FlowRate, double);
  vtkGetMacro(FlowRate, double);
  ///@}

  ///@{
  /**
   * Velocity of the Uniform flow, and of Poiseuille's on the tube's axis, whose direction it gives.
   * Default: (1, 0, 0).
   */
  vtkSetVector3Macro(FlowVelocity, double);
  vtkGetVector3Macro(FlowVelocity, double);
  ///@}

  ///@{
  /**
   * Radius of Poiseuille's tube, a length, above 0. (The profile alone: there is no wall.)
   * Default: 5.
   */
  vtkSetMacro(FlowRadius, double);
  vtkGetMacro(FlowRadius, double);
  ///@}

  ///@{
  /**
   * A point on the axis of Poiseuille's tube. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(FlowCenter, double);
  vtkGetVector3Macro(FlowCenter, double);
  ///@}

  ///@{
  /**
   * The axis of Rotation, through the origin, of any length but 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(FlowAxis, double);
  vtkGetVector3Macro(FlowAxis, double);
  ///@}

  ///@{
  /**
   * α of FourRollMill: 1 planar extension, 0 shear along x = −z, −1 rotation. Default: 1.
   */
  vtkSetMacro(FlowType, double);
  vtkGetMacro(FlowType, double);
  ///@}

  ///@{
  /**
   * The file of VelocityField: points with vectors, .vti .vtr .vts .vtu .vtk, or a .pvd or .series of them, whose
   * times are those of the run. Default: none.
   */
  vtkSetFilePathMacro(FlowFile);
  vtkGetFilePathMacro(FlowFile);
  ///@}

  ///@{
  /**
   * Gravity as Bo = Δρ g r0⁴/EB, no unit; above 0 the vesicle rises along +z. It takes bending. 0:
   * see DensityDifference. Default: 0.
   */
  vtkSetMacro(BondNumber, double);
  vtkGetMacro(BondNumber, double);
  ///@}

  ///@{
  /**
   * Gravity by the density of the fluid outside less that inside, a mass a volume; with
   * Acceleration it makes the load, their product times z n, a force an area. Not used if there is
   * a BondNumber. Default: 0.
   */
  vtkSetMacro(DensityDifference, double);
  vtkGetMacro(DensityDifference, double);
  ///@}

  ///@{
  /**
   * Acceleration of gravity, along −z, for DensityDifference. Default: 1.
   */
  vtkSetMacro(Acceleration, double);
  vtkGetMacro(Acceleration, double);
  ///@}

  ///@{
  /**
   * The velocity of the fluid as it is without a vesicle, at port 1: an image or a grid whose points (or cells)
   * have it as their active vectors, or as their only array of three components. Data, or the output of
   * another algorithm at its first time; with FlowKind AtRest, and a scene without a flow. Default: none.
   */
  void SetVelocityFieldData(vtkDataObject* field);
  void SetVelocityFieldConnection(vtkAlgorithmOutput* output);
  vtkDataObject* GetVelocityField();
  ///@}

  ///@{
  /**
   * How surface and forces are discretised, one of Presets. Loop's surface (Balanced, Accurate)
   * wants a mesh with smoothly spaced points and tells by a warning if it hasn't got one; Fast
   * takes any. Default: Balanced.
   */
  vtkSetClampMacro(Preset, int, Paper, Accurate);
  vtkGetMacro(Preset, int);
  ///@}

protected:
  vtkVesicleSceneAlgorithm();
  ~vtkVesicleSceneAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

#ifndef __VTK_WRAP__
  /// A scene of these properties. Throws vesicle::InputError.
  vesicle::Scene MakeScene();
#endif

  double BendingRigidity = 1;
  double SpontaneousCurvature = 0;
  double AreaDifferenceStiffness = 0;
  double AreaDifference = 1;
  bool Incompressible = true;
  double ShearModulus = 0;
  int Elasticity = NeoHookean;
  double DilationModulus = 1;
  int Reference = StartReference;
  char* ReferenceFile = nullptr;
  double Prestretch = 1;
  double SurfaceViscosity = 0;
  double Viscosity = 1;
  double ViscosityRatio = 1;
  bool Wall = false;
  double WallPoint[3] = { 0, 0, 0 };
  double WallNormal[3] = { 0, 0, 1 };
  int FlowKind = AtRest;
  double FlowRate = 1;
  double FlowVelocity[3] = { 1, 0, 0 };
  double FlowRadius = 5;
  double FlowCenter[3] = { 0, 0, 0 };
  double FlowAxis[3] = { 0, 0, 1 };
  double FlowType = 1;
  char* FlowFile = nullptr;
  double BondNumber = 0;
  double DensityDifference = 0;
  double Acceleration = 1;
  int Preset = Balanced;

private:
#ifndef __VTK_WRAP__
  std::shared_ptr<const vesicle::ImposedFlow> MakeFlow();
  void MakeElastic(vesicle::Scene& scene) const;
#endif

  vtkVesicleSceneAlgorithm(const vtkVesicleSceneAlgorithm&) = delete;
  void operator=(const vtkVesicleSceneAlgorithm&) = delete;
};

#endif
