// Averages stress over discs of elements around each element; see initiation.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/initiation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <ranges>

#include "fracture/growth.hpp"
#include "fracture/rock_corners.hpp"
#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"

namespace keyblock {
namespace {

constexpr double kStartsTogether = 0.01;  // per greatest nearness: range of starts that happen together
constexpr double kApart = 4;              // discs: starts nearer to each other are one
constexpr double kFreeOfTips = 2;         // discs around a start without a tip
constexpr int kDegree = 2;                // of the stress in an element

class Starts {
 public:
  explicit Starts(const CoverSolution& solution)
      : solution_(solution), manifold_(solution.continuum.manifold), corners_(rock_corners(manifold_)) {
    for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
      const auto polygon = manifold_.polygon(manifold_.elements[e]);
      middles_.push_back(centroid(polygon.front()));
      std::vector<StressPoint>& points = points_.emplace_back();
      for (const AreaPoint& p : polygon_rule(polygon, kDegree))
        points.push_back({p.at, p.weight, stress_at(static_cast<int>(e), p.at)});
    }
    seen_.assign(middles_.size(), 0);
  }

  std::vector<CrackStart> nearest() {
    std::vector<CrackStart> all;
    for (std::size_t e = 0; e < middles_.size(); ++e)
      if (const std::optional<CrackStart> start = start_at(static_cast<int>(e))) all.push_back(*start);
    std::ranges::stable_sort(all, std::ranges::greater(), &CrackStart::nearness);
    std::vector<CrackStart> chosen;
    for (const CrackStart& start : all) {
      if (start.nearness() < (1 - kStartsTogether) * all.front().nearness()) break;
      if (std::ranges::none_of(chosen, [&](const CrackStart& other) {
            return distance(other.at, start.at) < kApart * (start.half_length + other.half_length) / 2;
          }))
        chosen.push_back(start);
    }
    return chosen;
  }

 private:
  double side_of(int e) const {
    const auto t = manifold_.triangle(manifold_.elements[static_cast<std::size_t>(e)]);
    return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  }

  Eigen::Matrix2d stress_at(int e, Point x) const {
    const ElementShape shape = solution_.basis.shape(e);
    const Eigen::Matrix2Xd dn = shape.gradients(x);
    Eigen::Matrix2d g = Eigen::Matrix2d::Zero();
    for (int a = 0; a < shape.function_count(); ++a)
      g += solution_.d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) * dn.col(a).transpose();
    const Eigen::Vector3d s = solution_.continuum.modulus(e) * Eigen::Vector3d(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
    const Stress first = solution_.continuum.initial_stress_at(e, x);
    return (Eigen::Matrix2d() << s(0) + first.xx, s(2) + first.xy, s(2) + first.xy, s(1) + first.yy).finished();
  }

  std::optional<CrackStart> start_at(int e) {
    const BlockMaterial& rock = solution_.continuum.material(e);
    if (!rock.toughness) return std::nullopt;
    const Toughness& toughness = *rock.toughness;
    std::optional<CrackStart> start;
    if (toughness.tensile_strength) start = in_tension(e, toughness.mode_1, *toughness.tensile_strength);
    if (!toughness.cohesion || !toughness.mode_2) return start;
    const double friction = toughness.friction_deg * std::numbers::pi / 180;
    const std::optional<CrackStart> other = in_shear(e, *toughness.mode_2, *toughness.cohesion, friction);
    return other && (!start || other->nearness() > start->nearness()) ? other : start;
  }

  /// Start without its stress, and the radius of the disc for the average.
  struct Site {
    CrackStart start;
    double radius = 0;
  };

  /// Returns nothing if a tip propagates instead.
  std::optional<Site> site_of(int e, double toughness, double strength) {
    const double own = std::pow(toughness / strength, 2) / std::numbers::pi;
    const double side = side_of(e);
    Site site{{.at = middles_[static_cast<std::size_t>(e)],
               .half_length = own,
               .strength = strength,
               .toughness = toughness,
               .side = side,
               .length_of_rock = own,
               .strength_of_rock = strength},
              own};
    if (site.start.is_coarse()) {
      const double wide = std::max(own, 2 * side);
      const double order = order_at(e, side, wide);
      site.start.half_length = wide;
      site.start.strength = strength * std::pow(own / wide, order);
      site.radius = order > 0 ? wide : std::max(own, side / 2);
    }
    for (const CrackTip& tip : manifold_.tips)
      if (distance(tip.at, site.start.at) < kFreeOfTips * site.start.half_length) return std::nullopt;
    return site;
  }

  /// Returns the order of the stress at the sharpest corner within `near` of an element, through the rock within
  /// `reach`.
  double order_at(int e, double near, double reach) {
    double order = 0;
    bool is_reached = false;
    for (const RockCorner& corner : corners_) {
      if (corner.order <= order || distance(corner.at, middles_[static_cast<std::size_t>(e)]) > near) continue;
      if (!is_reached) mean_stress(e, reach);
      is_reached = true;
      if (std::ranges::find(reached_, corner.element) != reached_.end()) order = corner.order;
    }
    return order;
  }

  std::optional<CrackStart> in_tension(int e, double toughness, double strength) {
    std::optional<Site> site = site_of(e, toughness, strength);
    if (!site) return std::nullopt;
    CrackStart& start = site->start;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(mean_stress(e, site->radius));
    start.stress = principal.eigenvalues()(1);
    if (!(start.stress > 0)) return std::nullopt;
    start.along = {principal.eigenvectors()(0, 0), principal.eigenvectors()(1, 0)};
    return start;
  }

  std::optional<CrackStart> in_shear(int e, double toughness, double cohesion, double friction) {
    std::optional<Site> site = site_of(e, toughness, cohesion);
    if (!site) return std::nullopt;
    CrackStart& start = site->start;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(mean_stress(e, site->radius));
    const double mean = principal.eigenvalues().mean();
    const double radius = (principal.eigenvalues()(1) - principal.eigenvalues()(0)) / 2;
    start.stress = radius / std::cos(friction) + mean * std::tan(friction);
    start.is_shear = true;
    if (!(start.stress > 0) || mean + radius * std::sin(friction) > 0) return std::nullopt;  // its faces would open
    const Point pressed{principal.eigenvectors()(0, 0), principal.eigenvectors()(1, 0)};
    const double angle = std::numbers::pi / 4 - friction / 2;
    const std::array<Point, 2> planes{turned_to_left(pressed, angle), turned_to_left(pressed, -angle)};
    std::array<double, 2> at_ends{};
    mean_stress(e, start.half_length);  // reaches their ends
    for (std::size_t i = 0; i < 2; ++i)
      for (const double way : {-1.0, 1.0})
        at_ends[i] += left_by_friction(e, start.at + way * start.half_length * planes[i], planes[i], friction);
    start.along = planes[at_ends[1] > (1 + kStartsTogether) * at_ends[0] ? 1 : 0];
    return start;
  }

  /// Returns |τ| + σ tan φ on a plane, from the element of the last disc whose middle is nearest to a place.
  double left_by_friction(int disc, Point place, Point along, double friction) const {
    std::size_t nearest = static_cast<std::size_t>(disc);
    for (const int e : reached_)
      if (const auto i = static_cast<std::size_t>(e); distance(middles_[i], place) < distance(middles_[nearest], place))
        nearest = i;
    const Eigen::Matrix2d& s = points_[nearest].front().stress;
    const Eigen::Vector2d t(along.x, along.y), n(along.y, -along.x);
    return std::abs(t.dot(s * n)) + n.dot(s * n) * std::tan(friction);
  }

  /// Returns the average over the elements within reach that are connected with `first` there.
  Eigen::Matrix2d mean_stress(int first, double radius) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    double weights = 0;
    const Point about = middles_[static_cast<std::size_t>(first)];
    std::vector<int> open{first};
    reached_.clear();
    seen_[static_cast<std::size_t>(first)] = ++discs_;
    while (!open.empty()) {
      const int e = open.back();
      open.pop_back();
      reached_.push_back(e);
      bool is_near = false;
      for (const StressPoint& p : points_[static_cast<std::size_t>(e)]) {
        const double t = std::pow(distance(p.at, about) / radius, 2);
        if (t >= 1) continue;
        is_near = true;
        const double weight = p.weight * (1 - t) * (1 - t);
        sum += weight * p.stress;
        weights += weight;
      }
      if (!is_near && e != first) continue;
      for (const ElementCorner& corner : manifold_.loop(manifold_.elements[static_cast<std::size_t>(e)].outer)) {
        if (corner.neighbour < 0 || seen_[static_cast<std::size_t>(corner.neighbour)] == discs_) continue;
        seen_[static_cast<std::size_t>(corner.neighbour)] = discs_;
        open.push_back(corner.neighbour);
      }
    }
    return weights > 0 ? Eigen::Matrix2d(sum / weights) : stress_at(first, about);
  }

  struct StressPoint {
    Point at;
    double weight = 0;
    Eigen::Matrix2d stress;
  };

  const CoverSolution& solution_;
  const Manifold& manifold_;
  std::vector<RockCorner> corners_;
  std::vector<Point> middles_;
  std::vector<std::vector<StressPoint>> points_;  // per element
  std::vector<int> seen_;                         // number of the disc, from 1
  int discs_ = 0;
  std::vector<int> reached_;  // by the last disc
};

}  // namespace

std::vector<CrackStart> crack_starts(const CoverSolution& solution) {
  const auto may_crack = [&](std::size_t e) {
    const auto& toughness = solution.continuum.material(static_cast<int>(e)).toughness;
    return toughness && (toughness->tensile_strength || toughness->cohesion);
  };
  const auto all = std::views::iota(std::size_t{0}, solution.continuum.manifold.elements.size());
  if (std::ranges::none_of(all, may_crack)) return {};
  return Starts(solution).nearest();
}

}  // namespace keyblock
