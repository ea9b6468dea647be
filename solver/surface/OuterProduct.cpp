#include "solver/surface/OuterProduct.h"

#include "solver/Multiversion.h"

namespace vesicle
{

VESICLE_MULTIVERSION
void add_outer_product(
  int rows, int columns, double factor, const double* a, const double* b, double* block)
{
  for (int i = 0; i < rows; ++i)
  {
    const double by = factor * a[i];
    double* row = block + static_cast<long>(i) * columns;
#pragma omp simd
    for (int j = 0; j < columns; ++j)
      row[j] += by * b[j];
  }
}

}
