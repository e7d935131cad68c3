// Looks up lines near an end in a grid over the lines; see near_ends.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/lines/near_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/sentences/sentences.hpp"
#include "geometry/box.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

constexpr double kRoundOff = 1e-10;  // per extent: a tenth of the distance that cutting treats as one
constexpr double kUlpsOfGreatest = 64;
constexpr double kSameWay = 1e-9;  // sine of the angle between lines that lie along each other
constexpr double kOwnWay = 2;      // distances by which an end may move along its own line
constexpr int kMostPasses = 4;     // a moved line may bring another end near; no drawing tried needed 3

Point nearest_point(const Segment& segment, Point p) {
  return point_at(segment, std::clamp(foot(segment, p), 0.0, 1.0));
}

/// Returns the crossing of the straight lines of two segments; nothing if they are parallel.
std::optional<Point> crossing_of_carriers(const Segment& a, const Segment& b) {
  const Point d = a.end - a.start;
  const Point e = b.end - b.start;
  const double sine = cross(d, e);
  if (std::abs(sine) <= kSameWay * length(d) * length(e)) return std::nullopt;
  return point_at(a, cross(b.start - a.start, e) / sine);
}

/// Moves ends until none is near a line that it does not meet.
class Joiner {
 public:
  Joiner(std::vector<Segment> lines, std::size_t boundary_count, double distance)
      : lines_(std::move(lines)), distance_(distance), search_(lines_, boundary_count, distance) {}

  void join() {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const std::size_t before = joined_.size() + trimmed_.size();
      for (std::size_t line = 0; line < lines_.size(); ++line)
        for (const bool is_start : {true, false})
          if (const auto near = search_.look(line, is_start, 0)) move(*near);
      if (joined_.size() + trimmed_.size() == before) return;
    }
  }

  const std::vector<Segment>& lines() const { return lines_; }
  const std::vector<NearEnd>& joined() const { return joined_; }
  const std::vector<NearEnd>& trimmed() const { return trimmed_; }

 private:
  void move(NearEnd near) {
    Segment& line = lines_[near.line];
    if (!near.is_beyond) near.to = target_of(near);
    const Point fixed = near.is_start ? line.end : line.start;
    if (distance(near.to, fixed) <= distance_ && distance(near.from, fixed) > distance_) return;
    if (near.to == fixed || near.to == near.from) return;
    (near.is_start ? line.start : line.end) = near.to;
    (near.is_beyond ? trimmed_ : joined_).push_back(near);
  }

  Point target_of(const NearEnd& near) const {
    const Segment& other = lines_[near.other];
    const auto crossing = crossing_of_carriers(lines_[near.line], other);
    const bool leads_there =
        crossing && distance(*crossing, near.from) <= kOwnWay * distance_ && distance(other, *crossing) <= distance_;
    if (!leads_there) return near.to;
    for (const Point end : {other.start, other.end})  // a corner that exists already
      if (distance(end, *crossing) <= kSameWay * distance_) return end;
    return *crossing;
  }

  std::vector<Segment> lines_;
  double distance_;
  NearEndSearch search_;
  std::vector<NearEnd> joined_;
  std::vector<NearEnd> trimmed_;
};

Warnings told(const Drawing& drawing, const std::string& code, const std::vector<NearEnd>& moved) {
  if (moved.empty()) return {};
  const auto farthest = *std::ranges::max_element(moved, {}, &NearEnd::gap);
  Facts facts{{{"count", moved.size()}, {"distance", farthest.gap()}}};
  facts.points = {{farthest.from.x, farthest.from.y}};
  const std::string form = moved.size() == 1 ? code : code + ":several";
  return {warning_of({form, std::move(facts)}, drawing.joints[farthest.line].place)};
}

}  // namespace

double meeting_distance(std::span<const Segment> lines) {
  Box box;
  for (const Segment& line : lines)
    for (const Point p : {line.start, line.end}) box.add(p);
  if (lines.empty()) return 0;
  const double greatest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return std::max(kRoundOff * std::max(box.size().x, box.size().y),
                  kUlpsOfGreatest * std::numeric_limits<double>::epsilon() * greatest);
}

NearEndSearch::NearEndSearch(std::span<const Segment> lines, std::size_t boundary_count, double within)
    : lines_(lines),
      boundary_count_(boundary_count),
      within_(within),
      met_(meeting_distance(lines)),
      grid_(lines, 3 * within) {}

std::optional<NearEnd> NearEndSearch::look(std::size_t line, bool is_start, double overshoot) {
  const bool is_of_outline = line < boundary_count_;
  const Found first = look_among(is_of_outline ? boundary_count_ : lines_.size(), line, is_start, overshoot);
  if (first.is_met || first.near || !is_of_outline) return first.is_met ? std::nullopt : first.near;
  const Found any = look_among(lines_.size(), line, is_start, overshoot);
  return any.is_met || (any.near && any.near->is_beyond) ? std::nullopt : any.near;
}

NearEndSearch::Found NearEndSearch::look_among(std::size_t count, std::size_t line, bool is_start, double overshoot) {
  const Segment& own = lines_[line];
  const Point end = is_start ? own.start : own.end;
  Found found;
  if (distance(own.start, own.end) <= met_) return found;
  for (const int other : grid_.near({end, end}, static_cast<int>(count))) {
    if (static_cast<std::size_t>(other) != line)
      look_at(static_cast<std::size_t>(other), overshoot, found, {line, is_start, 0, end, end, false});
    if (found.is_met) return found;
  }
  return found;
}

void NearEndSearch::look_at(std::size_t other_index, double overshoot, Found& found, const NearEnd& of) const {
  const Segment& own = lines_[of.line];
  const Segment& other = lines_[other_index];
  const Point end = of.from;
  const Point back = of.is_start ? own.end : own.start;
  NearEnd near = of;
  near.other = other_index;
  near.to = nearest_point(other, end);
  if (other.start == other.end || near.gap() > within_) return;
  const Point way = end - back;
  const Point other_way = other.end - other.start;
  const bool is_along = std::abs(cross(way, other_way)) <= kSameWay * length(way) * length(other_way) &&
                        distance_to_carrier(own, other.start) <= met_;
  const bool ends_here = std::min(distance(other.start, end), distance(other.end, end)) <= met_;
  const Point far = distance(other.start, end) < distance(other.end, end) ? other.end : other.start;
  if (is_along && ends_here && dot(way, far - end) < 0) return;  // the same piece drawn twice
  found.is_met = near.gap() <= met_;
  if (found.is_met) return;
  const bool meets_elsewhere = distance(other, back) <= met_ || meeting(own, other) != Meeting::none ||
                               distance(own, other.start) <= met_ || distance(own, other.end) <= met_;
  if (meets_elsewhere) {
    const auto crossing = is_along ? std::nullopt : crossing_of_carriers(own, other);
    if (!crossing || distance(*crossing, back) <= met_ || distance(*crossing, end) > within_) return;
    found.is_met = distance(*crossing, end) <= overshoot;
    near.to = *crossing;
    near.is_beyond = true;
  }
  if (!found.near || near.gap() < found.near->gap()) found.near = near;
}

Warnings join_ends(Drawing& drawing, double distance) {
  if (!(distance > 0) || drawing.joints.empty()) return {};
  std::vector<Segment> lines;
  for (const JointLine& joint : drawing.joints) lines.push_back(joint.segment);
  Joiner joiner(std::move(lines), drawing.boundary_count, distance);
  joiner.join();
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) drawing.joints[i].segment = joiner.lines()[i];
  return joined(told(drawing, "ends_joined", joiner.joined()), told(drawing, "ends_trimmed", joiner.trimmed()));
}

}  // namespace keyblock
