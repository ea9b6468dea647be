#pragma once
// Surfaces and pictures for the rendering tests, which all run without an X server.

#include "render/Picture.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <unistd.h>

namespace vesicle::test
{

inline const int no_display = unsetenv("DISPLAY");

/// An ellipsoid about (shift, 0, 2 shift) with made-up fields: Mean_Curvature runs along x,
/// Tension along z (times strength), Velocity turns about y.
inline vtkSmartPointer<vtkPolyData> make_surface(double shift = 0, double strength = 1)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(20);
  sphere->SetRadius(1);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(sphere->GetOutput());
  surface->GetPointData()->Initialize();
  vtkNew<vtkDoubleArray> curvature;
  vtkNew<vtkDoubleArray> tension;
  vtkNew<vtkDoubleArray> velocity;
  curvature->SetName("Mean_Curvature");
  tension->SetName("Tension");
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x;
    surface->GetPoint(i, x.data());
    x[0] *= 1.5;
    curvature->InsertNextValue(strength * (1 + 0.5 * x[0]));
    tension->InsertNextValue(strength * x[2]);
    velocity->InsertNextTuple3(x[2], 0, 1 - x[0]);
    surface->GetPoints()->SetPoint(i, x[0] + shift, x[1], x[2] + 2 * shift);
  }
  surface->GetPointData()->AddArray(curvature);
  surface->GetPointData()->AddArray(tension);
  surface->GetPointData()->AddArray(velocity);
  return surface;
}

inline vtkSmartPointer<vtkImageData> read_png(const std::filesystem::path& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

using Rgb = std::array<int, 3>;

inline Rgb pixel(vtkImageData* image, int x, int y)
{
  Rgb color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<int>(image->GetScalarComponentAsDouble(x, y, 0, i));
  }
  return color;
}

inline std::array<int, 2> size_of(vtkImageData* image)
{
  return { image->GetDimensions()[0], image->GetDimensions()[1] };
}

inline std::set<Rgb> colors_of(vtkImageData* image)
{
  std::set<Rgb> colors;
  const auto size = size_of(image);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      colors.insert(pixel(image, x, y));
    }
  }
  return colors;
}

/// Share of the pixels that differ, between two shares of the width.
inline double difference(vtkImageData* a, vtkImageData* b, double from = 0, double to = 1)
{
  const auto size = size_of(a);
  int different = 0;
  int all = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = static_cast<int>(from * size[0]); x < static_cast<int>(to * size[0]); ++x)
    {
      different += pixel(a, x, y) != pixel(b, x, y);
      ++all;
    }
  }
  return static_cast<double>(different) / all;
}

/// The message of the Error that work throws; empty when it throws nothing.
template<typename Error, typename Work>
std::string message_of(Work&& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

}
