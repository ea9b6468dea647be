#include "apps/BuildFacts.h"

#include "solver/linear/Blas.h"

#include "vtkVersion.h"

#include <Eigen/Core>
#include <H5public.h>
#include <fmt/format.h>
#include <oneapi/tbb/version.h>

namespace vesicle
{

std::vector<std::pair<std::string, std::string>> build_facts()
{
  return { { "vesicle", VESICLE_VERSION }, { "vtk", vtkVersion::GetVTKVersion() },
    { "eigen",
      fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) },
    { "hdf5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE) },
    { "tbb", TBB_runtime_version() }, { "compiler", __VERSION__ }, { "build", VESICLE_BUILD },
    { "blas_kernel", blas_kernel() } };
}

std::string version_text()
{
  std::string text;
  for (const auto& [name, value] : build_facts())
  {
    text +=
      text.empty() ? fmt::format("{} {}", name, value) : fmt::format("\n  {:<12} {}", name, value);
  }
  return text;
}

}
