#pragma once
// A membrane term of another strength: of a vesicle whose bending rigidity isn't the one that sets
// the unit of energy.

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// `factor` > 0 times the energy of a term, and so its force, rate and second variation. It has the
/// term's name.
class ScaledTerm final : public MembraneTerm
{
public:
  ScaledTerm(std::unique_ptr<const MembraneTerm> term, double factor);
  std::string name() const override { return term_->name(); }
  bool external() const override { return term_->external(); }
  bool stiff() const override { return term_->stiff(); }
  double rate() const override { return factor_ * term_->rate(); }
  double energy(const Surface& surface) const override { return factor_ * term_->energy(surface); }
  TermForce force(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;

private:
  std::unique_ptr<const MembraneTerm> term_;
  double factor_;
};

}
