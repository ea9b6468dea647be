#pragma once
// Shapes cut by a plane: outlines to lay over each other.

#include "render/Chart.h"
#include "render/View.h"

#include <vector>

class vtkPolyData;

namespace vesicle
{

struct CrossSection
{
  double time;
  vtkPolyData* surface;
};

/// Where the plane through the centroid that the view looks at cuts a surface: lines, closed where the
/// surface is, along the view's right and up, counted from `origin`.
std::vector<ChartLine> cut(vtkPolyData* surface, const View& view, const Point3& origin);

/// All of them in one chart, each in a colour of its time: about their centroids, or where they are.
/// Throws InputError where a plane meets nothing.
ChartSpec section_chart(
  const std::vector<CrossSection>& sections, const View& view, bool about_centroids);

}
