#include "solver/membrane/ScaledTerm.h"

#include <cmath>
#include <utility>

namespace vesicle
{

ScaledTerm::ScaledTerm(std::unique_ptr<const MembraneTerm> term, double factor)
  : term_(std::move(term)), factor_(factor)
{
}

TermForce ScaledTerm::force(const Surface& surface) const
{
  TermForce force = term_->force(surface);
  for (Eigen::VectorXd* part : { &force.density.normal, &force.density.vector })
    *part *= factor_;
  if (force.linearisation)
    *force.linearisation *= factor_;
  return force;
}

// The second variation is a square of the rates.
Variation ScaledTerm::variation(const Surface& surface) const
{
  Variation variation = term_->variation(surface);
  variation.gradient *= factor_;
  for (EntryVectors& rates : variation.rates)
    rates *= std::sqrt(factor_);
  return variation;
}

}
