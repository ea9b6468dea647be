// Filters on surfaces of several vesicles.

#include "solver/mesh/JoinedMesh.h"
#include "solver/simulation/Simulation.h"
#include "tests/solver/support/TestMeshes.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/SceneNumbers.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleStepper.h"

#include <gtest/gtest.h>

#include <string>

namespace vesicle::test
{
namespace
{

const std::string scene_text = R"(
[[vesicle]]
shape = "prolate"
reduced_volume = 0.9
triangles = 80
center = [0, 0, 2]
[[vesicle]]
shape = "sphere"
triangles = 120
center = [0, 0, -2]
[vesicle.fluid]
viscosity_ratio = 2
[membrane]
bending_rigidity = 1
[gravity]
bond_number = 5
[time]
end = 0.1
output_every = 0.05
)";

TriangleMesh sphere_at(const Vector3& center, double radius, int triangles)
{
  TriangleMesh mesh = smooth_sphere(triangles);
  mesh.points = radius * mesh.points;
  mesh.points.rowwise() += center.transpose();
  return mesh;
}

/// Points and triangles of two spheres, each second one of the other sphere as far as they go.
vtkSmartPointer<vtkPolyData> mixed_spheres()
{
  const TriangleMesh two =
    joined({ sphere_at({ -1.5, 0, 0 }, 1, 320), sphere_at({ 1.5, 0, 0 }, 0.8, 320) });
  const auto n = two.points.rows() / 2, m = two.triangles.rows() / 2;
  TriangleMesh mixed = two;
  for (Eigen::Index i = 0; i < n; ++i)
    for (int s = 0; s < 2; ++s)
      mixed.points.row(2 * i + s) = two.points.row(i + s * n);
  for (Eigen::Index t = 0; t < m; ++t)
    for (int s = 0; s < 2; ++s)
      mixed.triangles.row(2 * t + s) =
        (2 * (two.triangles.row(t + s * m).array() - static_cast<int>(s * n)) + s).matrix();
  return to_polydata(mixed);
}

Points array(vtkPolyData* surface, const char* name)
{
  vtkDataArray* found = surface->GetPointData()->GetArray(name);
  EXPECT_NE(found, nullptr) << name;
  Points values = Points::Zero(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; found && i < values.rows(); ++i)
    found->GetTuple(i, values.row(i).data());
  return values;
}

Points probed(vtkPolyData* source, const Points& at)
{
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(to_vtk_points(at));
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(cloud);
  probe->SetSourceData(source);
  probe->Update();
  return array(vtkPolyData::SafeDownCast(probe->GetOutput()), "Velocity");
}

/// One of the vesicles of a surface, with its forces.
vtkSmartPointer<vtkPolyData> alone(vtkPolyData* surface, const std::vector<int>& points)
{
  auto part = to_polydata(part_with(to_mesh(surface), points));
  part->GetPointData()->AddArray(
    to_array("Membrane_Force", array(surface, "Membrane_Force")(points, Eigen::all)));
  part->GetFieldData()->ShallowCopy(surface->GetFieldData());
  part->GetFieldData()->RemoveArray("Viscosity_Ratio");
  return part;
}

}

TEST(SeveralVesicles, ForcesStayWithTheirPointsAndTriangles)
{
  vtkNew<vtkVesicleForceFilter> filter;
  const auto input = mixed_spheres();
  filter->SetInputData(input);
  filter->SetBendingRigidity(0);
  filter->SetFlowKind(2); // shear
  filter->SetFlowRate(1);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_EQ(to_mesh(output).triangles, to_mesh(input).triangles);
  vtkDataArray* ids = output->GetPointData()->GetArray("Vesicle_Id");
  ASSERT_TRUE(ids);
  const Points normals = array(output, "Normals"), points = to_mesh(output).points;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(ids->GetComponent(i, 0), i % 2);
    const Vector3 center(i % 2 == 0 ? -1.5 : 1.5, 0, 0);
    const Vector3 out = (points.row(i).transpose() - center).normalized();
    EXPECT_GT(normals.row(i).dot(out.transpose()), 0.99);
  }
  vtkDataArray* volume = output->GetFieldData()->GetArray("Volume");
  ASSERT_EQ(volume->GetNumberOfTuples(), 2);
  EXPECT_NEAR(volume->GetComponent(1, 0) / volume->GetComponent(0, 0), 0.512, 1e-6);
}

// With one viscosity the velocity is the sum of what each membrane's forces make.
TEST(SeveralVesicles, FlowIsTheSumOfEachOnes)
{
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(mixed_spheres());
  filter->SetBondNumber(3);
  filter->Update();
  vtkPolyData* both = filter->GetOutput();
  both->GetPointData()->RemoveArray("Gravity_Force"); // which alone() leaves out
  Points at(4, 3);
  at << 0, 0, 0, -1.5, 0.2, 0.1, 1.4, 0, 0.3, 0, 2, 1;
  Points sum = Points::Zero(4, 3);
  for (const std::vector<int>& points : vesicle_points(both))
    sum += probed(alone(both, points), at);
  const Points velocity = probed(both, at);
  EXPECT_GT(velocity.norm(), 1e-3);
  EXPECT_LT((velocity - sum).norm(), 1e-12 * velocity.norm());
}

// At the membranes the probe's velocity is theirs, from inside and from outside, whatever the ratios.
TEST(SeveralVesicles, FlowIsContinuousWhereFluidsDiffer)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneText(scene_text.c_str());
  stepper->Update();
  vtkPolyData* surface = stepper->GetOutput();
  const Points points = to_mesh(surface).points, normals = array(surface, "Normals"),
               velocity = array(surface, "Velocity");
  const double speed = velocity.rowwise().norm().maxCoeff();
  for (const double side : { -1e-3, 1e-3 })
  {
    const Points there = probed(surface, points + side * normals);
    // A coarse mesh's error of the velocity; a vesicle left out or a wrong ratio makes some 10%.
    EXPECT_LT((there - velocity).rowwise().norm().maxCoeff(), 0.03 * speed) << side;
  }
}

TEST(SeveralVesicles, StepperGivesOneSurfaceWithIds)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneText(scene_text.c_str());
  stepper->UpdateTimeStep(0.03); // between two steps
  vtkPolyData* output = stepper->GetOutput();
  EXPECT_EQ(output->GetNumberOfPolys(), 200);
  vtkDataArray* ids = output->GetPointData()->GetArray("Vesicle_Id");
  ASSERT_TRUE(ids);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    EXPECT_EQ(ids->GetComponent(i, 0), output->GetPoint(i)[2] > 0 ? 0 : 1);
  EXPECT_EQ(output->GetFieldData()->GetArray("Viscosity_Ratio")->GetNumberOfTuples(), 2);
  EXPECT_EQ(output->GetFieldData()->GetArray("Viscosity_Ratio")->GetComponent(1, 0), 2);
  EXPECT_EQ(stepper->GetAllDiagnostics().size(), 2u);

  vtkNew<vtkVesicleStepper> from_input; // the same from a surface of two pieces
  from_input->SetSceneText(scene_text.c_str());
  from_input->SetInputData(to_polydata(stepper->GetSimulation()->start_mesh()));
  from_input->UpdateTimeStep(0.03);
  EXPECT_EQ(to_mesh(from_input->GetOutput()).points, to_mesh(output).points);
}

TEST(SeveralVesicles, StepperRefusesAnotherNumberOfPieces)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneText(scene_text.c_str());
  stepper->SetInputData(to_polydata(smooth_sphere(80)));
  stepper->Update();
  EXPECT_EQ(stepper->GetErrorCategory(), vtkVesicleStepper::InputFailure);
  EXPECT_NE(
    std::string(stepper->GetErrorMessage()).find("the scene has 2 vesicles"), std::string::npos)
    << stepper->GetErrorMessage();
}

}
