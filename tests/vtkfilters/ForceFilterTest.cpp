#include "vtkVesicleForceFilter.h"

#include "tests/solver/support/TestMeshes.h"
#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/VtkMessages.h"
#include "solver/mesh/MeshIntegrals.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vesicle::test
{
namespace
{

vtkSmartPointer<vtkPolyData> sphere(double radius = 1, int triangles = 320)
{
  TriangleMesh mesh = smooth_sphere(triangles);
  mesh.points *= radius;
  return to_polydata(mesh);
}

vtkSmartPointer<vtkPolyData> prolate(double radius = 1)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShape(vtkVesicleSource::Prolate);
  source->SetReducedVolume(0.9);
  source->SetTriangles(320);
  source->SetRadius(radius);
  source->Update();
  return source->GetOutput();
}

Points array(vtkPolyData* surface, const char* name)
{
  vtkDataArray* found = surface->GetPointData()->GetArray(name);
  EXPECT_NE(found, nullptr) << name;
  Points values = Points::Zero(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; found && i < values.rows(); ++i)
  {
    for (int c = 0; c < found->GetNumberOfComponents(); ++c)
    {
      values(i, c) = found->GetComponent(i, c);
    }
  }
  EXPECT_TRUE(values.allFinite()) << name;
  return values;
}

double number(vtkPolyData* surface, const char* name)
{
  vtkDataArray* found = surface->GetFieldData()->GetArray(name);
  EXPECT_NE(found, nullptr) << name;
  return found ? found->GetComponent(0, 0) : NAN;
}

/// Expects the filter to refuse the input with a message that has `words`.
void expect_refused(vtkPolyData* input, const char* words)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_NE(messages.first_error().find(words), std::string::npos) << messages.first_error();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

}

// An inextensible sphere in SI units: U = 2 Δρ g R²/(9μ), γ = Δρ g R z/3.
TEST(ForceFilter, RisingSphere)
{
  const double radius = 5e-6, difference = 20, acceleration = 9.81, viscosity = 1e-3;
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(sphere(radius, 1280));
  filter->SetBendingRigidity(0);
  filter->SetDensityDifference(difference);
  filter->SetAcceleration(acceleration);
  filter->SetViscosity(viscosity);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const double speed = 2 * difference * acceleration * radius * radius / (9 * viscosity);
  const double tension = difference * acceleration * radius * radius / 3;
  const Points velocity = array(output, "Velocity"), gamma = array(output, "Tension");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT((velocity.row(i) - Eigen::RowVector3d(0, 0, speed)).norm(), 0.02 * speed);
    EXPECT_NEAR(gamma(i, 0), tension * output->GetPoint(i)[2] / radius, 0.05 * tension);
  }
  EXPECT_FALSE(output->GetPointData()->HasArray("Bending_Force"));
  EXPECT_LT((array(output, "Membrane_Force") - array(output, "Tension_Force")).norm(), 1e-20);
  // f_g = Δρ g z n, whose sum over the sphere is Δρ g V.
  const Points gravity = array(output, "Gravity_Force"), normal = array(output, "Normals");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double load = difference * acceleration * output->GetPoint(i)[2];
    EXPECT_LT(
      (gravity.row(i) - load * normal.row(i)).norm(), 0.01 * difference * acceleration * radius);
  }
}

// A sphere whose lengths have grown by λ has the tension T of either law (D. Barthès-Biesel et al.,
// J. Fluid Mech. 460 (2002) 211) and so the force −2 T/R n.
TEST(ForceFilter, ElasticSheetOfASphere)
{
  const double radius = 2, modulus = 3, dilation = 4, stretch = 1.1;
  const double neo_hookean = modulus * (1 - std::pow(stretch, -6)),
               skalak = modulus *
    (stretch * stretch - 1 + dilation * stretch * stretch * (std::pow(stretch, 4) - 1));
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetBendingRigidity(0);
  filter->SetShearModulus(modulus);
  filter->SetDilationModulus(dilation);
  filter->SetPrestretch(stretch);
  for (const auto& [law, tension] : { std::pair(vtkVesicleForceFilter::NeoHookean, neo_hookean),
         std::pair(vtkVesicleForceFilter::Skalak, skalak) })
  {
    filter->SetElasticity(law);
    const double pressure = 2 * tension / radius;
    const auto error = [&](int triangles)
    {
      filter->SetInputData(sphere(radius, triangles));
      filter->Update();
      const Points force = array(filter->GetOutput(), "Elastic_Force"),
                   normal = array(filter->GetOutput(), "Normals");
      return (force + pressure * normal).norm() / normal.norm() / pressure;
    };
    const double coarse = error(320), fine = error(1280);
    EXPECT_LT(fine, 5e-3); // that of the curvature of Loop's surface, the same for both laws
    EXPECT_LT(fine, coarse / 2);
  }
}

TEST(ForceFilter, FlowsMoveABareSurface)
{
  const auto input = prolate();
  for (int kind = vtkVesicleForceFilter::AtRest; kind <= vtkVesicleForceFilter::FourRollMill;
       ++kind)
  {
    vtkNew<vtkVesicleForceFilter> filter;
    filter->SetInputData(input);
    filter->SetPreset(vtkVesicleForceFilter::Paper); // the others keep the volume of flat triangles
    filter->SetBendingRigidity(0);
    filter->IncompressibleOff();
    filter->SetFlowKind(kind);
    filter->SetFlowRate(3);
    filter->SetFlowVelocity(0, 2, 0);
    filter->SetFlowRadius(4);
    filter->SetFlowCenter(0.5, 0, 1);
    filter->SetFlowAxis(0, 2, 0);
    filter->SetFlowType(-1);
    filter->Update();
    const Points velocity = array(filter->GetOutput(), "Velocity");
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      double p[3];
      input->GetPoint(i, p);
      const double x = p[0], y = p[1], z = p[2];
      const double profile = 1 - ((x - 0.5) * (x - 0.5) + (z - 1) * (z - 1)) / 16;
      const Eigen::RowVector3d exact[] = { { 0, 0, 0 }, { 0, 2, 0 }, { 3 * z, 0, 0 },
        { 3 * x, 0, -3 * z }, { -1.5 * x, -1.5 * y, 3 * z }, { 0, 2 * profile, 0 },
        { 3 * z, 0, -3 * x }, { 3 * z, 0, -3 * x } };
      EXPECT_LT((velocity.row(i) - exact[kind]).norm(), 1e-12) << kind;
    }
    EXPECT_EQ(number(filter->GetOutput(), "Flow_Kind"), kind);
  }
}

TEST(ForceFilter, SameCurvaturesAndBendingForceAsTheCurvatureFilter)
{
  const auto input = to_polydata(mapped(jittered_sphere(4, 0.2), perturbed_sphere));
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(input);
  filter->SetBendingRigidity(2);
  filter->SetPreset(vtkVesicleForceFilter::Fast);
  filter->Update();
  vtkNew<vtkVesicleCurvatureFilter> curvature;
  curvature->SetInputData(input);
  curvature->SetBendingRigidity(2);
  curvature->Update();
  for (const char* name :
    { "Mean_Curvature", "Gauss_Curvature", "Laplacian_Mean_Curvature", "Bending_Force" })
  {
    const Points expected = array(curvature->GetOutput(), name);
    EXPECT_LT((array(filter->GetOutput(), name) - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST(ForceFilter, UnitsDontMatter)
{
  const double length = 1e-6, energy = 1e-19, viscosity = 1e-3;
  const double time = viscosity * length * length * length / energy;
  vtkNew<vtkVesicleForceFilter> plain, si;
  plain->SetInputData(prolate());
  plain->SetFlowKind(vtkVesicleForceFilter::Shear);
  plain->SetFlowRate(2);
  plain->SetBondNumber(1);
  plain->Update();
  si->SetInputData(prolate(length));
  si->SetFlowKind(vtkVesicleForceFilter::Shear);
  si->SetFlowRate(2 / time);
  si->SetBondNumber(1);
  si->SetBendingRigidity(energy);
  si->SetViscosity(viscosity);
  si->Update();
  const auto ratio = [&](const char* name)
  { return array(si->GetOutput(), name).norm() / array(plain->GetOutput(), name).norm(); };
  EXPECT_NEAR(ratio("Velocity"), length / time, 1e-6 * length / time);
  EXPECT_NEAR(ratio("Tension"), energy / length / length, 1e-6 * energy / length / length);
  const double density = energy / length / length / length;
  for (const char* name : { "Bending_Force", "Tension_Force", "Membrane_Force", "Gravity_Force" })
  {
    EXPECT_NEAR(ratio(name), density, 1e-6 * density) << name;
  }
  EXPECT_NEAR(
    number(si->GetOutput(), "Area") / length / length, number(plain->GetOutput(), "Area"), 1e-9);
}

TEST(ForceFilter, MembraneKeepsItsAreaInEveryPreset)
{
  for (int preset = vtkVesicleForceFilter::Paper; preset <= vtkVesicleForceFilter::Accurate;
       ++preset)
  {
    vtkNew<vtkVesicleForceFilter> filter;
    filter->SetInputData(prolate());
    filter->SetPreset(preset);
    filter->SetFlowKind(vtkVesicleForceFilter::Shear);
    filter->Update();
    // The flow alone has rates of about 1. Loop's tension filter leaves an error of third order.
    EXPECT_LT(array(filter->GetOutput(), "Surface_Divergence").cwiseAbs().maxCoeff(),
      preset < vtkVesicleForceFilter::Balanced ? 1e-6 : 0.1)
      << preset;
  }
}

TEST(ForceFilter, OtherArraysPassThrough)
{
  const auto input = prolate();
  vtkNew<vtkIntArray> points, cells;
  points->SetName("points");
  cells->SetName("cells");
  for (int i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    points->InsertNextValue(i);
  }
  for (int i = 0; i < input->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(i);
  }
  input->GetPointData()->AddArray(points);
  input->GetCellData()->AddArray(cells);
  input->GetPointData()->AddArray(to_array("Tension", Eigen::VectorXd::Zero(points->GetSize())));
  input->GetPoints()->InsertNextPoint(9, 9, 9); // used by no triangle
  points->InsertNextValue(1000);
  vtkNew<vtkReverseSense> inward;
  inward->SetInputData(input);
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(inward->GetOutputPort());
  filter->IncompressibleOff();
  {
    const VtkMessages messages;
    filter->Update();
    EXPECT_NE(messages.first_warning().find("inward"), std::string::npos);
    EXPECT_FALSE(messages.any_error());
  }
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints() - 1);
  EXPECT_GT(flat_volume(to_mesh(output)), 0);
  const auto origin =
    static_cast<vtkIdType>(output->GetPointData()->GetArray("points")->GetComponent(7, 0));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(output->GetPoint(7)[c], input->GetPoint(origin)[c]);
  }
  EXPECT_EQ(output->GetCellData()->GetArray("cells")->GetComponent(7, 0), 7);
  EXPECT_FALSE(output->GetPointData()->HasArray("Tension")) << "the input's is not this scene's";
  EXPECT_FALSE(input->GetPointData()->HasArray("Velocity"));
}

TEST(ForceFilter, StripsAndSinglePrecisionAreTakenToo)
{
  const auto input = prolate();
  vtkNew<vtkTransform> identity;
  vtkNew<vtkTransformPolyDataFilter> single;
  single->SetTransform(identity);
  single->SetInputData(input);
  single->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(single->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(strips->GetOutputPort());
  filter->SetFlowKind(vtkVesicleForceFilter::Shear);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), input->GetNumberOfPolys());
  EXPECT_EQ(filter->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_LT(array(filter->GetOutput(), "Surface_Divergence").cwiseAbs().maxCoeff(), 0.1);
}

TEST(ForceFilter, RefusesWhatIsNoVesicle)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(4, 4);
  plane->Update();
  expect_refused(plane->GetOutput(), "open border");
  expect_refused(to_polydata(clifford_torus(16, 8)), "genus");
  vtkNew<vtkAppendPolyData> two;
  two->AddInputData(sphere(1));
  two->AddInputData(sphere(2));
  two->Update();
  expect_refused(two->GetOutput(), "one inside of the other");
  vtkNew<vtkPolyData> bad;
  bad->DeepCopy(sphere());
  bad->GetPoints()->SetPoint(3, NAN, 0, 0);
  expect_refused(bad, "point 3");
}

TEST(ForceFilter, EmptyInputGivesEmptyOutput)
{
  const VtkMessages messages;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(messages.any_error());
  EXPECT_NE(messages.first_warning().find("no triangles"), std::string::npos);
}

TEST(ForceFilter, RoughMeshesAreAWarningWhereTheyMatter)
{
  const auto rough = to_polydata(jittered_sphere(4, 0.25));
  for (int preset : { vtkVesicleForceFilter::Fast, vtkVesicleForceFilter::Balanced })
  {
    const VtkMessages messages;
    vtkNew<vtkVesicleForceFilter> filter;
    filter->SetInputData(rough);
    filter->SetPreset(preset);
    filter->Update();
    EXPECT_FALSE(messages.any_error()) << messages.first_error();
    EXPECT_EQ(messages.first_warning().find("rough") != std::string::npos,
      preset == vtkVesicleForceFilter::Balanced)
      << messages.first_warning();
    array(filter->GetOutput(), "Velocity"); // finite
  }
}

TEST(ForceFilter, ImpossibleSettingsAreErrors)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(sphere());
  filter->SetViscosity(0);
  filter->Update();
  EXPECT_NE(messages.first_error().find("Viscosity"), std::string::npos);
}

TEST(ForceFilter, AnElasticSheetTakesLoopsSurfaceAndALength)
{
  for (const bool flat : { true, false })
  {
    const VtkMessages messages;
    vtkNew<vtkVesicleForceFilter> filter;
    filter->SetInputData(sphere());
    filter->SetShearModulus(1);
    filter->SetPreset(flat ? vtkVesicleForceFilter::Fast : vtkVesicleForceFilter::Balanced);
    filter->SetPrestretch(flat ? 1 : 0);
    filter->Update();
    EXPECT_NE(messages.first_error().find(flat ? "ShearModulus" : "Prestretch"), std::string::npos)
      << messages.first_error();
  }
}

// A sphere λ times as large as that of the file has what a prestretch of λ makes.
TEST(ForceFilter, ASheetWithoutStressIsThatOfAFile)
{
  const double stretch = 1.1;
  const TemporaryFolder folder;
  const std::string file = folder / "relaxed.vtu";
  write_mesh(sphere(2), file);
  vtkNew<vtkVesicleForceFilter> of_file, prestretched;
  for (vtkVesicleForceFilter* filter : { of_file.Get(), prestretched.Get() })
  {
    filter->SetInputData(sphere(2 * stretch));
    filter->SetBendingRigidity(0);
    filter->SetShearModulus(3);
  }
  of_file->SetReference(vtkVesicleForceFilter::FileReference);
  of_file->SetReferenceFile(file.c_str());
  of_file->Update();
  prestretched->SetPrestretch(stretch);
  prestretched->Update();
  const Points found = array(of_file->GetOutput(), "Elastic_Force"),
               expected = array(prestretched->GetOutput(), "Elastic_Force");
  EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());

  for (const auto& [given, words] :
    { std::pair("", "ReferenceFile"), std::pair(file.c_str(), "with the start's points") })
  {
    const VtkMessages messages;
    of_file->SetInputData(sphere(2, 80));
    of_file->SetReferenceFile(given);
    of_file->Update();
    EXPECT_NE(messages.first_error().find(words), std::string::npos) << messages.first_error();
  }
}

TEST(ForceFilter, VtkSphereSourceIsTaken)
{
  vtkNew<vtkSphereSource> source; // smallest angles at its poles
  source->SetThetaResolution(24);
  source->SetPhiResolution(16);
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetPreset(vtkVesicleForceFilter::Fast);
  filter->SetFlowKind(vtkVesicleForceFilter::Uniform);
  filter->Update();
  const Points velocity = array(filter->GetOutput(), "Velocity");
  EXPECT_LT((velocity.rowwise() - Eigen::RowVector3d(1, 0, 0)).rowwise().norm().mean(), 1);
}

}
