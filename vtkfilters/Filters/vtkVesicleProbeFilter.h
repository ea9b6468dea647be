/**
 * @class   vtkVesicleProbeFilter
 * @brief   the velocity of the fluid at any points, inside and outside a vesicle
 *
 * Adds to the points of its input (port 0: an image, a line, the seeds of a tracer, any vtkDataSet)
 * the velocity of the fluid around and inside the vesicle of the source (port 1), as vtkProbeFilter
 * adds the values of its source. The source is a vtkPolyData or vtkUnstructuredGrid as
 * vtkVesicleStepper and vtkVesicleForceFilter make it and as `vesicle run` writes it to its frames:
 * nothing but a file of the series is needed. Through vtkStreamTracer, a probed image becomes
 * streamlines.
 *
 * The velocity is that of the imposed flow and the forces on the fluid, in the units of the source:
 * u(x) = u∞(x) + (1/8πμ) ∮ G(x, y) f(y) dS(y), the Stokes flow of the same viscosity on both sides.
 * With a viscosity ratio λ the double layer −(1 − λ) K u joins in, and inside λ u is the sum; with λ = 0
 * nothing is known of the fluid inside, whose velocity is given as 0.
 * It holds up to the membrane and on it: near the membrane the integral is computed by a quadrature
 * made for each point (relative error 1e-7 at any distance), and the error is that of the surface
 * and its forces: on a rigid sphere, anywhere, 6e-3 of its speed with 1,280 flat triangles and 1e-4
 * with as many of Loop's surface.
 *
 * Point arrays that are added: Velocity (3 components, the active vectors) and Inside (1 where the
 * vesicle encloses the point, 0 elsewhere; on the membrane either). All others pass through, but
 * for arrays of these names.
 *
 * Read from the source: the point arrays Membrane_Force (a force an area), Gravity_Force if there
 * is gravity, Velocity if Viscosity_Ratio isn't 1; the field data Viscosity, Viscosity_Ratio (1 if
 * there is none), Surface_Basis (0 linear, 1 Loop),
 * Flow_Kind (0 at rest, 1 uniform, 2 shear, 3 planar extension, 4 axisymmetric extension, 5
 * Poiseuille, 6 rotation) and, as the kind has them, Flow_Rate, Flow_Velocity, Flow_Radius,
 * Flow_Center, Flow_Axis. What is missing is an error that names it; a surface without them gets
 * them from vtkVesicleForceFilter.
 *
 * Time: TIME_STEPS and TIME_RANGE are the source's.
 *
 * Source: G. Boedec, M. Leonetti, M. Jaeger, 3D vesicle dynamics simulations with a linearly
 * triangulated surface, J. Comput. Phys. 230 (2011) 1020, equation (11).
 */

#ifndef vtkVesicleProbeFilter_h
#define vtkVesicleProbeFilter_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

class VESICLEFILTERS_EXPORT vtkVesicleProbeFilter : public vtkDataSetAlgorithm
{
public:
  static vtkVesicleProbeFilter* New();
  vtkTypeMacro(vtkVesicleProbeFilter, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The vesicle: data, or the output of another algorithm. Default: none; one is needed.
   */
  void SetSourceData(vtkDataObject* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkDataObject* GetSource();
  ///@}

protected:
  vtkVesicleProbeFilter();
  ~vtkVesicleProbeFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVesicleProbeFilter(const vtkVesicleProbeFilter&) = delete;
  void operator=(const vtkVesicleProbeFilter&) = delete;
};

#endif
