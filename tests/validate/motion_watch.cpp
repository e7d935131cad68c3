// Sums over the blocks that may move.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validate/motion_watch.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"
#include "geometry/simplex.hpp"
#include "material/elastic.hpp"

namespace keyblock {
namespace {

constexpr double kReleaseThatCounts = 1e-9;

using Loop = std::vector<Point>;

double turn(const Loop& loop, std::size_t i) {
  const auto at = [&](std::size_t k) { return loop[k % loop.size()]; };
  return cross(at(i + 1) - at(i), at(i + 2) - at(i + 1));
}

bool is_convex(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (turn(loop, i) < 0) return false;
  return true;
}

// Sutherland & Hodgman 1974: part of `loop` to the left of start → end.
Loop left_part(const Loop& loop, Point start, Point end) {
  const auto side = [&](Point p) { return cross(end - start, p - start); };
  Loop part;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i], b = loop[(i + 1) % loop.size()];
    if (side(a) >= 0) part.push_back(a);
    if (side(a) * side(b) < 0) part.push_back(a + side(a) / (side(a) - side(b)) * (b - a));
  }
  return part;
}

double shared_area(Loop of, const Loop& convex) {
  for (std::size_t i = 0; i < convex.size() && of.size() > 2; ++i)
    of = left_part(of, convex[i], convex[(i + 1) % convex.size()]);
  return of.size() > 2 ? std::abs(area(of)) : 0;
}

bool are_near(const Loop& a, const Loop& b) {
  const auto apart = [&](double Point::*axis) {
    const auto [low_a, high_a] = std::ranges::minmax(a, {}, axis);
    const auto [low_b, high_b] = std::ranges::minmax(b, {}, axis);
    return low_a.*axis > high_b.*axis || low_b.*axis > high_a.*axis;
  };
  return !apart(&Point::x) && !apart(&Point::y);
}

// Pairs of which one is convex; in the other pairs both are fixed blocks.
double shared_area(const Frame& frame) {
  double sum = 0;
  for (std::size_t i = 0; i < frame.elements.size(); ++i)
    for (std::size_t j = i + 1; j < frame.elements.size(); ++j) {
      const Loop& a = frame.elements[i].loops.front();
      const Loop& b = frame.elements[j].loops.front();
      if (!are_near(a, b)) continue;
      sum += is_convex(b) ? shared_area(a, b) : is_convex(a) ? shared_area(b, a) : 0;
    }
  return sum;
}

Moments moments_of(const ElementFrame& element) {
  Moments sum;
  for (const std::vector<Point>& loop : element.loops) sum += moments(loop, element.centroid);
  return sum;
}

Eigen::Vector3d stress_of(const ElementFrame& element) {
  return {element.stress.xx, element.stress.yy, element.stress.xy};
}

// D⁻¹ σ: xx, yy, and the full shear angle.
Eigen::Vector3d strain_of(const ElementFrame& element, const BlockMaterial& material, Plane plane) {
  const Eigen::Matrix3d modulus =
      plane == Plane::stress ? plane_stress_modulus(material) : plane_strain_modulus(material);
  return modulus.inverse() * stress_of(element);
}

}  // namespace

// det(I + ε).
double MotionWatch::strained_area(const ElementFrame& element) const {
  const Eigen::Vector3d strain =
      strain_of(element, model_.block_materials[static_cast<std::size_t>(element.material)], settings_.plane);
  return (1 + strain[0]) * (1 + strain[1]) - strain[2] * strain[2] / 4;
}

void MotionWatch::begin(const Frame& frame) {
  double low = INFINITY;
  double high = -INFINITY;
  for (std::size_t i = 0; i < frame.elements.size(); ++i) {
    const ElementFrame& element = frame.elements[i];
    const Moments m = moments_of(element);
    const Element& modelled = model_.elements[ElementIndex{static_cast<int>(i)}];
    const double density =
        modelled.basis->unknown_count() == 0 ? 0 : model_.material_of(modelled).density;  // fixed blocks do not count
    masses_.push_back({density * m.area, density * (m.xx + m.yy), element.centroid, m.area, strained_area(element)});
    total_mass_ += density * m.area;
    if (density == 0) continue;
    for (const Point& p : element.loops.front()) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  }
  height_ = high - low;
}

void MotionWatch::see(const Frame& frame) {
  const bool is_first = masses_.empty();
  if (is_first) begin(frame);
  double kinetic = 0;
  double strain = 0;
  double released = 0;
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const ElementFrame& element = frame.elements[i];
    const Mass& m = masses_[i];
    const Velocity& v = element.velocity;
    kinetic += 0.5 * m.mass * (v.x * v.x + v.y * v.y) + 0.5 * m.inertia * v.rotation * v.rotation;
    released += m.mass * dot(settings_.gravity, element.centroid - m.start);
    if (m.mass == 0) continue;
    strain += 0.5 * element.area *
              stress_of(element).dot(strain_of(
                  element, model_.block_materials[static_cast<std::size_t>(element.material)], settings_.plane));
    const double grown = element.area / m.area;
    area_change_ = std::max(area_change_, std::abs(grown - 1));
    false_area_change_ = std::max(false_area_change_, std::abs(grown * m.strained_area / strained_area(element) - 1));
  }
  if (is_first) start_energy_ = kinetic + strain;
  all_finite_ = all_finite_ && std::isfinite(kinetic + released + area_change_);
  excess_ = std::max(excess_, (kinetic - released) / energy_scale());
  gain_ = std::max(gain_, (kinetic + strain - released - start_energy_) / energy_scale());
  double area = 0;
  for (const Mass& m : masses_) area += m.mass > 0 ? m.area : 0;
  overlap_ = std::max(overlap_, shared_area(frame) / area);
  rise_ = std::max(rise_, -released / energy_scale());
  if (released > kReleaseThatCounts * energy_scale()) ratio_ = std::max(ratio_, kinetic / released);
}

}  // namespace keyblock
