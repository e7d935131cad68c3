// Counts the distinct, undriven fixed points of each element.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/choose_basis.hpp"

#include <algorithm>

namespace keyblock {
namespace {

bool is_pinned(const Model& model, ElementIndex e) {
  std::vector<Point> places;
  for (const CarriedPoint& point : model.fixed_points) {
    if (point.element != e) continue;
    if (!point.curve.times.empty()) return false;
    if (std::ranges::find(places, point.start) == places.end()) places.push_back(point.start);
  }
  return places.size() >= 2;
}

}  // namespace

Model with_bases(Model model, const PerMaterial<BlockBasis>& basis) {
  for (ElementIndex e : indices(model.elements)) {
    Element& element = model.elements[e];
    const Basis& moving = basis.of(element.material) == BlockBasis::rigid ? rigid_basis() : affine_basis();
    element.basis = is_pinned(model, e) ? &fixed_basis() : &moving;
  }
  return model;
}

bool has_held_moving_element(const Model& model) {
  return std::ranges::any_of(model.fixed_points, [&](const CarriedPoint& point) {
    return model.elements[point.element].basis->unknown_count() > 0;
  });
}

}  // namespace keyblock
