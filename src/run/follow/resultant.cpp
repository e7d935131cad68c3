// Sums over contacts and bolts in one pass.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/resultant.hpp"

#include <algorithm>
#include <map>

#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

// Fraction of the length of a line: corners just beyond its ends count, moved there by round-off or bulging rock.
constexpr double kBeyondEnds = 1e-3;

bool lies_along(const Segment& line, Point p, double beyond = kBeyondEnds) {
  const Point along = line.end - line.start;
  const double share = dot(p - line.start, along) / dot(along, along);
  return share >= -beyond && share <= 1 + beyond;
}

class Sum {
 public:
  explicit Sum(const Segment& line) : middle_(0.5 * (line.start + line.end)) {}

  void add(Point force, Point at) {
    result.force = result.force + force;
    result.moment += cross(at - middle_, force);
  }

  LineResultant result;

 private:
  Point middle_;
};

}  // namespace

std::vector<bool> left_of(const Segment& line, const Stepper& stepper) {
  std::vector<bool> left;
  const auto& places = stepper.unloaded().elements;
  for (const ElementIndex e : indices(places))
    left.push_back(cross(line.end - line.start, places[e].centroid - line.start) > 0);
  return left;
}

int body_across(const Segment& line, const Manifold& manifold) {
  std::map<int, bool> side_of_body;
  for (const ManifoldElement& element : manifold.elements) {
    const Point middle = centroid(manifold.polygon(element).front());
    if (!lies_along(line, middle, 0)) continue;
    const bool is_left = cross(line.end - line.start, middle - line.start) > 0;
    if (side_of_body.try_emplace(element.body, is_left).first->second != is_left) return element.body;
  }
  return -1;
}

LineResultant resultant_across(const Segment& line, const Stepper& stepper, const ContactFrames& contacts) {
  const std::vector<bool> left = left_of(line, stepper);
  const Model& model = stepper.model();
  std::map<int, bool> side_of_number;
  for (const ElementIndex e : indices(model.elements))
    side_of_number[model.identities.of_element(e.value).number] = left[static_cast<std::size_t>(e.value)];
  Sum sum(line);
  for (const ContactFrame& contact : contacts) {
    const bool is_left = side_of_number[contact.element];
    if (is_left == side_of_number[contact.other] || !lies_along(line, contact.position)) continue;
    ++sum.result.contacts;
    if (contact.condition != ContactCondition::open) ++sum.result.closed;
    sum.add((is_left ? 1.0 : -1.0) * contact.force(), contact.position);
  }
  const State& state = stepper.state();
  for (std::size_t i = 0; i < state.bolts.size(); ++i) {
    const BoltState& bolt = state.bolts[i];
    const bool is_left = left[static_cast<std::size_t>(model.bolts[i].first.element.value)];
    if (is_left == left[static_cast<std::size_t>(model.bolts[i].second.element.value)]) continue;
    if (bolt.is_broken || !lies_along(line, 0.5 * (bolt.first + bolt.second))) continue;
    ++sum.result.bolts;
    const Point along = bolt.second - bolt.first;
    sum.add((is_left ? 1.0 : -1.0) * bolt.force / length(along) * along, bolt.first);
  }
  return sum.result;
}

}  // namespace keyblock
