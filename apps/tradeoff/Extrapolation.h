#pragma once
// What a quantity tends to as a mesh or a time step is refined, and how well that is known.

#include <vector>

namespace vesicle::tradeoff
{

/// A quantity computed at a resolution h > 0, whose error goes as h^p.
struct Sample
{
  double h, value;
};

/// The orders p that are possible, all as likely before the samples have spoken.
struct Orders
{
  double lowest, highest;
};

struct Limit
{
  double value;       ///< for h = 0
  double uncertainty; ///< half the width of an interval that holds nine limits of ten, or more
  double order;       ///< the samples' own, as far as they tell
};

/// The model is q_i = q + c h_i^p + s h_i^p z_i: a leading error, and an irregular part of the same order
/// (meshes that aren't refinements of each other, steps that a controller chose) of unknown size s, z_i
/// independent and normal. For a given p that is linear regression with weights h^−p; over p it is
/// averaged by the samples' likelihood, q and c integrated out. Two samples tell nothing of s: it then
/// counts as a quarter of |c|, which is also worth one sample more where there are others. Few samples
/// may lie well by chance: the uncertainty is 1 + 2/(n − 1) times the regression's standard error.
///
/// Samples of the same h count as one, their mean. Throws InputError for fewer than two different h, for
/// an h that isn't positive, for a value that isn't finite, or for orders that aren't 0 < lowest <= highest.
Limit extrapolate(std::vector<Sample> samples, const Orders& orders);

}
