// Vesicles in flows of VTK's files. Linear interpolation has no error where the flow is linear: there a
// field is the flow itself.

#include "vtkfilters/Filters/VelocityFieldFile.h"

#include "tests/support/TemporaryFolder.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDataSetWriter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleSource.h"
#include "vtkVesicleStepper.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>
#include <type_traits>

namespace vesicle::test
{
namespace
{

using std::filesystem::path;
using Velocity = std::function<Vector3(const Vector3&)>;

Vector3 shear(const Vector3& x)
{
  return { 2 * x.z(), 0, 0 };
}

vtkNew<vtkDoubleArray> vectors(vtkDataSet* at, const Velocity& u)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("U");
  array->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
    array->InsertNextTuple(u(Vector3(at->GetPoint(i))).data());
  return array;
}

/// From −4 to 4 in each direction.
vtkNew<vtkImageData> image(const Velocity& u, int cells = 5)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(-4, -4, -4);
  const double spacing = 8. / cells;
  image->SetSpacing(spacing, spacing, spacing);
  image->GetPointData()->AddArray(vectors(image, u));
  return image;
}

template<class Writer>
path written(vtkDataSet* data, const path& file)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->Write();
  return file;
}

path image_file(const TemporaryFolder& folder, const Velocity& u, const std::string& name = "u.vti")
{
  return written<vtkXMLImageDataWriter>(image(u), folder.path() / name);
}

std::string scene_text(const std::string& flow)
{
  return "[vesicle]\nshape = \"prolate\"\nreduced_volume = 0.95\ntriangles = 80\n"
         "[membrane]\nbending_rigidity = 1.0\n[flow]\n" +
    flow + "\n[time]\nend = 0.5\noutput_every = 0.5\n";
}

Points end_in(const std::string& flow)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneText(scene_text(flow).c_str());
  stepper->UpdateTimeStep(0.5);
  return to_mesh(stepper->GetOutput()).points;
}

std::string field_of(const path& file)
{
  return "kind = \"field\"\nfile = \"" + file.string() + "\"";
}

double largest_difference(const Points& a, const Points& b)
{
  return a.rows() == b.rows() ? (a - b).rowwise().norm().maxCoeff()
                              : std::numeric_limits<double>::infinity();
}

// Up to what rounding makes of linear solves that end at 1e-7.
constexpr double solved = 1e-7;

TEST(VelocityField, OfAShearIsTheShear)
{
  const TemporaryFolder folder;
  const Points exact = end_in("kind = \"shear\"\nrate = 2");
  EXPECT_LT(largest_difference(end_in(field_of(image_file(folder, shear))), exact), solved);
  // Tetrahedra, in both kinds of file.
  vtkNew<vtkDataSetTriangleFilter> cut;
  const auto cells = image(shear);
  cut->SetInputData(cells);
  cut->Update();
  const path xml = written<vtkXMLUnstructuredGridWriter>(cut->GetOutput(), folder.path() / "u.vtu");
  EXPECT_LT(largest_difference(end_in(field_of(xml)), exact), solved);
  const path legacy = written<vtkDataSetWriter>(cut->GetOutput(), folder.path() / "u.vtk");
  EXPECT_LT(largest_difference(end_in(field_of(legacy)), exact), 1e-6); // written with 6 digits
}

/// The box −4 to 4 as one cell of six faces.
vtkNew<vtkUnstructuredGrid> polyhedron(const Velocity& u)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
    points->InsertNextPoint(8 * (i & 1) - 4, 4 * (i & 2) - 4, 2 * (i & 4) - 4);
  grid->SetPoints(points);
  vtkNew<vtkIdList> faces;
  const std::vector<vtkIdType> numbers{ 6, 4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4, 2, 6, 7,
    3, 4, 0, 4, 6, 2, 4, 1, 3, 7, 5 };
  for (const vtkIdType number : numbers)
    faces->InsertNextId(number);
  grid->InsertNextCell(VTK_POLYHEDRON, faces);
  grid->GetPointData()->AddArray(vectors(grid, u));
  return grid;
}

/// The image with the places of its points written down.
template<class Grid>
vtkNew<Grid> spelt_out(vtkImageData* image)
{
  vtkNew<Grid> grid;
  grid->SetDimensions(image->GetDimensions());
  if constexpr (std::is_same_v<Grid, vtkRectilinearGrid>)
  {
    vtkNew<vtkFloatArray> along;
    for (int i = 0; i < image->GetDimensions()[0]; ++i)
      along->InsertNextValue(static_cast<float>(image->GetPoint(i)[0]));
    grid->SetXCoordinates(along);
    grid->SetYCoordinates(along);
    grid->SetZCoordinates(along);
  }
  else
  {
    vtkNew<vtkPoints> points;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      points->InsertNextPoint(image->GetPoint(i));
    grid->SetPoints(points);
  }
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  return grid;
}

double largest_error(const path& file)
{
  std::string notes;
  const auto field = read_velocity_field(file, notes);
  const Points at = 3.9 * Points::Random(50, 3);
  const Points u = field->velocities(at, 0);
  double largest = 0;
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    largest = std::max(largest, (u.row(i).transpose() - shear(at.row(i).transpose())).norm());
  return largest;
}

// Floats of 4 and 8/5 are exact to 1e-7; legacy files in text have six digits.
TEST(VelocityField, OfEveryKindOfGridAndFileIsTheSame)
{
  const TemporaryFolder folder;
  const auto box = image(shear);
  const auto in_file = [&](const char* name) { return folder.path() / name; };
  const auto rectilinear = spelt_out<vtkRectilinearGrid>(box);
  const auto structured = spelt_out<vtkStructuredGrid>(box);
  EXPECT_LT(largest_error(written<vtkXMLImageDataWriter>(box, in_file("u.vti"))), 1e-12);
  EXPECT_LT(
    largest_error(written<vtkXMLRectilinearGridWriter>(rectilinear, in_file("u.vtr"))), 1e-5);
  EXPECT_LT(largest_error(written<vtkXMLStructuredGridWriter>(structured, in_file("u.vts"))), 1e-5);
  EXPECT_LT(
    largest_error(written<vtkXMLUnstructuredGridWriter>(polyhedron(shear), in_file("u.vtu"))),
    1e-5);
  EXPECT_LT(largest_error(written<vtkDataSetWriter>(box, in_file("image.vtk"))), 1e-4);
  EXPECT_LT(largest_error(written<vtkDataSetWriter>(rectilinear, in_file("r.vtk"))), 1e-4);
  EXPECT_LT(largest_error(written<vtkDataSetWriter>(structured, in_file("s.vtk"))), 1e-4);

  // Axes that are turned, and numbers that don't begin at 0.
  vtkNew<vtkImageData> turned;
  turned->SetExtent(-2, 3, 1, 6, 0, 5);
  turned->SetSpacing(1.6, 1.6, 1.6);
  turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  turned->SetOrigin(5.6, -0.8, -4);
  turned->GetPointData()->AddArray(vectors(turned, shear));
  EXPECT_LT(largest_error(written<vtkXMLImageDataWriter>(turned, in_file("turned.vti"))), 1e-12);
}

TEST(VelocityField, HasTheRateOfItsGradient)
{
  const TemporaryFolder folder;
  std::string notes;
  EXPECT_NEAR(read_velocity_field(image_file(folder, shear), notes)->largest_rate(), 2, 1e-12);
  EXPECT_EQ(notes, "");
}

TEST(VelocityField, OfCellsIsBroughtToThePoints)
{
  const TemporaryFolder folder;
  const auto cells = image([](const Vector3&) { return Vector3(1, 2, 3); });
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    velocity->InsertNextTuple3(1, 2, 3);
  cells->GetPointData()->Initialize();
  cells->GetCellData()->AddArray(velocity);
  std::string notes;
  const auto field =
    read_velocity_field(written<vtkXMLImageDataWriter>(cells, folder.path() / "c.vti"), notes);
  EXPECT_LT((field->velocities(Points::Random(9, 3), 0).rowwise() - Eigen::RowVector3d(1, 2, 3))
              .rowwise()
              .norm()
              .maxCoeff(),
    1e-12);
}

path series_file(const TemporaryFolder& folder)
{
  std::vector<SeriesFrame> frames;
  for (const double time : { 0.1, 0.3 })
  {
    const std::string name = time < 0.2 ? "a.vti" : "b.vti";
    const double factor = time < 0.2 ? 1 : -3;
    image_file(
      folder, [=](const Vector3& x) -> Vector3 { return factor * shear(x); }, name);
    frames.push_back({ time, name });
  }
  const path file = folder.path() / "u.pvd";
  std::ofstream(file) << pvd_text(frames);
  return file;
}

// Linear between the files' times, constant before and after: what a history says, too.
TEST(VelocityField, OfASeriesFollowsItsTimes)
{
  const TemporaryFolder folder;
  const Points exact = end_in("kind = \"shear\"\nrate = 2\nhistory = [[0.1, 1], [0.3, -3]]");
  EXPECT_LT(largest_difference(end_in(field_of(series_file(folder))), exact), solved);
}

TEST(VelocityField, CanHaveAHistoryToo)
{
  const TemporaryFolder folder;
  const std::string history = "\nhistory = [[0, 1], [0.2, 1], [0.2, 0]]";
  const Points exact = end_in("kind = \"shear\"\nrate = 2" + history);
  EXPECT_LT(
    largest_difference(end_in(field_of(image_file(folder, shear)) + history), exact), solved);
}

TEST(VelocityField, IsAPropertyOfTheFilters)
{
  const TemporaryFolder folder;
  const path file = image_file(folder, shear);
  vtkNew<vtkVesicleSource> source;
  source->SetTriangles(80);
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetBendingRigidity(0);
  filter->IncompressibleOff();
  filter->SetFlowKind(vtkVesicleForceFilter::VelocityField);
  filter->SetFlowFile(file.c_str());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_GT(output->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double u[3];
    output->GetPointData()->GetArray("Velocity")->GetTuple(i, u);
    EXPECT_LT((Vector3(u) - shear(Vector3(output->GetPoint(i)))).norm(), 1e-9);
  }
}

TEST(VelocityField, LeftIsToldWithThePlace)
{
  const TemporaryFolder folder;
  const path file = image_file(folder, [](const Vector3&) { return Vector3(20, 0, 0); });
  const VtkMessages messages;
  end_in(field_of(file));
  EXPECT_NE(
    messages.first_error().find("isn't in the velocity field " + file.string()), std::string::npos)
    << messages.first_error();
}

TEST(VelocityField, TellsWhatDoesNotConserveVolume)
{
  const TemporaryFolder folder;
  std::string notes;
  read_velocity_field(image_file(folder, [](const Vector3& x) -> Vector3 { return x; }), notes);
  EXPECT_NE(notes.find("divergence"), std::string::npos) << notes;
}

std::string refusal(const path& file)
{
  std::string notes;
  try
  {
    read_velocity_field(file, notes);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(VelocityField, RefusesWhatIsNone)
{
  const TemporaryFolder folder;
  EXPECT_NE(refusal(folder.path() / "none.vti").find("can't be read"), std::string::npos);
  EXPECT_NE(
    refusal(folder.path() / "u.png").find("no file of a velocity field"), std::string::npos);
  const path file = image_file(folder, shear);
  const std::string whole = read_file(file);
  std::ofstream(folder.path() / "cut.vti") << whole.substr(0, whole.size() / 2);
  EXPECT_NE(refusal(folder.path() / "cut.vti"), "");
  auto two = image(shear);
  vtkNew<vtkDoubleArray> other;
  other->DeepCopy(two->GetPointData()->GetArray(0));
  other->SetName("W");
  two->GetPointData()->AddArray(other);
  const std::string which = refusal(written<vtkXMLImageDataWriter>(two, folder.path() / "two.vti"));
  EXPECT_NE(which.find("U, W"), std::string::npos) << which;
  two->GetPointData()->SetActiveVectors("W");
  EXPECT_EQ(refusal(written<vtkXMLImageDataWriter>(two, folder.path() / "two.vti")), "");
  auto bad = image(shear);
  bad->GetPointData()->GetArray(0)->SetComponent(7, 1, std::nan(""));
  EXPECT_NE(refusal(written<vtkXMLImageDataWriter>(bad, folder.path() / "nan.vti")).find("point 7"),
    std::string::npos);
}

// VTK's own readers follow them: into memory that isn't theirs.
TEST(VelocityField, NumbersOfAFileAreCheckedBeforeTheyAreFollowed)
{
  const TemporaryFolder folder;
  const auto changed = [&](const path& file, const std::string& from, const std::string& to)
  {
    std::string text = read_file(file);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    std::ofstream(file) << text;
    return refusal(file);
  };
  const auto grid = [&]
  {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(polyhedron(shear));
    writer->SetDataModeToAscii();
    writer->SetFileName((folder.path() / "u.vtu").c_str());
    writer->Write();
    return folder.path() / "u.vtu";
  };
  EXPECT_NE(changed(grid(), "6 7\n", "6 900000000\n").find("900000000"), std::string::npos);
  EXPECT_NE(
    changed(grid(), "6 4 0 2 3 1", "6 4 0 2 3 8").find("that there isn't"), std::string::npos);
  EXPECT_NE(changed(grid(), "6 4 0 2 3 1", "6 900 0 2 3 1").find("faces"), std::string::npos);
  EXPECT_NE(
    changed(grid(), "\n          42\n", "\n          70\n").find("type 70"), std::string::npos);
  const auto extents = image_file(folder, shear);
  EXPECT_NE(
    changed(extents, "Piece Extent=\"0 5 0 5 0 5\"", "Piece Extent=\"0 9 0 5 0 5\"").find("'U'"),
    std::string::npos);
}

// By the second input.
vtkNew<vtkVesicleSource> prolate()
{
  vtkNew<vtkVesicleSource> shape;
  shape->SetShape(vtkVesicleSource::Prolate);
  shape->SetReducedVolume(0.9);
  shape->SetTriangles(80);
  return shape;
}

vtkSmartPointer<vtkPolyData> prolate_data()
{
  const auto shape = prolate();
  shape->Update();
  return shape->GetOutput();
}

Points points_of(vtkPolyData* surface)
{
  return to_mesh(surface).points;
}

TEST(VelocityField, OfAPipelineIsThatOfThePropertiesToo)
{
  const auto shape = prolate();
  vtkNew<vtkVesicleStepper> in_shear, in_field;
  for (auto* stepper : { in_shear.Get(), in_field.Get() })
  {
    stepper->SetInputConnection(shape->GetOutputPort());
    stepper->SetEndTime(0.2);
    stepper->SetOutputEvery(0.1);
  }
  in_shear->SetFlowKind(vtkVesicleStepper::Shear);
  in_shear->SetFlowRate(2);
  const auto box = image(shear);
  in_field->SetVelocityFieldData(box);
  in_shear->UpdateTimeStep(0.2);
  in_field->UpdateTimeStep(0.2);
  const Points exact = points_of(in_shear->GetOutput());
  EXPECT_LT(largest_difference(points_of(in_field->GetOutput()), exact), solved);

  // Another field, and none, are other simulations.
  in_field->SetVelocityFieldData(image([](const Vector3& x) -> Vector3 { return -shear(x); }));
  in_field->UpdateTimeStep(0.2);
  EXPECT_GT(largest_difference(points_of(in_field->GetOutput()), exact), 0.01);
  in_field->SetVelocityFieldData(nullptr);
  in_field->UpdateTimeStep(0.2);
  in_shear->SetFlowKind(vtkVesicleStepper::AtRest);
  in_shear->UpdateTimeStep(0.2);
  EXPECT_EQ(points_of(in_field->GetOutput()), points_of(in_shear->GetOutput()));
}

std::string refusal(vtkDataObject* field)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetInputConnection(prolate()->GetOutputPort());
  stepper->SetVelocityFieldData(field);
  const VtkMessages messages;
  stepper->UpdateTimeStep(0.1);
  return messages.first_error();
}

TEST(VelocityField, OfAPipelineIsCheckedAsThatOfAFileIs)
{
  const auto box = image(shear);
  EXPECT_NE(refusal(prolate_data()).find("vtkPolyData"), std::string::npos);
  auto structured = spelt_out<vtkStructuredGrid>(box);
  structured->GetPoints()->Resize(7);
  structured->GetPoints()->SetNumberOfPoints(7);
  EXPECT_NE(refusal(structured).find("7 places"), std::string::npos);
  auto rectilinear = spelt_out<vtkRectilinearGrid>(box);
  rectilinear->GetYCoordinates()->SetNumberOfTuples(2);
  EXPECT_NE(refusal(rectilinear).find("2 places"), std::string::npos);
  auto cells = image(shear);
  cells->GetPointData()->Initialize();
  vtkNew<vtkDoubleArray> few;
  few->SetName("U");
  few->SetNumberOfComponents(3);
  few->InsertNextTuple3(1, 0, 0);
  cells->GetCellData()->AddArray(few);
  EXPECT_NE(refusal(cells).find("1 velocities for 125 cells"), std::string::npos);
  auto grid = polyhedron(shear);
  grid->GetFaces()->SetValue(4, 99);
  EXPECT_NE(refusal(grid).find("that there isn't"), std::string::npos);
}

// A field that is refused leaves the scene as it was.
TEST(VelocityField, OfAPipelineMayBeMended)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetSceneText(scene_text("kind = \"shear\"\nrate = 2").c_str());
  const auto box = image(shear);
  {
    const VtkMessages messages;
    stepper->SetVelocityFieldData(box);
    stepper->UpdateTimeStep(0.5);
    EXPECT_NE(messages.first_error().find("choose one"), std::string::npos)
      << messages.first_error();
  }
  stepper->SetVelocityFieldData(nullptr);
  stepper->UpdateTimeStep(0.5);
  EXPECT_EQ(points_of(stepper->GetOutput()), end_in("kind = \"shear\"\nrate = 2"));
}

TEST(VelocityField, OfAPipelineMovesForces)
{
  const auto shape = prolate();
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(shape->GetOutputPort());
  filter->SetBendingRigidity(0);
  filter->SetIncompressible(false);
  const auto box = image([](const Vector3&) { return Vector3(1, 2, 3); });
  filter->SetVelocityFieldData(box);
  filter->Update();
  vtkDataArray* velocity = filter->GetOutput()->GetPointData()->GetArray("Velocity");
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
    EXPECT_LT((Vector3(velocity->GetTuple3(i)) - Vector3(1, 2, 3)).norm(), 1e-9);
  EXPECT_EQ(filter->GetVelocityField(), box.Get());
}

TEST(VelocityField, OfAPipelineThatCanNotBeFollowedIsRefused)
{
  const auto shape = prolate();
  const auto message = [&](vtkDataObject* field, int kind)
  {
    const VtkMessages messages;
    vtkNew<vtkVesicleForceFilter> filter;
    filter->SetInputConnection(shape->GetOutputPort());
    filter->SetFlowKind(kind);
    filter->SetVelocityFieldData(field);
    filter->Update();
    return messages.first_error();
  };
  const auto expect = [](const std::string& found, const char* words)
  { EXPECT_NE(found.find(words), std::string::npos) << found; };
  expect(message(image(shear), vtkVesicleForceFilter::Shear), "choose one");
  const auto bare = image(shear);
  bare->GetPointData()->Initialize();
  expect(message(bare, vtkVesicleForceFilter::AtRest), "which of its arrays");
  const auto short_array = image(shear);
  short_array->GetPointData()->GetArray("U")->SetNumberOfTuples(5);
  expect(message(short_array, vtkVesicleForceFilter::AtRest), "velocities for");
  vtkNew<vtkImageData> empty;
  expect(message(empty, vtkVesicleForceFilter::AtRest), "no cells");
  vtkNew<vtkDataSetTriangleFilter> cut;
  const auto cells = image(shear);
  cut->SetInputData(cells);
  cut->Update();
  vtkUnstructuredGrid* grid = cut->GetOutput();
  vtkNew<vtkUnstructuredGrid> torn;
  torn->DeepCopy(grid);
  torn->GetCells()->ReplaceCellAtId(7, { 0, 1, 2, 900000000 });
  expect(message(torn, vtkVesicleForceFilter::AtRest), "cell 7");
}

}
}
