// Covers of Shi's manifold cutter, cut again from their contact loops: the same pieces on the same covers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/absorb.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "cut/mesh/snap_nodes.hpp"
#include "formats/case.hpp"
#include "tests/cut/manifolds.hpp"
#include "tests/support/shared_folder.hpp"

namespace keyblock::legacy_covers_test {
namespace {

namespace fs = std::filesystem;

/// A file and its n (legacy-formats 2.4; in cv15 the nodes of a row are placed as if n were 9). Shi's cutter moved some
/// nodes onto a line nearer than `snap` w, and gave some pieces the covers of a neighbour. The files show these nodes
/// and pieces; the rules are fits to them.
struct Sample {
  const char* name;
  int half_rows;
  double snap;
  int snapped;
  int absorbed;
};

const std::vector<Sample> kSamples = {
    {"cv01", 3, 0.0015, 0, 0}, {"cv02", 3, 0.0015, 0, 0},  {"cv03", 2, 0.005, 1, 5},  {"cv04", 3, 0.0015, 0, 5},
    {"cv06", 3, 0.0015, 0, 8}, {"cv07", 4, 0.0015, 1, 1},  {"cv09", 5, 0.0015, 0, 2}, {"cv10", 5, 0.0015, 9, 12},
    {"cv12", 4, 0.0015, 1, 7}, {"cv13", 5, 0.0015, 0, 24}, {"cv14", 7, 0.0015, 0, 1}, {"cv15", 8, 0.0015, 0, 0}};

fs::path sample_path(const std::string& name) {
  return shared_folder() / "legacy_samples" / "pythonwithnmm" / name;
}

Cover read_cover(const std::string& name) {
  return std::get<Cover>(formats::load_case({sample_path(name).string()}).problem.geometry);
}

struct LoopEdge {
  Segment segment;
  int material = 0;
  int walks = 0;  ///< 2: joint, with a body on both sides
};

std::vector<LoopEdge> loop_edges(const Cover& cover) {
  std::map<std::array<double, 4>, LoopEdge> edges;
  for (const SlotRange& loop : cover.loops) {
    const std::vector<Point> p = cover.corners(loop);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Point a = p[i];
      const Point b = p[i + 1 == p.size() ? 0 : i + 1];
      if (a == b) continue;
      const bool is_forward = std::pair(a.x, a.y) < std::pair(b.x, b.y);
      const Segment s = is_forward ? Segment{a, b} : Segment{b, a};
      LoopEdge& edge = edges[{s.start.x, s.start.y, s.end.x, s.end.y}];
      edge.segment = s;
      edge.material = cover.loop_vertices[static_cast<std::size_t>(loop.first) + i].joint_material;
      ++edge.walks;
    }
  }
  std::vector<LoopEdge> list;
  for (const auto& [key, edge] : edges) list.push_back(edge);
  return list;
}

Box box_of(const Cover& cover) {
  Box box;
  for (const LoopEdge& edge : loop_edges(cover)) {
    box.add(edge.segment.start);
    box.add(edge.segment.end);
  }
  return box;
}

/// Returns the loops as lines. Six decimals leave joints short of the lines that they end on: they are lengthened by
/// 2e-5, and points nearer than 3e-5 are merged.
Drawing drawing_of_loops(const Cover& cover) {
  constexpr double kLengthening = 2e-5;
  constexpr double kMerging = 3e-5;
  Drawing drawing;
  for (const LoopEdge& edge : loop_edges(cover)) {
    Segment s = edge.segment;
    if (edge.walks > 1) {
      const Point reach = (kLengthening / distance(s.start, s.end)) * (s.end - s.start);
      s = {s.start - reach, s.end + reach};
    }
    drawing.joints.push_back({s, edge.material, {"loops", static_cast<int>(drawing.joints.size()) + 1, 0}});
  }
  const Point size = box_of(cover).size();
  drawing.edge_node_ratio = kMerging / 1.25 / (1.02 * std::max(size.y / 2, size.x / 2 / 1.3));
  return drawing;
}

/// Closed lines with no element of the sample inside are voids.
void leave_out_voids(const Cover& cover, const Blocks& blocks, BodyGraph& graph) {
  const auto is_void = [&](int body) {
    if (body < 0) return true;
    const std::vector<Point> outer = points_of(blocks.blocks[static_cast<std::size_t>(body)].outer);
    return std::none_of(cover.elements.begin(), cover.elements.end(), [&](const CoverElement& element) {
      return side(outer, centroid(cover.polygon(element))) == Side::inside;
    });
  };
  std::vector<char> voids;
  for (std::size_t body = 0; body < graph.materials.size(); ++body) voids.push_back(is_void(static_cast<int>(body)));
  for (BodyPiece& piece : graph.pieces) {
    if (piece.left >= 0 && voids[static_cast<std::size_t>(piece.left)]) piece.left = -1;
    if (piece.right >= 0 && voids[static_cast<std::size_t>(piece.right)]) piece.right = -1;
  }
}

RegularMesh mesh_of(const std::string& name, const Cover& cover, int half_rows) {
  const Box box = box_of(cover);
  RegularMesh mesh = centred_mesh(box, half_rows, MeshShape::old);
  if (name == "cv15") mesh.dx *= 8.0 / 9;  // dx/dy = 52/45
  return mesh;
}

struct Recut {
  Cover sample;
  RegularMesh mesh;
  Manifold manifold;
  int snapped = 0;
  int absorbed = 0;
};

Recut recut(const Sample& sample) {
  Recut result;
  result.sample = read_cover(sample.name);
  BodyCut bodies = cut_bodies(drawing_of_loops(result.sample));
  leave_out_voids(result.sample, bodies.blocks.blocks, bodies.graph);
  result.mesh = mesh_of(sample.name, result.sample, sample.half_rows);
  const Box box = box_of(result.sample);
  TriangleMesh mesh = regular_triangles(box, result.mesh);
  result.snapped = snap_nodes(mesh, bodies.graph, sample.snap * mesh_scale(box));
  result.manifold = cut_cover(bodies.graph, std::move(mesh));
  expect_sound(result.manifold);
  result.absorbed = absorb_small_pieces(result.manifold);
  return result;
}

/// The element of the new cut with the same area and centroid, or -1. Six decimals, over the thinnest triangles.
int same_element(const Recut& recut, const CoverElement& element) {
  const auto polygon = recut.sample.polygon(element);
  const double triangle = recut.mesh.dx * recut.mesh.dy / 2;
  for (std::size_t e = 0; e < recut.manifold.elements.size(); ++e) {
    const ManifoldElement& own = recut.manifold.elements[e];
    const std::vector<std::vector<Point>> loops = recut.manifold.polygon(own);
    if (distance(centroid(loops[0]), centroid(polygon)) > 1e-2 * recut.mesh.dy) continue;
    if (std::fabs(area(recut.manifold, own) - area(polygon)) < 3e-4 * triangle) return static_cast<int>(e);
  }
  return -1;
}

bool has_same_nodes(const Recut& recut, const ManifoldElement& own, const CoverElement& element) {
  const std::array<Point, 3> triangle = recut.manifold.triangle(own);
  return std::all_of(triangle.begin(), triangle.end(), [&](Point p) {
    return std::any_of(element.covers.begin(), element.covers.end(), [&](int cover) {
      return distance(p, recut.sample.nodes[static_cast<std::size_t>(cover)]) < 1e-5;
    });
  });
}

/// Elements share a cover in the new cut exactly if they do in the sample: equal up to the numbering.
bool has_same_covers(const Recut& recut) {
  std::map<int, int> name;  // in the sample, of a cover of the new cut
  for (const CoverElement& element : recut.sample.elements) {
    const ManifoldElement& own = recut.manifold.elements[static_cast<std::size_t>(same_element(recut, element))];
    const std::array<Point, 3> triangle = recut.manifold.triangle(own);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto theirs = std::find_if(element.covers.begin(), element.covers.end(), [&](int cover) {
        return distance(triangle[k], recut.sample.nodes[static_cast<std::size_t>(cover)]) < 1e-5;
      });
      if (theirs == element.covers.end()) return false;
      if (name.try_emplace(own.covers[k], *theirs).first->second != *theirs) return false;
    }
  }
  return name.size() == recut.sample.nodes.size();
}

class LegacyCovers : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(sample_path("cv01"))) GTEST_SKIP() << "the samples have no licence and lie only in ../shared";
  }
};

}  // namespace

TEST_F(LegacyCovers, all_twelve_are_recut_piece_by_piece_and_cover_by_cover) {
  for (const Sample& sample : kSamples) {
    SCOPED_TRACE(sample.name);
    const Recut r = recut(sample);
    EXPECT_EQ(r.manifold.elements.size(), r.sample.elements.size());
    EXPECT_EQ(r.manifold.covers.size(), r.sample.nodes.size());
    EXPECT_EQ(r.manifold.boundary_loops.size(), r.sample.loops.size());
    EXPECT_EQ(r.snapped, sample.snapped);
    EXPECT_EQ(r.absorbed, sample.absorbed);
    int missing = 0;
    int elsewhere = 0;
    for (const CoverElement& element : r.sample.elements) {
      const int own = same_element(r, element);
      if (own < 0) {
        ++missing;
      } else if (!has_same_nodes(r, r.manifold.elements[static_cast<std::size_t>(own)], element)) {
        ++elsewhere;
      }
    }
    EXPECT_EQ(missing, 0);
    EXPECT_EQ(elsewhere, 0) << "elements on other nodes than in the sample";
    EXPECT_TRUE(missing == 0 && has_same_covers(r));
  }
}

// Without moving nodes the four come near, no more: this is the benefit of the rule.
TEST_F(LegacyCovers, the_four_with_moved_nodes_differ_by_up_to_7_percent_without_moving_them) {
  for (Sample sample : kSamples) {
    if (sample.snapped == 0) continue;
    SCOPED_TRACE(sample.name);
    sample.snap = 0;
    const Recut r = recut(sample);
    EXPECT_GT(r.manifold.elements.size(), r.sample.elements.size());
    EXPECT_LE(r.manifold.elements.size(), 1.07 * static_cast<double>(r.sample.elements.size()));
    EXPECT_LE(r.manifold.covers.size(), 1.07 * static_cast<double>(r.sample.nodes.size()));
  }
}

}  // namespace keyblock::legacy_covers_test
