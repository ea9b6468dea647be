#pragma once
// The movie at the end of a run.

#include "apps/RunTable.h"

#include "render/Movie.h"
#include "solver/scene/Scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace vesicle
{

class Progress;
class RunFolder;

/// What a scene's [movie] table asks for, but for what belongs to its run.
MovieSettings movie_settings(const Scene::Movie& movie);

/// What flow lines take that frames don't hold: the velocity field that the scene's flow names. Empty
/// where it names none. Throws InputError for one that can't be read.
std::shared_ptr<const ImposedFlow> field_of(const Scene& scene);

/// Throws InputError listing the arrays unless all that the scene's movie shows are the surface's.
/// Asked at the start: nobody wants to hear it at the end.
void require_arrays(const Scene& scene, vtkPolyData* surface);

/// Loads what draws, which takes a fifth of a second, so that it is there when pictures are to be made.
void prepare_to_draw();

/// Pictures of the frames, and a film where ffmpeg is installed. Where nothing can draw, or on
/// Ctrl-C, there is no movie, and the returned text says why; a run is not failed for that. Throws
/// IoError.
std::string make_run_movie(const Scene& scene, const RunFolder& folder,
  const std::vector<std::filesystem::path>& frames, const RunTable& table, Progress& progress);

}
