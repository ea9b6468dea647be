// Several shapes in one figure.

#include "TestSurfaces.h"

#include "render/Montage.h"
#include "solver/Errors.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

vtkSmartPointer<vtkImageData> drawn(int panels, const MontageSettings& settings)
{
  const TemporaryFolder folder;
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<double> times;
  for (int i = 0; i < panels; ++i)
  {
    surfaces.push_back(make_surface(2.5 * i)); // wherever they are
    times.push_back(0.5 * i);
  }
  write_montage(folder / "figure.png", surfaces, times, settings);
  return read_png(folder / "figure.png");
}

/// How often a row of pixels goes from white to something else, and where first and last.
std::vector<int> beginnings(vtkImageData* image, int y, int from, int to)
{
  std::vector<int> found;
  const Rgb white{ 255, 255, 255 };
  for (int x = from + 1; x < to; ++x)
  {
    if (pixel(image, x - 1, y) == white && pixel(image, x, y) != white)
    {
      found.push_back(x);
    }
  }
  return found;
}

MontageSettings plain()
{
  MontageSettings settings;
  settings.picture.axes = false;
  return settings;
}

}

TEST(Montage, HasAsManyShapesAsPanelsSideBySide)
{
  for (const int panels : { 1, 3, 5 })
  {
    const auto image = drawn(panels, plain());
    const auto size = size_of(image);
    const auto shapes =
      beginnings(image, size[1] / 2, 0, static_cast<int>(size[0] - 0.29 * size[1]));
    ASSERT_EQ(shapes.size(), static_cast<std::size_t>(panels));
    for (int i = 2; i < panels; ++i)
    {
      EXPECT_NEAR(shapes[i] - shapes[i - 1], shapes[1] - shapes[0], 2); // evenly
    }
  }
}

TEST(Montage, HasTheSizeAskedFor)
{
  MontageSettings settings = plain();
  settings.size = { 500, 400 };
  EXPECT_EQ(size_of(drawn(2, settings)), (std::array{ 500, 400 }));
  settings.picture.axes = true;
  settings.picture.arrows = true;
  EXPECT_EQ(size_of(drawn(8, settings)), (std::array{ 500, 400 }));
}

TEST(Montage, ErrorsSayWhatIsWrong)
{
  EXPECT_THROW(drawn(0, plain()), InputError);
  MontageSettings settings = plain();
  settings.size = { 30, 20 };
  EXPECT_THROW(drawn(40, settings), InputError);
  settings = plain();
  settings.picture.color = "Pressure";
  EXPECT_NE(
    message_of<InputError>([&] { drawn(1, settings); }).find("Pressure"), std::string::npos);
}

TEST(Frames, AreSpreadEvenlyInTime)
{
  const std::vector<double> times{ 0, 0.1, 0.2, 1, 2 };
  EXPECT_EQ(spread_frames(times, 3), (std::vector{ 0, 3, 4 }));
  EXPECT_EQ(spread_frames(times, 1), (std::vector{ 4 }));
  EXPECT_EQ(spread_frames({ 1, 2 }, 5), (std::vector{ 0, 1 }));
  EXPECT_TRUE(spread_frames({}, 3).empty());
  EXPECT_EQ(nearest_frames(times, { 1.9, 0.14 }), (std::vector{ 4, 1 }));
}
