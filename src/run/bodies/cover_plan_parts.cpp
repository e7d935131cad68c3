// Compiles formulas once and finds points in their elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/cover_plan_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "cut/bodies/place_points.hpp"
#include "cut/covers/to_cover.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

constexpr std::array<std::string_view, 5> kInTime{"x", "y", "nx", "ny", "t"};
constexpr std::span<const std::string_view> kOnBoundary = std::span(kInTime).first<4>();
constexpr std::span<const std::string_view> kInBody = kOnBoundary.first<2>();

// Tolerance relative to the extent of all bodies: cutting rounds, and a point on an edge belongs to the body.
constexpr double kOnEdge = 1e-9;

Traction traction_of(const TractionPlan& plan) {
  const TractionOnEdge on_edge = traction_on_edge(plan);
  return {plan.along, [=](Point at, Point n) { return on_edge.force(at, n, 0) - on_edge.pressure(at, n, 0) * n; }};
}

ChangingTraction changing_of(const TractionPlan& plan) {
  const TractionOnEdge on_edge = traction_on_edge(plan);
  const TimeCurve factor = curve_of(plan.over_time);
  return {plan.along,
          [=](Point at, Point n, double t) {
            return (factor.times.empty() ? 1 : factor.at(t).x) *
                   (on_edge.force(at, n, t) - on_edge.pressure(at, n, t) * n);
          },
          plan.uses_time() ? std::numeric_limits<double>::infinity() : factor.last_change(), factor.times};
}

FollowingPressure pressure_of(const TractionPlan& plan) {
  const TractionOnEdge on_edge = traction_on_edge(plan);
  const TimeCurve factor = curve_of(plan.over_time);
  return {plan.along, [=](Point at, Point n, double t) {
            return (factor.times.empty() ? 1 : factor.at(t).x) * on_edge.pressure(at, n, t);
          }};
}

double gap_to(const Manifold& manifold, const ManifoldElement& element, Point p) {
  const auto loops = manifold.polygon(element);
  double nearest = std::numeric_limits<double>::max();
  bool is_in = side(loops.front(), p) != Side::outside;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k > 0 && side(loops[k], p) == Side::inside) is_in = false;
    for (std::size_t i = 0; i < loops[k].size(); ++i)
      nearest = std::min(nearest, distance(Segment{loops[k][i], loops[k][(i + 1) % loops[k].size()]}, p));
  }
  return is_in ? 0 : nearest;
}

/// Drops points whose block is gone.
template <class Part>
std::vector<Part> in_blocks(const std::vector<Part>& parts, const Blocks& blocks) {
  std::vector<Part> kept;
  for (const Part& part : parts)
    if (std::ranges::any_of(blocks.blocks, [&](const BlockPolygon& block) { return holds(block, part.at); }))
      kept.push_back(part);
  return kept;
}

}  // namespace

TimeCurve curve_of(const std::vector<FactorAt>& rows) {
  TimeCurve curve;
  for (const FactorAt& row : rows) {
    curve.times.push_back(row.time);
    curve.values.push_back({row.factor, 0});
  }
  return curve;
}

TractionOnEdge traction_on_edge(const TractionPlan& plan) {
  const Compiled x(plan.x, kInTime), y(plan.y, kInTime), pressure(plan.pressure, kInTime);
  return {[=](Point at, Point n, double t) {
            return Point{x({at.x, at.y, n.x, n.y, t}), y({at.x, at.y, n.x, n.y, t})};
          },
          [=](Point at, Point n, double t) {
            return pressure({at.x, at.y, n.x, n.y, t});
          }};
}

PrescribedDisplacement displacement_of(const DisplacementPlan& plan) {
  const Compiled x(plan.x, kOnBoundary), y(plan.y, kOnBoundary), normal(plan.normal, kOnBoundary);
  return {plan.along, plan.held, [=](Point at, Point n) {
            return Point{x({at.x, at.y, n.x, n.y}), y({at.x, at.y, n.x, n.y})} + normal({at.x, at.y, n.x, n.y}) * n;
          }};
}

CoverPlan what_is_left_of(CoverPlan plan, const Manifold& bodies, const Blocks& blocks) {
  const auto is_gone = [&](const auto& part) { return sides_along(bodies, part.along).empty(); };
  std::erase_if(plan.tractions, is_gone);
  std::erase_if(plan.displacements, is_gone);
  plan.forces = in_blocks(plan.forces, blocks);
  plan.springs = in_blocks(plan.springs, blocks);
  return plan;
}

void put_loads(Continuum& continuum, const CoverPlan& plan) {
  for (const TractionPlan& part : plan.tractions) {
    if (part.changes_over_time())
      continuum.changing_tractions.push_back(changing_of(part));
    else
      continuum.tractions.push_back(traction_of(part));
    if (!Compiled(part.pressure, kInTime).is_zero()) continuum.pressures.push_back(pressure_of(part));
  }
  for (const DisplacementPlan& part : plan.displacements) continuum.prescribed.push_back(displacement_of(part));
  const Compiled fx(plan.body_force.x, kInBody), fy(plan.body_force.y, kInBody);
  if (!fx.is_zero() || !fy.is_zero())
    continuum.body_force = [=](Point p) { return Point{fx({p.x, p.y}), fy({p.x, p.y})}; };
  const Compiled xx(plan.initial_stress.xx, kInBody), yy(plan.initial_stress.yy, kInBody),
      xy(plan.initial_stress.xy, kInBody);
  const Compiled zz(plan.initial_stress.zz.value_or(Formula{}), kInBody);
  continuum.gives_initial_zz = plan.initial_stress.zz.has_value();
  if (!xx.is_zero() || !yy.is_zero() || !xy.is_zero() || !zz.is_zero())
    continuum.initial_stress = [=](Point p) {
      return Stress{xx({p.x, p.y}), yy({p.x, p.y}), xy({p.x, p.y}), zz({p.x, p.y})};
    };
}

int element_holding(const Manifold& manifold, int body, Point p, const char* noun, const Place& place) {
  Box box;
  for (const ElementCorner& corner : manifold.corners) box.add(corner.position);
  const double near = kOnEdge * length(box.size());
  const int bodies = static_cast<int>(manifold.body_materials.size());
  for (int b = body < 0 ? 0 : body; b < (body < 0 ? bodies : body + 1); ++b) {
    const int element = element_at(manifold, b, p);
    if (element >= 0 && gap_to(manifold, manifold.elements[static_cast<std::size_t>(element)], p) <= near)
      return element;
  }
  throw InputError(place, fmt::format("expected {} in a body, found none at ({:.9g}, {:.9g})", noun, p.x, p.y));
}

void put_points(Continuum& continuum, const CoverPlan& plan) {
  for (const ForcePlan& force : plan.forces)
    continuum.point_forces.push_back(
        {element_holding(continuum.manifold, -1, force.at, "a force", force.place), force.at, force.force});
  for (const SpringPlan& spring : plan.springs)
    continuum.point_springs.push_back({element_holding(continuum.manifold, -1, spring.at, "a spring", spring.place),
                                       spring.at, (1 / length(spring.direction)) * spring.direction, spring.stiffness});
}

}  // namespace keyblock
