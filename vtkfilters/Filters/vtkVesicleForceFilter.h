/**
 * @class   vtkVesicleForceFilter
 * @brief   forces, tension and velocity of a vesicle at this moment
 *
 * Solves for the instantaneous motion of a membrane of the input's shape in the flow and gravity of
 * the properties (see vtkVesicleSceneAlgorithm; any consistent units, lengths in the input's): no
 * time passes, and nothing depends on a time step.
 *
 * Input: a closed surface of genus 0, or several of them apart from each other, each a vesicle with the
 * same properties, as vtkPolyData, vtkUnstructuredGrid or blocks of them, which are joined: those of the point array Vesicle_Id, or what is connected. Polygons and strips are cut into triangles;
 * vertices, lines and points that no polygon uses are dropped; triangles that face inward are
 * turned, with a warning. What isn't such a surface (holes, handles, points that
 * should be one) is refused with an error that names the place and a remedy. All other arrays pass
 * through; empty input gives empty output. Where pieces are asked for, the first is the whole, others
 * are empty.
 *
 * Curvatures and bending force come from local fits (vtkVesicleCurvatureFilter's scheme Fit), which
 * converge on irregular meshes too; BendingForceToDynamics takes those of the Preset instead, as a
 * simulation would.
 *
 * The default Preset, Balanced, works on Loop's limit surface through the input's points, which
 * takes smoothly spaced points. Where the energies of that surface by two quadratures differ by
 * more than 1% the mesh is rough for it: the filter warns and goes on. Where bending drives the
 * motion, preset Fast is the more accurate one on such meshes: on r = 1 + 0.2 Y20 with points
 * shifted at random by a quarter of an edge the errors of the velocity are 71% and 18% with 320 and
 * 1,280 triangles (Balanced: 190% and 67%). In shear they are 1.3% and 0.23% (Balanced: 0.8% and
 * 0.2%; evenly spaced 0.04% and below 0.01%).
 *
 * Point arrays: Mean_Curvature (the active scalars), Gauss_Curvature, Laplacian_Mean_Curvature,
 * Normals n (outward), Bending_Force f_b = EB [2 Δ_s H + 4 H (H² − K)] n, Tension γ (above 0:
 * taut), Tension_Force f_γ = ∇_s γ − 2 γ H n, Membrane_Force (their sum), Gravity_Force, Velocity
 * (of membrane and fluid, u = u∞ + (1/8πμ) ∮ G (f_b + f_γ + f_g) dS; the active vectors) and
 * Surface_Divergence ∇_s·u. Forces are densities, a force an area, and what the membrane (gravity)
 * exerts on the fluid. Without bending there is no Bending_Force, without Incompressible no Tension
 * and Tension_Force, without gravity no Gravity_Force. The tension of a sphere is known but for a
 * constant; its mean is then 0.
 *
 * Field data: Area, Volume, Reduced_Volume, Bending_Energy, of several vesicles a tuple each (and the
 * point array Vesicle_Id), and what vtkVesicleProbeFilter needs to
 * find the velocity anywhere.
 *
 * Cost: a dense matrix between all points, 24 N² bytes for N points each of bending and tension.
 *
 * Source: G. Boedec, M. Leonetti, M. Jaeger, 3D vesicle dynamics simulations with a linearly
 * triangulated surface, J. Comput. Phys. 230 (2011) 1020, equations (6), (11), (36)–(39).
 */

#ifndef vtkVesicleForceFilter_h
#define vtkVesicleForceFilter_h

#include "vtkVesicleSceneAlgorithm.h"

class VESICLEFILTERS_EXPORT vtkVesicleForceFilter : public vtkVesicleSceneAlgorithm
{
public:
  static vtkVesicleForceFilter* New();
  vtkTypeMacro(vtkVesicleForceFilter, vtkVesicleSceneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BendingForces
  {
    Fitted,  ///< local fits: right at every point
    Dynamics ///< the Preset's: right on the average, with noise from point to point
  };

  ///@{
  /**
   * Where curvatures and bending force come from, one of BendingForces. Default: Fitted.
   */
  vtkSetClampMacro(BendingForce, int, Fitted, Dynamics);
  vtkGetMacro(BendingForce, int);
  void SetBendingForceToFitted() { this->SetBendingForce(Fitted); }
  void SetBendingForceToDynamics() { this->SetBendingForce(Dynamics); }
  ///@}

protected:
  vtkVesicleForceFilter() = default;
  ~vtkVesicleForceFilter() override = default;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int BendingForce = Fitted;

private:
  vtkVesicleForceFilter(const vtkVesicleForceFilter&) = delete;
  void operator=(const vtkVesicleForceFilter&) = delete;
};

#endif
