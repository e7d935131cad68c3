// Adds the springs of the fixed points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/fixed_point.hpp"

namespace keyblock {

void add_fixed_point(const StepContext& context, System& system) {
  const auto& [model, state, settings, dt] = context;
  const double stiffness = settings.fixed_point_factor * settings.contact_penalty;
  for (std::size_t i = 0; i < model.fixed_points.size(); ++i) {
    const CarriedPoint& point = model.fixed_points[i];
    const PointState& now = state.fixed_points[i];
    const Point gap = point.curve.at(state.time + dt) - now.displacement;
    const DisplacementOperator t = basis_at(model, state, point.element, now.position);
    system.matrix.add(point.element.value, point.element.value, stiffness * (t.transpose() * t));
    system.load_of(point.element.value) += stiffness * (t.transpose() * Eigen::Vector2d(gap.x, gap.y));
  }
}

}  // namespace keyblock
