/**
 * @class   vtkVesicleStepper
 * @brief   a vesicle simulation as a time-dependent source
 *
 * vtkVesicleStepper owns a simulation and makes accepted steps until it can answer the time that
 * the pipeline asks for.
 *
 * The scene is that of SceneFileName, or else SceneText, or else it is made of the properties:
 * vtkVesicleSceneAlgorithm's and EndTime, OutputEvery, TimeStep, Tolerance (which a file or text
 * leaves unused). Overrides replace single settings of each of them. The start mesh is the optional
 * input, as it is (in the units of the scene; at its first time, if it has several), or else what
 * the scene's [vesicle] table says; with properties alone an input is needed. It must be a closed
 * surface of genus 0, or of as many of them as the scene has vesicles, in the order of their first
 * triangles (with properties alone each is a vesicle), as vtkPolyData, vtkUnstructuredGrid or blocks of
 * them, which are joined; polygons and strips are cut into triangles; an empty one gives empty output.
 * Where pieces are asked for, the first is the whole, others are empty.
 * Arrays of the input pass through, and stay with the mesh's points and triangles (which slide
 * along the membrane, unless accuracy.mesh_motion is "material").
 *
 * Time: TIME_STEPS are the multiples of the scene's output_every up to its end, which are hit
 * exactly; TIME_RANGE is [start, end]. A scene that ends when it is steady announces TIME_RANGE
 * alone, open until the end is known. Steps never depend on what is asked for: a time between two
 * accepted steps is interpolated, positions by the cubic Hermite polynomial of both states'
 * positions and velocities, point arrays and field data linearly between both states (normals
 * brought back to length 1). Going back in time is served from kept states at output times and
 * steps made again from there, the same bit for bit. A time after the end gives the last state;
 * DATA_TIME_STEP and the field data TimeValue say which time was delivered.
 *
 * Output: triangles with double precision points and the point arrays that the scene has among
 * Mean_Curvature, Gauss_Curvature, Laplacian_Mean_Curvature, Normals, Bending_Force, Tension,
 * Tension_Force, Membrane_Force, Gravity_Force, Velocity, Surface_Divergence (the scene's
 * output.fields chooses); field data TimeValue, Area, Volume, Reduced_Volume, Bending_Energy,
 * Area_Drift, Volume_Drift, and what vtkVesicleProbeFilter needs to find the velocity anywhere. Of
 * several vesicles the point array Vesicle_Id, from 0, tells them apart, and field data but for the
 * time have a tuple for each. All
 * in the units of the scene. Mean curvature is 1/R on a sphere of radius R, n points outward, force
 * densities are what the membrane exerts on the fluid.
 *
 * Events: StepAcceptedEvent after every accepted step (not for those made again), ProgressEvent
 * with the share of the way to the requested time. SetAbortExecute(1), from an observer, ends the
 * update cleanly after the step; the output is then the last state, and the next update goes on
 * from there (after Modified(), if it is for the same time).
 *
 * Errors: what can't be used (scene, mesh) fails the update. When no step can be made any more, the
 * update delivers the last good state and reports an error. GetErrorCategory tells them apart. What
 * was changed in the start mesh, and a mesh too rough for the preset, are warnings.
 *
 * The method is that of G. Boedec, M. Leonetti, M. Jaeger, 3D vesicle dynamics simulations with a
 * linearly triangulated surface, J. Comput. Phys. 230 (2011) 1020: boundary integrals of the
 * Stokeslet, cotangent curvatures, a tension that keeps every patch's area, implicit bending.
 */

#ifndef vtkVesicleStepper_h
#define vtkVesicleStepper_h

#include "vtkCommand.h" // for the event
#include "vtkVesicleSceneAlgorithm.h"

class vtkTable;

#ifndef __VTK_WRAP__
#include <memory> // for the internals
#include <vector> // for the diagnostics

namespace vesicle
{
class Simulation;
struct Diagnostics;
struct Scene;
struct State;
}
#endif

class VESICLEFILTERS_EXPORT vtkVesicleStepper : public vtkVesicleSceneAlgorithm
{
public:
  static vtkVesicleStepper* New();
  vtkTypeMacro(vtkVesicleStepper, vtkVesicleSceneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    StepAcceptedEvent = vtkCommand::UserEvent + 2011
  };

  enum ErrorCategories
  {
    NoFailure,
    InputFailure,     ///< the scene or the mesh can't be used
    NumericalFailure, ///< no step can be made; the output is the last good state
    IoFailure         ///< a file can't be read
  };

  ///@{
  /**
   * The scene, a TOML file. Default: none. Setting it reads the file again and starts anew.
   */
  virtual void SetSceneFileName(const char* name);
  const char* GetSceneFileName();
  ///@}

  ///@{
  /**
   * The scene as TOML itself. Files that it names are looked for from the current folder.
   * Default: none.
   */
  virtual void SetSceneText(const char* text);
  const char* GetSceneText();
  ///@}

  ///@{
  /**
   * Settings that replace the scene's, as "table.key=value". Default: none.
   */
  void AddOverride(const char* setting);
  void RemoveAllOverrides();
  int GetNumberOfOverrides();
  ///@}

  ///@{
  /**
   * Where the simulation ends, a time; 0: when the shape is steady. Default: 1.
   */
  vtkSetClampMacro(EndTime, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * Interval of the announced times, a time above 0. Default: 0.1.
   */
  vtkSetMacro(OutputEvery, double);
  vtkGetMacro(OutputEvery, double);
  ///@}

  ///@{
  /**
   * Length of the steps, a time; 0: chosen and changed so that Tolerance holds. Default: 0.
   */
  vtkSetClampMacro(TimeStep, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Error of the position that a step may make, in units of r0; 0: the Preset's. Default: 0.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How many states at output times are kept for going back in time, 1 or more (a state of 2,562
   * vertices takes about 0.3 MB). When there are more, every second one is given up. Default: 200.
   */
  vtkSetClampMacro(CacheSize, int, 1, VTK_INT_MAX);
  vtkGetMacro(CacheSize, int);
  ///@}

  ///@{
  /**
   * What went wrong in the last update: one of ErrorCategories and a message (empty: nothing).
   */
  vtkGetMacro(ErrorCategory, int);
  const char* GetErrorMessage();
  ///@}

  ///@{
  /**
   * How far the simulation has come: the time of the last accepted step in the unit of the scene,
   * the number of steps, and whether that is the end. 0 and false before the first update.
   */
  double GetStateTime();
  vtkIdType GetNumberOfSteps();
  bool GetFinished();
  ///@}

  /**
   * The output time that comes after the last accepted state, or the end; VTK_DOUBLE_MAX where there is
   * none, or no state.
   */
  double GetNextOutputTime();

  /**
   * Of the last accepted state: a column of doubles a number, by the names of the table that
   * `vesicle run` writes, in the unit of the scene; NaN where a number is undefined. A new table each
   * time; nullptr before the first update. Observers of StepAcceptedEvent get that of the step.
   */
  vtkTable* GetDiagnosticsTable();

  /**
   * Makes `output` the last accepted state, as the output is at its time but for arrays of the start
   * mesh. For observers, to whom the output is still that of the update before. Reports an error where
   * there is no state.
   */
  void CopyState(vtkPolyData* output);

  /**
   * The scene as TOML with every setting spelled out, empty before the first UpdateInformation.
   */
  const char* GetSettings();

#ifndef __VTK_WRAP__
  /// Takes this scene instead of a file's.
  void SetScene(const vesicle::Scene& scene);
  /// Goes on from this state of the same scene (a checkpoint) instead of from the start.
  void SetState(const vesicle::State& state);

  /// The simulation and its last accepted state, for observers; nullptr before the first update.
  /// Where the start can't be solved there is a simulation, with its start mesh, and no state.
  vesicle::Simulation* GetSimulation();
  const vesicle::State* GetState() const;
  /// Of the last accepted state; there must be one. Of the first vesicle, and of each.
  const vesicle::Diagnostics& GetDiagnostics() const;
  const std::vector<vesicle::Diagnostics>& GetAllDiagnostics() const;
#endif

protected:
  vtkVesicleStepper();
  ~vtkVesicleStepper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double EndTime = 1;
  double OutputEvery = 0.1;
  double TimeStep = 0;
  double Tolerance = 0;
  int CacheSize = 200;
  int ErrorCategory = NoFailure;

private:
  vtkVesicleStepper(const vtkVesicleStepper&) = delete;
  void operator=(const vtkVesicleStepper&) = delete;

#ifndef __VTK_WRAP__
  /// Runs `work`; an exception becomes the error category and message. False if there was one.
  template<class Work>
  bool Guarded(const Work& work);
  void ForgetFailure();
  void SettingsChanged();
  vesicle::Scene SceneOfProperties();
  void ReadScene();
  void Prepare(vtkDataObject* start, vtkDataObject* field);
  void AdvanceTo(double time);
  void ShareProgress(double from, double to);

  struct Internals;
  std::unique_ptr<Internals> Internal;
#endif
};

#endif
