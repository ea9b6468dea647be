// Grids, composite data and pieces of surfaces: the numbers of the same surface as vtkPolyData, and an
// error for what is no surface.

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDoubleArray.h"
#include "vtkExtractPolyDataPiece.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleMeshReader.h"
#include "vtkVesicleMeshWriter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleSeriesWriter.h"
#include "vtkVesicleStepper.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

namespace vesicle::test
{
namespace
{

/// A triaxial body, so that curvatures differ from point to point. Its coordinates fit into single
/// precision wherever it is, which vtkExtractPolyDataPiece has.
TriangleMesh body(double x = 0)
{
  TriangleMesh mesh = geodesic_sphere(6);
  mesh.points *= Eigen::DiagonalMatrix<double, 3>(1.2, 1, .9);
  constexpr double fraction = 1 << 16;
  mesh.points = (fraction * mesh.points).array().round() / fraction;
  mesh.points.col(0).array() += x;
  return mesh;
}

vtkSmartPointer<vtkPolyData> surface(double x = 0)
{
  return to_polydata(body(x));
}

vtkSmartPointer<vtkPolyData> both()
{
  TriangleMesh mesh = body();
  const TriangleMesh other = body(4);
  const auto points = mesh.points.rows(), triangles = mesh.triangles.rows();
  mesh.points.conservativeResize(2 * points, 3);
  mesh.points.bottomRows(points) = other.points;
  mesh.triangles.conservativeResize(2 * triangles, 3);
  mesh.triangles.bottomRows(triangles) = other.triangles.array() + static_cast<int>(points);
  return to_polydata(mesh);
}

/// Two bodies: one as vtkPolyData, one as a grid, and a block that isn't there.
vtkSmartPointer<vtkMultiBlockDataSet> blocks()
{
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  all->SetNumberOfBlocks(3);
  all->SetBlock(0, surface());
  all->SetBlock(2, to_unstructured_grid(surface(4)));
  return all;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> collection()
{
  auto all = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  all->SetNumberOfPartitionedDataSets(2);
  all->SetPartition(0, 0, surface());
  all->SetPartition(1, 0, to_unstructured_grid(surface(4)));
  return all;
}

vtkPolyData* updated(vtkAlgorithm* filter)
{
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

void expect_same(vtkPolyData* a, vtkPolyData* b, const char* name, double tolerance)
{
  ASSERT_TRUE(a && b);
  vtkDataArray *of_a = a->GetPointData()->GetArray(name), *of_b = b->GetPointData()->GetArray(name);
  ASSERT_TRUE(of_a && of_b) << name;
  ASSERT_EQ(of_a->GetNumberOfTuples(), of_b->GetNumberOfTuples());
  for (vtkIdType i = 0; i < of_a->GetNumberOfTuples(); ++i)
    for (int c = 0; c < of_a->GetNumberOfComponents(); ++c)
      EXPECT_NEAR(of_a->GetComponent(i, c), of_b->GetComponent(i, c), tolerance) << name << i;
}

using Place = std::array<double, 3>;

/// Mean curvature at each place, but for points that only ghost cells use.
void add_curvatures(vtkPolyData* piece, std::map<Place, double>& to)
{
  const auto own = without_ghosts(piece);
  const TriangleMesh mesh = to_mesh(own);
  vtkDataArray* H = own->GetPointData()->GetArray("Mean_Curvature");
  ASSERT_TRUE(H);
  for (const int i : mesh.triangles.reshaped())
  {
    const Place place{ mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2) };
    const double value = H->GetComponent(i, 0);
    EXPECT_NEAR(to.try_emplace(place, value).first->second, value, 1e-13);
  }
}

}

TEST(Blocks, AGridHasTheCurvaturesOfItsSurface)
{
  vtkNew<vtkVesicleCurvatureFilter> of_surface, of_grid;
  of_surface->SetInputData(surface());
  of_grid->SetInputDataObject(to_unstructured_grid(surface()));
  for (const char* name : { "Mean_Curvature", "Bending_Force" })
    expect_same(updated(of_surface), updated(of_grid), name, 0);
}

TEST(Blocks, EachHasItsOwnCurvatures)
{
  vtkNew<vtkVesicleCurvatureFilter> single;
  single->SetInputData(surface());
  vtkPolyData* expected = updated(single);
  for (vtkDataObject* input : std::vector<vtkSmartPointer<vtkDataObject>>{ blocks(), collection() })
  {
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetInputDataObject(input);
    filter->Update();
    auto* output = vtkCompositeDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_TRUE(output);
    auto block = vtk::TakeSmartPointer(output->NewIterator());
    int count = 0;
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem(), ++count)
      expect_same(vtkPolyData::SafeDownCast(block->GetCurrentDataObject()), expected,
        "Mean_Curvature", 1e-12);
    EXPECT_EQ(count, 2);
  }
}

TEST(Blocks, TogetherAreVesiclesInOneFluid)
{
  const auto forces = [](vtkDataObject* input)
  {
    auto filter = vtkSmartPointer<vtkVesicleForceFilter>::New();
    filter->SetBondNumber(5);
    filter->SetInputDataObject(input);
    return filter;
  };
  const auto expected = forces(both()), of_blocks = forces(blocks()),
             of_collection = forces(collection());
  for (const char* name : { "Velocity", "Tension", "Vesicle_Id" })
  {
    expect_same(updated(of_blocks), updated(expected), name, 1e-10);
    expect_same(updated(of_collection), updated(expected), name, 1e-10);
  }
}

TEST(Blocks, OfAStartShapeAreStepped)
{
  const auto stepper_of = [](vtkDataObject* input)
  {
    auto stepper = vtkSmartPointer<vtkVesicleStepper>::New();
    stepper->SetBondNumber(5);
    stepper->SetOutputEvery(.01);
    stepper->SetInputDataObject(input);
    stepper->UpdateTimeStep(.01);
    return stepper;
  };
  const auto expected = stepper_of(both()), of_blocks = stepper_of(blocks());
  for (const char* name : { "Velocity", "Vesicle_Id" })
    expect_same(vtkPolyData::SafeDownCast(of_blocks->GetOutputDataObject(0)),
      vtkPolyData::SafeDownCast(expected->GetOutputDataObject(0)), name, 1e-10);
}

TEST(Blocks, AreTheSourceOfAProbe)
{
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetBondNumber(5);
  forces->SetInputDataObject(blocks());
  vtkPolyData* all = updated(forces);
  vtkNew<vtkMultiBlockDataSet> one_block;
  one_block->SetBlock(0, all);
  vtkNew<vtkImageData> places;
  places->SetDimensions(4, 3, 2);
  places->SetOrigin(-2, 1.5, 0);
  vtkNew<vtkVesicleProbeFilter> probe, of_blocks;
  for (vtkVesicleProbeFilter* filter : { probe.Get(), of_blocks.Get() })
    filter->SetInputData(places);
  probe->SetSourceData(all);
  of_blocks->SetSourceData(one_block);
  probe->Update();
  of_blocks->Update();
  vtkDataArray* velocity = vtkDataSet::SafeDownCast(of_blocks->GetOutputDataObject(0))
                             ->GetPointData()
                             ->GetArray("Velocity");
  ASSERT_TRUE(velocity);
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(velocity->GetComponent(i, c),
        probe->GetOutput()->GetPointData()->GetArray("Velocity")->GetComponent(i, c), 1e-12);
}

TEST(Blocks, ThatArePartsOfOneSurfaceAreJoined)
{
  vtkNew<vtkExtractPolyDataPiece> extract;
  extract->SetInputData(surface());
  vtkNew<vtkPartitionedDataSet> parts;
  for (int piece = 0; piece < 3; ++piece)
  {
    extract->UpdatePiece(piece, 3, 1); // with ghost cells
    vtkNew<vtkPolyData> part;
    part->DeepCopy(extract->GetOutput());
    parts->SetPartition(piece, part);
  }
  const auto whole = membrane_of(parts, "input");
  EXPECT_EQ(whole->GetNumberOfPoints(), surface()->GetNumberOfPoints());
  EXPECT_EQ(whole->GetNumberOfPolys(), surface()->GetNumberOfPolys());
}

TEST(Blocks, PiecesHaveTheCurvaturesOfTheWhole)
{
  for (const int scheme : { vtkVesicleCurvatureFilter::Fit, vtkVesicleCurvatureFilter::Cotan })
  {
    vtkNew<vtkVesicleCurvatureFilter> whole;
    whole->SetScheme(scheme);
    whole->SetInputData(surface());
    std::map<Place, double> expected, found;
    add_curvatures(updated(whole), expected);
    vtkNew<vtkExtractPolyDataPiece> extract;
    extract->SetInputData(surface());
    vtkNew<vtkVesicleCurvatureFilter> filter;
    filter->SetScheme(scheme);
    filter->SetInputConnection(extract->GetOutputPort());
    for (int piece = 0; piece < 2; ++piece)
    {
      filter->UpdatePiece(piece, 2, 0);
      add_curvatures(filter->GetOutput(), found);
    }
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [place, H] : expected)
      EXPECT_NEAR(found.at(place), H, 1e-12);
  }
}

// Whatever is local to a piece: a vesicle moves as a whole.
TEST(Blocks, OneOfThePiecesHasTheWholeVesicle)
{
  vtkNew<vtkExtractPolyDataPiece> extract;
  extract->SetInputData(surface());
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputConnection(extract->GetOutputPort());
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), surface()->GetNumberOfPoints());
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Blocks, WhatIsNoSurfaceIsRefused)
{
  const TemporaryFolder folder;
  vtkNew<vtkVesicleCurvatureFilter> curvature;
  vtkNew<vtkVesicleForceFilter> forces;
  vtkNew<vtkVesicleStepper> stepper;
  vtkNew<vtkVesicleProbeFilter> probe;
  vtkNew<vtkVesicleMeshWriter> mesh_writer;
  vtkNew<vtkVesicleSeriesWriter> series_writer;
  stepper->SetOutputEvery(1);
  mesh_writer->SetFileName((folder / "mesh.ply").c_str());
  series_writer->SetFileName((folder / "series.pvd").c_str());
  probe->SetSourceData(surface());
  vtkNew<vtkTable> table;
  vtkNew<vtkImageData> image;
  for (vtkDataObject* block : std::initializer_list<vtkDataObject*>{ table, image })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, block);
    for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{
           curvature, forces, stepper, probe, mesh_writer, series_writer })
    {
      filter->SetInputDataObject(blocks);
      const VtkMessages messages;
      filter->Update();
      EXPECT_NE(messages.first_error(), "") << filter->GetClassName();
    }
  }
}

TEST(Blocks, NoneAtAllIsRefused)
{
  vtkNew<vtkVesicleForceFilter> forces;
  forces->SetInputDataObject(vtkNew<vtkMultiBlockDataSet>());
  const VtkMessages messages;
  forces->Update();
  EXPECT_NE(messages.first_error().find("no blocks"), std::string::npos) << messages.first_error();
}

TEST(Blocks, AreWrittenAsOneMesh)
{
  const TemporaryFolder folder;
  vtkNew<vtkVesicleMeshWriter> writer;
  writer->SetFileName((folder / "mesh.ply").c_str());
  writer->SetInputDataObject(blocks());
  writer->Write();
  vtkNew<vtkVesicleMeshReader> reader;
  reader->SetFileName((folder / "mesh.ply").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), both()->GetNumberOfPolys());
}

}
