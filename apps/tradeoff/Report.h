#pragma once
// What a trade-off leaves behind: tradeoff.csv, .json, .svg, .png and recommended.toml.

#include "apps/tradeoff/Estimates.h"
#include "apps/tradeoff/KnownValues.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

struct Report
{
  std::string scene; ///< as the user named it
  std::vector<std::string> observables;
  double tolerance = 0;
  std::vector<Trial> trials;
  std::map<std::string, KnownValue> known;

  // What follows from them, by conclude().
  std::vector<Reference> references;
  std::optional<Recommendation> recommendation;
  Foresight foresight;
};

/// Throws NumericalError naming an observable of which too few runs finished with a value.
void conclude(Report& report);

/// A row a run, errors relative to the observable's scale, empty where there is none. Throws IoError.
void write_table(const Report& report, const std::filesystem::path& file);
/// The recommended settings as a part of a scene, with what they promise as comments. Throws IoError.
void write_recommended(const Report& report, const std::filesystem::path& file);
/// Throws IoError.
void write_json(const Report& report, const std::filesystem::path& file);
/// Errors against CPU time, a panel an observable. Throws IoError.
void draw(const Report& report, const std::filesystem::path& file);

/// For the terminal: what is recommended, what it promises, how sure that is.
std::string to_text(const Report& report);

}
