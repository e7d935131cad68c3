// Chooses the basis of its material for every block, and none if its fixed points leave it no motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setup/choose_basis.hpp"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

// `points`: those of one element.
bool pins(const std::vector<const CarriedPoint*>& points) {
  const bool is_still = std::ranges::all_of(points, [](const CarriedPoint* p) { return p->curve.times.empty(); });
  return is_still && std::ranges::any_of(points, [&](const CarriedPoint* p) { return p->start != points[0]->start; });
}

}  // namespace

Model with_moving_bases(Model model, const PerMaterial<BlockBasis>& basis) {
  for (Element& element : model.elements)
    if (!element.is_on_covers())
      element.basis = basis.of(element.material) == BlockBasis::rigid ? &rigid_basis() : &affine_basis();
  return model;
}

Model with_bases(Model model, const PerMaterial<BlockBasis>& basis) {
  model = with_moving_bases(std::move(model), basis);
  Table<ElementIndex, std::vector<const CarriedPoint*>> points;
  points.resize(model.elements.size());
  for (const CarriedPoint& point : model.fixed_points)
    if (!point.holds_in_place) points[point.element].push_back(&point);
  for (ElementIndex e : indices(model.elements))
    if (!model.elements[e].is_on_covers() && pins(points[e])) model.elements[e].basis = &fixed_basis();
  return model;
}

bool has_held_moving_element(const Model& model) {
  return std::ranges::any_of(model.fixed_points,
                             [&](const CarriedPoint& point) { return model.elements[point.element].can_move(); });
}

}  // namespace keyblock
