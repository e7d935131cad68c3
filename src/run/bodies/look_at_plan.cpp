// Finds parts of chains that lie on no boundary, and tries every formula once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/look_at_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/sentences/sentences.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"
#include "run/bodies/agreement.hpp"
#include "terms/cover_loads.hpp"

namespace keyblock {
namespace {

// Fraction of the length of a chain: less than this off the boundary is rounding.
constexpr double kLittleOff = 1e-6;
// Degree of the quadrature on areas and sides at which loads are tried.
constexpr int kTriedDegree = 2;

/// Length of a chain on none of these edges, and its first point off them.
struct OffBoundary {
  double whole = 0;  ///< length of the chain
  double off = 0;
  Point first;
};

OffBoundary off_boundary(const BoundaryPart& part, std::span<const Segment> edges, double near) {
  OffBoundary found;
  for (const Segment& piece : pieces_of(part)) {
    found.whole += distance(piece.start, piece.end);
    Point at = piece.start;
    const auto leave_out = [&](Point to) {
      if (found.off == 0) found.first = at;
      found.off += distance(at, to);
    };
    for (const Segment& covered : parts_along(piece, edges, near)) {
      leave_out(covered.start);
      at = covered.end;
    }
    leave_out(piece.end);
  }
  return found;
}

// Formulas report their own errors.
void try_formulas(const Continuum& continuum) {
  sum_of_loads(continuum, kTriedDegree);
  for (const ChangingTraction& part : continuum.changing_tractions)
    for (const ElementSide& side : sides_along(continuum.manifold, part.along))
      part.force(0.5 * (side.edge.start + side.edge.end), side.normal(), 0);
  for (const PrescribedDisplacement& part : continuum.prescribed)
    for (const ElementSide& side : sides_along(continuum.manifold, part.along))
      part.value(0.5 * (side.edge.start + side.edge.end), side.normal());
  for (std::size_t e = 0; e < continuum.manifold.elements.size(); ++e)
    continuum.initial_stress_at(static_cast<int>(e),
                                centroid(continuum.manifold.polygon(continuum.manifold.elements[e]).front()));
}

}  // namespace

void look_at_chain(const BoundaryPart& part, const Place& place, std::string_view edges_in_words,
                   std::span<const Segment> edges, double near, Warnings& warnings) {
  const OffBoundary found = off_boundary(part, edges, near);
  if (found.off == found.whole)
    throw InputError(place, fmt::format("expected a chain on {}, found none of it there: ({:.9g}, {:.9g}), …",
                                        edges_in_words, part.front().x, part.front().y));
  if (!(found.off > kLittleOff * found.whole)) return;
  Facts facts{{{"off", found.off}, {"length", found.whole}}};
  facts.points = {{found.first.x, found.first.y}};
  warnings.push_back(warning_of({"chain_off_boundary", std::move(facts)}, place));
}

Warnings look_at_plan(const CoverPlan& plan, const std::vector<const Continuum*>& scenes) {
  Warnings warnings;
  // Excavation may expose a boundary later, so that the edges of all scenes count.
  std::vector<Segment> edges;
  double near = 0;
  for (const Continuum* scene : scenes) {
    for (const ElementSide& side : boundary_sides(scene->manifold)) edges.push_back(side.edge);
    near = std::max(near, reach_of_chains(scene->manifold));
  }
  const auto look = [&](const auto& part) {
    if (!part.acts_on_all) look_at_chain(part.along, part.place, "the boundary of NMM bodies", edges, near, warnings);
  };
  for (const TractionPlan& part : plan.tractions) look(part);
  for (const DisplacementPlan& part : plan.displacements) look(part);
  for (const Continuum* scene : scenes) try_formulas(*scene);
  require_agreement(plan, scenes);
  return warnings;
}

}  // namespace keyblock
