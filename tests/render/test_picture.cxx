// One frame: what is in the picture, and what is refused.

#include "TestSurfaces.h"

#include "render/PngFile.h"
#include "solver/Errors.h"

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
  settings.color = "Tension"; // runs along z, which points up
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
  for (auto extra :
    { &PictureSettings::edges, &PictureSettings::arrows, &PictureSettings::smooth_outline })
  {
    PictureSettings settings = small();
    settings.*extra = true;
    EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  }
  PictureSettings settings = small();
  settings.title = "A title";
  EXPECT_GT(difference(plain, drawn(settings, surface)), shows);
  EXPECT_GT(difference(plain, drawn(small(), surface, 1.5)), shows);
  for (const char* view : { "x", "y", "z", "isometric" })
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
  const auto surface = make_surface();
  const auto large = drawn(small(), surface);
  const double micrometre = 1e-6;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    surface->GetPoints()->SetPoint(i, micrometre * x[0], micrometre * x[1], micrometre * x[2]);
  }
  surface->GetPoints()->Modified();
  EXPECT_LT(difference(large, drawn(small(), surface)), 0.01);
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

TEST(PngFile, ReportsAFullDiskAndAMissingFolder)
{
  const auto image = drawn(small(), make_surface());
  for (const char* file : { "/dev/full", "/nonexistent/picture.png" })
  {
    const auto message = message_of<IoError>([&] { write_png(file, image); });
    EXPECT_NE(message.find(file), std::string::npos) << message;
  }
}
