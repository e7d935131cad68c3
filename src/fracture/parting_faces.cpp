// Places points at the middles of parts, and lowers the pulls with their work; see parting_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/parting_faces.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/box.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr int kPoints = 12;  // per piece: tip_side is a sixteenth of an increment unless the case sets another
// Fraction of the squared pull that is released at once: a force 1 % below that just under the toughness.
constexpr double kGoesAtOnce = 0.02;
// Fraction of the pull that counts as zero: the faces have parted and have dissipated all but a thousandth of Γ.
constexpr double kParted = 0.03;
// Opening at which faces have parted, per opening behind a tip at its toughness at the distance of the length of the
// piece, 8 K/E' √(l/2π). Faces that pulled each other have dissipated their energy by then.
constexpr double kWide = 4;
// Distance from the piece, per length, at which an element is looked for.
constexpr double kBesideFace = 1e-6;
// Share of Γ by which the work of a step may differ from that of the law; later steps compensate for the difference.
constexpr double kWorkGoal = 1e-3;
constexpr double kRoundOff = 1e-9;       // per Γ
constexpr std::size_t kMostRounds = 12;  // of the search for the pulls of a step
constexpr Eigen::Index kRemembered = 5;  // of its iterations: they cannot separate the motion of more pieces

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

/// Returns x of the header.
Point shifted(const PartingFaces& faces, const PartingPoint& point, Point opening) {
  return opening - (faces.wide / kWide / length(point.pull)) * point.pull;
}

/// Returns the pulls over a step from the present openings to others.
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

double PartingFaces::work_at(double at) const {
  const double last = 2 * energy / first_share();
  const double most = std::clamp(std::max(at, farthest), 0.0, last);
  const double loaded = first_share() * most * (1 - most / (2 * last));
  return at >= farthest ? loaded : loaded - share(farthest) * (farthest - std::max(at, 0.0));
}

void PartingFaces::put_to_taken() {
  if (parted >= farthest) {
    const double left = 1 - std::clamp(taken / energy, 0.0, 1.0);
    parted = farthest = std::max(farthest, 2 * energy / first_share() * (1 - std::sqrt(left)));
  } else if (const double pull = share(farthest); parted > 0 && pull > 0) {
    parted = std::clamp(farthest - (work_at(farthest) - taken) / pull, 0.0, farthest);
  }
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
  const Point out{direction.y, -direction.x};  // outward normal of the left face
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

PullsOfStep::PullsOfStep(const std::vector<PartingFaces>& faces) : faces_(faces), shares_(faces.size()) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    shares_[i] = faces[i].share(faces[i].parted);
    pulls_.push_back(pulls_between(faces[i], shares_[i], openings_of(faces[i], nullptr)));
  }
}

bool PullsOfStep::are_found(const DisplacementAt& displacement) {
  if (tried_.size() > kMostRounds) return true;
  std::vector<std::vector<Point>> openings;
  for (const PartingFaces& piece : faces_) openings.push_back(openings_of(piece, &displacement));
  tried_.push_back(looked_at(openings));
  if (tried_.back().off <= kRoundOff) return true;
  if (tried_.size() > kMostRounds) {
    const Trial& nearest = *std::ranges::min_element(tried_, {}, &Trial::off);
    pulls_ = nearest.pulls;
    if (std::isinf(nearest.off))
      for (std::vector<Point>& piece : pulls_) std::ranges::fill(piece, Point{});
    return false;
  }
  shares_ = next_shares();
  for (std::size_t i = 0; i < faces_.size(); ++i) pulls_[i] = pulls_between(faces_[i], shares_[i], openings[i]);
  return false;
}

PullsOfStep::Trial PullsOfStep::looked_at(const std::vector<std::vector<Point>>& openings) const {
  Trial trial{shares_, shares_, 0, pulls_};
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const PartingFaces& faces = faces_[i];
    const double parted = parted_at(faces, openings[i]), way = parted - faces.parted;
    const double left = std::max(0.0, faces.energy - faces.taken), goal = kWorkGoal * faces.energy;
    const double by_law = std::clamp(faces.work_at(parted) - faces.work_at(faces.parted), -faces.taken, left);
    const double least = std::max(by_law - goal, -faces.taken), most = std::min(by_law + goal, left);
    trial.asked[i] = std::clamp(way == 0 ? faces.share(parted) : (least + most) / 2 / way, 0.0, 1.0);
    const double work = work_of(faces, pulls_[i], openings[i]), round_off = kRoundOff * faces.energy;
    const bool keeps_bounds = work >= -faces.taken - round_off && work <= left + round_off;
    const double off = keeps_bounds ? std::max({0.0, least - work, work - most}) / faces.energy
                                    : std::numeric_limits<double>::infinity();
    trial.off = std::max(trial.off, off);
  }
  return trial;
}

// Seeks the fixed point of asked(shares) by Anderson mixing (J. ACM 12, 1965), over as many trials as there are pieces:
// for one piece it is the secant through the last two.
Eigen::VectorXd PullsOfStep::next_shares() const {
  const Trial& last = tried_.back();
  const Eigen::Index n = last.shares.size();
  const auto count = std::min<Eigen::Index>({n, kRemembered, static_cast<Eigen::Index>(tried_.size()) - 1});
  Eigen::VectorXd next = last.asked;
  if (count > 0) {
    Eigen::MatrixXd off(n, count), asked(n, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Trial& before = tried_[tried_.size() - 2 - static_cast<std::size_t>(k)];
      asked.col(k) = last.asked - before.asked;
      off.col(k) = asked.col(k) - (last.shares - before.shares);
    }
    next -= asked * off.completeOrthogonalDecomposition().solve(last.asked - last.shares);
  }
  return next.cwiseMax(0).cwiseMin(1);
}

void part(PartingFaces& faces, const std::vector<Point>& pulls, const DisplacementAt& displacement) {
  const std::vector<Point> openings = openings_of(faces, &displacement);
  faces.parted = parted_at(faces, openings);
  faces.taken += work_of(faces, pulls, openings);
  for (std::size_t i = 0; i < openings.size(); ++i) faces.points[i].opening = openings[i];
  faces.put_to_taken();
  if (lies_wide_open(faces)) faces.farthest = faces.parted = std::max(faces.farthest, faces.end());
}

}  // namespace keyblock
