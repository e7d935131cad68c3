// Labels the faces of an overlay with their bodies and triangles; see cover_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/covers/cover_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/union_find.hpp"
#include "cut/lines/prune.hpp"
#include "geometry/box.hpp"

namespace keyblock {
namespace {

constexpr int kNone = -1;
constexpr int kUnknown = -2;

/// Calls `visit` with every link of a face.
template <class Visit>
void visit_links(const Face& face, Visit visit) {
  for (const ChainLink& link : face.outer) visit(link);
  for (const Chain& hole : face.holes) {
    for (const ChainLink& link : hole) visit(link);
  }
}

/// Returns the edge of a half-edge as a segment.
Segment edge_segment(const Arrangement& arrangement, int half_edge) {
  const Edge& e = arrangement.edges[half_edge / 2];
  return {arrangement.nodes[e.from].position, arrangement.nodes[e.to].position};
}
double edge_length(const Arrangement& arrangement, int half_edge) {
  const Segment of = edge_segment(arrangement, half_edge);
  return distance(of.start, of.end);
}

/// Contracts edges of zero length.
class Contraction {
 public:
  Contraction(CoverFaces& faces, double round_off) : faces_(faces), round_off_(round_off) {}

  /// Removes edges of zero length, and faces that have no others. Such edges arise if a piece passes a node of the mesh
  /// up to rounding.
  void run() {
    std::vector<Chain*> chain_of(2 * faces_.origins.size(), nullptr);
    const auto note = [&](Chain& chain) {
      for (const ChainLink& link : chain) chain_of[link.half_edge] = &chain;
    };
    for (CoverFace& face : faces_.faces) {
      note(face.face.outer);
      for (Chain& hole : face.face.holes) note(hole);
    }
    const auto can_lose_a_link = [&](const Chain* chain) {
      return chain == nullptr || chain->size() > 3 ||
             std::all_of(chain->begin(), chain->end(), [&](const ChainLink& l) { return is_short(l.half_edge); }) ||
             (chain->size() == 3 && piece_of(*chain) != kNone);
    };
    UnionFind same(faces_.arrangement.nodes.size());
    for (int e = 0; e < static_cast<int>(faces_.origins.size()); ++e) {
      if (!is_short(2 * e) || !can_lose_a_link(chain_of[2 * e]) || !can_lose_a_link(chain_of[2 * e + 1])) continue;
      same.unite(faces_.arrangement.edges[e].from, faces_.arrangement.edges[e].to);
      for (const int h : {2 * e, 2 * e + 1}) {
        if (chain_of[h] != nullptr) std::erase_if(*chain_of[h], [&](const ChainLink& l) { return l.half_edge == h; });
        faces_.face_of_half_edge[h] = kNone;
      }
    }
    drop_faces_of_two_edges();
    for (std::size_t n = 0; n < faces_.arrangement.nodes.size(); ++n)
      faces_.arrangement.nodes[n].position = faces_.arrangement.nodes[same.find(static_cast<int>(n))].position;
  }

 private:
  const EdgeOrigin& origin(int half_edge) const { return faces_.origins[half_edge / 2]; }

  bool is_short(int half_edge) const { return edge_length(faces_.arrangement, half_edge) <= 2 * round_off_; }

  /// Returns the first piece that a chain runs along, or kNone.
  int piece_of(const Chain& chain) const {
    for (const ChainLink& link : chain) {
      if (origin(link.half_edge).piece != kNone) return origin(link.half_edge).piece;
    }
    return kNone;
  }

  /// Replaces a needle whose short edge was contracted by one piece.
  void drop_faces_of_two_edges() {
    for (CoverFace& face : faces_.faces) {
      if (face.face.outer.size() != 2) continue;
      const int piece = piece_of(face.face.outer);
      for (const ChainLink& link : face.face.outer) {
        if (origin(link.half_edge).piece == kNone) faces_.origins[link.half_edge / 2].piece = piece;
        faces_.face_of_half_edge[link.half_edge] = kNone;
      }
      face.face.outer.clear();
    }
  }

  CoverFaces& faces_;
  double round_off_;
};

class Labelling {
 public:
  Labelling(const BodyGraph& graph, const TriangleMesh& mesh) : graph_(graph) {
    Overlay all = overlay(graph, mesh);
    result_.arrangement = std::move(all.arrangement);
    result_.sides = std::move(all.sides);
    result_.origins = std::move(all.origins);
    triangle_of_.assign(2 * result_.origins.size(), kUnknown);
    round_off_ = all.round_off;
  }

  CoverFaces run() {
    do {
      drop_loose_edges();
      trace();
      find_triangles();
      find_bodies();
    } while (leave_out_flat_faces());
    Contraction(result_, round_off_).run();
    keep_bodies();
    return std::move(result_);
  }

 private:
  std::vector<Edge>& edges() { return result_.arrangement.edges; }
  int edge_count() const { return static_cast<int>(result_.origins.size()); }
  const EdgeOrigin& origin(int half_edge) const { return result_.origins[half_edge / 2]; }

  double length(int half_edge) const { return edge_length(result_.arrangement, half_edge); }

  /// Keeps the edges for which `is_kept` is true, with their labels.
  template <class IsKept>
  void keep_edges(IsKept is_kept) {
    int kept = 0;
    for (int e = 0; e < edge_count(); ++e) {
      if (!is_kept(e)) continue;
      edges()[kept] = edges()[e];
      result_.origins[kept] = result_.origins[e];
      for (const int side : {0, 1}) triangle_of_[2 * kept + side] = triangle_of_[2 * e + side];
      ++kept;
    }
    edges().resize(kept);
    result_.origins.resize(kept);
    triangle_of_.resize(2 * static_cast<std::size_t>(kept));
  }

  void drop_loose_edges() {
    const std::vector<Edge> kept = prune(result_.arrangement).kept;
    std::size_t next = 0;
    keep_edges([&](int e) {
      if (next == kept.size() || kept[next].from != edges()[e].from || kept[next].to != edges()[e].to) return false;
      ++next;
      return true;
    });
  }

  void trace() {
    result_.faces.clear();
    for (Face& face : trace_faces(result_.arrangement)) result_.faces.push_back({std::move(face), kNone, kUnknown});
    result_.face_of_half_edge.assign(2 * result_.origins.size(), kNone);
    for (std::size_t f = 0; f < result_.faces.size(); ++f) {
      visit_links(result_.faces[f].face,
                  [&](const ChainLink& link) { result_.face_of_half_edge[link.half_edge] = static_cast<int>(f); });
    }
  }

  /// Finds triangles from the sides of the mesh. A face without such a side lies in the triangle of a face beyond a
  /// piece.
  void find_triangles() {
    std::vector<int> known;
    const auto learn = [&](int face, int triangle) {
      if (face == kNone || triangle == kUnknown || result_.faces[face].triangle != kUnknown) return;
      result_.faces[face].triangle = triangle;
      known.push_back(face);
    };
    for (int h = 0; h < 2 * edge_count(); ++h) {
      learn(result_.face_of_half_edge[h], triangle_of_[h] != kUnknown ? triangle_of_[h] : triangle_at_side(h));
    }
    while (!known.empty()) {
      const int face = known.back();
      known.pop_back();
      visit_links(result_.faces[face].face, [&](const ChainLink& link) {
        if (origin(link.half_edge).side == kNone)
          learn(result_.face_of_half_edge[link.half_edge ^ 1], result_.faces[face].triangle);
      });
    }
  }

  int triangle_at_side(int half_edge) const {
    const EdgeOrigin& from = origin(half_edge);
    if (from.side == kNone) return kUnknown;
    const MeshSide& side = result_.sides[from.side];
    return (half_edge % 2 == 0) != from.side_is_reversed ? side.left : side.right;
  }

  /// Finds bodies from the outlines beside faces; a body extends across sides of the mesh and slits. If rounding makes
  /// outlines contradict each other, the greater length decides.
  void find_bodies() {
    struct Vote {
      int region, body;
      double length;
    };
    UnionFind regions(result_.faces.size());
    for (int e = 0; e < edge_count(); ++e) {
      const int left = result_.face_of_half_edge[2 * e];
      const int right = result_.face_of_half_edge[2 * e + 1];
      if (!is_outline(e) && left != kNone && right != kNone) regions.unite(left, right);
    }
    std::vector<Vote> votes;
    for (int h = 0; h < 2 * edge_count(); ++h) {
      const int face = result_.face_of_half_edge[h];
      if (!is_outline(h / 2) || face == kNone) continue;
      const BodyPiece& piece = graph_.pieces[origin(h).piece];
      const bool is_left = (h % 2 == 0) != origin(h).piece_is_reversed;
      votes.push_back({regions.find(face), is_left ? piece.left : piece.right, length(h)});
    }
    std::stable_sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
      return std::tie(a.region, a.body) < std::tie(b.region, b.body);
    });
    std::vector<int> body(result_.faces.size(), kNone);
    std::vector<double> weight(result_.faces.size(), 0);
    double sum = 0;
    for (std::size_t k = 0; k < votes.size(); ++k) {
      const auto [region, name, own] = votes[k];
      const bool goes_on = k > 0 && votes[k - 1].region == region && votes[k - 1].body == name;
      sum = goes_on ? sum + own : own;
      if (sum <= weight[region]) continue;
      weight[region] = sum;
      body[region] = name;
    }
    for (std::size_t f = 0; f < result_.faces.size(); ++f)
      result_.faces[f].body = body[regions.find(static_cast<int>(f))];
  }

  bool is_outline(int edge) const {
    const int piece = result_.origins[edge].piece;
    return piece != kNone && !graph_.pieces[piece].is_slit;
  }

  /// Merges each flat face with the face that shares most of its length across a side of the mesh, and its triangle.
  /// Flat faces between two pieces stay, because the drawing has them. Returns true if there were any flat faces to
  /// merge.
  bool leave_out_flat_faces() {
    std::vector<double> extent;  // of flat faces; negative for others
    for (const CoverFace& face : result_.faces) extent.push_back(flat_extent(face).value_or(-1));
    std::vector<char> is_left_out(edges().size(), 0);
    for (std::size_t f = 0; f < result_.faces.size(); ++f) {
      if (extent[f] < 0) continue;
      int longest = kNone;
      visit_links(result_.faces[f].face, [&](const ChainLink& link) {
        const int h = link.half_edge;
        const int beyond = result_.face_of_half_edge[h ^ 1];
        if (origin(h).piece != kNone || beyond == kNone || extent[beyond] >= 0) return;
        if (result_.faces[beyond].body != result_.faces[f].body || length(h) < extent[f] / 2) return;
        if (longest == kNone || length(h) > length(longest)) longest = h;
      });
      if (longest == kNone) continue;
      is_left_out[longest / 2] = 1;
      result_.faces[f].triangle = result_.faces[result_.face_of_half_edge[longest ^ 1]].triangle;
    }
    if (std::find(is_left_out.begin(), is_left_out.end(), 1) == is_left_out.end()) return false;
    for (int h = 0; h < 2 * edge_count(); ++h) {
      const int face = result_.face_of_half_edge[h];
      triangle_of_[h] = face == kNone ? kUnknown : result_.faces[face].triangle;
    }
    keep_edges([&](int e) { return !is_left_out[e]; });
    return true;
  }

  /// Returns the extent of a face of a body if it has no thickness.
  std::optional<double> flat_extent(const CoverFace& face) const {
    if (face.body == kNone || face.triangle < 0) return std::nullopt;
    const std::vector<Node>& nodes = result_.arrangement.nodes;
    const Point origin = nodes[face.face.outer.front().node].position;
    double twice_area = 0;
    Box box;
    visit_links(face.face, [&](const ChainLink& link) {
      const Edge& e = result_.arrangement.edges[link.half_edge / 2];
      const Point to = nodes[link.node].position;
      const Point from = nodes[e.from == link.node ? e.to : e.from].position;
      twice_area += cross(from - origin, to - origin);
      box.add(to);
    });
    const double extent = keyblock::length(box.size());
    if (std::fabs(twice_area) > round_off_ * extent) return std::nullopt;
    return extent;
  }

  void keep_bodies() {
    std::vector<int> order;
    for (std::size_t f = 0; f < result_.faces.size(); ++f) {
      if (result_.faces[f].body == kNone || result_.faces[f].face.outer.empty()) continue;
      if (result_.faces[f].triangle < 0) throw std::invalid_argument("expected a mesh that covers all bodies");
      order.push_back(static_cast<int>(f));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return result_.faces[a].triangle < result_.faces[b].triangle; });
    std::vector<int> number(result_.faces.size(), kNone);
    std::vector<CoverFace> kept;
    kept.reserve(order.size());
    for (const int f : order) {
      number[f] = static_cast<int>(kept.size());
      kept.push_back(std::move(result_.faces[f]));
    }
    result_.faces = std::move(kept);
    for (int& face : result_.face_of_half_edge) {
      if (face != kNone) face = number[face];
    }
  }

  const BodyGraph& graph_;
  CoverFaces result_;
  std::vector<int> triangle_of_;  // per half-edge, from the iteration before
  double round_off_ = 0;
};

}  // namespace

CoverFaces cover_faces(const BodyGraph& graph, const TriangleMesh& mesh) {
  return Labelling(graph, mesh).run();
}

}  // namespace keyblock
