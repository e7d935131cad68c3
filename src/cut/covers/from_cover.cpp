// Turns slots into corners, edges into neighbours, and loops into the boundary; see from_cover.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/from_cover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/union_find.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

using EdgeKey = std::array<double, 4>;

EdgeKey key(Point from, Point to) {
  return {from.x, from.y, to.x, to.y};
}

using Slots = std::vector<int>;

int shared_covers(const ManifoldElement& a, const ManifoldElement& b) {
  return static_cast<int>(
      std::ranges::count_if(a.covers, [&](int cover) { return std::ranges::find(b.covers, cover) != b.covers.end(); }));
}

class FromCover {
 public:
  explicit FromCover(const Cover& cover) : cover_(cover), corner_of_slot_(cover.vertices.size(), -1) {}

  Manifold run() {
    add_nodes();
    mark_loop_edges();
    for (const CoverElement& element : cover_.elements) add_element(element);
    list_covers();
    add_boundary();
    find_neighbours();
    find_bodies();
    return std::move(manifold_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(cover_.place, what); }
  [[noreturn]] void fail(std::size_t element, const std::string& what) const {
    const Place& place = cover_.elements[element].place;
    throw InputError(place.line > 0 ? place : cover_.place, what);
  }

  Point position(int slot) const { return cover_.vertices[slot]; }
  std::string text_of(Point a, Point b) const { return fmt::format("from ({}, {}) to ({}, {})", a.x, a.y, b.x, b.y); }

  void add_nodes() {
    std::map<std::pair<double, double>, int> nodes;
    for (const Point p : cover_.nodes) {
      const auto [at, is_new] = nodes.try_emplace({p.x, p.y}, static_cast<int>(manifold_.mesh.nodes.size()));
      if (is_new) manifold_.mesh.nodes.push_back(p);
      manifold_.covers.push_back({at->second, {}});
    }
  }

  /// Marks edges in loops. A slot may occur twice in the chain of an element with a hole: where a bridge leaves, and
  /// where the loop continues.
  void mark_loop_edges() {
    is_in_loop_.assign(cover_.vertices.size(), 0);
    for (const SlotRange& loop : cover_.loops) {
      for (int i = loop.first; i < loop.first + loop.size; ++i) {
        const int slot = cover_.loop_vertices[i].slot;
        const Point next = position(cover_.loop_vertices[i + 1].slot);
        if (slot + 1 < static_cast<int>(cover_.vertices.size()) && position(slot + 1) == next) is_in_loop_[slot] = 1;
      }
    }
  }

  void add_element(const CoverElement& from) {
    ManifoldElement element;
    element.covers = from.covers;
    element.triangle = triangle_of(from.covers);
    Slots chain;
    for (int i = 0; i < from.vertices.size; ++i) chain.push_back(from.vertices.first + i);
    std::vector<Slots> loops = without_bridges(std::move(chain));
    const auto is_outer = [&](const Slots& loop) { return area(points_of(loop)) > 0; };
    std::ranges::stable_partition(loops, is_outer);
    if (!is_outer(loops.front()) || std::ranges::count_if(loops, is_outer) > 1)
      fail(manifold_.elements.size(),
           fmt::format("expected element {} counter-clockwise around one area, found another shape",
                       manifold_.elements.size() + 1));
    element.outer = add_loop(loops.front());
    element.holes = {static_cast<int>(manifold_.holes.size()), static_cast<int>(loops.size()) - 1};
    for (std::size_t i = 1; i < loops.size(); ++i) manifold_.holes.push_back(add_loop(loops[i]));
    manifold_.elements.push_back(element);
  }

  int triangle_of(const std::array<int, 3>& covers) {
    std::array<int, 3> nodes{};
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      nodes[k] = manifold_.covers[covers[k]].node;
      corners[k] = manifold_.mesh.nodes[nodes[k]];
    }
    if (!(cross(corners[1] - corners[0], corners[2] - corners[0]) > 0))
      fail(manifold_.elements.size(),
           fmt::format("expected the nodes of the covers of element {} counter-clockwise, found covers {}, {} and {}",
                       manifold_.elements.size() + 1, covers[0] + 1, covers[1] + 1, covers[2] + 1));
    const auto [at, is_new] = triangles_.try_emplace(nodes, static_cast<int>(manifold_.mesh.triangles.size()));
    if (is_new) manifold_.mesh.triangles.push_back(nodes);
    return at->second;
  }

  std::vector<Point> points_of(const Slots& loop) const {
    std::vector<Point> points;
    for (const int slot : loop) points.push_back(position(slot));
    return points;
  }

  /// Splits the chain at bridges: edges outside all loops whose reverse is in the same chain.
  std::vector<Slots> without_bridges(Slots chain) {
    std::map<EdgeKey, std::size_t> walked;
    const std::size_t n = chain.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 == n ? 0 : i + 1;
      if (is_in_loop_[chain[i]]) continue;
      const Point from = position(chain[i]);
      const Point to = position(chain[next]);
      if (const auto there = walked.find(key(to, from)); there != walked.end())
        return parted(chain, there->second, i, next);
      walked[key(from, to)] = i;
    }
    return {std::move(chain)};
  }

  /// Splits a chain at a bridge. The outward edge leaves place `there`; the return edge leads from `back` to `next`.
  std::vector<Slots> parted(const Slots& chain, std::size_t there, std::size_t back, std::size_t next) {
    const auto at = [&](std::size_t i) { return chain.begin() + static_cast<std::ptrdiff_t>(i); };
    Slots inner(at(there + 1), at(back));
    Slots outer = next == 0 ? Slots(chain.begin(), at(there)) : Slots(chain.begin(), at(there + 1));
    if (next != 0) outer.insert(outer.end(), at(next + 1), chain.end());
    merged_.push_back({chain[back], chain[there + 1]});
    merged_.push_back(next == 0 ? std::pair(chain[there], chain[0]) : std::pair(chain[next], chain[there]));
    std::vector<Slots> loops;
    for (Slots* part : {&outer, &inner}) {
      if (part->empty()) continue;
      std::vector<Slots> of_part = without_bridges(std::move(*part));
      loops.insert(loops.end(), of_part.begin(), of_part.end());
    }
    return loops;
  }

  SlotRange add_loop(const Slots& loop) {
    const SlotRange range{static_cast<int>(manifold_.corners.size()), static_cast<int>(loop.size())};
    for (std::size_t i = 0; i < loop.size(); ++i) {
      corner_of_slot_[loop[i]] = static_cast<int>(manifold_.corners.size());
      manifold_.corners.push_back({position(loop[i]), -1, -1});
      element_of_corner_.push_back(static_cast<int>(manifold_.elements.size()));
      next_corner_.push_back(range.first + static_cast<int>(i + 1 == loop.size() ? 0 : i + 1));
    }
    return range;
  }

  void list_covers() {
    std::vector<std::vector<int>> elements(manifold_.covers.size());
    for (std::size_t e = 0; e < manifold_.elements.size(); ++e) {
      for (const int cover : manifold_.elements[e].covers) elements[cover].push_back(static_cast<int>(e));
    }
    for (std::size_t c = 0; c < elements.size(); ++c) {
      manifold_.covers[c].elements = {static_cast<int>(manifold_.cover_elements.size()),
                                      static_cast<int>(elements[c].size())};
      manifold_.cover_elements.insert(manifold_.cover_elements.end(), elements[c].begin(), elements[c].end());
    }
  }

  void add_boundary() {
    for (auto at = merged_.rbegin(); at != merged_.rend(); ++at)
      corner_of_slot_[at->first] = corner_of_slot_[at->second];
    for (std::size_t l = 0; l < cover_.loops.size(); ++l) {
      const SlotRange& loop = cover_.loops[l];
      manifold_.boundary_loops.push_back({static_cast<int>(manifold_.boundary_edges.size()), loop.size});
      for (int i = loop.first; i < loop.first + loop.size; ++i)
        add_boundary_edge(cover_.loop_vertices[i], position(cover_.loop_vertices[i + 1].slot), l);
    }
  }

  void add_boundary_edge(const LoopVertex& vertex, Point to, std::size_t loop) {
    const int corner = corner_of_slot_[vertex.slot];
    if (corner < 0 || manifold_.corners[next_corner_[corner]].position != to ||
        manifold_.corners[corner].joint_material >= 0) {
      const std::string what =
          fmt::format("expected each edge of loop {} of {} once among the edges of the elements, found another {}",
                      loop + 1, cover_.loops.size(), text_of(position(vertex.slot), to));
      if (corner < 0) fail(what);
      fail(static_cast<std::size_t>(element_of_corner_[corner]), what);
    }
    manifold_.corners[corner].joint_material = std::max(vertex.joint_material, 0);
    manifold_.boundary_edges.push_back({element_of_corner_[corner], corner});
  }

  void find_neighbours() {
    std::multimap<EdgeKey, int> waiting;
    const int count = static_cast<int>(manifold_.corners.size());
    for (int corner = 0; corner < count; ++corner) {
      if (is_boundary(corner)) continue;
      const Point from = manifold_.corners[corner].position;
      const Point to = manifold_.corners[next_corner_[corner]].position;
      auto [at, end] = waiting.equal_range(key(to, from));
      at = std::find_if(at, end, [&](const auto& other) { return are_neighbours(corner, other.second); });
      if (at == end) {
        waiting.emplace(key(from, to), corner);
        continue;
      }
      manifold_.corners[corner].neighbour = element_of_corner_[at->second];
      manifold_.corners[at->second].neighbour = element_of_corner_[corner];
      waiting.erase(at);
    }
    if (waiting.empty()) return;
    const int lone = waiting.begin()->second;
    fail(static_cast<std::size_t>(element_of_corner_[lone]),
         fmt::format("expected the edge {} of element {} in a loop or in a neighbour that shares two covers, found it "
                     "in neither",
                     text_of(manifold_.corners[lone].position, manifold_.corners[next_corner_[lone]].position),
                     element_of_corner_[lone] + 1));
  }

  bool is_boundary(int corner) const { return manifold_.corners[corner].joint_material >= 0; }

  bool are_neighbours(int corner, int other) const {
    const int a = element_of_corner_[corner];
    const int b = element_of_corner_[other];
    return a != b && shared_covers(manifold_.elements[a], manifold_.elements[b]) >= 2;
  }

  void find_bodies() {
    UnionFind parts(manifold_.elements.size());
    const auto material = [&](int element) { return cover_.elements[element].material; };
    for (std::size_t c = 0; c < manifold_.corners.size(); ++c) {
      const int beyond = manifold_.corners[c].neighbour;
      if (beyond >= 0 && material(beyond) == material(element_of_corner_[c]))
        parts.unite(element_of_corner_[c], beyond);
    }
    std::vector<int> body_of_part(manifold_.elements.size(), -1);
    for (int e = 0; e < static_cast<int>(manifold_.elements.size()); ++e) {
      int& body = body_of_part[parts.find(e)];
      if (body < 0) {
        body = static_cast<int>(manifold_.body_materials.size());
        manifold_.body_materials.push_back(material(e));
      }
      manifold_.elements[e].body = body;
    }
  }

  const Cover& cover_;
  Manifold manifold_;
  std::map<std::array<int, 3>, int> triangles_;
  std::vector<char> is_in_loop_;     // per slot: true if the edge that leaves it in its chain is in a loop
  std::vector<int> corner_of_slot_;  // -1: none
  std::vector<int> element_of_corner_;
  std::vector<int> next_corner_;             // next in its loop
  std::vector<std::pair<int, int>> merged_;  // slots at both ends of bridges: the first is the corner of the second
};

/// Collects pieces by their ends; a piece whose reverse exists already becomes its other side.
class GraphOfBodies {
 public:
  explicit GraphOfBodies(const Manifold& manifold) : manifold_(manifold) { graph_.materials = manifold.body_materials; }

  BodyGraph run() {
    for (const ManifoldElement& element : manifold_.elements) {
      add(element.body, element.outer);
      for (const SlotRange& hole : manifold_.holes_of(element)) add(element.body, hole);
    }
    return std::move(graph_);
  }

 private:
  void add(int body, const SlotRange& range) {
    const std::span<const ElementCorner> loop = manifold_.loop(range);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (loop[i].neighbour < 0)
        add_piece(body, node_at(loop[i].position), node_at(loop[(i + 1) % loop.size()].position),
                  loop[i].joint_material);
  }

  void add_piece(int body, int from, int to, int joint_material) {
    const auto other = pieces_.find({to, from});
    if (other == pieces_.end()) {
      pieces_.emplace(std::pair(from, to), graph_.pieces.size());
      graph_.pieces.push_back({from, to, false, body, -1, joint_material});
      return;
    }
    BodyPiece& piece = graph_.pieces[other->second];
    piece.is_slit = piece.left == body;
    piece.right = body;
    if (piece.is_slit) piece.left = piece.right = -1;
  }

  int node_at(Point p) {
    const auto [at, is_new] = nodes_.try_emplace({p.x, p.y}, static_cast<int>(graph_.nodes.size()));
    if (is_new) graph_.nodes.push_back(p);
    return at->second;
  }

  const Manifold& manifold_;
  BodyGraph graph_;
  std::map<std::pair<double, double>, int> nodes_;
  std::map<std::pair<int, int>, std::size_t> pieces_;
};

}  // namespace

BodyGraph body_graph_of(const Manifold& manifold) {
  return GraphOfBodies(manifold).run();
}

Manifold manifold_of(const Cover& cover) {
  return FromCover(cover).run();
}

ElementPoints points_of(const Cover& cover) {
  return {cover.fixed_points, cover.loading_points, cover.measured_points};
}

}  // namespace keyblock
