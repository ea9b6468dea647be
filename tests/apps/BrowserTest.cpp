// The page of `vesicle render --html` in headless Chromium: what its document says and what is to
// be seen.

#include "Command.h"

#include "render/ColorMap.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

namespace vesicle::test
{
namespace
{

using std::filesystem::path;

std::optional<path> find_program(const std::string& name)
{
  std::istringstream folders(std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    if (std::filesystem::exists(path(folder) / name))
    {
      return path(folder) / name;
    }
  }
  return std::nullopt;
}

using Rgb = std::array<int, 3>;

class Picture
{
public:
  explicit Picture(const path& file)
  {
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }
  /// From the top left, as in a browser.
  Rgb at(int x, int y) const
  {
    vtkImageData* image = reader_->GetOutput();
    Rgb color;
    for (int i = 0; i < 3; ++i)
    {
      color[i] = static_cast<int>(
        image->GetScalarComponentAsDouble(x, image->GetDimensions()[1] - 1 - y, 0, i));
    }
    return color;
  }
  int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
  int height() const { return reader_->GetOutput()->GetDimensions()[1]; }

private:
  vtkNew<vtkPNGReader> reader_;
};

bool is_white(const Rgb& color)
{
  return *std::min_element(color.begin(), color.end()) > 250;
}

/// Where the surface is in a window of 1280 by 800: between the time at the left and the colour
/// bar.
struct Region
{
  int left = 140, right = 690, top = 100, bottom = 720;
};

/// Height over width of what isn't white.
double aspect_of_surface(const Picture& picture)
{
  const Region region;
  int left = region.right, right = region.left, top = region.bottom, bottom = region.top;
  for (int y = region.top; y < region.bottom; ++y)
  {
    for (int x = region.left; x < region.right; ++x)
    {
      if (!is_white(picture.at(x, y)))
      {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
  }
  return static_cast<double>(bottom - top) / (right - left);
}

std::set<Rgb> colors_of_surface(const Picture& picture)
{
  std::set<Rgb> colors;
  const Region region;
  for (int y = region.top; y < region.bottom; ++y)
  {
    for (int x = region.left; x < region.right; ++x)
    {
      colors.insert(picture.at(x, y));
    }
  }
  return colors;
}

/// Share of pixels that differ within a part of the window.
double difference(const Picture& a, const Picture& b, int from, int to)
{
  int different = 0;
  for (int y = 60; y < 740; ++y)
  {
    for (int x = from; x < to; ++x)
    {
      different += a.at(x, y) != b.at(x, y);
    }
  }
  return static_cast<double>(different) / (680 * (to - from));
}

/// A run and its page for all tests.
class Browser : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = new TemporaryFolder;
    write_scene_file(folder->path());
    run = vesicle_command(folder->path(),
      { "run", "pear.toml", "--no-movie", "--no-plots", "--quiet", "--set", "accuracy.preset=fast",
        "--set", "vesicle.triangles=320" });
    page = vesicle_command(folder->path(),
      { "render", "pear/pear.pvd", "--html", "page.html", "--title", "A <b>pear</b> & more" });
  }
  static void TearDownTestSuite() { delete folder; }
  void SetUp() override
  {
    ASSERT_EQ(run.code, 0) << run.errors;
    if (!std::filesystem::exists(VESICLE_BINARY_DIR "/share/vesicle/vtk.js"))
    {
      GTEST_SKIP() << "built without vtk.js (VESICLE_HTML): bash tests/browser.sh";
    }
    if (!find_program("chromium"))
    {
      GTEST_SKIP() << "chromium is not installed: bash tests/browser.sh";
    }
    ASSERT_EQ(page.code, 0) << page.errors;
  }

  /// Runs Chromium on the page, without a network.
  static Outcome browse(
    const std::string& wanted, const std::string& option, int milliseconds = 5000)
  {
    return program(*find_program("chromium"), folder->path(),
      { "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
        "--host-resolver-rules=MAP * ~NOTFOUND",
        "--user-data-dir=" + (*folder / "profile").string(), "--window-size=1280,800",
        "--virtual-time-budget=" + std::to_string(milliseconds), option,
        "file://" + (*folder / "page.html").string() + "#" + wanted });
  }
  static std::string document(const std::string& wanted, int milliseconds = 5000)
  {
    return browse(wanted, "--dump-dom", milliseconds).output;
  }
  static Picture screenshot(const std::string& wanted)
  {
    const path file = *folder / "screen.png";
    std::filesystem::remove(file);
    const auto outcome = browse(wanted, "--screenshot=" + file.string());
    EXPECT_TRUE(std::filesystem::exists(file)) << outcome.errors;
    return Picture(file);
  }

  inline static TemporaryFolder* folder = nullptr;
  inline static Outcome run, page;
};

bool holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

}

TEST_F(Browser, TheDocumentShowsWhatWasAskedFor)
{
  const std::string document = this->document("frame=2&array=Tension");
  // All but the scripts: that is where the words are anyway.
  const std::string visible = document.substr(0, document.find("<script"));
  EXPECT_FALSE(holds(visible, "data-error")) << visible.substr(0, 500);
  EXPECT_TRUE(holds(visible, "data-frame=\"2\"")) << visible.substr(0, 500);
  EXPECT_TRUE(holds(visible, "data-array=\"Tension\""));
  EXPECT_TRUE(holds(visible, "t = 0.2"));
  EXPECT_TRUE(holds(visible, "3 of 6"));
  EXPECT_TRUE(holds(visible, "<h1 id=\"title\">A &lt;b&gt;pear&lt;/b&gt; &amp; more</h1>"));
  for (const char* array : { "Mean_Curvature", "Gauss_Curvature", "Velocity", "Bending_Force" })
  {
    EXPECT_TRUE(holds(visible, "<option value=\"" + std::string(array) + "\"")) << array;
  }
  EXPECT_TRUE(holds(visible, "energy_over_8pi")); // a column to choose
}

TEST_F(Browser, TimeGoesOnWhenItPlays)
{
  // A round takes 5 seconds: after half of it the first frame isn't back yet.
  const std::string document = this->document("play=1", 2500);
  const std::string visible = document.substr(0, document.find("<script"));
  EXPECT_FALSE(holds(visible, "data-error")) << visible.substr(0, 500);
  EXPECT_FALSE(holds(visible, "data-frame=\"0\"")) << visible.substr(0, 500);
  EXPECT_TRUE(holds(visible, ">pause</button>"));
}

TEST_F(Browser, TheSurfaceHasItsShapeAndColors)
{
  const Picture first = screenshot("frame=0&array=Tension&view=front");
  EXPECT_EQ(first.width(), 1280);
  double bounds[6];
  read_mesh(*folder / "pear/frames/pear_000000.vtu")->GetBounds(bounds);
  const double expected = (bounds[5] - bounds[4]) / (bounds[1] - bounds[0]);
  EXPECT_NEAR(aspect_of_surface(first), expected, 0.02 * expected);
  EXPECT_GT(colors_of_surface(first).size(), 500u);

  // The bar's ends are the colour map's (a tension of one sign: sequential; of both: diverging).
  int x = 767, top = 0, bottom = 0;
  for (int y = 80; y < 745; ++y)
  {
    if (!is_white(first.at(x, y)))
    {
      top = top == 0 ? y : top;
      bottom = y;
    }
  }
  EXPECT_GT(bottom - top, 500);
  const auto table = color_table(ColorMap::sequential, 256);
  const auto diverging = color_table(ColorMap::diverging, 256);
  const auto near = [&](const Rgb& shown, const Color& color)
  {
    double largest = 0;
    for (int k = 0; k < 3; ++k)
    {
      largest = std::max(largest, std::abs(shown[k] - 255 * color[k]));
    }
    return largest < 12;
  };
  const Rgb high = first.at(x, top + 3), low = first.at(x, bottom - 3);
  EXPECT_TRUE((near(high, table.back()) && near(low, table.front())) ||
    near(high, diverging.back()) || near(low, diverging.front()))
    << high[0] << ' ' << high[1] << ' ' << high[2];

  const Picture other = screenshot("frame=0&array=Velocity&view=front");
  EXPECT_GT(difference(first, other, 140, 690), 0.05); // colours of the surface
  const Picture later = screenshot("frame=5&array=Tension&view=front");
  EXPECT_GT(difference(first, later, 140, 690), 0.05);
  EXPECT_EQ(difference(first, later, 756, 840), 0);     // the bar is the same all the time
  EXPECT_GT(difference(first, later, 860, 1260), 1e-3); // the chart shows how far time has come
}

}
