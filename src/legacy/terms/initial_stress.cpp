// Subtracts the force of the current stress on the strain unknowns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/initial_stress.hpp"

#include "base/loop.hpp"

namespace keyblock {

void add_initial_stress(const StepContext& context, System& system) {
  for_each_index(context.model.elements, [&](ElementIndex e) {
    const ElementState& now = context.state.elements[e];
    const Eigen::Vector3d stress(now.stress.xx, now.stress.yy, now.stress.xy);
    const StrainOperator strain = context.model.elements[e].basis->strain();
    system.load_of(e.value) -= now.moments.area * (strain.transpose() * stress);
  });
}

}  // namespace keyblock
