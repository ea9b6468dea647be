/**
 * @class   vtkVesicleSource
 * @brief   closed triangle meshes of vesicles: spheres, ellipsoids, the red cell's disc
 *
 * vtkVesicleSource makes the start shapes of a simulation. Twelve vertices have five neighbours and
 * all others six: meshes are capped tubes of the hexagonal lattice, or geodesic spheres, relaxed on
 * the shape that is asked for. Sizes refer to the surface that the mesh stands for, by Basis Loop's
 * smooth surface through the points or the flat triangles: its volume is that of a sphere of radius
 * Radius, and its reduced volume v = 6 √π V / A^(3/2) is ReducedVolume to 1e-6. The output's field
 * data say so: Surface_Basis (0 flat triangles, 1 Loop) and Reduced_Volume. Triangles are
 * counter-clockwise seen from outside; points are in double precision. A warning says where the
 * triangles are too few for Loop's surface to hold the shape's bending energy to 1%, or can't be as
 * round as asked for.
 *
 * Shapes: Sphere; Prolate and Oblate, ellipsoids of revolution about the axis; Ellipsoid with
 * SemiAxes; Discocyte, the biconcave disc of Evans & Fung, Microvasc. Res. 4 (1972) 335; Perturbed,
 * a sphere with spherical harmonics added, r = Radius (1 + Σ amplitude Y_lm) with orthonormal real
 * Y_lm; Stomatocyte, a bowl with a narrow mouth.
 *
 * Reduced volume as in Boedec, Leonetti, Jaeger, J. Comput. Phys. 230 (2011) 1020, equation (43).
 */

#ifndef vtkVesicleSource_h
#define vtkVesicleSource_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#ifndef __VTK_WRAP__
#include <memory> // for the modes
#endif

class VESICLEFILTERS_EXPORT vtkVesicleSource : public vtkPolyDataAlgorithm
{
public:
  static vtkVesicleSource* New();
  vtkTypeMacro(vtkVesicleSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    Sphere,
    Prolate,
    Oblate,
    Ellipsoid,
    Discocyte,
    Perturbed,
    Stomatocyte
  };

  enum Bases
  {
    Linear, ///< the flat triangles
    Loop    ///< Loop's limit surface through the points
  };

  ///@{
  /**
   * The shape, one of Shapes or its name in lower case ("sphere", "prolate", …). An unknown name is
   * an error and changes nothing. Default: Sphere.
   */
  vtkSetClampMacro(Shape, int, Sphere, Stomatocyte);
  vtkGetMacro(Shape, int);
  void SetShapeByName(const char* name);
  const char* GetShapeName();
  ///@}

  ///@{
  /**
   * Reduced volume v of the surface, no unit, above 0 up to 1 (each shape has its own range, and an
   * error says which). 0: the shape's own. Default: 0.
   */
  vtkSetClampMacro(ReducedVolume, double, 0.0, 1.0);
  vtkGetMacro(ReducedVolume, double);
  ///@}

  ///@{
  /**
   * Which surface has the ReducedVolume and the Radius, one of Bases: Loop's, which the Presets
   * Balanced and Accurate of vtkVesicleStepper move, or the flat triangles of Fast and Paper.
   * Default: Loop.
   */
  vtkSetClampMacro(Basis, int, Linear, Loop);
  vtkGetMacro(Basis, int);
  ///@}

  ///@{
  /**
   * Number of triangles, at least 20. Multiples of 10 and 12 are met exactly up to 2,000, those of
   * four times as much up to 8,000 and so on (ellipsoids with three different axes: multiples of 12
   * and 20 n²); otherwise the nearest is made. Default: 1280.
   */
  vtkSetClampMacro(Triangles, int, 20, VTK_INT_MAX);
  vtkGetMacro(Triangles, int);
  ///@}

  ///@{
  /**
   * Radius of the sphere of the same volume, r0 = (3V/4π)^(1/3), any unit of length, above 0.
   * Default: 1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Where the shape's own z axis (its axis of symmetry) points to; any length but 0. Default: (0,
   * 0, 1).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Centroid of the enclosed volume, in the unit of Radius. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Semi-axes of the Ellipsoid along x, y, z before it is scaled to Radius, above 0; only their
   * ratios matter. With ReducedVolume as well they are first raised to a common power until it
   * holds. Default: (1, 1, 1).
   */
  vtkSetVector3Macro(SemiAxes, double);
  vtkGetVector3Macro(SemiAxes, double);
  ///@}

  ///@{
  /**
   * Modes of the Perturbed sphere: degree l ≥ 2, order −l ≤ m ≤ l (m < 0: sin |m|φ), amplitude in
   * units of Radius; or all three in an array, as property panels give them. Default: none.
   */
  void AddMode(int l, int m, double amplitude);
  void AddMode(const double mode[3]);
  void RemoveAllModes();
  int GetNumberOfModes();
  ///@}

protected:
  vtkVesicleSource();
  ~vtkVesicleSource() override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Shape = Sphere;
  int Basis = Loop;
  double ReducedVolume = 0;
  int Triangles = 1280;
  double Radius = 1;
  double Axis[3] = { 0, 0, 1 };
  double Center[3] = { 0, 0, 0 };
  double SemiAxes[3] = { 1, 1, 1 };

private:
  vtkVesicleSource(const vtkVesicleSource&) = delete;
  void operator=(const vtkVesicleSource&) = delete;

#ifndef __VTK_WRAP__
  struct ModeList;
  std::unique_ptr<ModeList> Modes;
#endif
};

#endif
