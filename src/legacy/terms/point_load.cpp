// Adds the forces of the loading points at the end of the step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/point_load.hpp"

namespace keyblock {

void add_point_load(const StepContext& context, System& system) {
  const auto& [model, state, settings, dt] = context;
  for (std::size_t i = 0; i < model.loading_points.size(); ++i) {
    const CarriedPoint& point = model.loading_points[i];
    const Point load = point.curve.at(state.time + dt);
    const DisplacementOperator t = basis_at(model, state, point.element, state.loading_points[i].position);
    system.load_of(point.element.value) += t.transpose() * Eigen::Vector2d(load.x, load.y);
  }
}

}  // namespace keyblock
