#pragma once
// One sitting of a simulation: from the start or from the checkpoint to the end, to Ctrl-C, or to
// where no step can be made.

#include "apps/CsvFile.h"
#include "apps/Progress.h"
#include "apps/RunFolder.h"
#include "apps/RunTable.h"
#include "apps/Summary.h"

#include "solver/files/FileLock.h"
#include "solver/files/WriteQueue.h"
#include "solver/scene/Scene.h"
#include "solver/state/RunFile.h"
#include "vtkfilters/Filters/SeriesWriter.h"

#include "vtkNew.h"
#include "vtkVesicleStepper.h"

#include <chrono>
#include <exception>
#include <optional>

namespace vesicle
{

class Attempts;

struct RunOptions
{
  bool resume = false;
  bool overwrite = false;
  bool movie = true;
  bool plots = true;
  bool quiet = false;
};

/// Drives a vtkVesicleStepper from output time to output time and writes a frame at each; table,
/// checkpoint, progress and Ctrl-C watch the accepted steps in between. What a step leaves is handed
/// to a queue that writes it, in this order, while the next steps are computed.
class Run
{
public:
  Run(Scene scene, const std::filesystem::path& folder, const RunOptions& options);

  /// Returns the exit code. Throws InputError and IoError; a NumericalError once all that is good is
  /// saved, and says where.
  int carry_out();

private:
  void require_leave_to_write() const;
  void start_anew();
  void take_folder();
  bool go_on();
  void advance();
  void keep_refused();
  void return_to_last_good_state();
  void finish();

  void update_to(double time);
  void on_step();
  void record();
  void append_frame();
  void append_last_frame();
  void tell_once_if_unresolved();
  void require_movie_arrays();
  void estimate_errors();
  void summarize();
  void write_summary();
  void draw(const RunTable& table);
  void write_plots(const RunTable& table, Attempts& attempts);
  void make_movie(const RunTable& table, Attempts& attempts);
  bool is_failed() const { return !message_.empty(); }
  std::string outcome() const;
  std::string failure_and_what_is_left() const;
  std::string leave_bundle(const RunTable& table) const;
  RunFile create_checkpoint() const;

  Scene scene_;
  RunFolder folder_;
  RunOptions options_;
  const std::vector<std::string> columns_; ///< of its table
  std::chrono::steady_clock::time_point began_;
  vtkNew<vtkVesicleStepper> stepper_;
  std::optional<FileLock> lock_; ///< of the folder, from before anything there is read
  // The queue's, but while it is known to be empty.
  SeriesWriter series_;
  std::optional<RunFile> checkpoint_;
  std::optional<CsvFile> table_;
  std::optional<double> last_frame_time_; ///< that was handed over
  std::optional<Progress> progress_;
  std::exception_ptr failure_;          ///< of an observer: it must not pass through VTK
  std::string message_;                 ///< why the run failed
  std::optional<TriangleMesh> failing_; ///< what it failed with
  std::size_t rows_ = 0;                ///< of the checkpoint once it is closed; 0: no good state
  std::int64_t first_step_ = 0;
  bool resumed_ = false;
  bool told_unresolved_ = false;
  RunSummary summary_;
  WriteQueue writing_; ///< the last, as it is to end first
};

}
