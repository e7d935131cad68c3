// Compares vertices, edges and faces of cutting with those of GEOS on random, two-joint-set and lattice drawings, and
// reports each difference.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "tests/validate/exact_arrangement.hpp"
#include "tests/validate/random_drawings.hpp"

namespace keyblock {
namespace {

struct Counts {
  int vertices = 0;
  int edges = 0;
  int faces = 0;

  bool operator==(const Counts&) const = default;
};

GEOSGeometry* line_work(const Drawing& drawing) {
  std::vector<GEOSGeometry*> lines;
  for (const JointLine& line : drawing.joints) {
    GEOSCoordSequence* points = GEOSCoordSeq_create(2, 2);
    GEOSCoordSeq_setXY(points, 0, line.segment.start.x, line.segment.start.y);
    GEOSCoordSeq_setXY(points, 1, line.segment.end.x, line.segment.end.y);
    lines.push_back(GEOSGeom_createLineString(points));
  }
  return GEOSGeom_createCollection(GEOS_MULTILINESTRING, lines.data(), static_cast<unsigned>(lines.size()));
}

/// Vertices and edges on the rings of all polygons, each once. GEOS joins nothing: every node of the noded lines stays.
Counts counts_of_polygons(const GEOSGeometry* polygons) {
  using Vertex = std::pair<double, double>;
  std::vector<Vertex> vertices;
  std::vector<std::pair<Vertex, Vertex>> edges;
  const auto add_ring = [&](const GEOSGeometry* ring) {
    const GEOSCoordSequence* points = GEOSGeom_getCoordSeq(ring);
    unsigned size = 0;
    GEOSCoordSeq_getSize(points, &size);
    for (unsigned i = 0; i + 1 < size; ++i) {
      Vertex a;
      Vertex b;
      GEOSCoordSeq_getXY(points, i, &a.first, &a.second);
      GEOSCoordSeq_getXY(points, i + 1, &b.first, &b.second);
      vertices.push_back(a);
      edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  };
  Counts counts;
  counts.faces = GEOSGetNumGeometries(polygons);
  for (int i = 0; i < counts.faces; ++i) {
    const GEOSGeometry* polygon = GEOSGetGeometryN(polygons, i);
    add_ring(GEOSGetExteriorRing(polygon));
    for (int k = 0; k < GEOSGetNumInteriorRings(polygon); ++k) add_ring(GEOSGetInteriorRingN(polygon, k));
  }
  const auto count_distinct = [](auto& list) {
    std::sort(list.begin(), list.end());
    return static_cast<int>(std::unique(list.begin(), list.end()) - list.begin());
  };
  counts.vertices = count_distinct(vertices);
  counts.edges = count_distinct(edges);
  return counts;
}

/// GEOS nodes in floating point: where it cannot, it snaps within its own tolerance.
Counts counts_by_geos(const Drawing& drawing) {
  GEOSGeometry* lines = line_work(drawing);
  GEOSGeometry* noded = GEOSUnaryUnion(lines);
  GEOSGeometry* polygons = GEOSPolygonize(&noded, 1);
  const Counts counts = counts_of_polygons(polygons);
  GEOSGeom_destroy(polygons);
  GEOSGeom_destroy(noded);
  GEOSGeom_destroy(lines);
  return counts;
}

/// Vertices and edges before pruning; faces are left out.
Counts counts_exactly(const Drawing& drawing) {
  const ExactCounts counts = count_exactly(drawing);
  return {counts.vertices, counts.edges, 0};
}

struct Comparison {
  std::string name;
  Drawing drawing;
  bool is_lattice = false;
};

bool print_row(const std::string& name, const Counts& ours, const Counts& theirs) {
  fmt::print("{:<28} {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8}   {}\n", name, ours.vertices, ours.edges, ours.faces,
             theirs.vertices, theirs.edges, theirs.faces, ours == theirs ? "equal" : "different");
  return ours == theirs;
}

/// Returns true if cutting passes the test.
bool compare(const Comparison& c) {
  const CutReport report = cut_blocks(c.drawing).report;
  const bool is_as_geos =
      print_row(c.name, {report.pruned_nodes, report.pruned_edges, report.faces}, counts_by_geos(c.drawing));
  if (!c.is_lattice) return is_as_geos;
  return print_row("  exactly, before pruning", {report.nodes, report.edges, 0}, counts_exactly(c.drawing));
}

std::vector<Comparison> comparisons() {
  std::vector<Comparison> all;
  for (const int n : {100, 1000, 10000}) {
    all.push_back({fmt::format("random {}", n), random_lines(n, 4 / std::sqrt(n), 1), false});
    all.push_back({fmt::format("lattice {}", n), lattice_lines(n, static_cast<int>(std::sqrt(n)), 4, 3), true});
  }
  all.push_back({"lattice, dense 2000", lattice_lines(2000, 16, 6, 5), true});
  all.push_back({"two joint sets 1000", two_joint_sets(1000, 0.2, 2), false});
  all.push_back({"two joint sets 3000", two_joint_sets(3000, 0.2, 2), false});
  return all;
}

}  // namespace
}  // namespace keyblock

int main() {
  using namespace keyblock;
  initGEOS(nullptr, nullptr);
  fmt::print("{:<28} {:>26}   {:>26}\n{:<28} {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8}\n", "", "keyblock",
             "GEOS or exact count", "drawing", "vertices", "edges", "faces", "vertices", "edges", "faces");
  int different = 0;
  for (const Comparison& c : comparisons()) different += compare(c) ? 0 : 1;
  finishGEOS();
  fmt::print("{} of {} drawings are cut wrongly\n", different, comparisons().size());
  return different == 0 ? 0 : 1;
}
