// Visits all elements once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/extremes.hpp"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Greatest displacement in an element, and its initial place.
struct Displaced {
  double way = 0;
  Point from;

  void look_at(Point start, Point displacement) {
    if (!is_clearly_greater(length(displacement), way)) return;
    way = length(displacement);
    from = start;
  }
};

// Uses the vertices, or the centroid of a piece that is new or had other corners.
Displaced greatest_displacement(const ElementFrame* start, const ElementFrame& after) {
  const auto sizes_of = [](const ElementFrame& element) {
    std::vector<std::size_t> sizes;
    for (const auto& loop : element.loops) sizes.push_back(loop.size());
    return sizes;
  };
  Displaced greatest;
  const bool is_whole = start != nullptr && start->mass == after.mass && sizes_of(*start) == sizes_of(after);
  if (!is_whole) {
    greatest.look_at(after.centroid - after.displacement, after.displacement);
    return greatest;
  }
  const ElementFrame& before = *start;
  for (std::size_t l = 0; l < before.loops.size(); ++l)
    for (std::size_t v = 0; v < before.loops[l].size(); ++v)
      greatest.look_at(before.loops[l][v], after.loops[l][v] - before.loops[l][v]);
  return greatest;
}

Displaced greatest_displacement(const FieldElement& element) {
  Displaced greatest;
  for (const auto& loop : element.loops)
    for (const FieldCorner& corner : loop) greatest.look_at(corner.position, corner.displacement);
  return greatest;
}

}  // namespace

bool is_clearly_greater(double value, double than) {
  return value > (1 + kTie) * than;
}

std::pair<double, double> principal(const Stress& stress) {
  const double mean = (stress.xx + stress.yy) / 2;
  const double radius = std::hypot((stress.xx - stress.yy) / 2, stress.xy);
  return {mean - radius, mean + radius};
}

double principal_angle(const Stress& stress) {
  return std::atan2(2 * stress.xy, stress.xx - stress.yy) / 2;
}

Extremes extremes_of(const Frame& start, const Frame& end, const FieldFrame& field) {
  Extremes found;
  const bool is_from_drawing = field.elements.size() == end.elements.size();
  const ElementsByNumber before(start);
  for (std::size_t e = 0; e < end.elements.size(); ++e) {
    const int index = number_of(end, e);
    const ElementFrame* first = before.find(index);
    const Displaced displaced =
        is_from_drawing ? greatest_displacement(field.elements[e]) : greatest_displacement(first, end.elements[e]);
    const auto [least, greatest] = principal(end.elements[e].stress);
    if (is_clearly_greater(displaced.way, found.displacement)) {
      found.displacement = displaced.way;
      found.displaced_from = displaced.from;
      found.displaced_element = index;
    }
    // An element that was cut is smaller for another reason.
    const bool is_whole = first != nullptr && first->mass == end.elements[e].mass;
    const double area_share = is_whole ? end.elements[e].area / first->area : 1;
    if (area_share < found.area_share) {
      found.area_share = area_share;
      found.crushed_element = index;
    }
    if (e == 0 || least < found.least_stress) {
      found.least_stress = least;
      found.compressed_element = index;
    }
    if (e == 0 || greatest > found.greatest_stress) {
      found.greatest_stress = greatest;
      found.stretched_element = index;
    }
  }
  return found;
}

std::optional<PlasticExtremes> plastic_extremes_of(const Frame& end) {
  if (!end.plastic) return std::nullopt;
  PlasticExtremes found{*end.plastic};
  for (std::size_t i = 0; i < end.elements.size(); ++i) {
    const ElementFrame& element = end.elements[i];
    if (!element.plastic || element.plastic->equivalent <= found.equivalent) continue;
    found.equivalent = element.plastic->equivalent;
    found.element = number_of(end, i);
    found.place = element.centroid;
  }
  return found;
}

}  // namespace keyblock
