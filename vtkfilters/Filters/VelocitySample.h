#pragma once
// A velocity field at one moment: a data set whose points have velocities.

#include "solver/mesh/TriangleMesh.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkStaticCellLocator;

namespace vesicle
{

/// What to tell users of a field that isn't free of divergence, see VelocitySample::Rates; empty: it is.
std::string divergence_note(const std::string& name, double divergence);

/// For one thread at a time, as VTK's cells and locators are.
class VelocitySample
{
public:
  /// The velocity is the active vectors of the points, else their only array of three components; of
  /// cells, brought to the points, where points have none. `name`: of the field, for messages. Throws
  /// InputError with it, what is wrong and a remedy.
  VelocitySample(vtkSmartPointer<vtkDataSet> data, std::string name);

  const std::string& name() const { return name_; }

  /// Adds the velocities at the points times a factor. Throws NumericalError naming a point that isn't
  /// in the field.
  void add(const Points& points, double factor, Points& velocities);

  struct Rates
  {
    double largest = 0;    ///< of the gradient's largest singular value
    double divergence = 0; ///< mean of |∇·u| over that of the singular value
  };
  Rates rates() const;

private:
  [[noreturn]] void leave(const double x[3]) const;

  std::string name_;
  vtkSmartPointer<vtkDataSet> data_;
  vtkSmartPointer<vtkDataArray> velocity_;
  vtkSmartPointer<vtkStaticCellLocator> locator_; ///< of points without a structure
  double tolerance_ = 0;
  vtkNew<vtkGenericCell> cell_;
  std::vector<double> weights_;
};

}
