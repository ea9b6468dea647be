#include "apps/Run.h"

#include "apps/Attempts.h"
#include "apps/Commands.h"
#include "apps/Interrupt.h"
#include "apps/RunMovie.h"
#include "apps/RunPlots.h"
#include "apps/RunResume.h"
#include "apps/StopBundle.h"
#include "apps/Warning.h"

#include "render/RenderBackend.h"
#include "solver/Doing.h"
#include "solver/Errors.h"
#include "solver/simulation/Cost.h"
#include "solver/simulation/Simulation.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Trajectory.h"
#include "solver/state/RunRows.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fmt/format.h>

#include <sys/resource.h>

namespace vesicle
{
namespace
{

/// How many rows and frames may wait for the disk: what a kill may cost beside the step under way.
/// A disk that takes long now and then doesn't hold the run up so.
constexpr std::size_t most_waiting = 8;

/// Of this process so far, all threads together.
double cpu_seconds()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t)
  { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}

Run::Run(Scene scene, const std::filesystem::path& folder, const RunOptions& options)
  : scene_(std::move(scene)), folder_(folder, scene_.name), options_(options),
    columns_(run_columns(rows_of(scene_))), began_(std::chrono::steady_clock::now()),
    series_(folder, scene_.name), writing_(most_waiting)
{
  stepper_->SetScene(scene_);
  stepper_->SetCacheSize(1); // never goes back
  stepper_->AddObserver(vtkVesicleStepper::StepAcceptedEvent, this, &Run::on_step);
}

int Run::carry_out()
{
  watch_for_interrupts();
  require_affordable(scene_, shape_triangles(scene_), resources_for(folder_.folder()));
  const bool existing = !folder_.files().empty();
  if (existing)
  {
    require_leave_to_write();
    lock_.emplace(folder_.lock());
  }
  try
  {
    if (!existing || !options_.resume || !go_on())
    {
      start_anew();
    }
    if (options_.movie || options_.plots)
    {
      writing_.add([] { prepare_to_draw(); });
    }
    while (!stepper_->GetFinished() && !interrupted() && !is_failed())
    {
      advance();
    }
  }
  catch (const NumericalError& error)
  {
    message_ = error.what();
    return_to_last_good_state();
  }
  finish();
  return interrupted() ? exit_code::interrupted : exit_code::done;
}

void Run::require_leave_to_write() const
{
  if (!options_.resume && !options_.overwrite)
  {
    throw InputError(
      fmt::format("{}: there is a run already; go on with it by --resume, replace it by "
                  "--overwrite, or choose another folder by -o",
        folder_.folder().string()));
  }
}

/// In this order: a run that is there already is lost only once another one has begun, and what
/// follows the checkpoint can be made again from it.
void Run::start_anew()
{
  update_to(0);
  require_movie_arrays();
  take_folder();
  record();
  append_frame();
}

void Run::take_folder()
{
  make_folder(folder_.folder());
  if (!lock_)
  {
    lock_.emplace(folder_.lock());
    if (!folder_.files().empty()) // another run was quicker
    {
      require_leave_to_write();
    }
  }
  checkpoint_ = create_checkpoint();
  folder_.clear_but_checkpoint();
  table_.emplace(folder_.table(), columns_, std::vector<Row>{});
  progress_.emplace(options_.quiet, 0, scene_.time.end);
  progress_->say(to_text(stepper_->GetSimulation()->numbers()));
  if (!stepper_->GetSimulation()->notes().empty())
  {
    progress_->say(stepper_->GetSimulation()->notes());
  }
}

/// What couldn't be accepted, before going back makes it forgotten.
void Run::keep_refused()
{
  const Simulation* simulation = stepper_->GetSimulation();
  if (simulation && simulation->refused())
    failing_ = simulation->mesh(*simulation->refused());
}

/// Where no state could be reached the start shape is left, to be looked at.
void Run::return_to_last_good_state()
{
  writing_.wait();
  rows_ = checkpoint_ ? checkpoint_->rows() : 0;
  if (!stepper_->GetSimulation() || (rows_ > 0 && !table_))
  {
    throw NumericalError(rows_ > 0 ? failure_and_what_is_left() : message_); // nothing was begun
  }
  if (rows_ > 0)
  {
    failure_ = nullptr;
    stepper_->SetAbortExecute(0);
    stepper_->SetState(checkpoint_->state());
    update_to(checkpoint_->state().time);
    append_last_frame();
    return;
  }
  if (!table_)
  {
    take_folder();
  }
  const auto shape = to_polydata(stepper_->GetSimulation()->start_mesh());
  doing(
    "writing the start shape to " + series_.pvd_file().string(), [&] { series_.append(shape, 0); });
}

/// False where the run has no state yet. Nothing is touched before everything is known to fit.
bool Run::go_on()
{
  const auto file = folder_.checkpoint();
  if (!is_there(file))
  {
    throw InputError(
      file.string() + ": there is no checkpoint to go on from; start anew with --overwrite");
  }
  checkpoint_ = RunFile::open(file);
  if (checkpoint_->rows() == 0)
  {
    return false;
  }
  require_same_scene(scene_, *checkpoint_, file);
  stepper_->SetState(checkpoint_->state());
  update_to(checkpoint_->state().time);
  require_same_mesh(*stepper_->GetSimulation(), *checkpoint_, file);
  require_movie_arrays();

  const State& state = *stepper_->GetState();
  const OutputSchedule& schedule = stepper_->GetSimulation()->schedule();
  auto times = schedule.passed(state);
  // Whatever was written of the last moment before the run ended is written again.
  if (schedule.due(state))
  {
    times.pop_back();
  }
  series_.require_frames(times.size());
  first_step_ = state.step;
  resumed_ = true;

  folder_.sweep();
  table_.emplace(folder_.table(), columns_, checkpoint_->series());
  series_.keep(times, stepper_->GetOutput());
  if (schedule.due(state) || stepper_->GetFinished())
  {
    append_frame();
  }
  progress_.emplace(options_.quiet, state.time, scene_.time.end);
  progress_->say(fmt::format("going on from step {}, t = {:.6g}", state.step, state.time));
  return true;
}

void Run::advance()
{
  update_to(
    stepper_->GetSimulation()->schedule().next(*stepper_->GetState()).value_or(VTK_DOUBLE_MAX));
  append_last_frame();
}

/// After Ctrl-C or a failure too: the last state is always there.
void Run::append_last_frame()
{
  if (last_frame_time_ != stepper_->GetStateTime())
  {
    append_frame();
  }
}

void Run::update_to(double time)
{
  const VtkMessages messages; // they come back as the stepper's error
  stepper_->UpdateTimeStep(time);
  if (failure_)
  {
    std::rethrow_exception(failure_);
  }
  switch (stepper_->GetErrorCategory())
  {
    case vtkVesicleStepper::InputFailure:
      throw InputError(stepper_->GetErrorMessage());
    case vtkVesicleStepper::IoFailure:
      throw IoError(stepper_->GetErrorMessage());
    case vtkVesicleStepper::NumericalFailure:
      message_ = stepper_->GetErrorMessage();
      keep_refused();
      if (!stepper_->GetState())
      {
        throw NumericalError(fmt::format("t = 0: the start can't be solved: {}", message_));
      }
  }
}

void Run::on_step()
{
  try
  {
    record();
    progress_->step(stepper_->GetAllDiagnostics());
  }
  catch (...)
  {
    failure_ = std::current_exception();
  }
  if (failure_ || interrupted())
  {
    stepper_->SetAbortExecute(1);
  }
}

void Run::record()
{
  const State& state = *stepper_->GetState();
  const Row row = run_row(stepper_->GetAllDiagnostics());
  try
  {
    require_finite(state, columns_, row);
  }
  catch (const NumericalError& error) // not to be saved as a good state
  {
    throw NumericalError(fmt::format("t = {:.6g}: {}", state.time, error.what()));
  }
  writing_.add(
    [this, state, row]
    {
      doing("writing " + folder_.checkpoint().string(), [&] { checkpoint_->append(state, row); });
      doing("writing " + folder_.table().string(), [&] { table_->append(row); });
    });
}

void Run::append_frame()
{
  vtkNew<vtkPolyData> surface; // whose arrays stay, as each step makes new ones
  surface->ShallowCopy(stepper_->GetOutput());
  const double time = stepper_->GetStateTime();
  writing_.add(
    [this, surface = vtkSmartPointer<vtkPolyData>(surface), time]
    {
      doing(fmt::format("writing the frame at t = {:.6g} of {}", time, series_.pvd_file().string()),
        [&] { series_.append(surface, time); });
    });
  last_frame_time_ = time;
  tell_once_if_unresolved();
}

/// Of the start shape the notes tell.
void Run::tell_once_if_unresolved()
{
  const State& state = *stepper_->GetState();
  if (told_unresolved_ || state.step == 0 || is_failed())
  {
    return;
  }
  const std::string warning = stepper_->GetSimulation()->unresolved_warning(state);
  told_unresolved_ = !warning.empty();
  if (told_unresolved_)
  {
    warn(fmt::format("t = {:.6g}: {}", stepper_->GetStateTime(), warning));
  }
}

std::string Run::outcome() const
{
  if (is_failed())
  {
    return "failed";
  }
  return !stepper_->GetFinished() ? "interrupted" : scene_.time.end ? "finished" : "steady";
}

RunFile Run::create_checkpoint() const
{
  Simulation& simulation = *stepper_->GetSimulation();
  RunFile::Header header;
  header.scene = write_scene(scene_);
  header.triangles = simulation.start_triangles();
  header.length_scale = simulation.scales().length;
  header.time_scale = simulation.scales().time();
  header.energy_scale = simulation.scales().energy;
  header.viscosity = simulation.scales().viscosity;
  header.columns = columns_;
  return RunFile::create(folder_.checkpoint(), header);
}

void Run::require_movie_arrays()
{
  if (options_.movie)
  {
    require_arrays(scene_, stepper_->GetOutput());
  }
}

void Run::write_summary()
{
  doing("writing " + folder_.summary().string(),
    [&] { vesicle::write_summary(summary_, folder_.summary()); });
}

/// Of a state that a run stopped at there may be none.
void Run::estimate_errors()
{
  try
  {
    summary_.errors = stepper_->GetSimulation()->error_estimate(*stepper_->GetState());
    progress_->say(to_text(*summary_.errors));
  }
  catch (const NumericalError&)
  {
  }
}

void Run::summarize()
{
  summary_.scene = scene_;
  summary_.outcome = outcome();
  summary_.message = message_;
  if (rows_ > 0)
  {
    summary_.last = stepper_->GetAllDiagnostics();
    estimate_errors();
    summary_.steps = stepper_->GetState()->step - first_step_;
  }
  summary_.frames = series_.frames().size();
  summary_.numbers = stepper_->GetSimulation()->numbers();
  summary_.triangles = static_cast<int>(stepper_->GetSimulation()->start_mesh().triangles.rows());
  summary_.resumed = resumed_;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began_;
  summary_.wall_seconds = wall.count();
  summary_.cpu_seconds = cpu_seconds();
  write_summary();
  progress_->say(fmt::format("{} at t = {:.6g} after {} steps in {}: {} frames in {}",
    summary_.outcome, series_.frames().back().time, summary_.steps, duration_text(wall.count()),
    summary_.frames, folder_.folder().string()));
}

std::string Run::failure_and_what_is_left() const
{
  const std::string cause = message_ + (message_.ends_with('.') ? "" : ".");
  return rows_ > 0
    ? fmt::format("{} The last good state is saved in {}; it is the last frame of {}", cause,
        folder_.checkpoint().string(), series_.pvd_file().string())
    : fmt::format(
        "{} No state was reached; the start shape is in {}", cause, series_.pvd_file().string());
}

/// For whoever wants to know why.
std::string Run::leave_bundle(const RunTable& table) const
{
  const Simulation& simulation = *stepper_->GetSimulation();
  StopBundle bundle;
  bundle.message = message_;
  bundle.good = rows_ > 0 ? simulation.mesh(*stepper_->GetState()) : simulation.start_mesh();
  bundle.time = rows_ > 0 ? stepper_->GetState()->time : 0;
  bundle.failing = failing_;
  bundle.columns = table.columns;
  bundle.rows = table.rows;
  bundle.vesicles = scene_.vesicles();
  return doing("writing " + folder_.stopped().string(),
    [&] { return write_stop_bundle(scene_, bundle, folder_.stopped()); });
}

void Run::write_plots(const RunTable& table, Attempts& attempts)
{
  try
  {
    render_backend();
  }
  catch (const NothingToDrawWith& error)
  {
    progress_->say(fmt::format("no plots: {}", error.what()));
    return;
  }
  const auto failure =
    attempts.attempt("making " + folder_.plots().string(), [&] { make_folder(folder_.plots()); });
  if (!failure.empty())
  {
    return;
  }
  for (const RunPlot& plot : run_plots(scene_, table))
  {
    const auto file = folder_.plots() / (plot.name + ".png");
    attempts.attempt("drawing " + file.string(), [&] { write_chart(file, plot.chart); });
  }
}

void Run::make_movie(const RunTable& table, Attempts& attempts)
{
  const auto failure = attempts.attempt("making the movie in " + folder_.pictures().string(),
    [&]
    { summary_.movie_note = make_run_movie(scene_, folder_, series_.files(), table, *progress_); });
  if (!failure.empty())
  {
    summary_.movie_note = "no movie: " + failure;
  }
  write_summary();
}

/// A run is not failed where nothing can draw; where a picture fails, the others are made and the
/// failure is told at the end.
void Run::draw(const RunTable& table)
{
  Attempts attempts;
  if (options_.plots)
  {
    write_plots(table, attempts);
  }
  if (options_.movie)
  {
    make_movie(table, attempts);
  }
  attempts.require_success();
}

void Run::finish()
{
  writing_.wait();
  const RunTable table = run_table(columns_, checkpoint_->series());
  rows_ = checkpoint_->rows();
  checkpoint_->close();
  table_->close();
  summarize();
  if (is_failed())
  {
    const std::string advice = leave_bundle(table);
    throw NumericalError(failure_and_what_is_left() + "\n" + advice);
  }
  if (summary_.outcome == "interrupted")
  {
    progress_->say("go on with --resume");
  }
  else
  {
    draw(table);
  }
}

}
