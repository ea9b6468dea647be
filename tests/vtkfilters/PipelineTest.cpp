// The filters among VTK's own: in pipelines, by several threads, asked twice, printed.
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/VtkMessages.h"
#include "solver/mesh/MeshIntegrals.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkStreamTracer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleSource.h"
#include "vtkVesicleStepper.h"
#include "vtkWarpVector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <thread>

namespace vesicle::test
{
namespace
{

/// How often an algorithm has run.
struct Runs
{
  int count = 0;
  explicit Runs(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::EndEvent, this, &Runs::note);
  }
  void note() { ++count; }
};

void make_prolate(vtkVesicleSource* source, int triangles = 80)
{
  source->SetShape(vtkVesicleSource::Prolate);
  source->SetReducedVolume(0.95);
  source->SetTriangles(triangles);
}

void expect_same(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray *left = a->GetArray(i), *right = b->GetArray(a->GetArrayName(i));
    ASSERT_NE(right, nullptr) << a->GetArrayName(i);
    ASSERT_EQ(left->GetNumberOfValues(), right->GetNumberOfValues()) << a->GetArrayName(i);
    for (vtkIdType k = 0; k < left->GetNumberOfValues(); ++k)
    {
      const int n = left->GetNumberOfComponents();
      ASSERT_EQ(left->GetComponent(k / n, k % n), right->GetComponent(k / n, k % n))
        << a->GetArrayName(i);
    }
  }
}

void expect_same(vtkPolyData* a, vtkPolyData* b)
{
  EXPECT_EQ(to_mesh(a).points, to_mesh(b).points);
  EXPECT_EQ(to_mesh(a).triangles, to_mesh(b).triangles);
  expect_same(a->GetPointData(), b->GetPointData());
  expect_same(a->GetCellData(), b->GetCellData());
  expect_same(a->GetFieldData(), b->GetFieldData());
}

/// Start shape, simulation, forces, velocity on a line of points.
struct Chain
{
  vtkNew<vtkVesicleSource> source;
  vtkNew<vtkVesicleStepper> stepper;
  vtkNew<vtkVesicleForceFilter> forces;

  explicit Chain(double rate)
  {
    make_prolate(this->source);
    this->stepper->SetInputConnection(this->source->GetOutputPort());
    this->stepper->SetFlowKind(vtkVesicleStepper::Shear);
    this->stepper->SetFlowRate(rate);
    this->stepper->SetPreset(vtkVesicleStepper::Fast);
    this->stepper->SetEndTime(0.5);
    this->forces->SetInputConnection(this->stepper->GetOutputPort());
  }
  vtkPolyData* output()
  {
    this->forces->UpdateTimeStep(0.5);
    return this->forces->GetOutput();
  }
};

/// Every name is in what the object prints.
void expect_printed(vtkObject* object, std::initializer_list<const char*> names)
{
  std::ostringstream text;
  object->Print(text);
  for (const char* name : names)
  {
    EXPECT_NE(text.str().find(std::string(name) + ":"), std::string::npos)
      << object->GetClassName() << ' ' << name;
  }
}

const auto scene_properties = { "BendingRigidity", "Incompressible", "ShearModulus", "Elasticity",
  "DilationModulus", "Reference", "ReferenceFile", "Prestretch", "SurfaceViscosity", "Viscosity",
  "ViscosityRatio", "FlowKind", "FlowRate", "FlowVelocity", "FlowRadius", "FlowCenter", "FlowAxis",
  "FlowType", "FlowFile", "VelocityField", "Wall", "WallPoint", "WallNormal", "BondNumber",
  "DensityDifference", "Acceleration", "Preset" };

}

TEST(Pipeline, BetweenFiltersOfVtk)
{
  vtkNew<vtkVesicleSource> source;
  make_prolate(source, 320);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkTransform> transform;
  transform->RotateY(45);
  transform->Scale(2, 2, 2);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetTransform(transform);
  placed->SetInputConnection(clean->GetOutputPort());
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputConnection(placed->GetOutputPort());
  forces->SetFlowKind(vtkVesicleForceFilter::Shear);
  vtkNew<vtkWarpVector> warp; // one step of Euler's
  warp->SetInputConnection(forces->GetOutputPort());
  warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  warp->SetScaleFactor(0.01);
  vtkNew<vtkVesicleCurvatureFilter> curvature;
  curvature->SetInputConnection(warp->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(curvature->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  vtkPolyData* output = normals->GetOutput();
  EXPECT_EQ(output->GetNumberOfPolys(), 320);
  for (const char* name : { "Tension", "Velocity", "Mean_Curvature", "Bending_Force" })
  {
    ASSERT_TRUE(output->GetPointData()->HasArray(name)) << name;
  }
  // The flow keeps the membrane's area to second order.
  EXPECT_NEAR(flat_area(to_mesh(output)) / flat_area(to_mesh(forces->GetOutput())), 1, 1e-3);
  EXPECT_NEAR(flat_volume(to_mesh(output)) / flat_volume(to_mesh(forces->GetOutput())), 1, 1e-3);
}

// From the source to streamlines without a file.
TEST(Pipeline, StreamlinesPastAVesicle)
{
  vtkNew<vtkVesicleSource> sphere;
  sphere->SetTriangles(320);
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputConnection(sphere->GetOutputPort());
  forces->SetFlowKind(vtkVesicleForceFilter::Shear);
  vtkNew<vtkImageData> box;
  box->SetDimensions(21, 21, 21);
  box->SetOrigin(-2, -2, -2);
  box->SetSpacing(0.2, 0.2, 0.2);
  vtkNew<vtkVesicleProbeFilter> flow;
  flow->SetInputData(box);
  flow->SetSourceConnection(forces->GetOutputPort());
  vtkNew<vtkPolyData> seeds;
  Points places(2, 3);
  places << -1.9, 0, 1.5, 0.1, 0, 0.3;
  seeds->SetPoints(to_vtk_points(places));
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputConnection(flow->GetOutputPort());
  tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  tracer->SetSourceData(seeds);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetMaximumPropagation(30);
  tracer->SetMaximumNumberOfSteps(3000);
  tracer->Update();
  vtkPolyData* lines = tracer->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  vtkNew<vtkIdList> ids;
  lines->GetCellPoints(0, ids);
  EXPECT_GT(lines->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1))[0], 1.8);
  // In the plane of symmetry, where it stays.
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(lines->GetPoint(i)[1], 0, 1e-3);
  }
}

TEST(Pipeline, NothingRunsTwiceUnlessSomethingChanged)
{
  Chain chain(1);
  const Runs source(chain.source), stepper(chain.stepper), forces(chain.forces);
  vtkNew<vtkVesicleCurvatureFilter> curvature;
  curvature->SetInputConnection(chain.forces->GetOutputPort());
  const Runs curvatures(curvature);
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputConnection(chain.source->GetOutputPort());
  probe->SetSourceConnection(chain.forces->GetOutputPort());
  const Runs probes(probe);
  for (int i = 0; i < 3; ++i)
  {
    curvature->UpdateTimeStep(0.1);
    probe->UpdateTimeStep(0.1);
    chain.forces->SetFlowRate(chain.forces->GetFlowRate()); // no change
    chain.forces->SetPreset(vtkVesicleForceFilter::Balanced);
    curvature->SetCurvatureTypeToGaussian();
    chain.stepper->SetEndTime(0.5);
  }
  EXPECT_EQ(source.count, 1);
  EXPECT_EQ(stepper.count, 1);
  EXPECT_EQ(forces.count, 1);
  EXPECT_EQ(curvatures.count, 1);
  EXPECT_EQ(probes.count, 1);
  chain.forces->SetBendingRigidity(2);
  curvature->UpdateTimeStep(0.1);
  probe->UpdateTimeStep(0.1);
  EXPECT_EQ(stepper.count, 1);
  EXPECT_EQ(forces.count, 2);
  EXPECT_EQ(curvatures.count, 2);
  EXPECT_EQ(probes.count, 2);
  chain.source->SetReducedVolume(0.9);
  probe->UpdateTimeStep(0.1);
  EXPECT_EQ(source.count, 2);
  EXPECT_EQ(forces.count, 3);
}

TEST(Pipeline, DeepCopiesAreOnTheirOwn)
{
  Chain chain(1);
  vtkNew<vtkPolyData> copy, again;
  copy->DeepCopy(chain.output());
  again->DeepCopy(copy);
  expect_same(copy, chain.output());
  chain.source->SetReducedVolume(0.9);
  EXPECT_NE(to_mesh(chain.output()).points, to_mesh(copy).points);
  expect_same(copy, again);
}

TEST(Pipeline, TwoAtOnceGiveWhatEachGivesAlone)
{
  vtkNew<vtkPolyData> alone[2], together[2];
  const double rates[] = { 1, 2 };
  for (int i = 0; i < 2; ++i)
  {
    alone[i]->DeepCopy(Chain(rates[i]).output());
  }
  std::thread threads[2];
  for (int i = 0; i < 2; ++i)
  {
    threads[i] = std::thread([&, i] { together[i]->DeepCopy(Chain(rates[i]).output()); });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  for (int i = 0; i < 2; ++i)
  {
    expect_same(alone[i], together[i]);
  }
}

// VTK has one place for the messages of all threads.
TEST(Pipeline, MessagesAreKeptForTheThreadThatTheyAreOf)
{
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  {
    const VtkMessages here;
    std::thread(
      []
      {
        const VtkMessages there;
        vtkOutputWindowDisplayErrorText("file (1): there\n");
        EXPECT_TRUE(there.any_error());
        const VtkMessages within;
        EXPECT_FALSE(within.any_error());
      })
      .join();
    EXPECT_FALSE(here.any_error());
    vtkOutputWindowDisplayErrorText("file (1): here\n");
    vtkOutputWindowDisplayErrorText("file (1): here again\n");
    EXPECT_EQ(here.first_error(), "here");
  }
  EXPECT_EQ(vtkOutputWindow::GetInstance(), window);
}

TEST(Pipeline, TwoReadMeshesAtOnce)
{
  const TemporaryFolder folder;
  vtkNew<vtkVesicleSource> source;
  make_prolate(source);
  source->Update();
  write_mesh(source->GetOutput(), folder / "mesh.vtu");
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  std::thread threads[2];
  for (auto& thread : threads)
  {
    thread = std::thread(
      [&]
      {
        for (int i = 0; i < 20; ++i)
        {
          EXPECT_EQ(read_mesh(folder / "mesh.vtu")->GetNumberOfPolys(), 80);
        }
      });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(vtkOutputWindow::GetInstance(), window);
}

TEST(Pipeline, ClassesPrintAllTheirProperties)
{
  vtkNew<vtkVesicleSource> source;
  source->AddMode(2, 0, 0.1);
  expect_printed(source,
    { "Shape", "Basis", "ReducedVolume", "Triangles", "Radius", "Axis", "Center", "SemiAxes",
      "Mode" });
  expect_printed(vtkNew<vtkVesicleCurvatureFilter>(),
    { "CurvatureType", "InvertMeanCurvature", "Scheme", "BendingRigidity", "OrientOutward" });
  vtkNew<vtkVesicleForceFilter> forces;
  expect_printed(forces, scene_properties);
  expect_printed(forces, { "BendingForce" });
  expect_printed(vtkNew<vtkVesicleProbeFilter>(), { "Source" });
  vtkNew<vtkVesicleStepper> stepper;
  stepper->AddOverride("flow.rate=1");
  expect_printed(stepper, scene_properties);
  expect_printed(stepper,
    { "SceneFileName", "SceneText", "Override", "EndTime", "OutputEvery", "TimeStep", "Tolerance",
      "CacheSize", "ErrorCategory", "ErrorMessage", "StateTime", "NumberOfSteps", "Finished" });
}

}
