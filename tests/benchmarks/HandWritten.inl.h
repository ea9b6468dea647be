// The loops of InstructionSet.h for the instruction set that the file which includes this is compiled
// for. That file says before what its vectors are, Doubles and Floats, how 1/√s of them is found, and
// how many vectors of targets go side by side (side_by_side), so that one's arithmetic fills the
// other's waits. Nothing that isn't in this file may be called: the linker could take it for others.

#include <cstring>
#include <type_traits>

namespace vesicle::benchmarks
{
namespace
{

// Chains hide the latency of a multiplication with addition, four or five cycles on two ports.
constexpr int chains = 12;

template<class Vector, class Real>
Real multiply_add(long rounds)
{
  Vector a[chains];
  for (int i = 0; i < chains; ++i)
    a[i] = Vector{} + static_cast<Real>(i);
  const Vector factor = Vector{} + static_cast<Real>(0.5);
  for (long k = 0; k < rounds; ++k)
#pragma GCC unroll 12
    for (int i = 0; i < chains; ++i)
      a[i] = a[i] * factor + factor;
  Real sum = 0;
  for (int i = 0; i < chains; ++i)
    sum += a[i][0];
  return sum;
}

template<class Vector, class Real>
void add_stokeslets(const PointForces<Real>& s, const Coordinate<Real>* targets, double* velocities)
{
  constexpr int lanes = sizeof(Vector) / sizeof(Real), row = side_by_side * lanes;
  std::conditional_t<std::is_same_v<Real, double>, Vector, Integers> x[side_by_side][3];
  Vector u[side_by_side][3] = {};
  for (int v = 0; v < side_by_side; ++v)
    for (int c = 0; c < 3; ++c)
      std::memcpy(&x[v][c], targets + c * row + v * lanes, sizeof(Vector));
  const auto& [sx, sy, sz] = s.position;
  const auto& [sfx, sfy, sfz] = s.strength;
  for (int q = 0; q < s.count; ++q)
#pragma GCC unroll 4
    for (int v = 0; v < side_by_side; ++v)
    {
      const Vector dx = __builtin_convertvector(sx[q] - x[v][0], Vector),
                   dy = __builtin_convertvector(sy[q] - x[v][1], Vector),
                   dz = __builtin_convertvector(sz[q] - x[v][2], Vector);
      Vector over_r;
      inverse_root(over_r, dx * dx + dy * dy + dz * dz);
      const Vector along = (sfx[q] * dx + sfy[q] * dy + sfz[q] * dz) * (over_r * over_r);
      u[v][0] += over_r * (sfx[q] + along * dx);
      u[v][1] += over_r * (sfy[q] + along * dy);
      u[v][2] += over_r * (sfz[q] + along * dz);
    }
  for (int v = 0; v < side_by_side; ++v)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < lanes; ++i)
        velocities[c * row + v * lanes + i] += u[v][c][i];
}

template<class Vector, class Real>
constexpr HandWritten<Real> hand_written()
{
  constexpr int lanes = sizeof(Vector) / sizeof(Real);
  return { multiply_add<Vector, Real>, 2L * chains * lanes, add_stokeslets<Vector, Real>,
    side_by_side * lanes };
}

}
}
