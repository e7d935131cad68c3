// Compares edge by edge, and each edge with the next of its loop; see agreement.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/bodies/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "geometry/segment.hpp"
#include "run/bodies/cover_plan_parts.hpp"
#include "terms/held_edges.hpp"

namespace keyblock {
namespace {

// Tolerance relative to the largest value of either: formulas round.
constexpr double kSameValue = 1e-9;
// Difference of unit directions: edges of one straight line are cut with rounding.
constexpr double kParallel = 1e-6;

/// Part of an edge that one prescribed displacement fixes.
struct HeldPart {
  std::size_t number = 0;  ///< of the plan
  ElementSide side;
};

class Agreement {
 public:
  Agreement(const CoverPlan& plan, const Manifold& manifold)
      : plan_(plan), near_(reach_of_chains(manifold)), sides_(boundary_sides(manifold)), parts_(sides_.size()) {
    Continuum all;
    put_loads(all, plan);
    prescribed_ = std::move(all.prescribed);
    largest_.resize(prescribed_.size());
    for (std::size_t i = 0; i < prescribed_.size(); ++i) find_parts(i);
  }

  void require_of_loop(std::size_t first, std::size_t size) const {
    for (std::size_t k = 0; k < size; ++k) {
      const std::vector<HeldPart>& here = parts_[first + k];
      for (std::size_t a = 0; a < here.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) require_on_edge(here[a], here[b]);
      const Point corner = sides_[first + k].edge.end;
      for (const HeldPart& a : here)
        for (const HeldPart& b : parts_[first + (k + 1) % size])
          if (distance(a.side.edge.end, corner) <= near_ && distance(b.side.edge.start, corner) <= near_)
            require_at(a, b, corner);
    }
  }

 private:
  void find_parts(std::size_t number) {
    const std::vector<Segment> pieces = pieces_of(prescribed_[number].along);
    for (std::size_t k = 0; k < sides_.size(); ++k)
      for (const Segment& held : parts_along(sides_[k].edge, pieces, near_)) {
        parts_[k].push_back({number, {sides_[k].element, held}});
        for (const double at : {0.0, 0.5, 1.0})
          largest_[number] =
              std::max(largest_[number], length(prescribed_[number].value(point_at(held, at), sides_[k].normal())));
      }
  }

  void require_on_edge(const HeldPart& a, const HeldPart& b) const {
    for (const Segment& common : parts_along(a.side.edge, std::array{b.side.edge}, near_))
      for (const double at : {0.0, 0.5, 1.0}) require_at(a, b, point_at(common, at));
    if (distance(a.side.edge.end, b.side.edge.start) <= near_) require_at(a, b, a.side.edge.end);
    if (distance(b.side.edge.end, a.side.edge.start) <= near_) require_at(a, b, b.side.edge.end);
  }

  /// Returns the projector on the components that both fix.
  static Eigen::Matrix2d held_by_both(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
    if (a.isIdentity()) return b;
    if (b.isIdentity() || (a - b).norm() < kParallel) return a;
    return Eigen::Matrix2d::Zero();
  }

  /// Returns true for two halves of one formula: at a corner both give the same value on either side's normal.
  bool are_one(const HeldPart& a, const HeldPart& b, Point x) const {
    const PrescribedDisplacement& of_a = prescribed_[a.number];
    const PrescribedDisplacement& of_b = prescribed_[b.number];
    const auto is_same = [&](Point n) { return length(of_a.value(x, n) - of_b.value(x, n)) <= allowed(a, b); };
    return of_a.held == of_b.held && is_same(a.side.normal()) && is_same(b.side.normal());
  }

  double allowed(const HeldPart& a, const HeldPart& b) const {
    return kSameValue * std::max(largest_[a.number], largest_[b.number]);
  }

  /// Returns true if no stage has both.
  bool are_apart(const HeldPart& a, const HeldPart& b) const {
    const ActiveStages& of_a = plan_.displacements[a.number].stages;
    const ActiveStages& of_b = plan_.displacements[b.number].stages;
    return (of_a.last && of_b.first && *of_a.last < *of_b.first) ||
           (of_b.last && of_a.first && *of_b.last < *of_a.first);
  }

  void require_at(const HeldPart& a, const HeldPart& b, Point x) const {
    if (a.number == b.number || are_apart(a, b) || are_one(a, b, x)) return;
    const PrescribedDisplacement& of_a = prescribed_[a.number];
    const PrescribedDisplacement& of_b = prescribed_[b.number];
    const Eigen::Matrix2d both =
        held_by_both(held_projector(of_a.held, a.side.normal()), held_projector(of_b.held, b.side.normal()));
    const auto value = [&](const PrescribedDisplacement& of, const HeldPart& part) {
      const Point u = of.value(x, part.side.normal());
      return Eigen::Vector2d(both * Eigen::Vector2d(u.x, u.y));
    };
    const Eigen::Vector2d u_a = value(of_a, a), u_b = value(of_b, b);
    if ((u_a - u_b).norm() <= allowed(a, b)) return;
    const bool is_a_later = a.number > b.number;
    const DisplacementPlan& later = plan_.displacements[is_a_later ? a.number : b.number];
    const DisplacementPlan& other = plan_.displacements[is_a_later ? b.number : a.number];
    const auto text = [](const Eigen::Vector2d& u) {
      return fmt::format("({:.6g}, {:.6g})", u.x() + 0.0, u.y() + 0.0);
    };
    throw InputError(
        later.place,
        fmt::format("expected prescribed displacements that agree at common points, found {} here and {} in that of {} "
                    "at the point ({:.6g}, {:.6g}), in components that both prescribe; end one chain before that "
                    "point, or give both the same value there",
                    text(is_a_later ? u_a : u_b), text(is_a_later ? u_b : u_a), to_string(other.place), x.x, x.y));
  }

  const CoverPlan& plan_;
  double near_ = 0;
  std::vector<ElementSide> sides_;
  std::vector<std::vector<HeldPart>> parts_;  ///< one list per side
  std::vector<PrescribedDisplacement> prescribed_;
  std::vector<double> largest_;  ///< length of the values of each
};

/// Returns the projected value at a point of a piece of the chain; empty if it is zero within rounding.
std::optional<Eigen::Vector2d> moved(const PrescribedDisplacement& prescribed, const Segment& piece, Point x) {
  const Point along = piece.end - piece.start;
  const Point normal = (1 / length(along)) * Point{along.y, -along.x};
  const auto value = [&](Point p) {
    const Point u = prescribed.value(p, normal);
    return Eigen::Vector2d(held_projector(prescribed.held, normal) * Eigen::Vector2d(u.x, u.y));
  };
  double largest = 0;
  for (const double at : {0.0, 0.5, 1.0}) largest = std::max(largest, value(point_at(piece, at)).norm());
  const Eigen::Vector2d u = value(x);
  return u.norm() > kSameValue * largest ? std::optional(u) : std::nullopt;
}

}  // namespace

void require_agreement(const CoverPlan& plan, const std::vector<const Continuum*>& scenes) {
  if (plan.displacements.size() < 2) return;
  for (const Continuum* scene : scenes) {
    const Agreement agreement(plan, scene->manifold);
    std::size_t first = 0;
    for (const SlotRange& loop : scene->manifold.boundary_loops) {
      agreement.require_of_loop(first, static_cast<std::size_t>(loop.size));
      first += static_cast<std::size_t>(loop.size);
    }
  }
}

void require_agreement(const CoverPlan& plan, const Model& model) {
  if (!model.continuum || plan.displacements.empty() || model.fixed_points.empty()) return;
  Continuum all;
  put_loads(all, plan);
  const double near = reach_of_chains(model.continuum->manifold);
  for (const CarriedPoint& fixed : model.fixed_points) {
    if (!model.elements[fixed.element].is_on_covers() || !fixed.curve.times.empty()) continue;
    for (std::size_t i = 0; i < all.prescribed.size(); ++i)
      for (const Segment& piece : pieces_of(all.prescribed[i].along)) {
        if (distance(piece, fixed.start) > near) continue;
        if (const auto u = moved(all.prescribed[i], piece, fixed.start))
          throw InputError(plan.displacements[i].place,
                           fmt::format("expected a prescribed displacement of 0 at the fixed point ({:.6g}, {:.6g}), "
                                       "found ({:.6g}, {:.6g}) there; end the chain before that point, or do without "
                                       "the fixed point",
                                       fixed.start.x, fixed.start.y, u->x() + 0.0, u->y() + 0.0));
      }
  }
}

}  // namespace keyblock
