// One frame: what is in the picture, and what is refused.

#include "TestSurfaces.h"

#include "render/PngFile.h"
#include "render/SurfaceMeasures.h"
#include "solver/Errors.h"

#include "vtkAppendPolyData.h"
#include "vtkReverseSense.h"

#include <gtest/gtest.h>
#include <limits>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

constexpr std::size_t many_colors = 500;
constexpr double shows = 3e-4; // of all pixels: a word of text
const Rgb white{ 255, 255, 255 };

PictureSettings small()
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  return settings;
}

vtkSmartPointer<vtkImageData> drawn(
  const PictureSettings& settings, vtkPolyData* surface, std::optional<double> time = {})
{
  Picture picture(settings);
  picture.draw(surface, time);
  return picture.image();
}

std::string refusal(const PictureSettings& settings, vtkPolyData* surface)
{
  return message_of<InputError>([&] { Picture(settings).draw(surface); });
}

}

TEST(Picture, ShowsTheSurfaceOnABackground)
{
  const auto image = drawn(PictureSettings{}, make_surface());
  EXPECT_EQ(size_of(image), (std::array{ 1280, 720 }));
  const auto colors = colors_of(image);
  EXPECT_TRUE(colors.contains(white));
  EXPECT_GT(colors.size(), many_colors);
  EXPECT_EQ(pixel(image, 5, 360), white);
  EXPECT_NE(pixel(image, 550, 360), white); // the centroid, left of the middle for the colour bar
}

TEST(Picture, ColorsFollowTheArray)
{
  PictureSettings settings = small();
  settings.color_bar = false;
  const auto surface = make_surface();
  const auto curvature = drawn(settings, surface);
  settings.color = "Tension";
  EXPECT_GT(difference(curvature, drawn(settings, surface)), 0.1);
}

TEST(Picture, ColdIsLowAndWarmIsHigh)
{
  PictureSettings settings = small();
  settings.color = "Tension"; // runs along z, which points up; both signs
  const auto image = drawn(settings, make_surface());
  const Rgb top = pixel(image, 138, 145);
  const Rgb bottom = pixel(image, 138, 35);
  EXPECT_GT(top[0], top[2]);
  EXPECT_LT(bottom[0], bottom[2]);
}

TEST(Picture, AutoViewHasXToTheRight)
{
  const auto image = drawn(small(), make_surface()); // Mean_Curvature runs along x
  const Rgb left = pixel(image, 70, 90);
  const Rgb right = pixel(image, 205, 90);
  EXPECT_GT(left[2], left[0]);
  EXPECT_GT(right[0], right[2]);
}

TEST(Picture, AVectorIsColoredByItsMagnitude)
{
  PictureSettings settings = small();
  settings.color = "Velocity";
  Picture picture(settings);
  picture.draw(make_surface());
  EXPECT_GE(picture.color_range()[0], 0);
  EXPECT_GT(colors_of(picture.image()).size(), many_colors);
}

TEST(Picture, ValuesOutsideTheRangeKeepTheEndsColors)
{
  PictureSettings settings = small();
  settings.range = Range{ 100, 200 };
  Picture picture(settings);
  picture.draw(make_surface());
  EXPECT_EQ(picture.color_range(), (Range{ 100, 200 }));
  const Rgb center = pixel(picture.image(), 138, 90);
  EXPECT_GT(center[2], center[0]);
}

TEST(Picture, TheFrameIsLeftAsItWas)
{
  const auto surface = make_surface();
  const auto before = surface->GetMTime();
  drawn(small(), surface);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(surface->GetMTime(), before);
}

TEST(Picture, EachExtraShows)
{
  const auto surface = make_surface();
  const auto plain = drawn(small(), surface);
  for (auto extra : { &PictureSettings::edges, &PictureSettings::arrows, &PictureSettings::smooth })
  {
    PictureSettings settings = small();
    settings.*extra = true;
    EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  }
  PictureSettings settings = small();
  settings.title = "A title";
  EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  EXPECT_GT(difference(plain, drawn(small(), surface, 1.5)), shows);
  settings = small();
  settings.guides = { { "up", { { { 0, 0, -1 }, { 0, 0, 1 } } }, {} } };
  EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  settings.smooth = settings.edges = true;
  EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  for (const char* view : { "side", "y", "top", "iso" })
  {
    settings = small();
    settings.view = view;
    EXPECT_GT(difference(plain, drawn(settings, surface)), shows) << view;
  }
}

TEST(Picture, TheCameraFollowsTheCentroid)
{
  Picture picture(small());
  Framing framing;
  framing.include(make_surface(), View::named("auto"));
  picture.set_framing(framing);
  picture.draw(make_surface(0));
  const auto at_origin = picture.image();
  const double scale = picture.camera_scale();
  picture.draw(make_surface(3));
  const Point3 focus = picture.camera_focus();
  EXPECT_NEAR(focus[0], 3, 1e-6);
  EXPECT_NEAR(focus[1], 0, 1e-6);
  EXPECT_NEAR(focus[2], 6, 1e-6);
  EXPECT_EQ(picture.camera_scale(), scale);
  EXPECT_LT(difference(at_origin, picture.image()), 0.01);
}

TEST(Picture, SmallUnitsLookAlike)
{
  PictureSettings settings = small();
  settings.color = "Tension";
  const auto surface = make_surface();
  const auto large = drawn(settings, surface);
  const double micrometre = 1e-6;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    surface->GetPoints()->SetPoint(i, micrometre * x[0], micrometre * x[1], micrometre * x[2]);
  }
  surface->GetPoints()->Modified();
  EXPECT_LT(difference(large, drawn(settings, surface)), 0.01);
}

TEST(Picture, AMissingArrayIsAnErrorThatListsTheOthers)
{
  PictureSettings settings = small();
  settings.color = "Pressure";
  const auto message = refusal(settings, make_surface());
  for (const char* word : { "Pressure", "Mean_Curvature", "Tension", "Velocity" })
  {
    EXPECT_NE(message.find(word), std::string::npos) << message;
  }
}

TEST(Picture, ANonFiniteValueIsAnErrorThatNamesThePoint)
{
  const auto surface = make_surface();
  surface->GetPointData()
    ->GetArray("Mean_Curvature")
    ->SetComponent(17, 0, std::numeric_limits<double>::quiet_NaN());
  const auto message = refusal(small(), surface);
  EXPECT_NE(message.find("not finite at point 17"), std::string::npos) << message;
}

TEST(Picture, SlowFlowIsDrawnAsLongAsFast)
{
  PictureSettings settings = small();
  settings.arrows = true;
  Picture picture(settings);
  const auto fast = make_surface(), slow = make_surface();
  vtkDataArray* velocity = slow->GetPointData()->GetArray("Velocity");
  for (vtkIdType i = 0; i < velocity->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      velocity->SetComponent(i, k, 0.01 * velocity->GetComponent(i, k));
    }
  }
  const auto region = [](vtkImageData* a, vtkImageData* b) { return difference(a, b, 0.4, 1); };
  picture.draw(fast);
  const auto of_fast = picture.image();
  picture.draw(slow);
  EXPECT_LT(region(of_fast, picture.image()), shows); // the label is in the left part
  EXPECT_GT(difference(of_fast, picture.image()), 0);
  // Unless it is slower than what is worth showing.
  picture.set_least_arrow_speed(1);
  picture.draw(slow);
  EXPECT_GT(region(of_fast, picture.image()), 10 * shows);
}

TEST(Picture, TheChartShowsHowFarTimeHasCome)
{
  PictureSettings settings = small();
  settings.size = { 640, 360 };
  settings.chart = ChartSpec{};
  settings.chart->lines.push_back({ "", { 0, 1, 2 }, { 0, 1, 4 } });
  Picture picture(settings);
  const auto surface = make_surface();
  picture.draw(surface, 0.5);
  const auto early = picture.image();
  picture.draw(surface, 1.5);
  const auto late = picture.image();
  EXPECT_GT(difference(early, late, 0.7, 1), 0);
  const Rgb full{ 0, 114, 178 }; // the first line's colour, where time has passed
  const auto count = [&](vtkImageData* image)
  {
    int pixels = 0;
    for (int x = 403; x < 640; ++x)
    {
      for (int y = 0; y < 360; ++y)
      {
        pixels += pixel(image, x, y) == full;
      }
    }
    return pixels;
  };
  EXPECT_GT(count(late), count(early));
  EXPECT_GT(count(early), 0);
}

TEST(Picture, SmoothNeedsAClosedMesh)
{
  vtkNew<vtkSphereSource> bowl;
  bowl->SetStartPhi(90);
  bowl->Update();
  const vtkSmartPointer<vtkPolyData> surface = bowl->GetOutput();
  vtkNew<vtkDoubleArray> values;
  values->SetName("Mean_Curvature");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i));
  }
  surface->GetPointData()->AddArray(values);
  PictureSettings settings = small();
  settings.smooth = true;
  EXPECT_NE(refusal(settings, surface).find("closed"), std::string::npos);
}

TEST(Picture, ArrowsNeedAVelocity)
{
  const auto surface = make_surface();
  surface->GetPointData()->RemoveArray("Velocity");
  PictureSettings settings = small();
  settings.arrows = true;
  EXPECT_NE(refusal(settings, surface).find("Velocity"), std::string::npos);
}

TEST(Picture, ImpossibleSettingsAreErrors)
{
  const auto surface = make_surface();
  PictureSettings settings = small();
  settings.size = { 0, 720 };
  EXPECT_NE(refusal(settings, surface).find("size"), std::string::npos);
  settings = small();
  settings.range = Range{ 2, 2 };
  EXPECT_NE(refusal(settings, surface).find("range"), std::string::npos);
  settings = small();
  settings.view = "above";
  EXPECT_NE(refusal(settings, surface).find("above"), std::string::npos);
  EXPECT_NE(refusal(small(), vtkNew<vtkPolyData>()), "");
}

// A speck inside makes it a surface of two pieces, which is drawn with its inner side.
TEST(Picture, TheInnerSideOfABodyIsNeverSeen)
{
  const auto surface = make_surface();
  vtkNew<vtkAppendPolyData> with_speck;
  const auto speck = make_surface();
  for (vtkIdType i = 0; i < speck->GetNumberOfPoints(); ++i)
  {
    speck->GetPoints()->SetPoint(
      i, 0.01 * speck->GetPoint(i)[0], 0.01 * speck->GetPoint(i)[1], 0.01 * speck->GetPoint(i)[2]);
  }
  with_speck->AddInputData(surface);
  vtkNew<vtkReverseSense> inside_out; // so that nothing is known of what is seen
  inside_out->SetInputData(speck);
  inside_out->Update();
  with_speck->AddInputData(inside_out->GetOutput());
  with_speck->Update();
  ASSERT_TRUE(hides_its_inside(surface));
  ASSERT_FALSE(hides_its_inside(with_speck->GetOutput()));
  PictureSettings settings;
  settings.range = Range{ 0, 2 };
  const auto image = drawn(settings, surface);
  // Where the outline cuts a pixel, a sample may fall to either side.
  EXPECT_LT(difference(image, drawn(settings, with_speck->GetOutput())), 1e-4);
}

TEST(PngFile, HoldsEveryPixel)
{
  const TemporaryFolder folder;
  PictureSettings settings;
  settings.size = { 321, 181 };
  for (const auto& image : { drawn(settings, make_surface()), drawn(small(), make_surface(0, -1)) })
  {
    write_png(folder / "picture.png", image);
    const auto read = read_png(folder / "picture.png");
    ASSERT_EQ(size_of(read), size_of(image));
    EXPECT_EQ(difference(read, image), 0);
  }
}

TEST(PngFile, ReportsAFullDiskAndAMissingFolder)
{
  const auto image = drawn(small(), make_surface());
  for (const char* file : { "/dev/full", "/nonexistent/picture.png" })
  {
    const auto message = message_of<IoError>([&] { write_png(file, image); });
    EXPECT_NE(message.find(file), std::string::npos) << message;
  }
}
