#pragma once
// What is fuzzed: each target takes any bytes by one way into the program. What that may do, refuse
// them with one of the program's errors, is caught within; whatever leaves a target (another
// exception, a signal, a sanitizer's report) is a fault. Fuzzer.cpp runs one under libFuzzer,
// SeedsTest.cpp all over their seeds.

#include <string_view>

namespace vesicle::fuzz
{

/// The first byte chooses the format, the rest is the file.
void meshes(std::string_view bytes);
/// A scene as text.
void scenes(std::string_view bytes);
/// What is done to a run file, see RunFiles.cpp.
void run_files(std::string_view bytes);
/// The first byte chooses .vtp, .vtu or .pvtu; the latter's piece follows it behind a zero.
void xml_surfaces(std::string_view bytes);
/// The first byte chooses .vti, .vtr, .vts, .vtu or .vtk.
void velocity_fields(std::string_view bytes);
/// A surface in a pipeline and the filter that it meets, see Filters.cpp.
void filters(std::string_view bytes);

}
