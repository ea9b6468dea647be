// glTF 2.0 (Khronos Group): one mesh, whose numbers are in the text itself.

#include "render/Model.h"

#include "solver/files/Base64.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <cstring>

namespace vesicle
{
namespace
{

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

using Json = nlohmann::ordered_json;

// Of OpenGL, as glTF names its types.
constexpr int float_type = 5126, index_type = 5125, vertex_buffer = 34962, index_buffer = 34963;

/// Numbers one after the other, and what tells them apart.
class Buffer
{
public:
  /// The number of the accessor.
  std::size_t add(const Points& rows, bool with_bounds = false)
  {
    const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> values = rows.cast<float>();
    Json accessor{ { "componentType", float_type }, { "count", rows.rows() }, { "type", "VEC3" } };
    if (with_bounds && rows.rows() > 0)
    {
      const Eigen::RowVector3f low = values.colwise().minCoeff(),
                               high = values.colwise().maxCoeff();
      accessor["min"] = { low[0], low[1], low[2] };
      accessor["max"] = { high[0], high[1], high[2] };
    }
    return put(values.data(), values.size() * sizeof(float), std::move(accessor), vertex_buffer);
  }

  std::size_t add(const Triangles& triangles)
  {
    const std::vector<std::uint32_t> indices(triangles.data(), triangles.data() + triangles.size());
    return put(indices.data(), indices.size() * sizeof(std::uint32_t),
      { { "componentType", index_type }, { "count", indices.size() }, { "type", "SCALAR" } },
      index_buffer);
  }

  void write(Json& to) const
  {
    to["buffers"] = { { { "byteLength", bytes_.size() },
      { "uri", "data:application/octet-stream;base64," + base64(bytes_) } } };
    to["bufferViews"] = views_;
    to["accessors"] = accessors_;
  }

private:
  std::size_t put(const void* data, std::size_t size, Json accessor, int target)
  {
    views_.push_back({ { "buffer", 0 }, { "byteOffset", bytes_.size() }, { "byteLength", size },
      { "target", target } });
    accessor["bufferView"] = views_.size() - 1;
    accessors_.push_back(std::move(accessor));
    const auto* bytes = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
    return accessors_.size() - 1;
  }

  std::vector<std::byte> bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

}

std::string gltf_text(const Model& model, const std::string& name)
{
  Buffer buffer;
  const auto points = buffer.add(model.points, true), normals = buffer.add(model.normals),
             colors = buffer.add(model.colors), triangles = buffer.add(model.triangles);
  const double half = std::sqrt(.5);
  Json gltf{ { "asset", { { "version", "2.0" }, { "generator", "vesicle" } } }, { "scene", 0 },
    { "scenes", { { { "nodes", { 0 } } } } } };
  // glTF's y axis is up: a node turns z there, its child is at its place.
  gltf["nodes"] = { { { "name", "z up" }, { "rotation", { -half, 0, 0, half } },
                      { "children", { 1 } } },
    { { "name", name }, { "mesh", 0 },
      { "translation", { model.place[0], model.place[1], model.place[2] } } } };
  gltf["meshes"] = { { { "name", name },
    { "primitives",
      { { { "attributes",
            { { "POSITION", points }, { "NORMAL", normals }, { "COLOR_0", colors } } },
        { "indices", triangles }, { "material", 0 } } } } } };
  gltf["materials"] = { { { "doubleSided", true },
    { "pbrMetallicRoughness", { { "metallicFactor", 0 }, { "roughnessFactor", .6 } } } } };
  buffer.write(gltf);
  return gltf.dump() + '\n';
}

}
