// Computes the affine field of three corners, and velocities from it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/step/hanging.hpp"

#include <algorithm>
#include <utility>

#include "model/shared_covers.hpp"

namespace keyblock {
namespace {

struct Weight {
  double area = 0;
  Point moment;
};

}  // namespace

Eigen::Matrix<double, 6, 6> affine_from_corners(const std::array<Point, 3>& corners, Point centroid) {
  const double twice_area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = corners[(i + 1) % 3];
    const Point q = corners[(i + 2) % 3];
    const double share = cross(p - centroid, q - centroid) / twice_area;  // of corner i at the centroid
    const double dx = (p.y - q.y) / twice_area;
    const double dy = (q.x - p.x) / twice_area;
    const auto x = 2 * static_cast<Eigen::Index>(i);
    a.col(x) << share, 0, -dy / 2, dx, 0, dy;
    a.col(x + 1) << 0, share, dx / 2, 0, dy, dx;
  }
  return a;
}

Eigen::Matrix<double, 6, 6> affine_from_nodes(const Element& element, Point centroid, const State& state) {
  const auto at = [&](std::size_t i) { return state.nodes[static_cast<std::size_t>(element.covers[i])].position; };
  return affine_from_corners({at(0), at(1), at(2)}, centroid);
}

Model with_affine_elements(Model model) {
  for (Element& element : model.elements) element.basis = &affine_basis();
  return model;
}

std::vector<NodeState> start_nodes(const Model& model, const Table<ElementIndex, ElementState>& elements) {
  std::vector<NodeState> nodes;
  if (model.nodes.empty()) return nodes;
  for (const Point p : model.nodes) nodes.push_back({p, {}, {}});
  const std::vector<int> bodies = body_numbers(model);
  std::vector<Weight> weights(model.elements.size());
  for (ElementIndex e : indices(model.elements)) {
    Weight& body = weights[static_cast<std::size_t>(bodies[static_cast<std::size_t>(e.value)])];
    body.area += elements[e].moments.area;
    body.moment = body.moment + elements[e].moments.area * elements[e].centroid;
  }
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    if (!element.is_on_covers()) continue;
    const Weight& body = weights[static_cast<std::size_t>(bodies[static_cast<std::size_t>(e.value)])];
    const Velocity v = model.material_of(element).initial_velocity;
    for (const int number : element.covers) {
      NodeState& node = nodes[static_cast<std::size_t>(number)];
      const Point arm = node.position - (1 / body.area) * body.moment;
      node.velocity = {v.x - v.rotation * arm.y, v.y + v.rotation * arm.x};
    }
  }
  return nodes;
}

void hang_velocities(const Model& model, State& state) {
  if (model.nodes.empty()) return;
  for (ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    if (!element.is_on_covers() || element.basis->unknown_count() == 0) continue;
    Eigen::Matrix<double, 6, 1> velocities;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point v = state.nodes[static_cast<std::size_t>(element.covers[i])].velocity;
      velocities.segment<2>(2 * static_cast<Eigen::Index>(i)) << v.x, v.y;
    }
    ElementState& now = state.elements[e];
    now.velocity = affine_from_nodes(element, now.centroid, state) * velocities;
  }
}

}  // namespace keyblock
