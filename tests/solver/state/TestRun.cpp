#include "TestRun.h"

#include "solver/state/StateFields.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <random>

namespace vesicle::testing_support
{
namespace
{

class Filler
{
public:
  explicit Filler(std::uint64_t seed, int vertices) : random_(seed), vertices_(vertices) {}
  void operator()(const std::string&, std::int64_t& value)
  {
    value = static_cast<std::int64_t>(random_() / 2);
  }
  void operator()(const std::string&, double& value) { value = any(); }
  void operator()(const std::string&, Points& points)
  {
    points.resize(vertices_, 3);
    fill(points.data(), points.size());
  }
  void operator()(const std::string&, Triangles& triangles)
  {
    triangles.resize(2 * vertices_ - 1, 3); // an odd number of bytes of eight
    for (int& corner : triangles.reshaped())
      corner = static_cast<int>(random_() % 1000);
  }
  void operator()(const std::string&, Eigen::VectorXd& vector)
  {
    vector.resize(vertices_);
    fill(vector.data(), vector.size());
  }

private:
  double any() { return std::ldexp(normal_(random_), static_cast<int>(random_() % 100) - 50); }
  void fill(double* values, Eigen::Index count)
  {
    for (Eigen::Index i = 0; i < count; ++i)
    {
      values[i] = any();
    }
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  int vertices_;
};

template<class T>
void append_bytes(std::string& bytes, const T* values, Eigen::Index count)
{
  bytes.append(reinterpret_cast<const char*>(values), sizeof(T) * static_cast<std::size_t>(count));
}

std::string bytes_of(const State& state)
{
  std::string bytes;
  const auto add = [&](const std::string& name, const auto& field)
  {
    bytes += name;
    if constexpr (requires { field.rows(); })
    {
      const std::int64_t rows = field.rows();
      append_bytes(bytes, &rows, 1);
      append_bytes(bytes, field.data(), field.size());
    }
    else
    {
      append_bytes(bytes, &field, 1);
    }
  };
  for_each_field(state, add);
  return bytes;
}

}

RunFile::Header header()
{
  RunFile::Header header;
  header.scene = "name = \"é\"\n[vesicle]\nshape = \"sphere\"\n";
  header.triangles.resize(2); // vesicles
  header.triangles[0].resize(3, 3);
  header.triangles[0] << 0, 1, 2, 2, 1, 3, 0, 3, 41;
  header.triangles[1].resize(1, 3);
  header.triangles[1] << 0, 1, 2;
  header.length_scale = 1e-6;
  header.time_scale = 0.1;
  header.energy_scale = 1e-19;
  header.viscosity = 1e-3;
  header.columns = { "time", "area", "inclination_deg", "energy_over_8pi" };
  return header;
}

State state(std::int64_t step, int vertices)
{
  State state;
  state.vesicles.resize(2);
  state.preconditioner.points.resize(2);
  for_each_field(state, Filler(static_cast<std::uint64_t>(step) + 1, vertices));
  state.step = step;
  return state;
}

std::vector<std::optional<double>> row(std::int64_t step)
{
  const auto s = static_cast<double>(step);
  std::optional<double> undefined;
  return { s / 3, -s, step % 3 == 0 ? undefined : 0.1 * s, 1 / (1 + s), // of each vesicle
    s / 7, 2 * s, 0.2 * s, step % 2 == 0 ? undefined : 3 * s };
}

std::filesystem::path empty_folder(const std::string& name)
{
  const auto folder =
    std::filesystem::path(testing::TempDir()) / (name + "-" + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

bool same_bits(const State& a, const State& b)
{
  return bytes_of(a) == bytes_of(b);
}

}
