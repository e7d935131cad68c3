// Compares ratios to toughness, and finds directions and the nearest line ahead; see growth.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fracture/tip_report.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Difference of K_eq over toughness, per greatest, within which tips propagate together.
constexpr double kTies = 0.01;
// Distance to a line, per increment, below which the line is cut through. A tip so near to a boundary has no field of
// its own (fracture recipes, several authors).
constexpr double kLeftBefore = 0.25;

double length_of(const std::vector<Point>& chain) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) sum += distance(chain[i], chain[i + 1]);
  return sum;
}

/// Returns where a ray from `from` meets a segment, as a distance along the ray; infinity if nowhere.
double station_on(Point from, Point direction, const Segment& line) {
  const Point along = line.end - line.start;
  const double parallel = cross(direction, along);
  if (parallel == 0) return std::numeric_limits<double>::infinity();
  const Point to = line.start - from;
  const double t = cross(to, along) / parallel;
  const double s = cross(to, direction) / parallel;
  return t > 0 && s >= 0 && s <= 1 ? t : std::numeric_limits<double>::infinity();
}

// Cosine of the widest angle at which another tip lies ahead.
constexpr double kAhead = 0.7;
// Distance behind the tip, per distance to a point, up to which the point is not behind; the crack itself lies there.
constexpr double kBehind = 0.5;

/// Calls `visit` with the boundary edges of bodies, cracks and joints.
template <class Visit>
void visit_boundary(const Manifold& manifold, const Visit& visit) {
  for (const BoundaryEdge& edge : manifold.boundary_edges) {
    const SlotRange& outer = manifold.elements[static_cast<std::size_t>(edge.element)].outer;
    const auto loop = manifold.loop(outer);
    const auto i = static_cast<std::size_t>(edge.corner - outer.first);
    if (i < loop.size())  // else of a hole within an element
      visit(Segment{loop[i].position, loop[(i + 1) % loop.size()].position});
  }
}

double nearness(const TipState& tip) {
  return tip.toughness > 0 ? tip.equivalent / tip.toughness : 0;
}

}  // namespace

std::vector<TipState> followed_tips(const Manifold& manifold, const std::vector<CrackPlan>& cracks) {
  std::vector<TipState> followed;
  int others = 0;
  for (const CrackTip& tip : manifold.tips) {
    TipState state;
    state.at = tip.at;
    state.crack = -1;
    for (std::size_t c = 0; c < cracks.size(); ++c) {
      const std::vector<Point>& along = cracks[c].along;
      if (along.front() != tip.at && along.back() != tip.at) continue;
      state.crack = static_cast<int>(c);
      state.at_end = along.back() == tip.at;
      state.length = length_of(along);
      state.is_shear = cracks[c].is_shear;
    }
    if (state.crack < 0) state.crack = static_cast<int>(cracks.size()) + others++;
    followed.push_back(state);
  }
  return followed;
}

const CrackTip& tip_of(const Manifold& manifold, const TipState& state) {
  const auto found = std::ranges::find(manifold.tips, state.at, &CrackTip::at);
  if (found == manifold.tips.end()) throw std::logic_error("a tip that its bodies do not have");
  return *found;
}

void put_factors(TipState& state, const CoverSolution& solution, GrowthCriterion criterion) {
  const CrackTip& tip = tip_of(solution.continuum.manifold, state);
  const BlockMaterial& material =
      solution.continuum.material(std::max(0, element_of(solution.continuum.manifold, tip)));
  if (material.toughness) state.toughness = material.toughness->mode_1;
  std::optional<TipFactors> factors;
  if (!material.is_nonlinear()) factors = tip_factors(solution, tip);  // the integrals hold for elastic rock only
  state.has_room = factors.has_value();
  if (!factors) return;
  state.mode_1 = factors->k.mode_1;
  state.mode_2 = factors->k.mode_2;
  state.energy_release = factors->j;
  const Kink next = kink(criterion, rock_at(solution.continuum, tip), factors->k);
  state.kink = next.angle;
  state.equivalent = material.toughness ? equivalent_of(next, *material.toughness, factors->k) : next.equivalent;
}

std::vector<std::size_t> next_to_go_on(const std::vector<TipState>& tips) {
  double greatest = 0;
  for (const TipState& tip : tips) greatest = std::max(greatest, nearness(tip));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < tips.size(); ++i)
    if (greatest > 0 && nearness(tips[i]) >= (1 - kTies) * greatest) chosen.push_back(i);
  return chosen;
}

std::optional<Point> facing_tip(const Manifold& manifold, Point tip, Point direction, double reach) {
  std::optional<Point> nearest;
  double least = reach;
  for (const CrackTip& other : manifold.tips) {
    const Point to = other.at - tip;
    const double d = length(to);
    if (d == 0 || d >= least || dot(to, direction) < kAhead * d) continue;
    least = d;
    nearest = other.at;
  }
  return nearest;
}

Advance advance_of(const Manifold& manifold, Point tip, Point direction, double increment) {
  double nearest = (1 + kLeftBefore) * increment;
  bool meets = false;
  visit_boundary(manifold, [&](const Segment& line) {
    if (line.start == tip || line.end == tip) return;  // its own crack
    const double t = station_on(tip, direction, line);
    if (t >= nearest) return;
    nearest = t;
    meets = true;
  });
  return {tip + (meets ? nearest : increment) * direction, meets};
}

std::optional<Point> line_beside(const Manifold& manifold, const CrackTip& tip, double reach) {
  std::optional<Point> nearest;
  double least = reach;
  visit_boundary(manifold, [&](const Segment& line) {
    const Point p = point_at(line, std::clamp(foot(line, tip.at), 0.0, 1.0));
    const double d = distance(p, tip.at);
    if (d >= least || line.start == tip.at || line.end == tip.at || dot(p - tip.at, tip.ahead) < -kBehind * d) return;
    least = d;
    nearest = p;
  });
  return nearest;
}

double rayleigh_speed(const PlaneElasticity& rock, double density) {
  const double nu = rock.is_plane_strain ? rock.poissons_ratio : rock.poissons_ratio / (1 + rock.poissons_ratio);
  return std::sqrt(rock.shear_modulus() / density) * (0.862 + 1.14 * nu) / (1 + nu);
}

Point turned_to_left(Point direction, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
}

void prolong(std::vector<CrackPlan>& cracks, const TipState& tip, Point to) {
  if (tip.crack >= static_cast<int>(cracks.size())) {
    cracks.push_back({{tip.at, to}, {}, 0});
    return;
  }
  std::vector<Point>& along = cracks[static_cast<std::size_t>(tip.crack)].along;
  along.insert(tip.at_end ? along.end() : along.begin(), to);
}

}  // namespace keyblock
