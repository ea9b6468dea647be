#include "solver/flow/FlowKinds.h"

#include "solver/flow/Extension.h"
#include "solver/flow/FieldFlow.h"
#include "solver/flow/FourRollMill.h"
#include "solver/flow/Poiseuille.h"
#include "solver/flow/Rotation.h"
#include "solver/flow/Shear.h"
#include "solver/flow/Uniform.h"

#include <algorithm>

namespace vesicle
{

const std::vector<const FlowKind*>& flow_kinds()
{
  static const std::vector<const FlowKind*> kinds{
    &Uniform::description(),
    &Shear::description(),
    &Extension::description(Extension::Type::planar),
    &Extension::description(Extension::Type::axisymmetric),
    &Poiseuille::description(),
    &Rotation::description(),
    &FourRollMill::description(),
    &FieldFlow::description(),
  };
  return kinds;
}

int number_of(const FlowKind& kind)
{
  const auto& kinds = flow_kinds();
  return 1 + static_cast<int>(std::find(kinds.begin(), kinds.end(), &kind) - kinds.begin());
}

}
