// Adapts Shi's penalty: aims at the allowed penetration and falls by at most a factor of three.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/penalty.hpp"

#include <algorithm>

namespace keyblock {
namespace {

constexpr double kFloor = 1e-7;     // added to either estimate (legacy-rules 11.3)
constexpr double kFastestFall = 3;  // the stiffness falls at most by this factor
constexpr double kTooDeep = 2.5;    // penetration over the allowed one that forces a redo
constexpr double kRedoIncrease = 10;

}  // namespace

Misfit misfit(const Contacts& contacts) {
  Misfit greatest;
  for (const Contact& contact : contacts) {
    if (contact.is_open()) continue;
    greatest.opening = std::max(greatest.opening, contact.distance);
    greatest.penetration = std::max(greatest.penetration, -contact.distance);
  }
  return greatest;
}

double penetration_share(const Contacts& contacts, const Model& model, const State& state) {
  Table<ElementIndex, double> sizes(model.elements.size(), 0);  // 0: not computed yet
  const auto size_of = [&](ElementIndex e) {
    double& size = sizes[e];
    if (size > 0) return size;
    for (VertexIndex v : model.elements[e].vertices())
      size = std::max(size, distance(state.vertices[v], state.elements[e].centroid));
    return size;
  };
  double greatest = 0;
  for (const Contact& contact : contacts) {
    if (contact.is_open() || contact.distance >= 0) continue;
    const double one = size_of(model.vertices[contact.active().vertex].element);
    const double other = size_of(model.vertices[contact.active().start].element);
    greatest = std::max(greatest, -contact.distance / std::min(one, other));
  }
  return greatest;
}

AdaptedPenalty adapt(double penalty, const Misfit& misfit, double scale, const Settings& settings) {
  if (settings.penalty_control == PenaltyControl::constant) return {penalty, false};
  const double opening = misfit.opening / scale / (2 * settings.allowed_displacement_ratio);
  const double penetration = misfit.penetration / scale / settings.open_close.allowed_penetration;
  const double adapted = std::max({penalty * opening + kFloor, penalty * penetration + kFloor, penalty / kFastestFall});
  const bool redo = penetration > kTooDeep;
  return {redo ? kRedoIncrease * adapted : adapted, redo};
}

}  // namespace keyblock
