// What the properties of the VTK classes and of ParaView's proxies allow is what the scene's schema
// allows.

#include "vtkVesicleStepper.h"

#include "solver/flow/FlowKinds.h"
#include "solver/flow/FlowNumbers.h"
#include "solver/scene/SceneNames.h"
#include "solver/scene/SceneSchema.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace vesicle
{
namespace
{

/// Elements of a tag anywhere below.
void collect(vtkXMLDataElement* from, const std::string& tag, std::vector<vtkXMLDataElement*>& to)
{
  for (int i = 0; i < from->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = from->GetNestedElement(i);
    if (element->GetName() == tag)
      to.push_back(element);
    collect(element, tag, to);
  }
}

std::vector<vtkXMLDataElement*> all(vtkXMLDataElement* from, const std::string& tag)
{
  std::vector<vtkXMLDataElement*> elements;
  collect(from, tag, elements);
  return elements;
}

std::string attribute(vtkXMLDataElement* element, const char* name)
{
  const char* value = element->GetAttribute(name);
  return value ? value : "";
}

std::string capitalised(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

class ParaViewProperties : public testing::Test
{
protected:
  void SetUp() override
  {
    root_.TakeReference(vtkXMLUtilities::ReadElementFromFile(
      VESICLE_SOURCE_DIR "/vtkfilters/paraview/Vesicle/Vesicle.xml"));
    ASSERT_TRUE(root_);
  }

  /// The first property of a name.
  vtkXMLDataElement* property(const std::string& name) const
  {
    for (const char* tag : { "DoubleVectorProperty", "IntVectorProperty" })
      for (vtkXMLDataElement* element : all(root_, tag))
        if (attribute(element, "name") == name)
          return element;
    ADD_FAILURE() << "no property " << name;
    return nullptr;
  }

  std::vector<std::string> entries(const std::string& name) const
  {
    std::vector<std::string> texts;
    for (vtkXMLDataElement* entry : all(property(name), "Entry"))
    {
      EXPECT_EQ(attribute(entry, "value"), std::to_string(texts.size())) << name;
      texts.push_back(attribute(entry, "text"));
    }
    return texts;
  }

  /// A bound of the property's range; empty: none.
  std::string bound(const std::string& name, const char* which) const
  {
    for (const char* tag : { "DoubleRangeDomain", "IntRangeDomain" })
      for (vtkXMLDataElement* domain : all(property(name), tag))
        return attribute(domain, which);
    ADD_FAILURE() << name << " has no range";
    return "";
  }

  /// The values of FlowKind with which a property is shown.
  std::set<int> shown_with(const std::string& name) const
  {
    vtkXMLDataElement* hint = all(property(name), "PropertyWidgetDecorator").at(0);
    std::istringstream values(attribute(hint, "values") + ' ' + attribute(hint, "value"));
    std::set<int> kinds;
    for (int kind; values >> kind;)
      kinds.insert(kind);
    return kinds;
  }

  vtkSmartPointer<vtkXMLDataElement> root_;
};

}

TEST_F(ParaViewProperties, OfferEveryChoice)
{
  std::vector<std::string> flows{ "At rest" }, presets, shapes, laws;
  for (const FlowKind* kind : flow_kinds())
    flows.push_back(capitalised(kind->title));
  for (const auto& preset : preset_names)
    presets.push_back(capitalised(std::string(preset.name)));
  for (const auto& law : elasticity_names)
    laws.push_back(capitalised(std::string(law.name)));
  for (const auto kind : shape_kinds)
    shapes.push_back(capitalised(shape_name(kind)));
  EXPECT_EQ(entries("FlowKind"), flows);
  EXPECT_EQ(entries("Preset"), presets);
  EXPECT_EQ(entries("Shape"), shapes);
  EXPECT_EQ(entries("Elasticity"), laws);
  EXPECT_EQ(entries("Reference"), (std::vector<std::string>{ "Start", "Sphere", "File" }));
}

// A range ends where the key's does: what is below or above it no scene may have.
TEST_F(ParaViewProperties, HaveTheRangesOfTheirKeys)
{
  const std::map<std::string, const SceneKey*> keys{ { "BendingRigidity",
                                                       &scene_key("membrane", "bending_rigidity") },
    { "SurfaceViscosity", &scene_key("membrane", "surface_viscosity") },
    { "DilationModulus", &scene_key("membrane", "dilation_modulus") },
    { "Prestretch", &scene_key("membrane", "prestretch") },
    { "Viscosity", &scene_key("fluid", "viscosity") },
    { "ViscosityRatio", &scene_key("fluid", "viscosity_ratio") },
    { "FlowRate", &scene_key("flow", "rate") }, { "FlowRadius", &scene_key("flow", "radius") },
    { "BondNumber", &scene_key("gravity", "bond_number") },
    { "DensityDifference", &scene_key("gravity", "density_difference") },
    { "Acceleration", &scene_key("gravity", "acceleration") },
    { "ReducedVolume", &scene_key("vesicle", "reduced_volume") },
    { "Radius", &scene_key("vesicle", "radius") },
    { "Triangles", &scene_key("vesicle", "triangles") },
    { "SemiAxes", &scene_key("vesicle", "semi_axes") },
    { "OutputEvery", &scene_key("time", "output_every") },
    { "Tolerance", &scene_key("time", "tolerance") } };
  for (const auto& [name, key] : keys)
  {
    SCOPED_TRACE(name);
    const std::string least = bound(name, "min");
    EXPECT_EQ(least.empty(), key->allows(-1));
    if (!least.empty())
    {
      EXPECT_FALSE(key->allows(std::stod(least) - 1));
      EXPECT_TRUE(key->allows(std::stod(least) + 0.5));
    }
  }
  EXPECT_EQ(bound("ReducedVolume", "max"), "1");
  EXPECT_FALSE(scene_key("vesicle", "reduced_volume").allows(1.001));
}

TEST_F(ParaViewProperties, OfAFlowAreShownWithTheKindsThatHaveThem)
{
  std::map<std::string, std::set<int>> kinds;
  for (const FlowKind* kind : flow_kinds())
    for (const FlowNumbers& numbers : numbers_of(*kind->make()))
      kinds["Flow" + capitalised(numbers.name)].insert(number_of(*kind));
  EXPECT_GE(kinds.size(), 5u);
  for (const auto& [name, numbers] : kinds)
    EXPECT_EQ(shown_with(name), numbers) << name;
}

TEST(SceneProperties, NumberTheFlowsAsTheListDoes)
{
  vtkNew<vtkVesicleStepper> stepper;
  const std::vector<int> numbers{ vtkVesicleStepper::Uniform, vtkVesicleStepper::Shear,
    vtkVesicleStepper::PlanarExtension, vtkVesicleStepper::AxisymmetricExtension,
    vtkVesicleStepper::Poiseuille, vtkVesicleStepper::Rotation, vtkVesicleStepper::FourRollMill,
    vtkVesicleStepper::VelocityField };
  ASSERT_EQ(numbers.size(), flow_kinds().size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    std::string title = flow_kinds()[i]->title;
    EXPECT_EQ(numbers[i], number_of(*flow_kinds()[i]));
    stepper->SetFlowKind(numbers[i]);
    std::ostringstream text;
    stepper->Print(text);
    EXPECT_NE(text.str().find("FlowKind: " + title + '\n'), std::string::npos) << title;
  }
  stepper->SetFlowKind(1000);
  EXPECT_EQ(stepper->GetFlowKind(), numbers.back());
}

TEST(SceneProperties, NumberThePresetsAsTheSceneDoes)
{
  EXPECT_EQ(preset_names[vtkVesicleStepper::Paper].choice, Scene::Preset::paper);
  EXPECT_EQ(preset_names[vtkVesicleStepper::Fast].choice, Scene::Preset::fast);
  EXPECT_EQ(preset_names[vtkVesicleStepper::Balanced].choice, Scene::Preset::balanced);
  EXPECT_EQ(preset_names[vtkVesicleStepper::Accurate].choice, Scene::Preset::accurate);
}

}
