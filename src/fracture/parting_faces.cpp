// Points at the middles of parts, pulls that fall with their work; see parting_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/parting_faces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr int kPoints = 12;  // of a piece: tip_side is a sixteenth of an increment unless the case says otherwise
// What of the square of the pull goes at once: a force of 1 % less than under just the toughness.
constexpr double kGoesAtOnce = 0.02;
// Share of the pull that counts as none: the faces have parted and have taken all but a thousandth of Γ.
constexpr double kParted = 0.03;
// Over the opening that a tip at its toughness has behind it as far as the piece is long, 8 K/E' √(l/2π), by which
// faces that pulled each other have taken their energy.
constexpr double kWide = 4;
// Of the length of a piece: how far beside it an element is looked for.
constexpr double kBesideFace = 1e-6;
// Share of Γ by which the work of a step may differ from that of the law. Later steps make up for the difference.
constexpr double kWorkGoal = 1e-3;
constexpr double kRoundOff = 1e-9;  // of Γ
constexpr int kMostRounds = 12;     // of the search for the pulls of a step
constexpr int kHalvedEvery = 3;     // rounds: the range of shares

bool is_in(const Manifold& manifold, std::size_t e, Point p) {
  Box box;
  for (const ElementCorner& corner : manifold.loop(manifold.elements[e].outer)) box.add(corner.position);
  if (!box.holds(p)) return false;
  const auto loops = manifold.polygon(manifold.elements[e]);
  return side(loops.front(), p) != Side::outside &&
         std::none_of(loops.begin() + 1, loops.end(), [&](const auto& hole) { return side(hole, p) == Side::inside; });
}

int element_at(const Manifold& manifold, Point p) {
  for (std::size_t e = 0; e < manifold.elements.size(); ++e)
    if (is_in(manifold, e, p)) return static_cast<int>(e);
  return -1;
}

Point opening_at(const PartingPoint& point, const DisplacementAt& displacement) {
  return displacement(point.left, point.at) - displacement(point.right, point.at);
}

double first_share() {
  return std::sqrt(1 - kGoesAtOnce);
}

bool lies_wide_open(const PartingFaces& faces) {
  return std::ranges::all_of(faces.points,
                             [&](const PartingPoint& p) { return p.left < 0 || length(p.opening) > faces.wide; });
}

/// x of the header.
Point shifted(const PartingFaces& faces, const PartingPoint& point, Point opening) {
  return opening - (faces.wide / kWide / length(point.pull)) * point.pull;
}

/// The pulls over a step from the present openings to others.
std::vector<Point> pulls_between(const PartingFaces& faces, double share, const std::vector<Point>& openings) {
  std::vector<Point> pulls;
  for (std::size_t i = 0; i < faces.points.size(); ++i) {
    const PartingPoint& point = faces.points[i];
    const bool pulls_here = point.left >= 0 && point.pull != Point{};
    pulls.push_back(pulls_here ? -share * length(point.pull) * faces.way(point, openings[i]) : Point{});
  }
  return pulls;
}

std::vector<Point> openings_of(const PartingFaces& faces, const DisplacementAt* displacement) {
  std::vector<Point> openings;
  for (const PartingPoint& point : faces.points)
    openings.push_back(point.left < 0 || displacement == nullptr ? point.opening : opening_at(point, *displacement));
  return openings;
}

double parted_at(const PartingFaces& faces, const std::vector<Point>& openings) {
  double parted = faces.parted;
  for (std::size_t i = 0; i < faces.points.size(); ++i) {
    const PartingPoint& point = faces.points[i];
    if (point.left < 0 || point.pull == Point{}) continue;
    parted += length(point.pull) *
              (length(shifted(faces, point, openings[i])) - length(shifted(faces, point, point.opening)));
  }
  return parted;
}

double work_of(const PartingFaces& faces, const std::vector<Point>& pulls, const std::vector<Point>& openings) {
  double work = 0;
  for (std::size_t i = 0; i < faces.points.size(); ++i) work -= dot(pulls[i], openings[i] - faces.points[i].opening);
  return work;
}

}  // namespace

double PartingFaces::end() const {
  return (1 - kParted) * 2 * energy / first_share();
}

double PartingFaces::share(double at) const {
  if (at < 0) return 0;
  const double last = 2 * energy / first_share();
  const auto envelope = [&](double d) { return first_share() * std::max(0.0, 1 - d / last); };
  return envelope(std::max(at, farthest));
}

double PartingFaces::work_to(double at) const {
  const double last = 2 * energy / first_share();
  const auto work = [&](double d) {
    const double most = std::clamp(std::max(d, farthest), 0.0, last);
    const double loaded = first_share() * most * (1 - most / (2 * last));
    return d >= farthest ? loaded : loaded - share(farthest) * (farthest - std::max(d, 0.0));
  };
  return work(at) - work(parted);
}

Point PartingFaces::way(const PartingPoint& point, Point opening) const {
  const Point before = shifted(*this, point, point.opening), after = shifted(*this, point, opening);
  const double sum = length(before) + length(after);
  return sum > 0 ? (1 / sum) * (before + after) : Point{};
}

PartingFaces parting_faces(Point from, Point to, double energy, double modulus, Point along,
                           const std::function<Point(Point)>& traction) {
  // With K = √(E' Γ/l).
  const double wide = kWide * 8 * std::sqrt(energy / modulus / (2 * std::numbers::pi));
  PartingFaces faces{from, to, energy, wide};
  const double part = distance(from, to) / kPoints;
  const Point direction = (1 / length(along)) * along;
  const Point out{direction.y, -direction.x};  // of the left face
  for (int i = 0; i < kPoints; ++i) {
    const Point at = from + ((i + 0.5) / kPoints) * (to - from);
    Point pull = part * traction(at);
    if (const double normal = dot(pull, out); normal < 0) pull = pull - normal * out;
    faces.points.push_back({at, pull});
  }
  return faces;
}

void put_elements(PartingFaces& faces, const Manifold& manifold) {
  const Point along = faces.to - faces.from;
  const Point left = kBesideFace * Point{-along.y, along.x};
  for (PartingPoint& point : faces.points) {
    point.left = element_at(manifold, point.at + left);
    point.right = element_at(manifold, point.at - left);
    if (point.left < 0 || point.right < 0) point.left = point.right = -1;
  }
}

void look_at_openings(PartingFaces& faces, const DisplacementAt& displacement) {
  const std::vector<Point> openings = openings_of(faces, &displacement);
  for (std::size_t i = 0; i < openings.size(); ++i) faces.points[i].opening = openings[i];
}

PullsOfStep::PullsOfStep(const std::vector<PartingFaces>& faces) : faces_(faces) {
  for (const PartingFaces& piece : faces) {
    searches_.push_back({piece.share(piece.parted)});
    pulls_.push_back(pulls_between(piece, searches_.back().share, openings_of(piece, nullptr)));
  }
}

bool PullsOfStep::are_found(const DisplacementAt& displacement) {
  if (round_ > kMostRounds) return true;
  ++round_;
  bool are_all = true;
  for (std::size_t i = 0; i < faces_.size(); ++i) are_all = looks_right(i, displacement) && are_all;
  return are_all;
}

bool PullsOfStep::looks_right(std::size_t piece, const DisplacementAt& displacement) {
  const PartingFaces& faces = faces_[piece];
  const std::vector<Point> openings = openings_of(faces, &displacement);
  const double parted = parted_at(faces, openings);
  const double by_law = faces.work_to(parted), goal = kWorkGoal * faces.energy;
  const double least = std::max(by_law - goal, -faces.taken);
  const double most = std::max(std::min(by_law + goal, faces.energy - faces.taken), least);
  const double work = work_of(faces, pulls_[piece], openings);
  if (work >= least - kRoundOff * faces.energy && work <= most + kRoundOff * faces.energy) return true;
  Search& search = searches_[piece];
  const double way = parted - faces.parted;
  if (round_ > kMostRounds)
    search.share = 0;
  else
    choose(search, way == 0 ? faces.share(parted) : (least + most) / 2 / way);
  pulls_[piece] = pulls_between(faces, search.share, openings);
  return false;
}

// A share of nothing is below what the law asks for, all of the pull above it. Pieces move each other's bounds.
void PullsOfStep::choose(Search& search, double asked) const {
  const double off = search.share - asked;
  if (off < 0) {
    search.low = search.share;
    search.off_at_low = off;
    if (search.high <= search.low) search.high = 1;
  } else {
    search.high = search.share;
    search.off_at_high = off;
    if (search.low >= search.high) search.low = 0;
  }
  const bool has_both = search.off_at_low < 0 && search.off_at_high > 0;
  double next =
      has_both ? search.low + (search.high - search.low) * search.off_at_low / (search.off_at_low - search.off_at_high)
               : asked;
  if (!(next > search.low && next < search.high) || round_ % kHalvedEvery == 0) next = (search.low + search.high) / 2;
  search.share = next;
}

void part(PartingFaces& faces, const std::vector<Point>& pulls, const DisplacementAt& displacement) {
  const std::vector<Point> openings = openings_of(faces, &displacement);
  const double parted = parted_at(faces, openings);
  faces.taken += work_of(faces, pulls, openings);
  for (std::size_t i = 0; i < openings.size(); ++i) faces.points[i].opening = openings[i];
  faces.parted = parted;
  if (parted >= faces.farthest) {  // to where the law has the work taken
    const double left = 1 - std::clamp(faces.taken / faces.energy, 0.0, 1.0);
    faces.farthest = std::max(faces.farthest, 2 * faces.energy / first_share() * (1 - std::sqrt(left)));
    faces.parted = faces.farthest;
  }
  if (lies_wide_open(faces)) faces.farthest = faces.parted = std::max(faces.farthest, faces.end());
}

}  // namespace keyblock
