// Writing a Scene as TOML: the inverse of SceneFile.cpp, key by key.

#include "solver/flow/FlowKind.h"
#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneNames.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// The shortest text that reads back as the same double, and as a float rather than an integer.
std::string toml(double value)
{
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string toml(int value)
{
  return fmt::format("{}", value);
}

std::string toml(bool value)
{
  return value ? "true" : "false";
}

std::string toml(const std::string& text)
{
  std::string escaped = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      escaped += '\\';
      escaped += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
    {
      escaped += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    }
    else
    {
      escaped += c;
    }
  }
  return escaped + "\"";
}

std::string toml(const ShapeMode& mode)
{
  return fmt::format("[{}, {}, {}]", mode.l, mode.m, toml(mode.amplitude));
}

template<class Values>
std::string toml_array(const Values& values)
{
  std::string text = "[";
  for (const auto& value : values)
  {
    text += (text.size() > 1 ? ", " : "") + toml(value);
  }
  return text + "]";
}

std::string toml(const Vector3& v)
{
  return toml_array(std::array<double, 3>{ v[0], v[1], v[2] });
}

template<class T, std::size_t n>
std::string toml(const std::array<T, n>& values)
{
  return toml_array(values);
}

template<class T>
std::string toml(const std::vector<T>& values)
{
  return toml_array(values);
}

class Writer
{
public:
  void table(const std::string& name) { text_ += fmt::format("\n[{}]\n", name); }

  template<class T>
  void key(const std::string& name, const T& value)
  {
    text_ += fmt::format("{} = {}\n", name, toml(value));
  }

  /// Left out where empty.
  template<class T>
  void key(const std::string& name, const std::optional<T>& value)
  {
    if (value)
    {
      key(name, *value);
    }
  }

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

void write_shape(Writer& out, const Scene::Vesicle& vesicle)
{
  const ShapeRequest& shape = vesicle.shape;
  out.key("shape", shape_name(shape.kind));
  out.key("triangles", shape.triangles);
  out.key("reduced_volume", shape.reduced_volume);
  if (shape.kind == ShapeRequest::Kind::ellipsoid)
  {
    out.key("semi_axes", shape.semi_axes);
  }
  if (shape.kind == ShapeRequest::Kind::perturbed)
  {
    out.key("modes", shape.modes);
  }
  out.key("radius", vesicle.radius);
  if (!vesicle.rotation)
  {
    out.key("axis", vesicle.axis);
  }
  out.key("center", vesicle.center);
}

void write_vesicle(Writer& out, const Scene::Vesicle& vesicle)
{
  out.table("vesicle");
  if (vesicle.mesh_file)
  {
    out.key("file", std::filesystem::absolute(*vesicle.mesh_file).string());
    out.key("radius", vesicle.mesh_radius);
    out.key("triangles", vesicle.mesh_triangles);
  }
  else
  {
    write_shape(out, vesicle);
  }
  out.key("rotation", vesicle.rotation);
}

void write_membrane(Writer& out, const Scene::Membrane& membrane)
{
  out.table("membrane");
  out.key("bending_rigidity", membrane.bending_rigidity);
  out.key("incompressible", membrane.incompressible);
}

void write_flow(Writer& out, const ImposedFlow& flow)
{
  const FlowKind& kind = flow.kind();
  out.table("flow");
  out.key("kind", kind.name);
  if (!kind.type.empty())
    out.key("type", kind.type);
  for (const FlowParameter& parameter : kind.parameters)
    std::visit([&](auto member) { out.key(parameter.name, flow.*member); }, parameter.member);
}

void write_gravity(Writer& out, const Scene::Gravity& gravity)
{
  out.table("gravity");
  out.key("bond_number", gravity.bond_number);
  if (!gravity.bond_number)
  {
    out.key("density_difference", gravity.density_difference);
    out.key("acceleration", gravity.acceleration);
  }
}

void write_number_or(
  Writer& out, const std::string& key, const std::optional<double>& value, const std::string& word)
{
  if (value)
  {
    out.key(key, *value);
  }
  else
  {
    out.key(key, word);
  }
}

void write_time(Writer& out, const Scene::Time& time)
{
  out.table("time");
  write_number_or(out, "end", time.end, "steady");
  // In memory 0 stands for "only start and end", which a file says with the end itself.
  const bool only_end = time.output_every == 0 && time.end;
  out.key("output_every", only_end ? *time.end : time.output_every);
  write_number_or(out, "step", time.step, "auto");
  out.key("tolerance", time.tolerance);
}

void write_accuracy(Writer& out, const Scene::Accuracy& accuracy)
{
  out.table("accuracy");
  out.key("preset", name_of(preset_names, accuracy.preset));
  out.key("basis", name_of(basis_names, accuracy.basis));
  out.key("bending", name_of(bending_names, accuracy.bending));
  out.key("integrator", name_of(integrator_names, accuracy.integrator));
  out.key("mesh_motion", name_of(mesh_motion_names, accuracy.mesh_motion));
  out.key("operator", name_of(operator_names, accuracy.stokes_operator));
  out.key("quadrature", accuracy.quadrature);
  out.key("linear_tolerance", accuracy.linear_tolerance);
  out.key("precision", name_of(precision_names, accuracy.precision));
}

void write_movie(Writer& out, const Scene::Movie& movie)
{
  out.table("movie");
  out.key("color", movie.color);
  out.key("range", movie.range);
  out.key("size", movie.size);
  out.key("view", movie.view);
  out.key("camera", movie.camera);
  out.key("smooth", movie.smooth);
  out.key("arrows", movie.arrows);
  out.key("edges", movie.edges);
  out.key("chart", movie.chart);
}

void write_output(Writer& out, const Scene::Output& output)
{
  out.table("output");
  out.key("fields", output.fields);
  if (output.directory)
  {
    out.key("directory", std::filesystem::absolute(*output.directory).string());
  }
}

}

std::string write_scene(const Scene& scene)
{
  Writer out;
  out.key("name", scene.name);
  write_vesicle(out, scene.vesicle);
  write_membrane(out, scene.membrane);
  out.table("fluid");
  out.key("viscosity", scene.fluid.viscosity);
  if (scene.flow)
  {
    write_flow(out, *scene.flow);
  }
  if (scene.gravity)
  {
    write_gravity(out, *scene.gravity);
  }
  write_time(out, scene.time);
  write_accuracy(out, scene.accuracy);
  write_movie(out, scene.movie);
  write_output(out, scene.output);
  return out.text();
}

}
