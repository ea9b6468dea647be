#include "FileArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkStringArray.h"
#include "vtkTypeTraits.h"

#include <algorithm>

namespace vesicle
{
namespace
{

template<typename T>
vtkSmartPointer<vtkAbstractArray> converted(const std::vector<T>& values, const DataArray& array)
{
  const int type = array.ids ? VTK_ID_TYPE : vtkTypeTraits<T>::VTK_TYPE_ID;
  auto result = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  result->SetNumberOfComponents(array.components);
  result->SetNumberOfTuples(array.tuples());
  std::copy(values.begin(), values.end(), static_cast<T*>(result->GetVoidPointer(0)));
  return result;
}

vtkSmartPointer<vtkAbstractArray> converted(
  const std::vector<std::string>& values, const DataArray& array)
{
  auto result = vtkSmartPointer<vtkStringArray>::New();
  result->SetNumberOfComponents(array.components);
  result->SetNumberOfTuples(array.tuples());
  for (std::size_t i = 0; i < values.size(); ++i)
    result->SetValue(static_cast<vtkIdType>(i), values[i]);
  return result;
}

/// VTK's attribute for the role, −1: none.
int attribute_of(DataArray::Role role)
{
  switch (role)
  {
    case DataArray::Role::scalars:
      return vtkDataSetAttributes::SCALARS;
    case DataArray::Role::vectors:
      return vtkDataSetAttributes::VECTORS;
    case DataArray::Role::normals:
      return vtkDataSetAttributes::NORMALS;
    case DataArray::Role::texture_coordinates:
      return vtkDataSetAttributes::TCOORDS;
    case DataArray::Role::tensors:
      return vtkDataSetAttributes::TENSORS;
    case DataArray::Role::global_ids:
      return vtkDataSetAttributes::GLOBALIDS;
    case DataArray::Role::pedigree_ids:
      return vtkDataSetAttributes::PEDIGREEIDS;
    case DataArray::Role::edge_flags:
      return vtkDataSetAttributes::EDGEFLAG;
    default:
      return -1;
  }
}

/// Whether VTK takes it without a complaint.
bool fits(const DataArray& array, int attribute)
{
  if (std::holds_alternative<std::vector<std::string>>(array.values))
    return attribute == vtkDataSetAttributes::PEDIGREEIDS;
  const int n = array.components;
  switch (attribute)
  {
    case vtkDataSetAttributes::VECTORS:
    case vtkDataSetAttributes::NORMALS:
      return n == 3;
    case vtkDataSetAttributes::TCOORDS:
      return n <= 3;
    case vtkDataSetAttributes::TENSORS:
      return n == 6 || n == 9;
    case vtkDataSetAttributes::GLOBALIDS:
      return n == 1 && array.ids;
    case vtkDataSetAttributes::PEDIGREEIDS:
    case vtkDataSetAttributes::EDGEFLAG:
      return n == 1;
    default:
      return true;
  }
}

}

vtkSmartPointer<vtkAbstractArray> to_vtk(const DataArray& array)
{
  auto result = std::visit([&](const auto& v) { return converted(v, array); }, array.values);
  result->SetName(array.name.c_str());
  for (std::size_t i = 0; i < array.component_names.size(); ++i)
    result->SetComponentName(static_cast<vtkIdType>(i), array.component_names[i].c_str());
  return result;
}

void add_arrays(const std::vector<DataArray>& arrays, vtkDataSetAttributes* to)
{
  for (const DataArray& array : arrays)
  {
    const int index = to->AddArray(to_vtk(array));
    const int attribute = attribute_of(array.role);
    if (attribute >= 0 && fits(array, attribute) && !to->GetAbstractAttribute(attribute))
      to->SetActiveAttribute(index, attribute);
  }
}

}
