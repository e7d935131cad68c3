// Searches with a margin that grows while lists are soon used up.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/near_vertices.hpp"

#include <algorithm>

#include "base/loop.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Reach of a contact over its greatest distance: allows for rounding.
constexpr double kReach = 1.001;
// A list that served for fewer steps than this is followed by one with twice the margin, up to so many times the
// reach of a contact. A search costs as much as five to ten tests of a list.
constexpr int kFewUses = 8;
constexpr double kMostMargin = 8;

class Search {
 public:
  Search(const Model& model, const Table<VertexIndex, Point>& places, double distance)
      : model_(model), places_(places), distance_(distance) {}

  void add(const ElementPair& pair, NearList& list) const {
    const Element& a = model_.elements[pair.lower];
    const Element& b = model_.elements[pair.upper];
    const bool hang_together = share_a_cover(a, b);
    const Box reach_a = reach(a);
    const Box reach_b = reach(b);
    for (VertexIndex i : a.vertices()) {
      if (!follower(i)) continue;
      const bool i_is_near = reach_b.holds(places_[i]);
      for (VertexIndex j : b.vertices()) {
        if (!follower(j) || !(i_is_near || reach_a.holds(places_[j]))) continue;
        if (hang_together && (follower(i) == j || follower(j) == i)) continue;
        if (are_near(i, j)) list.vertices.push_back({i, j});
      }
    }
    const std::size_t before = list.elements.empty() ? 0 : list.elements.back().end;
    if (list.vertices.size() > before) list.elements.push_back({pair, list.vertices.size()});
  }

 private:
  VertexIndex follower(VertexIndex v) const { return model_.vertices[v].boundary_next; }
  Segment edge(VertexIndex start) const { return {places_[start], places_[model_.vertices[start].next]}; }
  bool are_near(VertexIndex i, VertexIndex j) const {
    return !(distance(edge(j), places_[i]) > distance_) || !(distance(edge(i), places_[j]) > distance_);
  }
  Box reach(const Element& element) const {
    Box box;
    for (VertexIndex v : element.vertices()) box.add(places_[v]);
    return {box.low - Point{distance_, distance_}, box.high + Point{distance_, distance_}};
  }

  const Model& model_;
  const Table<VertexIndex, Point>& places_;
  double distance_;
};

}  // namespace

// Two vertices, or a vertex and an edge, approach by twice the greatest displacement at most.
bool NearVertices::is_complete(const State& state) const {
  if (places_.size() != state.vertices.size()) return false;
  const double allowed = margin_ * margin_ / 4;
  for (VertexIndex v : indices(places_)) {
    const Point moved = state.vertices[v] - places_[v];
    if (!(dot(moved, moved) <= allowed)) return false;
  }
  return true;
}

void NearVertices::search(const Model& model, const State& state, double distance) {
  const std::vector<ElementPair> pairs = close_pairs(model, state, distance);
  const Search search(model, state.vertices, distance);
  std::vector<NearList> parts(range_count(pairs.size()));
  for_ranges(pairs.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) search.add(pairs[i], parts[range]);
  });
  list_ = {};
  for (const NearList& part : parts) {
    const std::size_t before = list_.vertices.size();
    list_.vertices.insert(list_.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [elements, end] : part.elements) list_.elements.push_back({elements, before + end});
  }
  places_ = state.vertices;
}

const NearList& NearVertices::of(const Model& model, const State& state, const ContactRules& rules) {
  if (!is_complete(state)) {
    const double reach = kReach * std::max(rules.search_distance, rules.search_depth);
    const double margin = margin_ == 0       ? reach
                          : uses_ < kFewUses ? std::min(2 * margin_, kMostMargin * reach)
                                             : margin_;
    search(model, state, reach + margin);
    margin_ = margin;
    uses_ = 0;
  }
  ++uses_;
  return list_;
}

}  // namespace keyblock
