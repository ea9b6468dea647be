/**
 * @class   vtkVesicleCurvatureFilter
 * @brief   curvatures, their Laplacian and the bending force of a triangle mesh
 *
 * Adds these point arrays to any surface mesh, open or closed, a vtkPolyData or vtkUnstructuredGrid
 * (polygons and strips are cut into triangles first; vertices and lines are dropped; all other
 * arrays pass through). Of composite data each block is a surface of its own. A piece of a surface asks
 * for as many ghost cells as its curvatures need (with FitRadius, for those of two rings):
 *
 * - Mean_Curvature H and Gauss_Curvature K; with PrincipalCurvatures, or CurvatureType Maximum or
 * Minimum, also Maximum_Curvature and Minimum_Curvature, κ1 ≥ κ2 = H ± √(H² − K). Names,
 * CurvatureType (which makes one of them the active scalars) and InvertMeanCurvature are those of
 * vtkCurvatures, whose place the filter takes in a pipeline by its class name alone.
 * - Laplacian_Mean_Curvature Δ_s H, the Laplace–Beltrami operator of H.
 * - Normals n, unit vectors.
 * - With PrincipalCurvatures and scheme Fit: Maximum_Direction and Minimum_Direction, unit tangents
 * along which the surface has these curvatures (each may as well point the other way; any two that
 * are normal to each other where κ1 = κ2).
 * - With ShapeDescriptors: Curvedness √((κ1² + κ2²)/2); Shape_Index (2/π) arctan((κ1 + κ2)/(κ1 − κ2)),
 * 1 on a sphere seen from outside, 1/2 on a cylinder, 0 on a symmetric saddle and where it is flat,
 * −1 in a cup; Willmore_Density H², of which the bending energy is 2 EB times the integral.
 * - Bending_Force, the force density (a vector, force an area) that a membrane of Helfrich energy
 *   E = (EB/2) ∮ (2H)² dS exerts on the fluid: f = EB [2 Δ_s H + 4 H (H² − K)] n.
 * - Curvature_Valid (1 or 0): H, K and Normals are defined here. 0 where no triangle is, on an open
 *   border and where more than two triangles share an edge; the arrays are 0 there (Normals
 * aren't).
 * - Bending_Force_Valid (1 or 0): Δ_s H and the force are defined as well, which takes a ring of
 * valid neighbours. 0 elsewhere, and both arrays are 0 there. No value is ever NaN, unless
 * UndefinedIsNaN asks for it where values are undefined.
 *
 * Arrays know their units (vtkDataArray::UNITS_LABEL, in words: "1/length") and the names of their
 * components.
 *
 * Sign: H is +1/R on a sphere of radius R with outward normals. Normals follow the orientation of
 * the triangles (counter-clockwise seen from where n points to), but for one case: a closed,
 * consistently oriented body that faces inward counts as facing outward while OrientOutward is on,
 * if it lies in no other; its triangles are left as they are. Bodies within it are turned with it,
 * so that a hollow ball's inner side stays one: it faces inward on purpose, with H < 0. Of several
 * bodies the filter names those that it counts as turned and the inner sides in a warning. On an
 * inconsistently oriented mesh the signs mean little, and the filter warns (vtkPolyDataNormals with
 * ConsistencyOn mends it).
 *
 * Algorithm, scheme Fit (default): a quartic height function through each vertex and its neighbours
 * of two rings gives H, K and n; a second one of the fitted H gives Δ_s H. It converges on
 * irregular meshes too. Three more arrays: Fit_Residual (weighted RMS distance of the neighbours
 * from the fit, in edges), Fit_Degree (4; lower where the neighbourhood is too small) and
 * Mean_Curvature_Error, the standard error of H if that residual is noise, independent from point
 * to point.
 *
 * Noisy meshes, as of segmented images, need a length scale: with FitRadius (or FitRings) the
 * surface of second order is taken that is nearest to all points within that radius. The noise of H
 * falls as its third power, its bias grows as the square of radius over radius of curvature
 * (docs/filters.md has both measured). Where the curvature is mostly noise, the filter warns and
 * names a radius.
 *
 * Scheme Loop: the Loop limit surface through the vertices of a closed mesh, as the dynamics use
 * it; for meshes with smoothly spaced points.
 *
 * Time and memory of Fit and Loop grow as the number of triangles; threads share the work, and
 * results don't depend on their number. ProgressEvent comes on the way; where AbortExecute is set
 * the output is empty.
 *
 * Scheme Cotan (the paper's; H doesn't converge at vertices of valence other than six, nor Δ_s H on
 * irregular meshes): with the cotangent Laplacian L over the barycentric areas A_i,
 * (L f)_i = Σ_j (cot α_ij + cot β_ij)(f_j − f_i)/(2 A_i), H = −½ (L x)·n, K = (2π − Σ θ)/A_i from
 * the angles θ around the vertex, Δ_s H = L H, and n the area-weighted mean of the triangles'
 * normals.
 *
 * Source: G. Boedec, M. Leonetti, M. Jaeger, 3D vesicle dynamics simulations with a linearly
 * triangulated surface, J. Comput. Phys. 230 (2011) 1020, equations (14)–(24) and (6), where the
 * paper prints a factor 2 for the 4.
 */

#ifndef vtkVesicleCurvatureFilter_h
#define vtkVesicleCurvatureFilter_h

#include "VesicleFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

// As in vtkCurvatures.h, word for word: both may be included.
#define VTK_CURVATURE_GAUSS 0
#define VTK_CURVATURE_MEAN 1
#define VTK_CURVATURE_MAXIMUM 2
#define VTK_CURVATURE_MINIMUM 3

class VESICLEFILTERS_EXPORT vtkVesicleCurvatureFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkVesicleCurvatureFilter* New();
  vtkTypeMacro(vtkVesicleCurvatureFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Schemes
  {
    Fit,
    Cotan,
    Loop
  };

  ///@{
  /**
   * Which curvature becomes the active scalars. Default: Gaussian, as in vtkCurvatures.
   */
  vtkSetClampMacro(CurvatureType, int, VTK_CURVATURE_GAUSS, VTK_CURVATURE_MINIMUM);
  vtkGetMacro(CurvatureType, int);
  void SetCurvatureTypeToGaussian() { this->SetCurvatureType(VTK_CURVATURE_GAUSS); }
  void SetCurvatureTypeToMean() { this->SetCurvatureType(VTK_CURVATURE_MEAN); }
  void SetCurvatureTypeToMaximum() { this->SetCurvatureType(VTK_CURVATURE_MAXIMUM); }
  void SetCurvatureTypeToMinimum() { this->SetCurvatureType(VTK_CURVATURE_MINIMUM); }
  ///@}

  ///@{
  /**
   * Whether Mean_Curvature has the opposite sign (and the principal curvatures, their directions
   * and Shape_Index follow); the other arrays stay what they are. Default: off.
   */
  vtkSetMacro(InvertMeanCurvature, vtkTypeBool);
  vtkGetMacro(InvertMeanCurvature, vtkTypeBool);
  vtkBooleanMacro(InvertMeanCurvature, vtkTypeBool);
  ///@}

  ///@{
  /**
   * How curvatures are found, one of Schemes or its name in lower case. Default: Fit.
   */
  vtkSetClampMacro(Scheme, int, Fit, Loop);
  vtkGetMacro(Scheme, int);
  void SetSchemeByName(const char* name);
  const char* GetSchemeName();
  ///@}

  ///@{
  /**
   * Of scheme Fit: the radius of the neighbourhoods, a length in the mesh's units, 0 or more, less
   * than half the diagonal of the mesh's box. Points within it along the surface count that face
   * the same way. Time grows as its square. 0: FitRings says. Default: 0.
   */
  vtkSetClampMacro(FitRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FitRadius, double);
  ///@}

  ///@{
  /**
   * The same in mean lengths of the mesh's edges, where FitRadius is 0. 0: the nearest two or three
   * rings of neighbours, for smooth meshes. Default: 0.
   */
  vtkSetClampMacro(FitRings, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FitRings, double);
  ///@}

  ///@{
  /**
   * Whether Laplacian_Mean_Curvature, Bending_Force and Bending_Force_Valid are wanted, which with
   * a radius takes half of the time. Default: on.
   */
  vtkSetMacro(BendingForce, bool);
  vtkGetMacro(BendingForce, bool);
  vtkBooleanMacro(BendingForce, bool);
  ///@}

  ///@{
  /**
   * Whether both principal curvatures and their directions are wanted. Default: off.
   */
  vtkSetMacro(PrincipalCurvatures, bool);
  vtkGetMacro(PrincipalCurvatures, bool);
  vtkBooleanMacro(PrincipalCurvatures, bool);
  ///@}

  ///@{
  /**
   * Whether Curvedness, Shape_Index and Willmore_Density are wanted. Default: off.
   */
  vtkSetMacro(ShapeDescriptors, bool);
  vtkGetMacro(ShapeDescriptors, bool);
  vtkBooleanMacro(ShapeDescriptors, bool);
  ///@}

  ///@{
  /**
   * EB, an energy, 0 or more: multiplies Bending_Force. Default: 1.
   */
  vtkSetClampMacro(BendingRigidity, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BendingRigidity, double);
  ///@}

  ///@{
  /**
   * Whether arrays hold NaN instead of 0 where Curvature_Valid, or for Δ_s H and the force
   * Bending_Force_Valid, is 0. Default: off.
   */
  vtkSetMacro(UndefinedIsNaN, bool);
  vtkGetMacro(UndefinedIsNaN, bool);
  vtkBooleanMacro(UndefinedIsNaN, bool);
  ///@}

  ///@{
  /**
   * Whether closed bodies that face inward count as facing outward. Default: on.
   */
  vtkSetMacro(OrientOutward, bool);
  vtkGetMacro(OrientOutward, bool);
  vtkBooleanMacro(OrientOutward, bool);
  ///@}

protected:
  vtkVesicleCurvatureFilter() = default;
  ~vtkVesicleCurvatureFilter() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int CurvatureType = VTK_CURVATURE_GAUSS;
  vtkTypeBool InvertMeanCurvature = 0;
  int Scheme = Fit;
  double BendingRigidity = 1;
  double FitRadius = 0;
  double FitRings = 0;
  bool BendingForce = true;
  bool PrincipalCurvatures = false;
  bool ShapeDescriptors = false;
  bool UndefinedIsNaN = false;
  bool OrientOutward = true;

private:
  vtkVesicleCurvatureFilter(const vtkVesicleCurvatureFilter&) = delete;
  void operator=(const vtkVesicleCurvatureFilter&) = delete;
};

#endif
