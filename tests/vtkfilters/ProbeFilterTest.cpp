#include "vtkVesicleProbeFilter.h"

#include "solver/flow/Uniform.h"
#include "solver/scene/SceneFile.h"
#include "solver/stokes/MembraneFlow.h"
#include "tests/solver/support/TestMeshes.h"
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/SceneNumbers.h"
#include "vtkfilters/Filters/SeriesWriter.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleSource.h"
#include "vtkVesicleStepper.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vesicle::test
{
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The unit sphere's mesh with the force of a solid sphere that moves with e_z, as if read from a
/// file.
vtkSmartPointer<vtkPolyData> solid_sphere(Scene::Basis basis)
{
  auto sphere = to_polydata(smooth_sphere(1280));
  Scene scene;
  scene.accuracy.basis = basis;
  scene.fluid.viscosity = 2;
  add_medium(scene, 0, sphere->GetFieldData());
  const Points force = Eigen::RowVector3d(0, 0, 3).replicate(sphere->GetNumberOfPoints(), 1);
  sphere->GetPointData()->AddArray(to_array("Membrane_Force", force));
  return sphere;
}

Eigen::RowVector3d stokes_sphere(const Vector3& x)
{
  const Vector3 U(0, 0, 1), n = x.normalized();
  const double r = x.norm();
  return r <= 1
    ? Eigen::RowVector3d(0, 0, 1)
    : Eigen::RowVector3d(
        (0.75 / r * (U + n * n.dot(U)) + 0.25 / (r * r * r) * (U - 3 * n * n.dot(U))).transpose());
}

vtkSmartPointer<vtkPolyData> cloud(const Points& points)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(to_vtk_points(points));
  return data;
}

vtkSmartPointer<vtkImageData> image(int points_a_side, double half_width)
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  const double spacing = 2 * half_width / (points_a_side - 1);
  data->SetDimensions(points_a_side, points_a_side, points_a_side);
  data->SetOrigin(-half_width, -half_width, -half_width);
  data->SetSpacing(spacing, spacing, spacing);
  return data;
}

Points velocity_of(vtkDataSet* data)
{
  vtkDataArray* array = data->GetPointData()->GetArray("Velocity");
  EXPECT_NE(array, nullptr);
  Points values = Points::Zero(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; array && i < values.rows(); ++i)
  {
    array->GetTuple(i, values.row(i).data());
  }
  EXPECT_TRUE(values.allFinite());
  return values;
}

Points velocity_at(const Points& points, vtkDataObject* source)
{
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(cloud(points));
  probe->SetSourceData(source);
  probe->Update();
  return velocity_of(probe->GetOutput());
}

void expect_refused(vtkDataObject* source, const char* words)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(image(2, 1));
  probe->SetSourceData(source);
  probe->Update();
  EXPECT_NE(messages.first_error().find(words), std::string::npos) << messages.first_error();
}

/// A vesicle in shear with gravity.
vtkSmartPointer<vtkPolyData> vesicle_in_shear()
{
  vtkNew<vtkVesicleSource> source;
  source->SetShape(vtkVesicleSource::Prolate);
  source->SetReducedVolume(0.9);
  source->SetTriangles(320);
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputConnection(source->GetOutputPort());
  forces->SetFlowKind(vtkVesicleForceFilter::Shear);
  forces->SetBondNumber(2);
  forces->Update();
  return forces->GetOutput();
}

}

TEST(ProbeFilter, SolidSphereAtEveryDistance)
{
  for (auto basis : { Scene::Basis::linear, Scene::Basis::loop })
  {
    const auto sphere = solid_sphere(basis);
    Points directions = smooth_sphere(80).points;
    directions.row(0) = Eigen::RowVector3d(0.3, -0.5, 0.2).normalized();
    for (double d : { 3., 1., 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0. })
    {
      for (double side : { -1., 1. })
      {
        const double radius = std::abs(1 + side * d);
        const Points velocity = velocity_at(radius * directions, sphere);
        for (Eigen::Index i = 0; i < velocity.rows(); ++i)
        {
          const Vector3 x = radius * directions.row(i).transpose();
          EXPECT_LT((velocity.row(i) - stokes_sphere(x)).norm(),
            basis == Scene::Basis::linear ? 8e-3 : 2e-4)
            << side * d;
        }
      }
    }
  }
}

TEST(ProbeFilter, VelocityOfTheMembraneItself)
{
  const auto vesicle = vesicle_in_shear();
  const Points expected = velocity_of(vesicle);
  const Points probed = velocity_at(to_mesh(vesicle).points, vesicle);
  EXPECT_LT(
    (probed - expected).rowwise().norm().maxCoeff(), 0.01 * expected.rowwise().norm().maxCoeff());
}

// With the solver that is linked to this program, beside the one in the filters' library.
TEST(ProbeFilter, TheSameAsTheSolverItself)
{
  const TriangleMesh mesh = smooth_sphere(1280);
  const Points force = Eigen::RowVector3d(0, 0, 3).replicate(mesh.points.rows(), 1);
  const FlowField flow = membrane_flow(mesh, SurfaceBasis::linear, force);
  const Points points = 1.5 * smooth_sphere(80).points;
  const double viscosity = 2;
  EXPECT_LT(
    (velocity_at(points, solid_sphere(Scene::Basis::linear)) - flow.at(points).velocity / viscosity)
      .cwiseAbs()
      .maxCoeff(),
    1e-14);
}

TEST(ProbeFilter, AFrameOfTheSeriesIsEnough)
{
  const TemporaryFolder folder;
  const auto vesicle = vesicle_in_shear();
  SeriesWriter writer(folder.path(), "shear");
  writer.append(vesicle, 0);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(writer.files().front().c_str());
  vtkNew<vtkVesicleProbeFilter> probe;
  const Points points = 1.3 * smooth_sphere(80).points;
  probe->SetInputData(cloud(points));
  probe->SetSourceConnection(reader->GetOutputPort());
  probe->Update();
  EXPECT_EQ(velocity_of(probe->GetOutput()), velocity_at(points, vesicle));
}

TEST(ProbeFilter, EveryFlowComesBackFromItsNumbers)
{
  const Points points = 4 * smooth_sphere(80).points;
  vtkNew<vtkVesicleSource> sphere;
  sphere->SetTriangles(80);
  for (int kind = vtkVesicleForceFilter::AtRest; kind <= vtkVesicleForceFilter::FourRollMill;
       ++kind)
  {
    vtkNew<vtkVesicleForceFilter> bare; // no force: the imposed flow is all there is
    bare->SetInputConnection(sphere->GetOutputPort());
    bare->SetBendingRigidity(0);
    bare->IncompressibleOff();
    bare->SetFlowKind(kind);
    bare->SetFlowRate(-3);
    bare->SetFlowVelocity(1, -2, 0.5);
    bare->SetFlowRadius(4);
    bare->SetFlowCenter(0.5, 0, 1);
    bare->SetFlowAxis(3, 0, 0);
    bare->SetFlowType(0.5);
    bare->Update();
    const Points velocity = velocity_at(points, bare->GetOutput());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      const double x = points(i, 0), y = points(i, 1), z = points(i, 2);
      const Vector3 axis(1, -2, 0.5);
      const Vector3 from_axis = (Vector3(x, y, z) - Vector3(0.5, 0, 1)).cross(axis.normalized());
      const Eigen::RowVector3d exact[] = { { 0, 0, 0 }, axis.transpose(), { -3 * z, 0, 0 },
        { -3 * x, 0, 3 * z }, { 1.5 * x, 1.5 * y, -3 * z },
        (1 - from_axis.squaredNorm() / 16) * axis.transpose(), { 0, 3 * z, -3 * y },
        { -2.25 * x - 0.75 * z, 0, 0.75 * x + 2.25 * z } };
      EXPECT_LT((velocity.row(i) - exact[kind]).norm(), 1e-12) << kind;
    }
  }
}

TEST(ProbeFilter, ImagesKeepTheirKindAndArrays)
{
  const auto box = image(24, 1.5);
  vtkNew<vtkIntArray> points, cells;
  points->SetName("points");
  points->SetNumberOfValues(box->GetNumberOfPoints());
  points->FillValue(5);
  cells->SetName("cells");
  cells->SetNumberOfValues(box->GetNumberOfCells());
  cells->FillValue(6);
  box->GetPointData()->AddArray(points);
  box->GetCellData()->AddArray(cells);
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(box);
  probe->SetSourceData(solid_sphere(Scene::Basis::loop));
  probe->Update();
  auto* output = vtkImageData::SafeDownCast(probe->GetOutput());
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfPoints(), box->GetNumberOfPoints());
  EXPECT_EQ(output->GetPointData()->GetArray("points")->GetComponent(9, 0), 5);
  EXPECT_EQ(output->GetCellData()->GetArray("cells")->GetComponent(9, 0), 6);
  EXPECT_EQ(std::string(output->GetPointData()->GetVectors()->GetName()), "Velocity");
  // Inside marks the unit ball.
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double r = Vector3(output->GetPoint(i)).norm();
    if (std::abs(r - 1) > 1e-4)
    {
      EXPECT_EQ(output->GetPointData()->GetArray("Inside")->GetComponent(i, 0), r < 1);
    }
  }
  EXPECT_FALSE(box->GetPointData()->HasArray("Velocity"));
}

// In a frame that moves with a solid sphere the streamlines run past it: ψ = r² sin²θ (½ − 3/(4r) +
// 1/(4r³)) stays what it is along each of them.
TEST(ProbeFilter, StreamTracerFollowsTheStreamFunction)
{
  const auto sphere = solid_sphere(Scene::Basis::loop);
  Scene medium;
  medium.accuracy.basis = Scene::Basis::loop;
  medium.fluid.viscosity = 2;
  medium.flow = std::make_shared<Uniform>(Vector3(0, 0, -1));
  add_medium(medium, 0, sphere->GetFieldData());
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(image(33, 3));
  probe->SetSourceData(sphere);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputConnection(probe->GetOutputPort());
  tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  Points seeds(3, 3);
  seeds << 0.8, 0, 2.9, 0, 1.2, 2.9, 1.5, 1.5, 2.9;
  tracer->SetSourceData(cloud(seeds));
  tracer->SetIntegrationDirectionToForward();
  tracer->SetIntegratorTypeToRungeKutta45();
  tracer->SetMaximumPropagation(20);
  tracer->Update();
  vtkPolyData* lines = tracer->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 3);
  const auto stream_function = [](const double* p)
  {
    const double r = Vector3(p).norm(), rho2 = p[0] * p[0] + p[1] * p[1];
    return rho2 * (0.5 - 0.75 / r + 0.25 / (r * r * r));
  };
  for (vtkIdType line = 0; line < 3; ++line)
  {
    const double start = stream_function(seeds.row(line).data());
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(line, ids);
    EXPECT_LT(lines->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1))[2], -2.7);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      EXPECT_NEAR(stream_function(lines->GetPoint(ids->GetId(i))), start, 0.03 * start + 0.01);
    }
  }
}

TEST(ProbeFilter, FollowsTheTimeOfItsSource)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetScene(parse_scene(R"(
name = "shear"
[vesicle]
shape = "prolate"
reduced_volume = 0.95
triangles = 80
[flow]
kind = "shear"
rate = 1.0
[time]
end = 0.5
output_every = 0.25
)",
    "test"));
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(image(5, 1.2));
  probe->SetSourceConnection(stepper->GetOutputPort());
  probe->UpdateInformation();
  EXPECT_EQ(probe->GetOutputInformation(0)->Length(Pipeline::TIME_STEPS()), 3);
  probe->UpdateTimeStep(0);
  const Points at_start = velocity_of(probe->GetOutput());
  probe->UpdateTimeStep(0.5);
  EXPECT_EQ(stepper->GetStateTime(), 0.5);
  EXPECT_EQ(probe->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 0.5);
  EXPECT_NE(velocity_of(probe->GetOutput()), at_start);
  probe->UpdateTimeStep(0);
  EXPECT_EQ(velocity_of(probe->GetOutput()), at_start);
}

TEST(ProbeFilter, SaysWhatTheSourceLacks)
{
  auto sphere = solid_sphere(Scene::Basis::linear);
  sphere->GetFieldData()->RemoveArray("Viscosity");
  expect_refused(sphere, "Viscosity");
  sphere = solid_sphere(Scene::Basis::linear);
  sphere->GetPointData()->RemoveArray("Membrane_Force");
  expect_refused(sphere, "Membrane_Force");
  sphere = solid_sphere(Scene::Basis::linear);
  add_number(sphere->GetFieldData(), "Flow_Kind", 17);
  expect_refused(sphere, "Flow_Kind");
  sphere = solid_sphere(Scene::Basis::linear);
  add_number(sphere->GetFieldData(), "Flow_Kind", 2);
  expect_refused(sphere, "Flow_Rate");
  sphere = solid_sphere(Scene::Basis::linear);
  sphere->GetPoints()->InsertNextPoint(0, 0, 0);
  for (int i = 0; i < sphere->GetPointData()->GetNumberOfArrays(); ++i)
  {
    sphere->GetPointData()->GetArray(i)->InsertNextTuple(0, sphere->GetPointData()->GetArray(i));
  }
  expect_refused(sphere, "no triangle uses");
  expect_refused(vtkNew<vtkUnstructuredGrid>(), "");
}

// A vesicle that a stepper moves beside a wall: nothing slips there, nothing moves behind it, and at the
// vertices the velocity is the membrane's.
TEST(ProbeFilter, AtAWallNothingMoves)
{
  vtkNew<vtkVesicleSource> source;
  source->SetTriangles(320);
  source->SetCenter(0, 0, 1.2);
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputConnection(source->GetOutputPort());
  forces->SetFlowKind(vtkVesicleForceFilter::Shear);
  forces->SetViscosityRatio(3);
  forces->SetWall(true);
  forces->Update();
  const Points vertices = to_mesh(forces->GetOutput()).points,
               membrane = velocity_of(forces->GetOutput());
  Points feet = vertices, behind = vertices;
  feet.col(2).setZero();
  behind.col(2).setConstant(-1);
  const auto probed = [&](const Points& at) { return velocity_at(at, forces->GetOutput()); };
  EXPECT_LT((probed(vertices) - membrane).norm(), 2e-3 * membrane.norm());
  EXPECT_LT(probed(feet).norm(), 1e-5 * membrane.norm());
  EXPECT_TRUE(probed(behind).isZero());
}

TEST(ProbeFilter, NoPointsNoVelocities)
{
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(cloud(Points(0, 3)));
  probe->SetSourceData(solid_sphere(Scene::Basis::loop));
  probe->Update();
  EXPECT_EQ(probe->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(velocity_of(probe->GetOutput()).rows(), 0);
}

TEST(ProbeFilter, AbortGivesNothing)
{
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(image(20, 2));
  probe->SetSourceData(solid_sphere(Scene::Basis::linear));
  struct Stop
  {
    void now(vtkObject* caller, unsigned long, void*)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  } stop;
  probe->AddObserver(vtkCommand::ProgressEvent, &stop, &Stop::now);
  probe->Update();
  EXPECT_FALSE(probe->GetOutput()->GetPointData()->HasArray("Velocity"));
}

}
