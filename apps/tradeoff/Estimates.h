#pragma once
// The errors of a trade-off's runs, by extrapolation to the finest of them.

#include "apps/tradeoff/Trial.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

/// What an observable tends to for many triangles and small steps. Errors are relative to its scale.
struct BestValue
{
  double value = 0;
  double uncertainty = 0; ///< of the value: half an interval that holds it nine times of ten
  double scale = 1;
  double order_in_triangles = 0; ///< the error falls as N to minus this
  std::string from;              ///< the runs that say so
};

/// What errors of an observable are counted in: of angles a radian, of velocities the speed, otherwise
/// the largest magnitude in the run; 1 where that is 0.
double scale_of(const std::string& observable, const Trial& trial);

/// Space: over the triangles of a preset at one time setting, the error as 1/N to an order of .5 to 3.
/// Time: over the time settings at one number of triangles, the error as the run's own estimate of that in
/// time (how much of area and volume projections took out), to an order of .5 to 2: a tolerance or a mean
/// step tells less, as the mesh's motion decides of many steps. Errors of the two add up.
/// Each preset says its own; the least uncertain counts that rests on three numbers of triangles or more.
/// Empty where no preset has two that finished.
std::optional<BestValue> best_value(
  const std::vector<Trial>& trials, const std::string& observable);

/// Of one run in one observable, relative to the scale.
struct Estimate
{
  double error;       ///< the distance from the best value
  double uncertainty; ///< of that
  double promised() const;
};
std::optional<Estimate> estimate(
  const Trial& trial, const std::string& observable, const BestValue& best);

/// Observables with what they tend to.
struct Reference
{
  std::string observable;
  BestValue best;
};

/// The largest promised error among the observables; infinite for a run that didn't finish or lacks one.
double promised_error(const Trial& trial, const std::vector<Reference>& references);
/// The same, and no less than that of any run of the same method that is finer in triangles or time and
/// no coarser in either: an error that happens to pass through 0 is not counted on.
double dependable_error(
  const Trial& trial, const std::vector<Trial>& trials, const std::vector<Reference>& references);

struct Recommendation
{
  std::size_t trial;
  bool keeps_tolerance; ///< false: none does, and this is the most accurate
};
/// The cheapest whose dependable error is within the tolerance. Empty where none finished.
std::optional<Recommendation> recommend(
  const std::vector<Trial>& trials, const std::vector<Reference>& references, double tolerance);

/// How the runs' own estimates compare to the errors by extrapolation.
struct Foresight
{
  int runs = 0;
  double lowest = 0, median = 0,
         highest = 0; ///< of error/estimate; lowest and highest but for a tenth each
  double ordered =
    0; ///< share of the pairs of runs of which the one with the larger estimate errs more
};
Foresight foresight(const std::vector<Trial>& trials, const std::vector<Reference>& references);

}
