#include "vtkVesicleCurvatureFilter.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "tests/solver/support/TestMeshes.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include "vtkCommand.h"
#include "vtkCurvatures.h"
#include "vtkDiscreteFlyingEdges3D.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace vesicle::test
{
namespace
{

constexpr double radius = 2;

vtkSmartPointer<vtkPolyData> with_curvature(vtkPolyData* surface, double rigidity = 1)
{
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->SetBendingRigidity(rigidity);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> sphere()
{
  TriangleMesh mesh = geodesic_sphere(8);
  mesh.points *= radius;
  return to_polydata(mesh);
}

vtkDataArray* array(vtkPolyData* surface, const std::string& name)
{
  vtkDataArray* found = surface->GetPointData()->GetArray(name.c_str());
  EXPECT_NE(found, nullptr) << name;
  return found;
}

double value(vtkPolyData* surface, const std::string& name, vtkIdType i)
{
  return array(surface, name)->GetComponent(i, 0);
}

void expect_finite_array(vtkPolyData* surface, const char* name)
{
  vtkDataArray* values = array(surface, name);
  ASSERT_EQ(values->GetNumberOfTuples(), surface->GetNumberOfPoints()) << name;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      ASSERT_TRUE(std::isfinite(values->GetComponent(i, c))) << name << ' ' << i;
    }
  }
}

void expect_finite(vtkPolyData* surface)
{
  for (const char* name : { "Mean_Curvature", "Gauss_Curvature", "Laplacian_Mean_Curvature",
         "Normals", "Bending_Force", "Fit_Residual", "Mean_Curvature_Error" })
  {
    expect_finite_array(surface, name);
  }
}

}

TEST(CurvatureFilter, SphereHasItsCurvaturesEverywhere)
{
  const auto output = with_curvature(sphere());
  expect_finite(output);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double mean_error = value(output, "Mean_Curvature", i) * radius - 1;
    const double gauss_error = value(output, "Gauss_Curvature", i) * radius * radius - 1;
    EXPECT_LT(std::max(std::abs(mean_error), std::abs(gauss_error)), 1e-3);
    EXPECT_EQ(value(output, "Fit_Degree", i), 4);
    EXPECT_EQ(value(output, "Curvature_Valid", i), 1);
    EXPECT_EQ(value(output, "Bending_Force_Valid", i), 1);
    double point[3], normal[3];
    output->GetPoint(i, point);
    array(output, "Normals")->GetTuple(i, normal);
    EXPECT_NEAR(normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2], radius, 0.01);
  }
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(CurvatureFilter, EverySchemeFindsTheSpheresCurvature)
{
  for (const char* scheme : { "fit", "cotan", "loop" })
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetInputData(sphere());
    filter->SetSchemeByName(scheme);
    filter->Update();
    EXPECT_EQ(std::string(filter->GetSchemeName()), scheme);
    double sum = 0;
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      sum += value(filter->GetOutput(), "Mean_Curvature", i) * radius;
    }
    EXPECT_NEAR(sum / static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), 1, 0.01)
      << scheme;
  }
}

TEST(CurvatureFilter, VtkSphereSourceWorksToo)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->Update();
  const auto output = with_curvature(source->GetOutput());
  expect_finite(output);
  EXPECT_NEAR(value(output, "Mean_Curvature", output->GetNumberOfPoints() / 2), 2, 0.1);
}

TEST(CurvatureFilter, BendingForceIsProportionalToTheRigidity)
{
  const auto one = with_curvature(sphere()), three = with_curvature(sphere(), 3);
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(3 * value(one, "Bending_Force", i), value(three, "Bending_Force", i), 1e-9);
  }
}

TEST(CurvatureFilter, InwardSphereCountsAsOutwardUnlessTold)
{
  vtkNew<vtkReverseSense> inward;
  inward->SetInputData(sphere());
  inward->Update();
  EXPECT_GT(value(with_curvature(inward->GetOutput()), "Mean_Curvature", 0), 0);
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(inward->GetOutput());
  filter->OrientOutwardOff();
  filter->Update();
  EXPECT_LT(value(filter->GetOutput(), "Mean_Curvature", 0), 0);
}

TEST(CurvatureFilter, OpenPlaneOfQuadsIsMarkedAtItsBorder)
{
  vtkNew<vtkPlaneSource> plane; // quads
  plane->SetResolution(6, 6);
  plane->Update();
  const auto output = with_curvature(plane->GetOutput());
  expect_finite(output);
  EXPECT_EQ(output->GetNumberOfPolys(), 72);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const bool border = i % 7 == 0 || i % 7 == 6 || i / 7 == 0 || i / 7 == 6;
    EXPECT_EQ(value(output, "Curvature_Valid", i), border ? 0 : 1);
    EXPECT_NEAR(value(output, "Mean_Curvature", i), 0, 1e-12);
    EXPECT_NEAR(value(output, "Gauss_Curvature", i), 0, 1e-9);
  }
  const vtkIdType next_to_border = 8, center = 24;
  EXPECT_EQ(value(output, "Bending_Force_Valid", next_to_border), 0);
  EXPECT_EQ(value(output, "Bending_Force_Valid", center), 1);
}

TEST(CurvatureFilter, OtherArraysPassThrough)
{
  const auto input = sphere();
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    number->InsertNextValue(i);
  }
  input->GetPointData()->AddArray(number);
  const auto output = with_curvature(input);
  EXPECT_EQ(value(output, "number", 17), 17);
  EXPECT_FALSE(input->GetPointData()->HasArray("Mean_Curvature"));
}

TEST(CurvatureFilter, UnusedPointsAreMarked)
{
  const auto input = sphere();
  const vtkIdType unused = input->GetPoints()->InsertNextPoint(9, 9, 9);
  const auto output = with_curvature(input);
  expect_finite(output);
  EXPECT_EQ(value(output, "Curvature_Valid", unused), 0);
}

TEST(CurvatureFilter, NothingToDoIsAWarning)
{
  const VtkMessages messages;
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(with_curvature(empty)->GetNumberOfPolys(), 0);
  EXPECT_FALSE(messages.any_error());
  EXPECT_NE(messages.first_warning().find("no triangles"), std::string::npos);
}

/// What a pipeline written for vtkCurvatures does with its filter: active scalars, over the
/// vertices that both know.
template<class Filter>
std::vector<double> scalars_of(int type, bool inverted)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->SetRadius(0.5);
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  switch (type)
  {
    case VTK_CURVATURE_GAUSS:
      filter->SetCurvatureTypeToGaussian();
      break;
    case VTK_CURVATURE_MEAN:
      filter->SetCurvatureTypeToMean();
      break;
    case VTK_CURVATURE_MAXIMUM:
      filter->SetCurvatureTypeToMaximum();
      break;
    case VTK_CURVATURE_MINIMUM:
      filter->SetCurvatureTypeToMinimum();
      break;
  }
  filter->SetInvertMeanCurvature(inverted);
  filter->Update();
  vtkDataArray* scalars = filter->GetOutput()->GetPointData()->GetScalars();
  EXPECT_NE(scalars, nullptr);
  std::vector<double> values{ static_cast<double>(scalars->GetName()[2]) }; // "Ga…", "Me…", …
  for (vtkIdType i = 2; i < scalars->GetNumberOfTuples(); ++i)              // not the poles
  {
    values.push_back(scalars->GetComponent(i, 0));
  }
  return values;
}

TEST(CurvatureFilter, TakesThePlaceOfVtkCurvatures)
{
  for (const bool inverted : { false, true })
  {
    for (int type = VTK_CURVATURE_GAUSS; type <= VTK_CURVATURE_MINIMUM; ++type)
    {
      const auto ours = scalars_of<vtkVesicleCurvatureFilter>(type, inverted);
      const auto vtks = scalars_of<vtkCurvatures>(type, inverted);
      ASSERT_EQ(ours.size(), vtks.size());
      EXPECT_EQ(ours[0], vtks[0]) << "the name";
      double ours_sum = 0, vtks_sum = 0;
      for (std::size_t i = 1; i < ours.size(); ++i)
      {
        ours_sum += ours[i];
        vtks_sum += vtks[i];
      }
      EXPECT_NEAR(ours_sum / vtks_sum, 1, 0.2) << type << inverted;
    }
  }
  vtkNew<vtkVesicleCurvatureFilter> ours;
  vtkNew<vtkCurvatures> vtks;
  EXPECT_EQ(ours->GetCurvatureType(), vtks->GetCurvatureType()) << "the default";
}

// Of the spheroid 2:1:1 at its equator and tips.
TEST(CurvatureFilter, PrincipalCurvatures)
{
  const auto input = to_polydata(mapped(smooth_sphere(1280), ellipsoid_2_1_1));
  for (const int type : { VTK_CURVATURE_MAXIMUM, VTK_CURVATURE_MINIMUM })
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetInputData(input);
    filter->SetCurvatureType(type);
    filter->Update();
    vtkDataArray* scalars = filter->GetOutput()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      // x²/4 + ρ² = 1: 1/√(ρ² + x²/16) across; along, its cube over 4.
      const double x = input->GetPoint(i)[0];
      const double across = 1 / std::sqrt(1 - 3 * x * x / 16);
      const double along = across * across * across / 4;
      const double exact =
        type == VTK_CURVATURE_MAXIMUM ? std::max(across, along) : std::min(across, along);
      EXPECT_NEAR(scalars->GetComponent(i, 0), exact, 0.05);
    }
  }
}

namespace
{

vtkSmartPointer<vtkPolyData> two_spheres(double second_radius, const Vector3& centre, bool inward)
{
  const TriangleMesh ball = geodesic_sphere(8);
  TriangleMesh both{ Points(2 * ball.points.rows(), 3), Triangles(2 * ball.triangles.rows(), 3) };
  Points second = second_radius * ball.points;
  second.rowwise() += centre.transpose();
  Triangles triangles = ball.triangles.array() + static_cast<int>(ball.points.rows());
  if (inward)
  {
    triangles.col(1).swap(triangles.col(2));
  }
  both.points << radius * ball.points, second;
  both.triangles << ball.triangles, triangles;
  return to_polydata(both);
}

}

TEST(CurvatureFilter, OneBodyInsideOutCountsAsFacingOutward)
{
  const VtkMessages messages;
  const auto surface = with_curvature(two_spheres(1, Vector3(5, 0, 0), true));
  EXPECT_NEAR(value(surface, "Mean_Curvature", 0), 1 / radius, 1e-3);
  EXPECT_NEAR(value(surface, "Mean_Curvature", surface->GetNumberOfPoints() - 1), 1, 2e-3);
  EXPECT_NE(messages.first_warning().find("the body about (5, 0, 0)"), std::string::npos)
    << messages.first_warning();
}

TEST(CurvatureFilter, TheInnerSideOfAShellFacesInward)
{
  const VtkMessages messages;
  const auto surface = with_curvature(two_spheres(1, Vector3::Zero(), true));
  EXPECT_NEAR(value(surface, "Mean_Curvature", 0), 1 / radius, 1e-3);
  EXPECT_NEAR(value(surface, "Mean_Curvature", surface->GetNumberOfPoints() - 1), -1, 2e-3);
  EXPECT_NE(messages.first_warning().find("inner side of a shell"), std::string::npos)
    << messages.first_warning();
}

TEST(CurvatureFilter, IsTheSameFarFromTheOrigin)
{
  for (const int scheme : { vtkVesicleCurvatureFilter::Fit, vtkVesicleCurvatureFilter::Cotan,
         vtkVesicleCurvatureFilter::Loop })
  {
    vtkSmartPointer<vtkPolyData> near, far;
    for (const double distance : { 0., 1e6 })
    {
      TriangleMesh mesh = geodesic_sphere(8);
      mesh.points.array() += distance;
      vtkNew<vtkVesicleCurvatureFilter> filter;
      filter->SetScheme(scheme);
      filter->SetInputData(to_polydata(mesh));
      filter->Update();
      (distance > 0 ? far : near) = filter->GetOutput();
    }
    for (vtkIdType i = 0; i < near->GetNumberOfPoints(); ++i)
    {
      // Coordinates of 1e6 are rounded to 1e-10; second differences over edges of 0.15.
      EXPECT_NEAR(value(far, "Mean_Curvature", i), value(near, "Mean_Curvature", i), 1e-7);
    }
  }
}

namespace
{

constexpr int schemes[] = { vtkVesicleCurvatureFilter::Fit, vtkVesicleCurvatureFilter::Cotan,
  vtkVesicleCurvatureFilter::Loop };

/// Notes the progress and, from `stop_at` on, sets AbortExecute.
struct ProgressNotes
{
  void note(vtkObject* caller, unsigned long, void* share)
  {
    shares.push_back(*static_cast<double*>(share));
    if (shares.back() >= stop_at)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
  double stop_at = 2;
  std::vector<double> shares;
};

}

TEST(CurvatureFilter, ProgressRisesToOne)
{
  for (const int scheme : schemes)
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetScheme(scheme);
    filter->SetInputData(to_polydata(geodesic_sphere(50)));
    ProgressNotes notes;
    filter->AddObserver(vtkCommand::ProgressEvent, &notes, &ProgressNotes::note);
    filter->Update();
    EXPECT_GT(notes.shares.size(), 4U);
    EXPECT_TRUE(std::is_sorted(notes.shares.begin(), notes.shares.end())) << scheme;
    EXPECT_EQ(notes.shares.front(), 0);
    EXPECT_EQ(notes.shares.back(), 1);
  }
}

TEST(CurvatureFilter, AbortGivesNothingAndTheNextUpdateAll)
{
  const VtkMessages messages;
  for (const int scheme : schemes)
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetScheme(scheme);
    filter->SetInputData(to_polydata(geodesic_sphere(50)));
    ProgressNotes notes{ 0.2, {} };
    const auto observer =
      filter->AddObserver(vtkCommand::ProgressEvent, &notes, &ProgressNotes::note);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_LT(notes.shares.back(), scheme == vtkVesicleCurvatureFilter::Cotan ? 1 : 0.6);
    filter->RemoveObserver(observer);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 25002);
    EXPECT_NEAR(value(filter->GetOutput(), "Mean_Curvature", 7), 1, 1e-3);
  }
  EXPECT_FALSE(messages.any_error());
}

TEST(CurvatureFilter, DoesNotDependOnTheNumberOfThreads)
{
  for (const int scheme : schemes)
  {
    const auto output = [&](int threads)
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      vtkNew<vtkVesicleCurvatureFilter> filter;
      filter->SetScheme(scheme);
      filter->SetInputData(sphere());
      filter->Update();
      return vtkSmartPointer<vtkPolyData>(filter->GetOutput());
    };
    const auto one = output(1), four = output(4);
    for (int k = 0; k < one->GetPointData()->GetNumberOfArrays(); ++k)
    {
      const std::string name = one->GetPointData()->GetArrayName(k);
      for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
      {
        EXPECT_EQ(value(one, name, i), value(four, name, i)) << name;
      }
    }
  }
}

namespace
{

constexpr double ball_radius = 60; // in voxels

/// A ball as a segmented image has it, 1 inside and 0 outside, no voxel at its centre.
vtkSmartPointer<vtkImageData> ball()
{
  constexpr int half = 63, size = 2 * half + 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetOrigin(-half - 0.13, -half + 0.27, -half - 0.41);
  image->AllocateScalars(VTK_INT, 1);
  auto* mask = static_cast<int*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    mask[i] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < ball_radius * ball_radius;
  }
  return image;
}

template<class Contour>
vtkSmartPointer<vtkPolyData> contour(double value)
{
  vtkNew<Contour> filter;
  filter->SetInputData(ball());
  filter->SetValue(0, value);
  filter->Update();
  return filter->GetOutput();
}

/// Of H R, over all vertices.
struct MeanCurvatureErrors
{
  double bias = 0, deviation = 0;
};

MeanCurvatureErrors errors_of(vtkPolyData* surface)
{
  const auto count = static_cast<double>(surface->GetNumberOfPoints());
  MeanCurvatureErrors errors;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double error = value(surface, "Mean_Curvature", i) * ball_radius - 1;
    errors.bias += error / count;
    errors.deviation += error * error / count;
  }
  errors.deviation = std::sqrt(errors.deviation - errors.bias * errors.bias);
  return errors;
}

}

// Vertices half-way between voxels inside and outside are off by 0.2 voxels (evenly spread within
// half a voxel along one of three axes). Of n ≈ 680 that are independent, H of radius r deviates by
// 0.2 √48/(r² √n), a thirtieth of 1/R here.
TEST(CurvatureFilter, ABallOfVoxelsHasItsCurvatureAtALengthScale)
{
  for (const auto& surface :
    { contour<vtkFlyingEdges3D>(0.5), contour<vtkDiscreteFlyingEdges3D>(1) })
  {
    EXPECT_NEAR(static_cast<double>(surface->GetNumberOfPolys()), 135752, 200);
    const VtkMessages messages;
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetInputData(surface);
    filter->SetFitRadius(12);
    filter->BendingForceOff();
    filter->Update();
    const MeanCurvatureErrors errors = errors_of(filter->GetOutput());
    EXPECT_LT(std::abs(errors.bias), 0.02);
    EXPECT_LT(errors.deviation, 0.05);
    EXPECT_EQ(messages.first_warning(), "");
    EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("Bending_Force"));
    expect_finite_array(filter->GetOutput(), "Mean_Curvature_Error");
  }
}

TEST(CurvatureFilter, NoiseIsAWarningThatNamesARadius)
{
  const auto surface = contour<vtkFlyingEdges3D>(0.5);
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->BendingForceOff();
  const VtkMessages messages;
  filter->Update();
  EXPECT_GT(errors_of(filter->GetOutput()).deviation, 10) << "all noise";
  const std::string text = messages.first_warning();
  ASSERT_NE(text.find("--radius) of "), std::string::npos) << text;
  const double radius = std::stod(text.substr(text.find("--radius) of ") + 13));
  filter->SetFitRadius(radius);
  filter->Update();
  // The error that it names, a third more as staircases' errors aren't independent.
  EXPECT_NEAR(errors_of(filter->GetOutput()).deviation, 0.03 * 4 / 3, 0.015) << text;
  EXPECT_EQ(messages.warnings().size(), 1U) << "one, for the first";
}

TEST(CurvatureFilter, ASmoothMeshIsNoWarning)
{
  const VtkMessages messages;
  with_curvature(sphere());
  EXPECT_EQ(messages.first_warning(), "");
}

TEST(CurvatureFilter, TheRadiusInMeanEdges)
{
  vtkNew<vtkVesicleCurvatureFilter> filter;
  const TriangleMesh mesh = geodesic_sphere(16);
  filter->SetInputData(to_polydata(mesh));
  filter->SetFitRings(4);
  filter->Update();
  EXPECT_EQ(value(filter->GetOutput(), "Fit_Degree", 0), 2);
  const vtkSmartPointer<vtkPolyData> by_rings = filter->GetOutput();
  double edges = 0; // each from both sides
  for (const auto t : mesh.triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges += (mesh.points.row(t[k]) - mesh.points.row(t[(k + 1) % 3])).norm();
    }
  }
  vtkNew<vtkVesicleCurvatureFilter> by_length;
  by_length->SetInputData(to_polydata(mesh));
  by_length->SetFitRadius(4 * edges / static_cast<double>(mesh.triangles.size()));
  by_length->Update();
  for (vtkIdType i = 0; i < by_rings->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(value(by_rings, "Mean_Curvature", i),
      value(by_length->GetOutput(), "Mean_Curvature", i), 1e-9);
  }
  filter->SetFitRadius(5); // the mesh's box has half a diagonal of 1.7
  const VtkMessages messages;
  filter->Update();
  EXPECT_NE(messages.first_error().find("a fit radius of 5 is too large"), std::string::npos);
}

// On a torus the circle around the tube is the more curved one.
TEST(CurvatureFilter, PrincipalDirectionsAndShapeDescriptors)
{
  const TriangleMesh torus = test::clifford_torus(96, 64); // ρ = √2 + cos v
  for (const bool inverted : { false, true })
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetInputData(to_polydata(torus));
    filter->PrincipalCurvaturesOn();
    filter->ShapeDescriptorsOn();
    filter->SetInvertMeanCurvature(inverted);
    filter->Update();
    const auto surface = filter->GetOutput();
    const double sign = inverted ? -1 : 1;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const Vector3 x = torus.points.row(i);
      const double rho = std::hypot(x[0], x[1]), around = (rho - std::sqrt(2)) / rho;
      const char* const tube[] = { "Maximum_Curvature", "Minimum_Curvature" };
      EXPECT_NEAR(value(surface, tube[inverted], i), sign, 0.02);
      EXPECT_NEAR(value(surface, tube[!inverted], i), sign * around, 0.02);
      EXPECT_NEAR(value(surface, "Curvedness", i), std::sqrt((1 + around * around) / 2), 0.02);
      EXPECT_NEAR(value(surface, "Shape_Index", i),
        sign * 2 / std::numbers::pi * std::atan((1 + around) / (1 - around)), 0.02);
      EXPECT_NEAR(value(surface, "Willmore_Density", i), std::pow((1 + around) / 2, 2), 0.02);
      double along[3];
      array(surface, inverted ? "Maximum_Direction" : "Minimum_Direction")->GetTuple(i, along);
      const Vector3 circle = Vector3(-x[1], x[0], 0) / rho;
      EXPECT_GT(std::abs(circle.dot(Vector3(along[0], along[1], along[2]))), 0.999);
    }
  }
}

TEST(CurvatureFilter, ProgressAndAbortAtALengthScale)
{
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(to_polydata(geodesic_sphere(50)));
  filter->SetFitRadius(0.2);
  ProgressNotes notes;
  filter->AddObserver(vtkCommand::ProgressEvent, &notes, &ProgressNotes::note);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(notes.shares.begin(), notes.shares.end()));
  EXPECT_EQ(notes.shares.back(), 1);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  notes.stop_at = 0.5;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Of a square of 5 × 5 points the border is undefined.
TEST(CurvatureFilter, UndefinedIsNaNIfSoWanted)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(4, 4);
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->PrincipalCurvaturesOn();
  filter->ShapeDescriptorsOn();
  for (const bool nan : { false, true })
  {
    filter->SetUndefinedIsNaN(nan);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    for (const char* name : { "Mean_Curvature", "Gauss_Curvature", "Maximum_Curvature",
           "Maximum_Direction", "Curvedness", "Mean_Curvature_Error" })
    {
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const bool defined = value(output, "Curvature_Valid", i) == 1;
        EXPECT_EQ(std::isnan(value(output, name, i)), nan && !defined) << name << ' ' << i;
      }
    }
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const bool defined = value(output, "Bending_Force_Valid", i) == 1;
      EXPECT_EQ(std::isnan(value(output, "Bending_Force", i)), nan && !defined);
      EXPECT_EQ(std::isnan(value(output, "Laplacian_Mean_Curvature", i)), nan && !defined);
      EXPECT_FALSE(std::isnan(value(output, "Normals", i)));
    }
  }
}

TEST(CurvatureFilter, ArraysKnowUnitsAndComponents)
{
  const auto output = with_curvature(sphere());
  const auto unit = [&](const char* name)
  { return std::string(array(output, name)->GetInformation()->Get(vtkDataArray::UNITS_LABEL())); };
  EXPECT_EQ(unit("Mean_Curvature"), "1/length");
  EXPECT_EQ(unit("Gauss_Curvature"), "1/length^2");
  EXPECT_EQ(unit("Bending_Force"), "force/length^2");
  EXPECT_STREQ(array(output, "Bending_Force")->GetComponentName(0), "X");
  EXPECT_STREQ(array(output, "Normals")->GetComponentName(2), "Z");
}

}
