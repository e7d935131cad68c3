// Chooses covers by distance and branches of θ by neighbours; see tip_enrichment.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tips/tip_enrichment.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "geometry/polygon.hpp"
#include "geometry/tip_rule.hpp"

namespace keyblock {
namespace {

constexpr double kSidesOfRadius = 3;   // K of fra-01 within 0.3 % with sides of a/5; 2 sides: 0.9 %
constexpr double kSidesOfPatch = 1.5;  // beyond R; without them 1.8 %
// Distance to another line or tip, per R, below which a tip gets no field of its own, as hardly any element resolves
// it. At 1e-7 the functions of two tips differ by round-off only, and residuals of 1e-9 remain.
constexpr double kLeastRoom = 0.003;
constexpr double kAhead = 1e-6;       // per side: where straight ahead begins
constexpr double kSameAngle = 1e-6;   // rad; where θ jumps, it differs by a full turn
constexpr double kDependent = 1e-12;  // per greatest eigenvalue: smaller combinations are dependent
constexpr double kRound = 1 + 1e-9;   // per R: nodes on its circle belong to it
constexpr int kPlainDegree = 8;       // of quadrature, far from the tip
constexpr double kSmall = 0.01;       // per area of a cover's triangles: a smaller share counts as little

double size_of(const std::array<Point, 3>& t) {
  return std::sqrt(2 / std::sqrt(3.0) * cross(t[1] - t[0], t[2] - t[0]));
}

CoverWeight weight_of(const std::array<Point, 3>& t, std::size_t k) {
  const Point opposite = t[(k + 2) % 3] - t[(k + 1) % 3];
  const double twice = cross(t[1] - t[0], t[2] - t[0]);
  return {t[k], {-opposite.y / twice, opposite.x / twice}};
}

}  // namespace

TipEnrichment::TipEnrichment(const Manifold& manifold, const TipFunctionPlan& plan)
    : manifold_(manifold), own_gradient_(manifold.covers.size(), 0), of_cover_(manifold.covers.size()) {
  for (std::size_t t = 0; t < manifold.tips.size(); ++t) {
    axes_.push_back({manifold.tips[t].at, manifold.tips[t].ahead});
    middles_.emplace_back();
    add_tip(static_cast<int>(t), plan);
  }
}

int TipEnrichment::number_functions(int next) {
  for (TipCover& cover : tip_covers_) {
    cover.first_function = next;
    next += static_cast<int>(cover.mix.cols());
  }
  return next;
}

TipShape TipEnrichment::shape(int element, std::vector<int>& numbers) const {
  TipShape shape;
  const ManifoldElement& e = manifold_.elements[static_cast<std::size_t>(element)];
  std::map<int, std::size_t> branch_of_tip;
  for (std::size_t k = 0; k < 3; ++k) {
    const CoverWeight weight = weight_of(manifold_.triangle(e), k);
    for (const std::size_t i : of_cover_[static_cast<std::size_t>(e.covers[k])]) {
      const TipCover& cover = tip_covers_[i];
      const auto [branch, is_new] = branch_of_tip.try_emplace(cover.tip, shape.branches.size());
      if (is_new) {
        const auto tip = static_cast<std::size_t>(cover.tip);
        shape.branches.push_back({axes_[tip], middles_[tip].at(element)});
        shape.tips.push_back(axes_[tip].at);
      }
      for (Eigen::Index m = 0; m < cover.mix.cols(); ++m) {
        shape.functions.push_back({weight, branch->second, cover.mix.col(m)});
        numbers.push_back(cover.first_function + static_cast<int>(m));
      }
    }
  }
  return shape;
}

void TipEnrichment::add_tip(int tip, const TipFunctionPlan& plan) {
  const TipAxes& axes = axes_.back();
  const std::vector<int> at_tip = elements_at(axes.at);
  if (at_tip.empty()) return;
  const double side = side_at(at_tip);
  const double radius = kRound * (plan.radius > 0 ? plan.radius : kSidesOfRadius * side);
  if (manifold_.tips[static_cast<std::size_t>(tip)].room < kLeastRoom * radius) return;
  const auto node_distance = [&](int cover) {
    const int node = manifold_.covers[static_cast<std::size_t>(cover)].node;
    return distance(manifold_.mesh.nodes[static_cast<std::size_t>(node)], axes.at);
  };
  std::vector<char> is_near;
  for (const ManifoldElement& e : manifold_.elements)
    is_near.push_back(std::ranges::any_of(e.covers, [&](int c) { return node_distance(c) <= radius; }) ? 1 : 0);
  const Middles all = middles(seed(at_tip, axes, side), axes, is_near);
  const std::vector<char> is_torn = torn(all, axes);
  for (int c = 0; c < static_cast<int>(manifold_.covers.size()); ++c) {
    const double d = node_distance(c);
    if (d <= radius + kSidesOfPatch * side) give_own_gradient(c);
    const std::span<const int> star = manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(c)]);
    if (d > radius || is_torn[static_cast<std::size_t>(c)] ||
        !std::ranges::all_of(star, [&](int e) { return all.contains(e); }))
      continue;
    of_cover_[static_cast<std::size_t>(c)].push_back(tip_covers_.size());
    tip_covers_.push_back({c, tip, orthonormal(c, axes, all)});
  }
  middles_.back() = all;
}

std::vector<int> TipEnrichment::elements_at(Point tip) const {
  std::vector<int> found;
  for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
    const std::array<Point, 3> triangle = manifold_.triangle(manifold_.elements[e]);
    if (side(triangle, tip) == Side::outside) continue;
    if (side(manifold_.polygon(manifold_.elements[e]).front(), tip) != Side::outside)
      found.push_back(static_cast<int>(e));
  }
  return found;
}

double TipEnrichment::side_at(const std::vector<int>& at_tip) const {
  double longest = 0;
  for (const int e : at_tip) {
    const auto t = manifold_.triangle(manifold_.elements[static_cast<std::size_t>(e)]);
    longest = std::max({longest, distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  }
  return longest;
}

bool TipEnrichment::holds_inside(int element, Point tip) const {
  return side(manifold_.triangle(manifold_.elements[static_cast<std::size_t>(element)]), tip) == Side::inside;
}

// An element that holds the tip contains all directions.
double TipEnrichment::angle_of(int element, const TipAxes& axes) const {
  if (holds_inside(element, axes.at)) return 0;
  return axes.angle_to(centroid(manifold_.polygon(manifold_.elements[static_cast<std::size_t>(element)]).front()));
}

int TipEnrichment::seed(const std::vector<int>& at_tip, const TipAxes& axes, double side_there) const {
  const Point ahead = axes.at + (kAhead * side_there) * axes.ahead;
  int best = at_tip.front();
  double least = std::numeric_limits<double>::max();
  for (const int e : at_tip) {
    const bool is_ahead =
        side(manifold_.polygon(manifold_.elements[static_cast<std::size_t>(e)]).front(), ahead) != Side::outside;
    const double angle = is_ahead ? -1 : std::abs(angle_of(e, axes));
    if (angle >= least) continue;
    least = angle;
    best = e;
  }
  return best;
}

/// Calls `visit` with each neighbour and the middle of the shared side.
template <class Visit>
void TipEnrichment::visit_neighbours(int element, Visit visit) const {
  const std::span<const ElementCorner> loop =
      manifold_.loop(manifold_.elements[static_cast<std::size_t>(element)].outer);
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (loop[i].neighbour >= 0)
      visit(loop[i].neighbour, 0.5 * (loop[i].position + loop[(i + 1) % loop.size()].position));
}

TipEnrichment::Middles TipEnrichment::middles(int seed, const TipAxes& axes, const std::vector<char>& is_near) const {
  using Reached = std::pair<double, int>;  // distance from the tip, element
  const auto reach = [&](int e) {
    return distance(centroid(manifold_.polygon(manifold_.elements[static_cast<std::size_t>(e)]).front()), axes.at);
  };
  Middles found{{seed, angle_of(seed, axes)}};
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  for (next.emplace(reach(seed), seed); !next.empty();) {
    const int e = next.top().second;
    next.pop();
    const double own = found.at(e);
    visit_neighbours(e, [&](int other, Point between) {
      if (!is_near[static_cast<std::size_t>(other)] || found.contains(other)) return;
      const double there = own + half_turn(axes.angle_to(between) - own);
      found.emplace(other, there + half_turn(angle_of(other, axes) - there));
      next.emplace(reach(other), other);
    });
  }
  return found;
}

std::vector<char> TipEnrichment::torn(const Middles& middles, const TipAxes& axes) const {
  std::vector<char> is_torn(manifold_.covers.size(), 0);
  for (const auto& [e, own] : middles) {
    visit_neighbours(e, [&](int other, Point between) {
      const auto found = middles.find(other);
      if (found == middles.end()) return;
      const double angle = axes.angle_to(between);
      const double here = own + half_turn(angle - own);
      const double there = found->second + half_turn(angle - found->second);
      if (std::abs(here - there) < kSameAngle) return;
      const std::array<int, 3>& a = manifold_.elements[static_cast<std::size_t>(e)].covers;
      for (const int c : manifold_.elements[static_cast<std::size_t>(other)].covers)
        if (std::ranges::find(a, c) != a.end()) is_torn[static_cast<std::size_t>(c)] = 1;
    });
  }
  return is_torn;
}

// Orthonormal functions of a cover that has little of its triangles grow large in the rest of them. The ghost penalty
// integrates them there, and its residual would be their round-off. They are scaled as if the cover had all of its
// triangles.
Eigen::Matrix4Xd TipEnrichment::orthonormal(int cover, const TipAxes& axes, const Middles& middles) const {
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  double covered = 0, whole = 0;
  const std::array<Point, 1> tips{axes.at};
  for (const int e : manifold_.elements_of(manifold_.covers[static_cast<std::size_t>(cover)])) {
    const ManifoldElement& element = manifold_.elements[static_cast<std::size_t>(e)];
    const std::array<Point, 3> triangle = manifold_.triangle(element);
    const auto k = static_cast<std::size_t>(std::ranges::find(element.covers, cover) - element.covers.begin());
    const CoverWeight weight = weight_of(triangle, k);
    const double middle = middles.at(e);
    const auto loops = manifold_.polygon(element);
    for (const AreaPoint& p : polygon_rule_about(tips, loops, size_of(triangle), kPlainDegree)) {
      const NearTipValues v = near_tip_values(axes, middle, p.at);
      Eigen::Matrix<double, 2, 4> g = weight.at(p.at) * v.gradients;
      g.row(0) += weight.gradient.x * v.values;
      g.row(1) += weight.gradient.y * v.values;
      products += p.weight * g.transpose() * g;
      covered += p.weight;
    }
    whole += area(triangle);
  }
  const double share = covered > 0 && covered < kSmall * whole ? covered / whole : 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(products);
  const Eigen::Vector4d& values = solver.eigenvalues();
  Eigen::Matrix4Xd mix(4, 0);
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (!(values(i) > kDependent * values(3))) continue;
    mix.conservativeResize(4, mix.cols() + 1);
    mix.col(mix.cols() - 1) = solver.eigenvectors().col(i) / std::sqrt(values(i) / share);
  }
  return mix;
}

}  // namespace keyblock
