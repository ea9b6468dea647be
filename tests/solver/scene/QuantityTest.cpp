// Numbers with units, against the SI brochure's factors.

#include "solver/scene/Quantity.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace vesicle;

namespace
{

constexpr double room = 298.15;

struct Case
{
  std::string text;
  double value;
  PhysicalDimension dimension;
};

std::string error_of(const std::string& text)
{
  try
  {
    parse_quantity(text, room);
  }
  catch (const QuantityError& error)
  {
    return error.what();
  }
  return "no error";
}

}

TEST(Quantity, IsReadIntoSi)
{
  const PhysicalDimension length{ 1 }, energy{ 2, 1, -2 }, viscosity{ -1, 1, -1 },
    tension{ 0, 1, -2 }, time{ 0, 0, 1 }, kelvin{ 0, 0, 0, 1 };
  const std::vector<Case> cases{
    { "10 um", 1e-5, length },
    { "10um", 1e-5, length },
    { "100 aJ", 1e-16, energy },
    { "10 µm", 1e-5, length },
    { "10 μm", 1e-5, length },
    { "-.5e3 nm", -5e-7, length },
    { "+2 mm", 2e-3, length },
    { "40 Å", 4e-9, length },
    { "20 kT", 20 * 1.380649e-23 * room, energy },
    { "1 eV", 1.602176634e-19, energy },
    { "2 pN nm", 2e-21, energy },
    { "2 pN·nm", 2e-21, energy },
    { "1 mPa s", 1e-3, viscosity },
    { "1 cP", 1e-3, viscosity },
    { "1 Pa*s", 1, viscosity },
    { "3 uN/m", 3e-6, tension },
    { "3 dyn/cm", 3e-3, tension },
    { "5 min", 300, time },
    { "1 h", 3600, time },
    { "2 ms", 2e-3, time },
    { "25 degC", 298.15, kelvin },
    { "25 °C", 298.15, kelvin },
    { "310 K", 310, kelvin },
    { "3 1/s", 3, { 0, 0, -1 } },
    { "3 /s", 3, { 0, 0, -1 } },
    { "3 s^-1", 3, { 0, 0, -1 } },
    { "3 s⁻¹", 3, { 0, 0, -1 } },
    { "3 Hz", 3, { 0, 0, -1 } },
    { "9.81 m/s^2", 9.81, { 1, 0, -2 } },
    { "9.81 m/s²", 9.81, { 1, 0, -2 } },
    { "9.81 m/s/s", 9.81, { 1, 0, -2 } },
    { "9.81 m s-2", 9.81, { 1, 0, -2 } },
    { "40 kg/m^3", 40, { -3, 1 } },
    { "1 g/cm^3", 1000, { -3, 1 } },
    { "2 /um", 2e6, { -1 } },
    { "7", 7, {} },
  };
  for (const Case& c : cases)
  {
    const Quantity quantity = parse_quantity(c.text, room);
    EXPECT_NEAR(quantity.value, c.value, 1e-14 * std::abs(c.value)) << c.text;
    EXPECT_EQ(quantity.dimension, c.dimension) << c.text;
  }
}

// What people type is the double that they would have typed in SI.
TEST(Quantity, IsTheNearestDouble)
{
  EXPECT_EQ(parse_quantity("10 um", room).value, 1e-5);
  EXPECT_EQ(parse_quantity("1 mPa s", room).value, 1e-3);
  EXPECT_EQ(parse_quantity("0.3 nm", room).value, .3e-9);
  EXPECT_EQ(parse_quantity("7 um/ms", room).value, 7e-3);
  EXPECT_EQ(parse_quantity("40 angstrom", room).value, 4e-9);
}

TEST(Quantity, SaysWhatIsntUnderstood)
{
  EXPECT_EQ(error_of("10 umm"), "there is no unit \"umm\", did you mean um?");
  EXPECT_EQ(error_of("20 kt"), "there is no unit \"kt\", did you mean kT?");
  EXPECT_EQ(error_of("20 %"), "\"%\" is no unit");
  EXPECT_EQ(error_of("um"), "\"um\" doesn't begin with a number");
  EXPECT_EQ(error_of("1e999 um"), "its number is beyond double precision");
  EXPECT_EQ(error_of("1 m^99"), "\"^99\" is no power from -9 to 9");
  EXPECT_EQ(error_of("1 m^"), "\"^\" is no power from -9 to 9");
  EXPECT_EQ(error_of("nan m"), "\"nan m\" doesn't begin with a number");
}

TEST(Quantity, IsShownInAUnitThatPeopleUse)
{
  EXPECT_EQ(quantity_text(1e-5, { 1 }), "10 um");
  EXPECT_EQ(quantity_text(0, { 1 }), "0 m");
  EXPECT_EQ(quantity_text(-2.5e-9, { 1 }), "-2.5 nm");
  EXPECT_EQ(quantity_text(.99999, { 0, 0, 1 }), "1 s");
  EXPECT_EQ(quantity_text(999.96, { 0, 0, 1 }), "1 ks");
  EXPECT_EQ(quantity_text(1e-3, { -1, 1, -1 }), "1 mPa s");
  EXPECT_EQ(quantity_text(2e-10, { 2 }), "2e-10 m^2");
  EXPECT_EQ(quantity_text(1e-20, { 1 }), "1e-05 fm");
  EXPECT_EQ(quantity_text(1.03e-19, { 2, 1, -2 }), "1.03e-19 J");
  EXPECT_EQ(si_unit({ 1, 0, -1 }), "m/s");
  EXPECT_EQ(si_unit({ 3 }), "m^3");
}

TEST(Quantity, WhatIsShownReadsBack)
{
  for (const PhysicalDimension& dimension :
    { PhysicalDimension{ 1 }, { 2, 1, -2 }, { -1, 1, -1 }, { 0, 0, -1 }, { -3, 1 }, { 4, -1, 2 } })
    for (const double value : { 1.25e-19, 3e-6, .02, 1., 47., 5e5 })
    {
      const Quantity quantity = parse_quantity(quantity_text(value, dimension), room);
      EXPECT_NEAR(quantity.value, value, 1e-14 * value) << quantity_text(value, dimension);
      EXPECT_EQ(quantity.dimension, dimension);
      EXPECT_EQ(parse_quantity(example_of(dimension), room).dimension, dimension);
    }
}

TEST(Quantity, TheSchemasWordsHaveDimensions)
{
  EXPECT_EQ(dimensions_of("length"), (Dimensions{ { 1 } }));
  EXPECT_EQ(dimensions_of("1 / time"), (Dimensions{ { 0, 0, -1 } }));
  EXPECT_EQ(dimensions_of("energy/area"), (Dimensions{ { 0, 1, -2 } }));
  EXPECT_EQ(dimensions_of("pressure × time"), (Dimensions{ { -1, 1, -1 } }));
  EXPECT_EQ(dimensions_of("length / time²"), (Dimensions{ { 1, 0, -2 } }));
  EXPECT_EQ(dimensions_of("time, a number"), (Dimensions{ { 0, 0, 1 }, {} }));
  for (const char* none : { "", "r0", "pixels", "that of the array", "bending_rigidity" })
    EXPECT_TRUE(dimensions_of(none).empty()) << none;
}
