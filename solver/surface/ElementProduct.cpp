#include "solver/surface/ElementProduct.h"

#include "solver/Lanes.h"

namespace vesicle
{

namespace
{

// Of the product four rows and `width` Lanes at once: as many sums as there are registers for.
constexpr int rows_at_once = lanes;
constexpr int most_lanes = 3;

template<int width>
VESICLE_INLINE void multiply_strip(int count, const double* a, int a_stride, const double* b,
  int b_stride, double* product, int stride)
{
  Lanes sum[rows_at_once][width]{};
  for (int q = 0; q < count; ++q, a += a_stride, b += b_stride)
    for (int r = 0; r < rows_at_once; ++r)
      for (int w = 0; w < width; ++w)
        sum[r][w] += a[r] * lanes_at(b + w * lanes);
  for (int r = 0; r < rows_at_once; ++r)
    for (int w = 0; w < width; ++w)
      lanes_at(product + r * stride + w * lanes) = sum[r][w];
}

}

VESICLE_MULTIVERSION
void multiply_rows(
  int count, int rows, int columns, const double* a, const double* b, double* product)
{
  const int a_stride = in_lanes(rows), stride = in_lanes(columns);
  for (int i = 0; i < rows; i += rows_at_once)
  {
    double* to = product + i * stride;
    int j = 0;
    for (; j + most_lanes * lanes <= stride; j += most_lanes * lanes)
      multiply_strip<most_lanes>(count, a + i, a_stride, b + j, stride, to + j, stride);
    for (; j < stride; j += lanes)
      multiply_strip<1>(count, a + i, a_stride, b + j, stride, to + j, stride);
  }
}

}
