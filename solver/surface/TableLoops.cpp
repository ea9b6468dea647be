#include "solver/surface/TableLoops.h"

#include "solver/Lanes.h"

namespace vesicle
{

PaddedPoints padded(const Points& points)
{
  PaddedPoints result(points.rows(), 4);
  result << points, Eigen::VectorXd::Zero(points.rows());
  return result;
}

namespace
{

// The loops for a number of fields that the compiler knows, so that what they have at a row stays in
// registers, and sums that wait for each other are several.

template<int fields>
VESICLE_INLINE void sum_fields(
  const FieldRows& rows, const double* nodes, double* const* sums, long stride)
{
  const int *start = rows.table.start.data(), *node = rows.table.node.data();
  const double* const* const field = rows.fields.data();
  for (int q = rows.begin; q < rows.end; ++q)
  {
    Lanes sum[fields]{};
    for (int k = start[q]; k < start[q + 1]; ++k)
    {
      const Lanes& x = lanes_at(nodes + lanes * static_cast<long>(node[k]));
      for (int f = 0; f < fields; ++f)
        sum[f] += field[f][k] * x;
    }
    for (int f = 0; f < fields; ++f)
      for (int c = 0; c < 3; ++c)
        sums[f][q + c * stride] = sum[f][c];
  }
}

// use(entry, sum) with Σ_fields field_k f of each entry.
template<int fields, class Use>
VESICLE_INLINE void combine_fields(const FieldRows& rows, const double* of_rows, Use use)
{
  const int* start = rows.table.start.data();
  const double* field[fields];
  for (int f = 0; f < fields; ++f)
    field[f] = rows.fields[f];
  for (int q = rows.begin; q < rows.end; ++q, of_rows += fields * lanes)
  {
    Lanes at_row[fields];
    for (int f = 0; f < fields; ++f)
      at_row[f] = lanes_at(of_rows + f * lanes);
    for (int k = start[q]; k < start[q + 1]; ++k)
    {
      Lanes sum = field[0][k] * at_row[0];
      for (int f = 1; f < fields; ++f)
        sum += field[f][k] * at_row[f];
      use(k, sum);
    }
  }
}

template<class Use>
VESICLE_INLINE void combine(const FieldRows& rows, const double* of_rows, Use use)
{
  switch (rows.fields.size())
  {
    case 1:
      return combine_fields<1>(rows, of_rows, use);
    case 2:
      return combine_fields<2>(rows, of_rows, use);
    case 3:
      return combine_fields<3>(rows, of_rows, use);
    default:
      return combine_fields<5>(rows, of_rows, use);
  }
}

}

VESICLE_MULTIVERSION
void sum_over_entries(
  const FieldRows& rows, const PaddedPoints& nodes, std::span<double* const> sums, long stride)
{
  if (sums.size() == 1)
    sum_fields<1>(rows, nodes.data(), sums.data(), stride);
  else
    sum_fields<3>(rows, nodes.data(), sums.data(), stride);
}

VESICLE_MULTIVERSION
void add_to_nodes(const FieldRows& rows, const double* of_rows, PaddedPoints& nodes)
{
  const int* node = rows.table.node.data();
  double* x = nodes.data();
  combine(
    rows, of_rows, [=](int k, const Lanes& sum) __attribute__((always_inline)) {
      lanes_at(x + lanes * static_cast<long>(node[k])) += sum;
    });
}

VESICLE_MULTIVERSION
void combine_vectors(const FieldRows& rows, const double* of_rows, double* entries)
{
  combine(
    rows, of_rows, [=](int k, const Lanes& sum) __attribute__((always_inline)) {
      for (int c = 0; c < 3; ++c)
        entries[3 * static_cast<long>(k) + c] = sum[c];
    });
}

VESICLE_MULTIVERSION
void combine_numbers(const FieldRows& rows, const double* of_rows, double* entries)
{
  const int* start = rows.table.start.data();
  const std::size_t fields = rows.fields.size();
  for (int q = rows.begin; q < rows.end; ++q, of_rows += fields)
    for (std::size_t f = 0; f < fields; ++f)
    {
      const double *field = rows.fields[f], by = of_rows[f];
      if (f == 0) // NOLINT(bugprone-branch-clone): what is set first and added then
#pragma omp simd
        for (int k = start[q]; k < start[q + 1]; ++k)
          entries[k] = by * field[k];
      else
#pragma omp simd
        for (int k = start[q]; k < start[q + 1]; ++k)
          entries[k] += by * field[k];
    }
}

}
