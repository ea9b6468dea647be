#include "vtkVesicleStepper.h"

#include "TemporaryFolder.h"

#include "vtkfilters/Filters/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/dynamics/Simulation.h"
#include "solver/scene/SceneFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

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

}
