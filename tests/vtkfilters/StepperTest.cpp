#include "vtkVesicleStepper.h"

#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/dynamics/Diagnostics.h"
#include "solver/simulation/Simulation.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkVariant.h"
#include "vtkVesicleSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vesicle::test
{
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

const char* const scene_text = R"(
name = "shear"
[vesicle]
shape = "prolate"
reduced_volume = 0.95
triangles = 80
[membrane]
bending_rigidity = 1.0
[flow]
kind = "shear"
rate = 1.0
[time]
end = 1.0
output_every = 0.25
)";

Scene scene(const std::vector<std::string>& overrides = {})
{
  return parse_scene(scene_text, "test", ".", overrides);
}

Points points_at(vtkVesicleStepper* stepper, double time)
{
  stepper->UpdateTimeStep(time);
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::NoFailure)
    << stepper->GetErrorMessage();
  return to_mesh(stepper->GetOutput()).points;
}

double field(vtkPolyData* surface, const char* name)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(0, 0) : 0;
}

/// Follows the accepted steps.
struct Log
{
  std::vector<double> times;
  int stop_after = 1000;

  explicit Log(vtkVesicleStepper* stepper)
  {
    stepper->AddObserver(vtkVesicleStepper::StepAcceptedEvent, this, &Log::note);
  }
  void note(vtkObject* caller, unsigned long, void*)
  {
    auto* stepper = vtkVesicleStepper::SafeDownCast(caller);
    times.push_back(stepper->GetStateTime());
    EXPECT_EQ(stepper->GetDiagnostics().time, times.back());
    if (static_cast<int>(times.size()) >= stop_after)
    {
      stepper->SetAbortExecute(1);
    }
  }
};

}

TEST(Stepper, AnnouncesItsTimes)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  stepper->UpdateInformation();
  vtkInformation* info = stepper->GetOutputInformation(0);
  ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), 5);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_DOUBLE_EQ(info->Get(Pipeline::TIME_STEPS())[i], 0.25 * i);
  }
  EXPECT_EQ(info->Get(Pipeline::TIME_RANGE())[1], 1);
  stepper->SetScene(scene({ "time.end=steady" }));
  stepper->UpdateInformation();
  EXPECT_FALSE(info->Has(Pipeline::TIME_STEPS()));
  EXPECT_TRUE(info->Has(Pipeline::TIME_RANGE()));
}

TEST(Stepper, SameTimeSameShapeForwardAndBack)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  const Points at_0 = points_at(stepper, 0), at_half = points_at(stepper, 0.5);
  const Points between = points_at(stepper, 0.61), at_1 = points_at(stepper, 1);
  EXPECT_NE(at_0, at_half);
  EXPECT_EQ(points_at(stepper, 0.5), at_half);
  EXPECT_EQ(points_at(stepper, 0.61), between);
  EXPECT_EQ(points_at(stepper, 0), at_0);
  EXPECT_EQ(points_at(stepper, 1), at_1);
  EXPECT_EQ(field(stepper->GetOutput(), "TimeValue"), 1);
  EXPECT_EQ(stepper->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 1);
}

TEST(Stepper, DeliversMeshesThatAreLaidAnew)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(read_scene(VESICLE_SOURCE_DIR "/data/scenes/tadpole.toml",
    { "vesicle.triangles=120", "accuracy.most_triangles=320", "time.end=0.05" }));
  const Points start = points_at(stepper, 0), end = points_at(stepper, 0.05);
  EXPECT_GT(end.rows(), start.rows());
  for (const double time : { 0.05, 0.033, 0.0 })
  {
    stepper->UpdateTimeStep(time);
    vtkPolyData* output = stepper->GetOutput();
    vtkPointData* arrays = output->GetPointData();
    ASSERT_GT(arrays->GetNumberOfArrays(), 5);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      EXPECT_EQ(arrays->GetArray(i)->GetNumberOfTuples(), output->GetNumberOfPoints()) << time;
    EXPECT_EQ(output->GetNumberOfPolys(), 2 * output->GetNumberOfPoints() - 4) << time;
  }
  EXPECT_EQ(points_at(stepper, 0), start);
}

// What the start shape had at its points means nothing at others.
TEST(Stepper, AMeshLaidAnewHasNoneOfTheStartsArrays)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShapeByName("prolate");
  source->SetReducedVolume(0.9);
  source->SetTriangles(120);
  source->Update();
  vtkNew<vtkPolyData> marked;
  marked->ShallowCopy(source->GetOutput());
  vtkNew<vtkIntArray> marks;
  marks->SetName("Marks");
  marks->SetNumberOfValues(marked->GetNumberOfPoints());
  marks->FillValue(1);
  marked->GetPointData()->AddArray(marks);
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetInputData(marked);
  stepper->SetBondNumber(200);
  stepper->SetEndTime(0.05);
  stepper->SetOutputEvery(0.01);
  stepper->AddOverride("accuracy.mesh_motion=adaptive");
  stepper->AddOverride("accuracy.most_triangles=320");
  stepper->UpdateTimeStep(0);
  EXPECT_TRUE(stepper->GetOutput()->GetPointData()->HasArray("Marks"));
  stepper->UpdateTimeStep(0.05);
  ASSERT_GT(stepper->GetOutput()->GetNumberOfPoints(), marked->GetNumberOfPoints());
  EXPECT_FALSE(stepper->GetOutput()->GetPointData()->HasArray("Marks"));
}

TEST(Stepper, ThinnedOutMemoryIsReplayed)
{
  vtkNew<vtkVesicleStepper> stepper, forgetful;
  stepper->SetScene(scene());
  forgetful->SetScene(scene());
  forgetful->SetCacheSize(1);
  points_at(forgetful, 1);
  for (const double time : { 0.1, 0.25, 0.5, 0.61 })
  {
    EXPECT_EQ(points_at(stepper, time), points_at(forgetful, time)) << time;
  }
}

TEST(Stepper, RequestsDontChangeSteps)
{
  vtkNew<vtkVesicleStepper> straight, asked_often;
  straight->SetScene(scene());
  asked_often->SetScene(scene());
  const Log straight_log(straight), often_log(asked_often);
  points_at(straight, 1);
  for (const double time : { 0.03, 0.3, 0.1, 0.77, 0.2, 1.0 })
  {
    points_at(asked_often, time);
  }
  EXPECT_EQ(straight_log.times, often_log.times);
}

TEST(Stepper, DeliversFieldsAndNumbers)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  points_at(stepper, 0.3);
  vtkPolyData* output = stepper->GetOutput();
  for (const char* name :
    { "Mean_Curvature", "Gauss_Curvature", "Laplacian_Mean_Curvature", "Normals", "Bending_Force",
      "Tension", "Tension_Force", "Membrane_Force", "Velocity", "Surface_Divergence" })
  {
    ASSERT_TRUE(output->GetPointData()->HasArray(name)) << name;
    EXPECT_EQ(output->GetPointData()->GetArray(name)->GetDataType(), VTK_DOUBLE);
  }
  for (const char* name :
    { "Area", "Volume", "Reduced_Volume", "Bending_Energy", "Area_Drift", "Volume_Drift" })
  {
    EXPECT_TRUE(std::isfinite(field(output, name)));
  }
  EXPECT_NEAR(field(output, "Reduced_Volume"), 0.95, 1e-6);
  EXPECT_NEAR(field(output, "TimeValue"), 0.3, 1e-12);
}

TEST(Stepper, OnlyTheFieldsThatTheSceneChooses)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene({ "output.fields=[\"Tension\"]" }));
  points_at(stepper, 0);
  EXPECT_EQ(stepper->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_TRUE(stepper->GetOutput()->GetPointData()->HasArray("Tension"));
}

TEST(Stepper, AbortEndsAfterTheStepAndGoesOnLater)
{
  vtkNew<vtkVesicleStepper> stopped, straight;
  stopped->SetScene(scene());
  straight->SetScene(scene());
  Log log(stopped);
  log.stop_after = 2;
  points_at(stopped, 1);
  EXPECT_EQ(log.times.size(), 2u);
  EXPECT_FALSE(stopped->GetFinished());
  EXPECT_EQ(field(stopped->GetOutput(), "TimeValue"), log.times.back());
  log.stop_after = 1000;
  stopped->Modified(); // the same time again
  EXPECT_EQ(points_at(stopped, 1), points_at(straight, 1));
}

TEST(Stepper, GoesOnFromAState)
{
  vtkNew<vtkVesicleStepper> first, second;
  first->SetScene(scene());
  points_at(first, 0.5);
  second->SetScene(scene());
  second->SetState(*first->GetState());
  EXPECT_EQ(points_at(second, 1), points_at(first, 1));
  EXPECT_EQ(second->GetNumberOfSteps(), first->GetNumberOfSteps());
}

TEST(Stepper, TakesItsStartMeshFromTheInput)
{
  vtkNew<vtkVesicleStepper> by_shape, by_input;
  by_shape->SetScene(scene());
  const Points start = points_at(by_shape, 0);
  by_input->SetScene(scene({ "vesicle.shape=sphere", "vesicle.reduced_volume=1.0" }));
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(by_shape->GetOutput());
  by_input->SetInputData(mesh);
  EXPECT_LT((points_at(by_input, 0) - start).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Stepper, TimesPastTheEndGiveTheEnd)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene({ "time.end=0.25" }));
  points_at(stepper, 100);
  EXPECT_TRUE(stepper->GetFinished());
  EXPECT_EQ(field(stepper->GetOutput(), "TimeValue"), 0.25);
}

TEST(Stepper, ReadsASceneFileWithOverrides)
{
  const TemporaryFolder folder;
  replace_file(folder / "scene.toml", scene_text);
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneFileName((folder / "scene.toml").c_str());
  stepper->AddOverride("vesicle.triangles=180");
  points_at(stepper, 0);
  EXPECT_EQ(stepper->GetOutput()->GetNumberOfPolys(), 180);
}

TEST(Stepper, ErrorsHaveTheirCategory)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleStepper> stepper;
  stepper->UpdateTimeStep(0);
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::InputFailure);
  EXPECT_NE(std::string(stepper->GetErrorMessage()).find("SceneFileName"), std::string::npos);
  stepper->SetSceneFileName("/nowhere/scene.toml");
  stepper->UpdateTimeStep(0);
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::InputFailure);
}

TEST(Stepper, DeliversTheLastGoodStateWhenNoStepCanBeMade)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(
    scene({ "time.step=50.0", "time.end=100.0", "time.output_every=50.0", "flow.rate=30.0" }));
  stepper->UpdateTimeStep(100);
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::NumericalFailure);
  EXPECT_TRUE(messages.any_error());
  EXPECT_EQ(stepper->GetOutput()->GetNumberOfPolys(), 80);
  EXPECT_FALSE(stepper->GetFinished());
}

TEST(Stepper, TimesInAnyOrderGiveTheShapesOfTheirTime)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  std::vector<Points> shapes;
  for (const double time : { 0., 0.5, 1., 0.5, 0. })
  {
    shapes.push_back(points_at(stepper, time));
  }
  EXPECT_EQ(shapes[1], shapes[3]);
  EXPECT_EQ(shapes[0], shapes[4]);
  EXPECT_NE(shapes[0], shapes[1]);
  EXPECT_NE(shapes[1], shapes[2]);
}

TEST(Stepper, AsksForNothingTwice)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  const Log log(stepper);
  points_at(stepper, 0.5);
  const std::size_t steps = log.times.size();
  vtkSmartPointer<vtkPolyData> copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(stepper->GetOutput());
  const vtkMTimeType made = stepper->GetOutput()->GetMTime();
  stepper->UpdateTimeStep(0.5);
  EXPECT_EQ(stepper->GetOutput()->GetMTime(), made);
  stepper->SetCacheSize(50); // nothing of the simulation
  points_at(stepper, 0.5);
  EXPECT_EQ(log.times.size(), steps);
  points_at(stepper, 1);
  EXPECT_NE(to_mesh(copy).points, to_mesh(stepper->GetOutput()).points) << "a copy stays";
}

TEST(Stepper, TakesItsSceneFromText)
{
  vtkNew<vtkVesicleStepper> by_scene, by_text;
  by_scene->SetScene(scene({ "flow.rate=2.0" }));
  by_text->SetSceneText(scene_text);
  by_text->AddOverride("flow.rate=2.0");
  EXPECT_EQ(points_at(by_text, 0.25), points_at(by_scene, 0.25));
}

TEST(Stepper, AnElasticSheetOfPropertiesMovesAsThatOfAScene)
{
  vtkNew<vtkVesicleSource> shape;
  shape->SetShape(vtkVesicleSource::Prolate);
  shape->SetReducedVolume(0.95);
  shape->SetTriangles(80);
  vtkNew<vtkVesicleStepper> stepper, by_scene;
  stepper->SetInputConnection(shape->GetOutputPort());
  stepper->SetIncompressible(false);
  stepper->SetShearModulus(4);
  stepper->SetElasticity(vtkVesicleStepper::Skalak);
  stepper->SetDilationModulus(2);
  stepper->SetReference(vtkVesicleStepper::SphereReference);
  stepper->SetPrestretch(1.05);
  stepper->SetFlowKind(vtkVesicleStepper::Shear);
  stepper->SetEndTime(0.25);
  stepper->SetOutputEvery(0.25);
  by_scene->SetScene(scene({ "membrane.incompressible=false", "membrane.shear_modulus=4",
    "membrane.elasticity='skalak'", "membrane.dilation_modulus=2", "membrane.reference='sphere'",
    "membrane.prestretch=1.05", "accuracy.mesh_motion='material'", "time.end=0.25" }));
  by_scene->SetInputConnection(shape->GetOutputPort());
  EXPECT_EQ(points_at(stepper, 0.25), points_at(by_scene, 0.25));
}

TEST(Stepper, PropertiesAloneMakeAScene)
{
  vtkNew<vtkVesicleSource> shape;
  shape->SetShape(vtkVesicleSource::Prolate);
  shape->SetReducedVolume(0.95);
  shape->SetTriangles(80);
  vtkNew<vtkVesicleStepper> stepper, by_scene;
  stepper->SetInputConnection(shape->GetOutputPort());
  stepper->SetFlowKind(vtkVesicleStepper::Shear);
  stepper->SetFlowRate(1);
  stepper->SetPreset(vtkVesicleStepper::Fast);
  stepper->SetEndTime(0.5);
  stepper->SetOutputEvery(0.25);
  by_scene->SetScene(scene({ "accuracy.preset=fast", "time.end=0.5" }));
  by_scene->SetInputConnection(shape->GetOutputPort());
  EXPECT_EQ(points_at(stepper, 0.5), points_at(by_scene, 0.5));
  EXPECT_EQ(stepper->GetOutputInformation(0)->Length(Pipeline::TIME_STEPS()), 3);
  EXPECT_TRUE(stepper->GetFinished());

  stepper->SetFlowRate(2); // starts anew
  EXPECT_NE(points_at(stepper, 0.5), points_at(by_scene, 0.5));
  stepper->AddOverride("flow.rate=1.0");
  EXPECT_EQ(points_at(stepper, 0.5), points_at(by_scene, 0.5));
}

TEST(Stepper, StartsAnewWhenTheInputChanges)
{
  vtkNew<vtkVesicleSource> shape;
  shape->SetShape(vtkVesicleSource::Prolate);
  shape->SetReducedVolume(0.95);
  shape->SetTriangles(80);
  vtkNew<vtkTransform> turn;
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetTransform(turn);
  turned->SetInputConnection(shape->GetOutputPort());
  turned->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetInputConnection(turned->GetOutputPort());
  stepper->SetPreset(vtkVesicleStepper::Fast);
  stepper->SetFlowKind(vtkVesicleStepper::Shear);
  const Points upright = points_at(stepper, 0.1);
  turn->RotateY(90);
  const Points lying = points_at(stepper, 0.1);
  EXPECT_GT((upright - lying).norm(), 1);
  EXPECT_EQ(field(stepper->GetOutput(), "TimeValue"), 0.1);
}

TEST(Stepper, ArraysOfTheStartShapePassThrough)
{
  vtkNew<vtkPolyData> start;
  {
    vtkNew<vtkVesicleStepper> stepper;
    stepper->SetScene(scene());
    points_at(stepper, 0);
    start->DeepCopy(stepper->GetOutput());
  }
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int i = 0; i < start->GetNumberOfPoints(); ++i)
  {
    number->InsertNextValue(i);
  }
  start->GetPointData()->AddArray(number);
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene({ "membrane.incompressible=false" }));
  stepper->SetInputData(start);
  points_at(stepper, 0.1);
  EXPECT_EQ(stepper->GetOutput()->GetPointData()->GetArray("number")->GetComponent(5, 0), 5);
  EXPECT_FALSE(stepper->GetOutput()->GetPointData()->HasArray("Tension")) << "the start's";
}

TEST(Stepper, EmptyOrImpossibleStartShapes)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleStepper> stepper;
  vtkNew<vtkPolyData> empty;
  stepper->SetInputData(empty);
  stepper->UpdateTimeStep(0.1);
  EXPECT_FALSE(messages.any_error());
  EXPECT_EQ(stepper->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkSphereSource> open;
  open->SetEndPhi(90);
  stepper->SetInputConnection(open->GetOutputPort());
  stepper->UpdateTimeStep(0.1);
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::InputFailure);
  EXPECT_NE(std::string(stepper->GetErrorMessage()).find("open border"), std::string::npos);
}

// Observers take errors and warnings off the output window.
TEST(Stepper, ErrorsAndWarningsGoToObservers)
{
  struct Heard
  {
    int errors = 0, warnings = 0;
    void note(vtkObject*, unsigned long event, void*)
    {
      ++(event == vtkCommand::ErrorEvent ? errors : warnings);
    }
  } heard;
  vtkNew<vtkVesicleSource> sphere;
  sphere->SetTriangles(80);
  vtkNew<vtkReverseSense> inward;
  inward->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkVesicleStepper> stepper;
  stepper->AddObserver(vtkCommand::ErrorEvent, &heard, &Heard::note);
  stepper->AddObserver(vtkCommand::WarningEvent, &heard, &Heard::note);
  stepper->SetInputConnection(inward->GetOutputPort());
  stepper->UpdateTimeStep(0);
  EXPECT_EQ(heard.warnings, 1);
  EXPECT_EQ(heard.errors, 0) << stepper->GetErrorMessage();
  stepper->UpdateTimeStep(0.01);
  EXPECT_EQ(heard.warnings, 1) << "said once";
  stepper->SetViscosity(-1);
  const VtkMessages executive;
  stepper->UpdateTimeStep(0);
  EXPECT_GE(heard.errors, 1);
}

/// What observers in languages that have no Diagnostics follow.
TEST(Stepper, TellsOfTheLastStepAsATableAndAsASurface)
{
  struct Follower
  {
    vtkNew<vtkPolyData> surface;
    vtkSmartPointer<vtkTable> table;
    void note(vtkObject* caller, unsigned long, void*)
    {
      auto* stepper = vtkVesicleStepper::SafeDownCast(caller);
      table = stepper->GetDiagnosticsTable();
      stepper->CopyState(surface);
    }
  } follower;
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(scene());
  EXPECT_EQ(stepper->GetDiagnosticsTable(), nullptr);
  EXPECT_EQ(stepper->GetNextOutputTime(), VTK_DOUBLE_MAX);
  EXPECT_STREQ(stepper->GetSettings(), "");
  stepper->AddObserver(vtkVesicleStepper::StepAcceptedEvent, &follower, &Follower::note);
  points_at(stepper, 0.5);

  EXPECT_EQ(stepper->GetNextOutputTime(), 0.75);
  EXPECT_EQ(write_scene(parse_scene(stepper->GetSettings(), "settings")), write_scene(scene()));
  const auto& names = Diagnostics::names();
  const auto values = stepper->GetDiagnostics().values();
  ASSERT_EQ(follower.table->GetNumberOfColumns(), static_cast<vtkIdType>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const double value = follower.table->GetValueByName(0, names[i].c_str()).ToDouble();
    EXPECT_TRUE(values[i] ? value == *values[i] : std::isnan(value)) << names[i];
  }
  EXPECT_EQ(to_mesh(follower.surface).points, to_mesh(stepper->GetOutput()).points);
  EXPECT_EQ(follower.surface->GetPointData()->GetNumberOfArrays(),
    stepper->GetOutput()->GetPointData()->GetNumberOfArrays());
  EXPECT_EQ(field(follower.surface, "TimeValue"), 0.5);
}

}
