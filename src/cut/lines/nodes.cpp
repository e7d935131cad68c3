// Builds nodes from crossings and edges from lines; see nodes.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/lines/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/union_find.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

struct NearPair {
  double distance = 0;
  int first = 0;
  int second = 0;
};

/// Finds all pairs of points nearer than `reach`, by distance; points are sorted into square cells of that size.
class NearPairs {
 public:
  NearPairs(const std::vector<Point>& points, double reach) : points_(points), reach_(reach) {
    cells_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      cells_.push_back({cell(points[i].x), cell(points[i].y), static_cast<int>(i)});
    }
    std::sort(cells_.begin(), cells_.end());
  }

  std::vector<NearPair> sorted() {
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const auto [x, y, i] = cells_[k];
      add_from(k + 1, x, y + 1, i);  // the rest of this cell and the one above it
      add_column(x + 1, y - 1, y + 1, i);
    }
    std::sort(pairs_.begin(), pairs_.end(), [](const NearPair& a, const NearPair& b) {
      return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
    });
    return std::move(pairs_);
  }

 private:
  using Cell = std::tuple<std::int64_t, std::int64_t, int>;

  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / reach_)); }

  void add_from(std::size_t k, std::int64_t x, std::int64_t last_y, int i) {
    for (; k < cells_.size() && std::get<0>(cells_[k]) == x && std::get<1>(cells_[k]) <= last_y; ++k) {
      const int j = std::get<2>(cells_[k]);
      const double gap = distance(points_[i], points_[j]);
      if (gap <= reach_) pairs_.push_back({gap, std::min(i, j), std::max(i, j)});
    }
  }

  void add_column(std::int64_t x, std::int64_t first_y, std::int64_t last_y, int i) {
    const auto at = std::lower_bound(cells_.begin(), cells_.end(), Cell{x, first_y, -1});
    add_from(static_cast<std::size_t>(at - cells_.begin()), x, last_y, i);
  }

  const std::vector<Point>& points_;
  double reach_;
  std::vector<Cell> cells_;
  std::vector<NearPair> pairs_;
};

/// Groups crossings into nodes.
class Merger {
 public:
  Merger(const Crossings& crossings, std::size_t boundary_count, const CutTolerances& tolerances, NodeMerging merging)
      : crossings_(crossings), boundary_count_(static_cast<int>(boundary_count)), groups_(crossings.found.size()) {
    for (const std::size_t k : crossings.equal_before) {
      groups_.unite(crossings.stops[k - 1].crossing, crossings.stops[k].crossing);
    }
    is_merged_.assign(crossings.found.size(), 0);
    if (tolerances.is_exact()) return;
    if (merging == NodeMerging::nearest_first)
      merge_near(tolerances);
    else
      merge_with_earlier(tolerances);
  }

  int group(int crossing) { return groups_.find(crossing); }
  bool is_exact(int crossing) { return !is_merged_[groups_.find(crossing)]; }
  const std::vector<int>& undecided() const { return undecided_; }

  /// Returns true for crossings with boundary lines, which Shi's programs look for before all others.
  bool is_found_early(int crossing) const { return crossings_.found[crossing].other < boundary_count_; }

 private:
  bool is_boundary(int crossing) const { return crossings_.found[crossing].line < boundary_count_; }

  struct Leaders {
    std::vector<int> crossings;
    std::vector<Point> points;
  };

  /// Returns one crossing of every group of exactly coinciding crossings.
  Leaders leaders_of_groups() {
    Leaders leaders;
    for (std::size_t i = 0; i < crossings_.found.size(); ++i) {
      const int crossing = static_cast<int>(i);
      if (groups_.find(crossing) != crossing) continue;
      leaders.crossings.push_back(crossing);
      leaders.points.push_back(crossings_.found[i].position);
    }
    return leaders;
  }

  /// Merges each crossing with an earlier node, without averaging; crossings of two boundary lines never merge
  /// (legacy-formats 3.6, rule 1).
  void merge_with_earlier(const CutTolerances& tolerances) {
    const auto [leaders, points] = leaders_of_groups();
    const auto rank = [this](int crossing) { return std::pair(!is_found_early(crossing), crossing); };
    std::vector<std::pair<int, int>> later_and_earlier;
    for (const NearPair& pair : NearPairs(points, tolerances.merge).sorted()) {
      const int a = leaders[pair.first];
      const int b = leaders[pair.second];
      later_and_earlier.push_back(rank(a) < rank(b) ? std::pair(b, a) : std::pair(a, b));
    }
    std::sort(later_and_earlier.begin(), later_and_earlier.end(), [&](const auto& p, const auto& q) {
      return std::pair(rank(p.first), rank(p.second)) < std::pair(rank(q.first), rank(q.second));
    });
    std::vector<char> has_joined(crossings_.found.size(), 0);
    for (const auto& [later, earlier] : later_and_earlier) {
      if (is_boundary(later) || has_joined[later] || has_joined[earlier]) continue;
      has_joined[later] = 1;
      groups_.unite(later, earlier);
      is_merged_[groups_.find(earlier)] = 1;
    }
  }

  void merge_near(const CutTolerances& tolerances) {
    const auto [leaders, points] = leaders_of_groups();
    members_.resize(crossings_.found.size());
    for (const int leader : leaders) members_[leader] = {leader};
    // A boundary crossing may coincide exactly with inner lines; its group then counts as boundary.
    has_boundary_.assign(crossings_.found.size(), 0);
    for (std::size_t i = 0; i < crossings_.found.size(); ++i) {
      if (is_boundary(static_cast<int>(i))) has_boundary_[groups_.find(static_cast<int>(i))] = 1;
    }
    for (const NearPair& pair : NearPairs(points, tolerances.merge).sorted()) {
      join(leaders[pair.first], leaders[pair.second], pair.distance, tolerances);
    }
    std::sort(undecided_.begin(), undecided_.end());
    undecided_.erase(std::unique(undecided_.begin(), undecided_.end()), undecided_.end());
  }

  void join(int first, int second, double gap, const CutTolerances& tolerances) {
    const int a = groups_.find(first);
    const int b = groups_.find(second);
    if (a == b) return;
    const bool is_round_off = gap <= tolerances.round_off;
    if (!is_round_off && has_boundary_[a] && has_boundary_[b]) return;
    if (!is_round_off && !fit_together(a, b, tolerances.merge)) {
      undecided_.push_back(a);
      return;
    }
    groups_.unite(a, b);
    const auto [low, high] = std::minmax(a, b);
    members_[low].insert(members_[low].end(), members_[high].begin(), members_[high].end());
    members_[high].clear();
    has_boundary_[low] |= has_boundary_[high];
    is_merged_[low] = 1;
  }

  bool fit_together(int a, int b, double merge) const {
    for (const int i : members_[a]) {
      for (const int j : members_[b]) {
        if (distance(crossings_.found[i].position, crossings_.found[j].position) > merge) return false;
      }
    }
    return true;
  }

  const Crossings& crossings_;
  int boundary_count_;
  UnionFind groups_;
  std::vector<std::vector<int>> members_;  // members of each group's leader
  std::vector<char> has_boundary_;
  std::vector<char> is_merged_;
  std::vector<int> undecided_;
};

/// Chooses the crossing that gives a node its coordinates. If all crossings differ by round-off only, it is the first
/// found, as in Shi's programs. Otherwise the drawing decides, not the order of its lines. A crossing goes before the
/// end of an overlap, and boundary lines before others. Ends drawn there go before lines passing through, long lines
/// before short ones, square crossings before flat ones. If all are equal, the first found is chosen.
class Placing {
 public:
  Placing(std::span<const Segment> lines, std::size_t boundary_count, const Crossings& crossings,
          const CutTolerances& tolerances)
      : lines_(lines),
        boundary_count_(static_cast<int>(boundary_count)),
        found_(crossings.found),
        tolerances_(tolerances) {}

  /// Returns the first found of crossings at exactly one point; the end of an overlap only if there is no other.
  int first_found(std::span<const int> members) const {
    const auto crossing = std::find_if(members.begin(), members.end(), [&](int i) { return !found_[i].is_end; });
    return crossing == members.end() ? members.front() : *crossing;
  }

  /// Chooses among `members`, which are in the order of finding.
  int choose(std::span<const int> members) const {
    const int first = first_found(members);
    const auto is_at = [&](int place) {
      return [this, place](int crossing) { return gap(crossing, place) <= tolerances_.round_off; };
    };
    if (std::all_of(members.begin(), members.end(), is_at(first))) return first;
    int best = first;
    for (const int crossing : members) {
      if (is_better(crossing, best)) best = crossing;
    }
    const auto is_same_place = is_at(best);
    return *std::find_if(members.begin(), members.end(), [&](int crossing) {
      return crossing == best || (!found_[crossing].is_end && is_same_place(crossing));
    });
  }

  double round_off() const { return tolerances_.round_off; }
  double gap(int a, int b) const { return distance(found_[a].position, found_[b].position); }

 private:
  bool is_better(int a, int b) const {
    const auto merit = [this](int i) {
      return std::tuple(!found_[i].is_end, found_[i].line < boundary_count_, ends_drawn_at(i));
    };
    if (merit(a) != merit(b)) return merit(a) > merit(b);
    if (is_clearly_more(summed_length(a), summed_length(b))) return true;
    if (is_clearly_more(summed_length(b), summed_length(a))) return false;
    return is_clearly_more(squareness(a), squareness(b));
  }

  /// Equal measures must not be distinguished by their rounding.
  static bool is_clearly_more(double a, double b) { return a > b * (1 + 1e-6); }

  /// Returns the sum over both lines: 2 if a line ends right there, 1 if within the merging distance (an overshoot).
  int ends_drawn_at(int crossing) const {
    const Crossing& c = found_[crossing];
    int sum = 0;
    for (const Segment& s : {lines_[c.line], lines_[c.other]}) {
      const double nearest = std::min(distance(s.start, c.position), distance(s.end, c.position));
      sum += nearest <= tolerances_.round_off ? 2 : nearest <= tolerances_.merge ? 1 : 0;
    }
    return sum;
  }

  double summed_length(int crossing) const {
    const Segment& a = lines_[found_[crossing].line];
    const Segment& b = lines_[found_[crossing].other];
    return distance(a.start, a.end) + distance(b.start, b.end);
  }

  /// Returns |sin| of the angle between the two lines.
  double squareness(int crossing) const {
    const Segment& a = lines_[found_[crossing].line];
    const Segment& b = lines_[found_[crossing].other];
    const Point along = a.end - a.start;
    const Point across = b.end - b.start;
    return std::fabs(cross(along, across)) / (length(along) * length(across));
  }

  std::span<const Segment> lines_;
  int boundary_count_;
  const std::vector<Crossing>& found_;
  const CutTolerances& tolerances_;
};

/// Crossings of each node in the order of finding; nodes in the order of their first crossing.
struct Members {
  std::vector<std::size_t> start;  // per node, and one past the last
  std::vector<int> crossings;

  std::size_t node_count() const { return start.size() - 1; }
  std::span<const int> of(std::size_t node) const {
    return std::span(crossings).subspan(start[node], start[node + 1] - start[node]);
  }
};

Members members_of_nodes(Merger& merger, const Crossings& crossings) {
  std::vector<int> order(crossings.found.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(), [&](int i) { return merger.is_found_early(i); });
  std::vector<int> node_of_group(order.size(), -1);
  Members members{{0}, std::vector<int>(order.size())};
  for (const int crossing : order) {
    int& node = node_of_group[merger.group(crossing)];
    if (node < 0) {
      node = static_cast<int>(members.node_count());
      members.start.push_back(0);
    }
    ++members.start[node + 1];
  }
  for (std::size_t i = 1; i < members.start.size(); ++i) members.start[i] += members.start[i - 1];
  std::vector<std::size_t> next(members.start.begin(), members.start.end() - 1);
  for (const int crossing : order) members.crossings[next[node_of_group[merger.group(crossing)]]++] = crossing;
  return members;
}

/// Makes the nodes and returns the node of each crossing.
std::vector<int> number_nodes(Merger& merger, const Crossings& crossings, const Placing& placing, NodeMerging merging,
                              NodeTable& table) {
  const Members members = members_of_nodes(merger, crossings);
  std::vector<int> node_of_crossing(crossings.found.size());
  const bool in_order = merging == NodeMerging::in_order_found;
  for (std::size_t node = 0; node < members.node_count(); ++node) {
    const std::span<const int> own = members.of(node);
    const int first = own.front();
    const bool is_exact = merger.is_exact(first);
    const int source = is_exact || in_order ? placing.first_found(own) : placing.choose(own);
    if (!is_exact && !in_order && placing.gap(first, source) > placing.round_off()) ++table.placed_otherwise;
    table.arrangement.nodes.push_back({crossings.found[source].position, is_exact});
    for (const int crossing : own) node_of_crossing[crossing] = static_cast<int>(node);
  }
  for (const int crossing : merger.undecided()) table.undecided_nodes.push_back(node_of_crossing[crossing]);
  return node_of_crossing;
}

/// Returns the pieces between consecutive nodes of every line. A piece shared by lines belongs to the lowest-numbered.
std::vector<Edge> make_edges(const Crossings& crossings, const std::vector<int>& node_of_crossing,
                             const std::vector<Node>& nodes) {
  std::vector<Edge> edges;
  for (std::size_t line = 0; line + 1 < crossings.first_stop.size(); ++line) {
    int last = -1;
    for (std::size_t k = crossings.first_stop[line]; k < crossings.first_stop[line + 1]; ++k) {
      const int node = node_of_crossing[crossings.stops[k].crossing];
      if (last >= 0 && node != last) {
        edges.push_back({last, node, static_cast<int>(line), nodes[last].is_exact && nodes[node].is_exact});
      }
      last = node;
    }
  }
  // Lines that only cross, in nodes that only they pass, share no piece.
  const bool has_overlaps =
      std::any_of(crossings.found.begin(), crossings.found.end(), [](const Crossing& c) { return c.is_end; });
  const bool has_merged = std::any_of(nodes.begin(), nodes.end(), [](const Node& n) { return !n.is_exact; });
  if (!has_overlaps && !has_merged) return edges;
  const auto ends = [](const Edge& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
  std::sort(edges.begin(), edges.end(),
            [&](const Edge& a, const Edge& b) { return std::tuple(ends(a), a.line) < std::tuple(ends(b), b.line); });
  edges.erase(std::unique(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return ends(a) == ends(b); }),
              edges.end());
  return edges;
}

}  // namespace

NodeTable make_nodes(std::vector<Segment> lines, std::size_t boundary_count, const Crossings& crossings,
                     const CutTolerances& tolerances, NodeMerging merging) {
  NodeTable table;
  Merger merger(crossings, boundary_count, tolerances, merging);
  const std::vector<int> node_of_crossing =
      number_nodes(merger, crossings, Placing(lines, boundary_count, crossings, tolerances), merging, table);
  for (std::size_t i = 0; i < crossings.found.size(); ++i) {
    const Crossing& c = crossings.found[i];
    const int node = node_of_crossing[i];
    if (tolerances.is_exact()) continue;
    // A crossing that slides along both its lines bends neither; most are ends of overlaps.
    const Point to = table.arrangement.nodes[node].position;
    if (std::max(distance_to_carrier(lines[c.line], to), distance_to_carrier(lines[c.other], to)) >
        tolerances.round_off) {
      table.moves.push_back({node, c.line, c.position});
    }
  }
  table.arrangement.edges = make_edges(crossings, node_of_crossing, table.arrangement.nodes);
  table.node_of_crossing = node_of_crossing;
  table.arrangement.lines = std::move(lines);
  return table;
}

}  // namespace keyblock
