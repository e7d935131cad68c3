// Tests near vertices by distance, then by angle.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/detect.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/loop.hpp"
#include "contact/find/candidates.hpp"
#include "legacy/contact/wedge.hpp"

namespace keyblock {
namespace {

// Largest interior angle of a convex vertex; the excess includes a straight angle (legacy-rules 2).
constexpr double kConvexBelow = 180.0001;

// Added to |dx| by the Berkeley program before it computes the direction of an edge [length] (legacy-rules 3).
constexpr double kBerkeleyDirectionOffset = 1e-7;

// Ratio of two squares beyond which rounding cannot reverse their order.
constexpr double kSureSquare = 1 + 1e-9;

// Fraction of the overlap angle within which two opposed directions count as tied (legacy-rules 3, vertex-vertex).
constexpr double kTieShare = 0.3;

// Value of π in Shi's programs (legacy-rules, Conventions). Where four blocks meet, the sines of the bisectors of
// opposite wedges differ only by rounding. This π makes them differ by 1e-10, and so decides which entrance line is
// taken.
constexpr double kOldPi = 3.1415926535;

double sine_of(double degrees) {
  return std::sin(degrees * kOldPi / 180);
}

class Detector {
 public:
  Detector(const Model& model, const State& state, const Settings& settings, const ContactRules& rules)
      : model_(model), state_(state), rules_(rules), leaving_(directions(model, state, settings)) {}

  Detection run(const NearList& near) const {
    Table<ElementIndex, Box> boxes(model_.elements.size());
    for_each_index(boxes, [&](ElementIndex e) { boxes[e] = box_of(model_, state_, e); });
    std::vector<Detector> parts(range_count(near.elements.size()), *this);
    for_ranges(near.elements.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto& [a, b] = near.elements[k].elements;
        if (!touch(boxes[a], boxes[b], rules_.search_distance)) continue;
        for (const auto& [i, j] : near.of(k)) parts[range].meet(i, j);
      }
    });
    if (parts.size() == 1) return std::move(parts.front().found_);
    Detection all;
    for (const Detector& part : parts) {
      all.contacts.insert(all.contacts.end(), part.found_.contacts.begin(), part.found_.contacts.end());
      all.all_exchanged = all.all_exchanged && part.found_.all_exchanged;
    }
    return all;
  }

 private:
  using Directions = Table<VertexIndex, double>;

  // Returns the directions of the edges that leave the vertices.
  static std::shared_ptr<const Directions> directions(const Model& model, const State& state,
                                                      const Settings& settings) {
    const double offset = settings.quirks.edge_direction_offset ? kBerkeleyDirectionOffset : 0;
    auto leaving = std::make_shared<Directions>(model.vertices.size());
    for_each_entry(leaving->size(), [&](std::size_t i) {
      const VertexIndex v{static_cast<int>(i)};
      (*leaving)[v] = edge_direction(state.vertices[model.vertices[v].next] - state.vertices[v], offset);
    });
    return leaving;
  }

  Point at(VertexIndex v) const { return state_.vertices[v]; }
  double leaving(VertexIndex v) const { return (*leaving_)[v]; }
  // Follows the boundary from element to element.
  VertexIndex next(VertexIndex v) const { return model_.vertices[v].boundary_next; }
  VertexIndex previous(VertexIndex v) const { return model_.vertices[v].boundary_previous; }
  ElementIndex element(VertexIndex v) const { return model_.vertices[v].element; }
  // Returns the end, in its element, of the edge that leaves v.
  VertexIndex end_of_edge(VertexIndex v) const { return model_.vertices[v].next; }
  // Pairs a vertex with the edge that leaves `start`: the reference line runs against it.
  Triple against_edge(VertexIndex vertex, VertexIndex start) const { return {vertex, end_of_edge(start), start}; }

  Wedge wedge(VertexIndex v) const { return {leaving(v), one_turn(leaving(previous(v)) - 180)}; }
  bool is_convex(VertexIndex v) const { return wedge(v).angle() < kConvexBelow; }

  void meet(VertexIndex i, VertexIndex j) {
    if (are_apart(at(i), at(j))) {
      if (near_edge(i, j)) vertex_edge(i, j);
      if (near_edge(j, i)) vertex_edge(j, i);
    } else if (is_convex(i) && is_convex(j)) {
      vertex_vertex(i, j);
    } else if (is_convex(i)) {
      vertex_edge(i, j);
      vertex_edge(i, previous(j));
    } else {
      vertex_edge(j, i);
      vertex_edge(j, previous(i));
    }
  }

  // Compares squares unless rounding could decide; so does `is_beyond`, which leaves such cases to `near_edge`.
  bool are_apart(Point a, Point b) const {
    const Point between = b - a;
    const double limit = rules_.search_distance * rules_.search_distance;
    return dot(between, between) > kSureSquare * limit || distance(a, b) > rules_.search_distance;
  }
  // Decides from twice the area of the triangle between the vertex and an edge, and the square of that edge.
  bool is_beyond(double twice_area, double edge_square) const {
    const double limit = twice_area < 0 ? rules_.search_distance : rules_.search_depth;
    return twice_area * twice_area > kSureSquare * limit * limit * edge_square;
  }

  // Tests vertex p against the edge from `a` to its next vertex; p is known to be away from `a` itself.
  bool near_edge(VertexIndex p, VertexIndex a) const {
    const Point start = at(a);
    const Point end = at(end_of_edge(a));
    const Point edge = end - start;
    if (is_beyond(cross(edge, at(p) - start), dot(edge, edge)) || !are_apart(at(p), end)) return false;
    const double size = length(edge);
    const double from_middle = dot(at(p) - 0.5 * (start + end), edge) / size;
    if (std::abs(from_middle) > size / 2) return false;
    const double inward = cross(edge, at(p) - start) / size;
    return -rules_.search_distance <= inward && inward <= rules_.search_depth;
  }

  // An element has no contact with itself.
  void vertex_edge(VertexIndex i, VertexIndex j) {
    if (element(i) == element(j)) return;
    const Wedge a = wedge(i);
    const Wedge b{leaving(j), one_turn(leaving(j) - 180)};
    if (!may_touch(a, b, rules_.angle_overlap)) return;
    Contact contact;
    contact.first = against_edge(i, j);
    const auto [gap_next, gap_previous] = gaps(a, b);
    if (gap_next < rules_.angle_overlap)
      contact.neighbour = next(i);
    else if (gap_previous < rules_.angle_overlap)
      contact.neighbour = previous(i);
    found_.contacts.push_back(contact);
    found_.all_exchanged = false;
  }

  void vertex_vertex(VertexIndex i, VertexIndex j) {
    if (element(i) == element(previous(j)) || element(j) == element(previous(i))) return;
    const Wedge a = wedge(i);
    const Wedge b = wedge(j);
    if (!may_touch(a, b, rules_.angle_overlap)) return;
    const auto [gap_next, gap_previous] = gaps(a, b);
    if (gap_next < rules_.angle_overlap) parallel_pair(against_edge(i, previous(j)), against_edge(j, i));
    if (gap_previous < rules_.angle_overlap) parallel_pair(against_edge(j, previous(i)), against_edge(i, j));
    if (gap_next >= rules_.angle_overlap && gap_previous >= rules_.angle_overlap) true_vertex_vertex(i, j, a, b);
  }

  // Open angles between the two wedges on the side of i's next and of i's previous edge; negative if they overlap.
  struct Gaps {
    double next;
    double previous;
  };
  static Gaps gaps(const Wedge& a, const Wedge& b) {
    const double turn = turn_between(a.from, b.from);
    return {360 - turn - b.angle(), turn - a.angle()};
  }
  static double turn_between(double from, double to) { return to - from < 0 ? to - from + 360 : to - from; }

  void parallel_pair(Triple first, Triple second) {
    Contact contact;
    contact.parallel_pair = true;
    const bool inside = dot(at(first.start) - at(first.vertex), at(first.end) - at(first.vertex)) <= 0;
    contact.first = inside ? first : second;
    contact.second = inside ? second : first;
    found_.contacts.push_back(contact);
    if (inside) found_.all_exchanged = false;
  }

  // Finds the two possible reference lines of two convex wedges (legacy-rules 3, true vertex-vertex).
  void true_vertex_vertex(VertexIndex i, VertexIndex j, const Wedge& a, const Wedge& b) {
    const double tie = kTieShare * rules_.angle_overlap;
    const double slope_a = std::abs(sine_of(a.from + a.angle() / 2));
    const double slope_b = std::abs(sine_of(b.from + b.angle() / 2));
    const double between_next = turn_between(a.from, b.from);
    const double between_previous = turn_between(a.to, b.to);
    Contact contact;
    contact.kind = ContactKind::vertex_vertex;
    const bool first_on_j = between_next <= 180 - tie || (between_next <= 180 + tie && slope_b >= slope_a);
    contact.first = first_on_j ? against_edge(i, j) : against_edge(j, i);
    const double first_direction = first_on_j ? b.from : a.from;
    const bool second_on_i = between_previous <= 180 - tie || (between_previous <= 180 + tie && slope_a >= slope_b);
    contact.second = second_on_i ? against_edge(j, previous(i)) : against_edge(i, previous(j));
    if (second_on_i && std::abs(sine_of(first_direction)) < std::abs(sine_of(a.to)))
      std::swap(contact.first, contact.second);
    found_.contacts.push_back(contact);
    found_.all_exchanged = false;
  }

  const Model& model_;
  const State& state_;
  const ContactRules& rules_;
  std::shared_ptr<const Directions> leaving_;
  Detection found_;
};

}  // namespace

Detection detect(const Model& model, const State& state, const Settings& settings, const ContactRules& rules,
                 NearVertices& near) {
  return Detector(model, state, settings, rules).run(near.of(model, state, rules));
}

}  // namespace keyblock
