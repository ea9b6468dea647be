// vesicle render: pictures, a film, a figure of a series or of meshes.

#include "apps/Commands.h"
#include "apps/HtmlPage.h"
#include "apps/Progress.h"
#include "apps/RunBeside.h"
#include "apps/RunMovie.h"
#include "apps/RunPlots.h"

#include "render/CrossSection.h"
#include "render/Model.h"
#include "render/Montage.h"
#include "render/Movie.h"
#include "render/SceneGuides.h"
#include "render/SmoothSurface.h"
#include "render/SurfaceMeasures.h"
#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneNames.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVesicleCurvatureFilter.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <memory>

namespace vesicle
{
namespace
{

using std::filesystem::path;

struct RenderOptions
{
  std::vector<std::string> inputs;
  std::string folder;
  std::string mp4;
  std::string montage;
  std::string html;
  std::string model;
  std::string section;
  int panels = 3;
  std::vector<double> times; ///< of the montage
  std::vector<double> range;
  std::string size;
  std::string title;
  Scene::Movie movie;
};

std::array<int, 2> parse_size(const std::string& text)
{
  std::array<int, 2> size{};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = separated ? std::from_chars(width.ptr + 1, end, size[1]) : width;
  if (!separated || height.ec != std::errc() || height.ptr != end || size[0] < 1 || size[1] < 1)
  {
    throw InputError(
      fmt::format("--size {}: give width and height in pixels, as in 1280x720", text));
  }
  return size;
}

/// What there is to draw.
struct Subject
{
  std::vector<SeriesFrame> frames;
  bool timed = true; ///< false: meshes, which have a number instead of a time
  RunBeside run;

  std::vector<double> times() const
  {
    std::vector<double> all;
    for (const auto& frame : frames)
    {
      all.push_back(frame.time);
    }
    return all;
  }
};

Subject subject_of(const std::vector<std::string>& inputs)
{
  Subject subject;
  for (const path input : inputs)
  {
    if (is_series(input))
    {
      const auto series = read_series(input);
      subject.frames.insert(subject.frames.end(), series.begin(), series.end());
      continue;
    }
    require_mesh_ending(input);
    subject.frames.push_back({ static_cast<double>(subject.frames.size()), input });
    subject.timed = false;
  }
  if (inputs.size() == 1 && subject.timed)
  {
    subject.run = run_beside(inputs[0]);
  }
  return subject;
}

/// With its curvature, should the array to show be missing.
vtkSmartPointer<vtkPolyData> surface_of(const path& file, const std::string& color)
{
  const auto surface = read_mesh(file);
  if (surface->GetPointData()->HasArray(color.c_str()))
  {
    return surface;
  }
  const VtkMessages quiet;
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

std::optional<ChartSpec> chart_of(const std::string& name, const RunBeside& run)
{
  if (name == "none")
  {
    return std::nullopt;
  }
  if (!run.table)
  {
    throw InputError(
      "--chart takes the table of diagnostics that a run leaves beside its series (<name>.csv)");
  }
  const auto chart = run_chart(name, *run.table);
  if (!chart)
  {
    throw InputError(fmt::format("--chart {}: the run's table has nothing to show of it", name));
  }
  return chart;
}

MovieSettings settings_of(const RenderOptions& options, const Subject& subject)
{
  MovieSettings settings = movie_settings(options.movie);
  PictureSettings& picture = settings.picture;
  if (!options.range.empty())
  {
    picture.range = { options.range[0], options.range[1] };
  }
  if (!options.size.empty())
  {
    picture.size = parse_size(options.size);
  }
  picture.title = options.title;
  if (subject.run.scene)
  {
    picture.guides = scene_guides(*subject.run.scene, View::named(picture.view));
    if (picture.flow_lines)
    {
      picture.field = field_of(*subject.run.scene);
    }
  }
  return settings;
}

void draw_movie(const RenderOptions& options, const Subject& subject)
{
  MovieSettings settings = settings_of(options, subject);
  settings.picture.chart = chart_of(options.movie.chart, subject.run);
  settings.directory = options.folder;
  if (!options.mp4.empty())
  {
    settings.mp4 = options.mp4;
  }
  Progress progress(false, 0, {});
  settings.progress = [&](int done, int total) { progress.count("frame", done, total); };
  const auto report = make_movie([&](int i)
    { return surface_of(subject.frames[static_cast<std::size_t>(i)].file, options.movie.color); },
    subject.times(), settings);
  if (!report.note.empty())
  {
    progress.say(report.note);
  }
}

/// The frames that a figure shows: those nearest to --times, or --panels of them.
std::vector<int> frames_of_figure(const RenderOptions& options, const Subject& subject)
{
  const auto all_times = subject.times();
  return !options.times.empty() ? nearest_frames(all_times, options.times)
    : subject.timed             ? spread_frames(all_times, options.panels)
                                : spread_frames(all_times, static_cast<int>(all_times.size()));
}

void draw_montage(const RenderOptions& options, const Subject& subject)
{
  const auto chosen = frames_of_figure(options, subject);
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<double> times;
  for (const int i : chosen)
  {
    const auto& frame = subject.frames[static_cast<std::size_t>(i)];
    surfaces.push_back(surface_of(frame.file, options.movie.color));
    if (subject.timed)
    {
      times.push_back(frame.time);
    }
  }
  MontageSettings settings{ settings_of(options, subject).picture, {} };
  if (!options.size.empty())
  {
    settings.size = settings.picture.size;
  }
  write_montage(options.montage, surfaces, times, settings);
}

/// The page's name of a view.
std::string page_view(const std::string& view)
{
  return view == "side" || view == "yz" || view == "x" ? "side"
    : view == "top" || view == "xy" || view == "z"     ? "top"
    : view == "iso" || view == "isometric"             ? "iso"
                                                       : "front";
}

/// What --chart asks for, or else what the run is about.
std::string chart_subject(const std::string& chart, const RunBeside& run)
{
  if (chart != "none")
  {
    chart_of(chart, run); // says what is wrong
    return chart;
  }
  const bool flows = run.scene && run.scene->flow;
  const bool rises = run.scene && run.scene->gravity;
  return flows ? "inclination" : rises ? "velocity" : "energy";
}

void write_page(const RenderOptions& options, const Subject& subject)
{
  HtmlPage page;
  page.title = !options.title.empty() ? options.title
    : subject.run.scene               ? subject.run.scene->name
                                      : path(options.inputs[0]).stem().string();
  page.color = options.movie.color;
  page.view = page_view(options.movie.view);
  page.range = settings_of(options, subject).picture.range;
  page.smooth = options.movie.smooth;
  page.times = subject.times();
  page.timed = subject.timed;
  if (options.movie.chart != "none" || subject.run.table)
  {
    const auto chart = chart_subject(options.movie.chart, subject.run);
    page.table = subject.run.table;
    if (page.table)
    {
      page.table = page.table->by_vesicle().front();
    }
    page.chart = chart_columns(chart, *page.table);
  }
  page.frames = [&](int i)
  { return surface_of(subject.frames[static_cast<std::size_t>(i)].file, options.movie.color); };
  write_html_page(options.html, page);
}

void draw_section(const RenderOptions& options, const Subject& subject)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<CrossSection> sections;
  SmoothSurface smooth;
  for (const int i : frames_of_figure(options, subject))
  {
    const auto& frame = subject.frames[static_cast<std::size_t>(i)];
    const auto surface = triangulated(read_mesh(frame.file).Get());
    surfaces.push_back(options.movie.smooth ? smooth.refine(surface, {}).surface : surface);
    sections.push_back({ frame.time, surfaces.back() });
  }
  const View view = View::named(options.movie.view);
  ChartSpec chart = section_chart(sections, view, options.movie.camera == "follow");
  if (!options.title.empty())
  {
    chart.title = options.title;
  }
  constexpr std::array<int, 2> size{ 1000, 800 };
  write_chart(options.section, chart, options.size.empty() ? size : parse_size(options.size));
}

constexpr const char *gltf = ".gltf", *usd = ".usda";

/// The frames that a model has: a glTF file the last one, or that nearest to --times.
std::vector<SeriesFrame> frames_of_model(const RenderOptions& options, const Subject& subject)
{
  std::vector<SeriesFrame> frames = subject.frames;
  if (!options.times.empty())
  {
    frames.clear();
    for (const int i : nearest_frames(subject.times(), options.times))
    {
      frames.push_back(subject.frames[static_cast<std::size_t>(i)]);
    }
  }
  return path(options.model).extension() == gltf ? std::vector{ frames.back() } : frames;
}

void write_model(const RenderOptions& options, const Subject& subject)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  SmoothSurface smooth;
  for (const SeriesFrame& frame : frames_of_model(options, subject))
  {
    auto surface = triangulated(surface_of(frame.file, options.movie.color).Get());
    surfaces.push_back(
      options.movie.smooth ? smooth.refine(surface, { options.movie.color }).surface : surface);
  }
  const ColorScale scale =
    color_scale(surfaces, options.movie.color, settings_of(options, subject).picture.range);
  std::vector<Model> models;
  for (vtkPolyData* surface : surfaces)
  {
    models.push_back(model_of(surface, options.movie.color, scale));
  }
  const path file = options.model;
  replace_file(file,
    file.extension() == gltf ? gltf_text(models.front(), file.stem().string())
                             : usd_text(models, file.stem().string()));
}

void require_model_ending(const path& file)
{
  if (!file.empty() && file.extension() != gltf && file.extension() != usd)
  {
    throw InputError(
      fmt::format("{}: --model writes glTF (.gltf) and USD as text (.usda)", file.string()));
  }
}

/// Films, figures and pages have one format each: another ending would promise another.
void require_ending(const path& file, const char* ending, const char* what)
{
  if (!file.empty() && file.extension() != ending)
  {
    throw InputError(fmt::format("{}: {} that end in {}", file.string(), what, ending));
  }
}

int draw(const RenderOptions& options)
{
  spdlog::set_level(spdlog::level::warn);
  if (options.folder.empty() && options.montage.empty() && options.html.empty() &&
    options.model.empty() && options.section.empty())
  {
    throw InputError(
      "render: say what to write: pictures with -o FOLDER, a figure with --montage FILE, "
      "outlines with --section FILE, a page with --html FILE, a model with --model FILE");
  }
  require_ending(options.mp4, ".mp4", "--mp4 writes films");
  require_ending(options.montage, ".png", "--montage writes pictures");
  require_ending(options.html, ".html", "--html writes pages");
  require_model_ending(options.model);
  if (path(options.section).extension() != ".svg")
  {
    require_ending(options.section, ".png", "--section writes .svg files and pictures");
  }
  if (options.folder.empty() && (options.movie.flow_lines || options.movie.markers > 0))
  {
    throw InputError(
      "--flow-lines and --markers are in pictures and films: give a folder for them with -o");
  }
  if (options.folder.empty() && !options.mp4.empty())
  {
    throw InputError("--mp4 is made of pictures: give a folder for them with -o");
  }
  const Subject subject = subject_of(options.inputs);
  if (!options.montage.empty())
  {
    draw_montage(options, subject);
  }
  if (!options.html.empty())
  {
    write_page(options, subject);
  }
  if (!options.section.empty())
  {
    draw_section(options, subject);
  }
  if (!options.model.empty())
  {
    write_model(options, subject);
  }
  if (!options.folder.empty())
  {
    draw_movie(options, subject);
  }
  return exit_code::done;
}

void add_look_options(CLI::App& command, RenderOptions& options)
{
  Scene::Movie& movie = options.movie;
  command
    .add_option("--color", movie.color,
      "Point array to show; curvatures and the bending force are computed where missing")
    ->capture_default_str();
  command.add_option("--range", options.range, "Smallest and largest value of the colours")
    ->expected(2);
  command.add_option(
    "--size", options.size, "WIDTHxHEIGHT in pixels; pictures: 1280x720 if left out");
  command
    .add_option("--view", movie.view, "From where: front (xz), side (yz), top (xy), iso, x, y, z")
    ->check(CLI::IsMember(view_names))
    ->capture_default_str();
  command.add_option("--camera", movie.camera, "Follows the vesicle, or stays where it is")
    ->check(CLI::IsMember(camera_names))
    ->capture_default_str();
  command.add_flag("--smooth", movie.smooth, "Show the Loop surface through the points");
  command.add_flag("--arrows", movie.arrows, "Show the flow of lipids along the membrane");
  command.add_flag("--flow-lines", movie.flow_lines,
    "Show the flow of the fluid, in the plane through the middle (pictures and films)");
  command
    .add_option("--markers", movie.markers,
      "Dots on each vesicle that the membrane carries along (pictures and films)")
    ->check(CLI::Range(0, 1000))
    ->capture_default_str();
  command.add_flag("--edges", movie.edges, "Show the mesh");
  command.add_option("--chart", movie.chart, "At the side, against time, from the run's table")
    ->check(CLI::IsMember(chart_names))
    ->capture_default_str();
  command.add_option("--title", options.title, "Top left");
}

}

void add_render_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<RenderOptions>();
  auto* command =
    app.add_subcommand("render", "Pictures, a film or a figure of a series or of meshes");
  command->add_option("input", options->inputs, "Series (.pvd .vtu.series) or meshes, a frame each")
    ->required();
  command->add_option("-o,--output", options->folder, "Folder for a picture of each frame");
  command->add_option("--mp4", options->mp4, "Film to write (takes the program ffmpeg)");
  command->add_option(
    "--montage", options->montage, "Figure (.png) to write: several shapes in one");
  command->add_option("--html", options->html,
    "Page to write, one file for any browser: surface, colours, time, diagnostics");
  command->add_option("--section", options->section,
    "Figure (.png, .svg) to write: outlines in the plane that --view looks at, about their "
    "centroids "
    "unless --camera is fixed");
  command->add_option("--model", options->model,
    "Model to write, for other programs' pictures: glTF (.gltf; the last frame) or USD (.usda; all "
    "frames)");
  auto* panels =
    command
      ->add_option("--panels", options->panels, "Shapes of a montage or section, evenly in time")
      ->check(CLI::Range(1, 60))
      ->capture_default_str();
  command
    ->add_option("--times", options->times, "Times of the shapes of a montage, a section, a model")
    ->excludes(panels);
  add_look_options(*command, *options);
  command->footer(
    "Example: vesicle render pear/pear.pvd -o pictures --color Tension --mp4 pear.mp4\n"
    "Example: vesicle render pear/pear.pvd --montage pear.png --smooth\n"
    "Example: vesicle render pear/pear.pvd --html pear.html\n"
    "Example: vesicle render pear/pear.pvd --model pear.usda --smooth");
  command->callback([options, &action] { action = [options] { return draw(*options); }; });
}

}
