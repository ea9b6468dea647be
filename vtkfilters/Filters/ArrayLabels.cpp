#include "ArrayLabels.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <map>
#include <string>
#include <string_view>

namespace vesicle
{
namespace
{

const std::map<std::string_view, const char*>& units()
{
  static const std::map<std::string_view, const char*> by_name{
    { "Mean_Curvature", "1/length" },
    { "Gauss_Curvature", "1/length^2" },
    { "Maximum_Curvature", "1/length" },
    { "Minimum_Curvature", "1/length" },
    { "Mean_Curvature_Error", "1/length" },
    { "Laplacian_Mean_Curvature", "1/length^3" },
    { "Curvedness", "1/length" },
    { "Shape_Index", "1" },
    { "Willmore_Density", "1/length^2" },
    { "Fit_Residual", "edge length" },
    { "Fit_Degree", "1" },
    { "Normals", "1" },
    { "Maximum_Direction", "1" },
    { "Minimum_Direction", "1" },
    { "Bending_Force", "force/length^2" },
    { "Area_Difference_Force", "force/length^2" },
    { "Tension_Force", "force/length^2" },
    { "Membrane_Force", "force/length^2" },
    { "Gravity_Force", "force/length^2" },
    { "Repulsion_Force", "force/length^2" },
    { "Tension", "force/length" },
    { "Velocity", "length/time" },
    { "Surface_Divergence", "1/time" },
    { "Vesicle_Id", "1" },
    { "TimeValue", "time" },
    { "Area", "length^2" },
    { "Volume", "length^3" },
    { "Reduced_Volume", "1" },
    { "Bending_Energy", "force length" },
    { "Area_Drift", "1" },
    { "Volume_Drift", "1" },
    { "Viscosity", "force time/length^2" },
    { "Viscosity_Ratio", "1" },
    { "Wall_Point", "length" },
    { "Wall_Normal", "1" },
    { "Flow_Rate", "1/time" },
    { "Flow_Velocity", "length/time" },
    { "Flow_Radius", "length" },
    { "Flow_Center", "length" },
    { "Flow_Axis", "1" },
  };
  return by_name;
}

}

void label(vtkDataArray* array)
{
  if (const auto unit = units().find(array->GetName() ? array->GetName() : "");
      unit != units().end())
  {
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit->second);
  }
  if (array->GetNumberOfComponents() == 3)
  {
    constexpr const char* names[] = { "X", "Y", "Z" };
    for (int i = 0; i < 3; ++i)
    {
      array->SetComponentName(i, names[i]);
    }
  }
}

}
