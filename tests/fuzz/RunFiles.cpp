// A run file that was damaged, as --resume reads it: an IoError, or one of the moments that were
// saved in it.
//
// The bytes are changes to a file of two rows. If the first one is even, they are such as disks make
// them; if it is odd, they are made to its numbers, whose checksums are then made to hold: what the
// checksums hide from the first kind is met by the reader's own checks. HDF5's structures are behind
// a checksum and trusted where it holds, so the second kind leaves them alone. A change has 4 bytes:
// place (2), what, value.
#include "tests/fuzz/Bytes.h"
#include "tests/fuzz/Fault.h"
#include "tests/fuzz/Targets.h"

#include "solver/Errors.h"
#include "solver/files/Checksum.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"
#include "solver/state/LittleEndian.h"
#include "solver/state/RunFileLayout.h"
#include "tests/support/TemporaryFolder.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace vesicle::fuzz
{
namespace
{

constexpr const char* scene_text = R"(
name = "small"
[vesicle]
shape = "sphere"
triangles = 20
[membrane]
bending_rigidity = 1.0
[time]
end = 1.0
output_every = 0.5
)";

/// A run of two rows: its file, and what the file would be had it been closed after each append.
struct SmallRun
{
  SmallRun()
    : scene(parse_scene(scene_text, "small.toml")), simulation(scene, make_start_mesh(scene))
  {
    const test::TemporaryFolder folder;
    const RunFile::Header header{ write_scene(scene), { simulation.start_mesh().triangles }, 1, 1,
      1, 1, { "time", "area" } };
    RunFile file = RunFile::create(folder / "run.h5", header);
    State state = simulation.start();
    closed.push_back(image_of(read_file(folder / "run.h5")));
    for (const double area : { 12.5, 12.25 })
    {
      file.append(state, { state.time, area });
      bytes = read_file(folder / "run.h5");
      closed.push_back(image_of(bytes));
      ++state.step;
      state.time += 0.125;
    }
    head = checked_run_file(bytes).head;
  }

  static std::string image_of(const std::string& file)
  {
    const RunFileContents contents = read_contents(file);
    return run_file_image(contents, contents.rows()).bytes;
  }

  Scene scene;
  Simulation simulation;
  std::string bytes;
  RunFileHead head;
  std::vector<std::string> closed;
};

/// The places of numbers: the fields of the head, of both commits, and all numbers.
std::vector<std::size_t> numbers_in(const SmallRun& run)
{
  std::vector<std::size_t> places;
  const auto add = [&places](std::size_t begin, std::size_t end)
  {
    for (; begin < end; ++begin)
      places.push_back(begin);
  };
  add(24, 72); // behind the signature and the version
  add(4096, 4104);
  add(8192, 8200);
  add(run.head.slots, run.bytes.size());
  return places;
}

void change(std::string& file, std::size_t place, unsigned what, std::uint8_t value)
{
  const auto overwrite = [&](std::string_view with)
  {
    file.replace(
      place, std::min(with.size(), file.size() - place), with.substr(0, file.size() - place));
  };
  switch (what % 6)
  {
    case 0:
      file[place] = static_cast<char>(value);
      break;
    case 1:
      file[place] = static_cast<char>(file[place] ^ (1 << value % 8));
      break;
    case 2:
      overwrite(std::string(value, '\0'));
      break;
    case 3:
      overwrite(std::string(16 * value, '\xff'));
      break;
    case 4:
    {
      const double number = special_number(value);
      std::string bytes;
      append_numbers(bytes, &number, 1);
      overwrite(bytes);
      break;
    }
    default:
      file.resize(place);
  }
}

/// As RunFileHead.h has it, wherever the head points to now.
void seal(std::string& file, const RunFileHead& original)
{
  constexpr std::size_t fields_end = 16 + 8 * 8;
  if (file.size() < run_file_head_size)
    return;
  const auto put = [&](std::size_t place, std::uint64_t number)
  {
    std::string bytes;
    append_numbers(bytes, &number, 1);
    file.replace(place, 8, bytes);
  };
  const auto field = [&](std::size_t i) { return number_at<std::uint64_t>(file, 16 + 8 * i); };
  const RunFileHead head{ field(1), field(2), field(3), field(4), field(5), field(6) };
  const std::string_view all(file);
  const auto part = [&](std::uint64_t begin, std::uint64_t size)
  { return begin > all.size() ? std::string_view() : all.substr(begin, size); };
  if (head.slots == original.slots)
    put(fields_end - 8, checksum(part(run_file_head_size, head.slots - run_file_head_size)));
  put(fields_end, checksum(std::string_view(file).substr(0, fields_end)));
  for (const std::size_t place : { 4096, 8192 })
  {
    const std::uint64_t rows = number_at<std::uint64_t>(file, place);
    put(place + 8, checksum(part(head.slot(rows), head.slot_size)));
    put(place + 16, checksum(part(head.series, rows * head.row_size)));
    put(place + 24, checksum(std::string_view(file).substr(place, 24)));
  }
}

std::string changed(const SmallRun& run, Bytes changes, bool sealed)
{
  static const std::vector<std::size_t> numbers = numbers_in(run);
  std::string file = run.bytes;
  while (!changes.empty() && !file.empty())
  {
    const auto place = changes.take<std::uint16_t>();
    const auto what = changes.take<std::uint8_t>(), value = changes.take<std::uint8_t>();
    const std::size_t at = sealed ? numbers[place % numbers.size()] : place % file.size();
    if (at < file.size())
      change(file, at, what, value);
  }
  if (sealed)
    seal(file, run.head);
  return file;
}

/// As --resume does, up to the first output.
void go_on(SmallRun& run, const RunFileContents& contents)
{
  const Scene scene = parse_scene(contents.header.scene, "run file");
  if (contents.rows() == 0 || write_scene(scene) != write_scene(run.scene))
    return;
  run.simulation.require_own(contents.state);
  for (const auto& [name, values] : run.simulation.fields(contents.state))
    require(values.allFinite(), name + " isn't finite");
}

}

void run_files(std::string_view bytes)
{
  static SmallRun run;
  Bytes input(bytes);
  const bool sealed = input.take<std::uint8_t>() % 2 == 1;
  const std::string file = changed(run, input, sealed);
  const hdf5::QuietErrors quiet;
  try
  {
    const RunFileContents contents = read_contents(file);
    const std::string image = run_file_image(contents, contents.rows()).bytes;
    require(SmallRun::image_of(image) == image, "what is read differs from what is written");
    if (!sealed)
      require(std::ranges::count(run.closed, image) > 0, "damage goes unnoticed");
    go_on(run, contents);
  }
  catch (const IoError&)
  {
  }
  catch (const InputError&)
  {
  }
  catch (const NumericalError&)
  {
  }
}

}
