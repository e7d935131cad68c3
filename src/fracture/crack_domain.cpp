// Builds circles by distance and levels by shared covers; see crack_domain.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Share of the room around a tip up to which a domain holds a straight crack and nothing else.
constexpr double kShareOfRoom = 0.95;

// Distances per size of an element. The first is how far ahead of the tip the next element of the crack is looked for.
// The second is how near to a side a point belongs to both elements.
constexpr double kAheadOfTip = 1e-6;
constexpr double kOnSide = 1e-9;

double nearest_distance(std::span<const Point> loop, Point p) {
  if (side(loop, p) != Side::outside) return 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < loop.size(); ++k)
    least = std::min(least, distance(Segment{loop[k], loop[(k + 1) % loop.size()]}, p));
  return least;
}

double farthest_distance(const std::vector<Point>& loop, Point p) {
  double most = 0;
  for (const Point corner : loop) most = std::max(most, distance(corner, p));
  return most;
}

/// Returns the gradients of the three functions that are 1 at one corner and 0 at the others.
std::array<Point, 3> gradients_of(const std::array<Point, 3>& t) {
  const double twice = cross(t[1] - t[0], t[2] - t[0]);
  std::array<Point, 3> gradients;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point opposite = t[(k + 2) % 3] - t[(k + 1) % 3];
    gradients[k] = {-opposite.y / twice, opposite.x / twice};
  }
  return gradients;
}

}  // namespace

std::string name_of(const DomainChoice& choice) {
  if (choice.kind == DomainKind::circle) return fmt::format("circle {:.4g} to {:.4g}", choice.inner, choice.outer);
  return fmt::format("{} level{} about the {}", choice.levels, choice.levels == 1 ? "" : "s",
                     choice.kind == DomainKind::element_levels ? "tip element" : "nearest node");
}

CrackDomain::CrackDomain(const Manifold& manifold, const CrackTip& tip, const DomainChoice& choice)
    : manifold_(manifold), tip_(tip), choice_(choice) {
  if (choice.kind == DomainKind::circle)
    take_circle();
  else
    take_levels(choice.kind == DomainKind::element_levels ? elements_at_tip() : elements_at_nearest_cover());
}

void CrackDomain::take_circle() {
  reach_ = choice_.outer;
  for (std::size_t e = 0; e < manifold_.elements.size(); ++e)
    if (nearest_distance(manifold_.triangle(manifold_.elements[e]), tip_.at) < choice_.outer)
      elements_.push_back(static_cast<int>(e));
}

// A node may lie on the tip: all elements around it then hold the tip, and one of them lies ahead.
std::vector<char> CrackDomain::elements_at_tip() const {
  std::vector<char> has_tip(manifold_.elements.size(), 0);
  for (std::size_t e = 0; e < has_tip.size(); ++e) {
    const std::array<Point, 3> triangle = manifold_.triangle(manifold_.elements[e]);
    const double size = distance(triangle[0], triangle[1]);
    const Point ahead = tip_.at + kAheadOfTip * size * tip_.ahead;
    const std::vector<Point> loop = manifold_.polygon(manifold_.elements[e]).front();
    has_tip[e] = nearest_distance(loop, ahead) <= kOnSide * size ? 1 : 0;
  }
  return has_tip;
}

std::vector<char> CrackDomain::elements_at_nearest_cover() const {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t c = 0; c < manifold_.covers.size(); ++c) {
    const Point at = manifold_.mesh.nodes[static_cast<std::size_t>(manifold_.covers[c].node)];
    if (distance(at, tip_.at) >= least) continue;
    least = distance(at, tip_.at);
    nearest = c;
  }
  std::vector<char> has_tip(manifold_.elements.size(), 0);
  if (!manifold_.covers.empty())
    for (const int e : manifold_.elements_of(manifold_.covers[nearest])) has_tip[static_cast<std::size_t>(e)] = 1;
  return has_tip;
}

// All covers of level 0, elements with the tip, have q = 1; so have those of further levels except the last.
void CrackDomain::take_levels(std::vector<char> has_tip) {
  is_one_.assign(manifold_.covers.size(), 0);
  std::vector<char> is_in = std::move(has_tip);
  for (int level = 0; level < choice_.levels; ++level) {
    for (std::size_t e = 0; e < is_in.size(); ++e)
      if (is_in[e])
        for (const int c : manifold_.elements[e].covers) is_one_[static_cast<std::size_t>(c)] = 1;
    for (std::size_t e = 0; e < is_in.size(); ++e)
      is_in[e] = std::ranges::any_of(manifold_.elements[e].covers,
                                     [&](int c) { return is_one_[static_cast<std::size_t>(c)] != 0; });
  }
  for (std::size_t e = 0; e < is_in.size(); ++e) {
    if (!is_in[e]) continue;
    elements_.push_back(static_cast<int>(e));
    reach_ = std::max(reach_, farthest_distance(manifold_.polygon(manifold_.elements[e]).front(), tip_.at));
  }
}

std::optional<std::string> CrackDomain::obstacle() const {
  if (reach_ <= kShareOfRoom * tip_.room) return std::nullopt;
  return fmt::format("it reaches {:.4g} from the tip, and {} is {:.4g} away", reach_, tip_.nearest, tip_.room);
}

double CrackDomain::weight(int element, Point x) const {
  const ManifoldElement& e = manifold_.elements[static_cast<std::size_t>(element)];
  if (choice_.kind == DomainKind::circle) {
    const double t = (distance(x, tip_.at) - choice_.inner) / (choice_.outer - choice_.inner);
    return t <= 0 ? 1 : t >= 1 ? 0 : 1 - t * t * t * (10 - 15 * t + 6 * t * t);
  }
  const std::array<Point, 3> triangle = manifold_.triangle(e);
  const std::array<Point, 3> gradients = gradients_of(triangle);
  double q = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_one_[static_cast<std::size_t>(e.covers[k])]) q += 1 + dot(gradients[k], x - triangle[k]);
  return q;
}

Point CrackDomain::gradient(int element, Point x) const {
  const ManifoldElement& e = manifold_.elements[static_cast<std::size_t>(element)];
  if (choice_.kind == DomainKind::circle) {
    const double r = distance(x, tip_.at);
    const double t = (r - choice_.inner) / (choice_.outer - choice_.inner);
    if (t <= 0 || t >= 1) return {};
    const double slope = -30 * t * t * (1 - t) * (1 - t) / (choice_.outer - choice_.inner);
    return (slope / r) * (x - tip_.at);
  }
  const std::array<Point, 3> gradients = gradients_of(manifold_.triangle(e));
  Point sum;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_one_[static_cast<std::size_t>(e.covers[k])]) sum = sum + gradients[k];
  return sum;
}

}  // namespace keyblock
