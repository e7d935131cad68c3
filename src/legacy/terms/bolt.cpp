// Adds stiffness and force of every bolt to its two elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/bolt.hpp"

#include <array>

namespace keyblock {
namespace {

struct EndRow {
  int element;
  Unknowns elongation;  ///< per unit of the element's unknowns
};

std::array<EndRow, 2> rows_of(const Bolt& bolt, const BoltState& now, const StepContext& context) {
  const Point along = (1 / distance(now.first, now.second)) * (now.second - now.first);
  const Eigen::Vector2d direction(along.x, along.y);
  const auto elongation = [&](ElementIndex e, Point end) -> Unknowns {
    return basis_at(context.model, context.state, e, end).transpose() * direction;
  };
  return {{{bolt.first.element.value, -elongation(bolt.first.element, now.first)},
           {bolt.second.element.value, elongation(bolt.second.element, now.second)}}};
}

}  // namespace

void add_bolt(const StepContext& context, System& system) {
  for (std::size_t i = 0; i < context.model.bolts.size(); ++i) {
    const Bolt& bolt = context.model.bolts[i];
    const BoltState& now = context.state.bolts[i];
    if (now.first == now.second) continue;
    const auto [first, second] = rows_of(bolt, now, context);
    for (const EndRow& end : {first, second}) {
      system.matrix.add(end.element, end.element, bolt.stiffness * (end.elongation * end.elongation.transpose()));
      system.load_of(end.element) -= now.force * end.elongation;
    }
    const UnknownBlock coupling = bolt.stiffness * (first.elongation * second.elongation.transpose());
    system.matrix.add(first.element, second.element, coupling);
    if (first.element == second.element)
      system.matrix.add(first.element, first.element, UnknownBlock(coupling.transpose()));
  }
}

}  // namespace keyblock
