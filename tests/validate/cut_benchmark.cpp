// Prints the processor time of cutting as the drawing grows, and the exponent of the growth over lines plus crossings;
// then the same for meshes cut by a drawing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "cut/covers/cut_cover.hpp"
#include "cut/mesh/background_mesh.hpp"
#include "tests/validate/random_drawings.hpp"

namespace keyblock {
namespace {

struct Series {
  std::string name;
  std::vector<int> sizes;
  std::function<Drawing(int)> draw;
};

void measure(const Series& series) {
  fmt::print("{}\n{:>10} {:>12} {:>10} {:>10} {:>9} {:>9}\n", series.name, "lines", "crossings", "nodes", "blocks",
             "seconds", "exponent");
  double last_work = 0;
  double last_seconds = 0;
  for (const int size : series.sizes) {
    const Drawing drawing = series.draw(size);
    const std::clock_t begin = std::clock();
    const CutResult cut = cut_blocks(drawing);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const double work = static_cast<double>(size) + cut.report.crossings;
    const std::string exponent =
        last_work > 0 ? fmt::format("{:.2f}", std::log(seconds / last_seconds) / std::log(work / last_work)) : "";
    fmt::print("{:>10} {:>12} {:>10} {:>10} {:>9.3f} {:>9}\n", size, cut.report.crossings, cut.report.nodes,
               cut.blocks.blocks.size(), seconds, exponent);
    last_work = work;
    last_seconds = seconds;
  }
}

/// The unit square with two joint sets, on an equilateral mesh rotated by a tenth.
void measure_covers() {
  fmt::print("meshes cut by two joint sets in the unit square, length 0.3\n{:>10} {:>10} {:>10} {:>10} {:>9}\n",
             "joints", "triangles", "elements", "covers", "seconds");
  for (const auto& [joints, half_rows] : {std::pair{0, 100}, {20, 130}, {200, 130}, {2000, 130}, {200, 400}}) {
    Drawing drawing = two_joint_sets(joints, 0.3, 5);
    drawing.edge_node_ratio = 1e-4;
    const std::vector<Point> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t k = 0; k < 4; ++k) add_line(drawing, corners[k], corners[(k + 1) % 4]);
    const BodyCut bodies = cut_bodies(drawing);
    Box box;
    for (const Point p : bodies.graph.nodes) box.add(p);
    RegularMesh regular = centred_mesh(box, half_rows, MeshShape::equilateral);
    regular.angle = 0.1;
    const TriangleMesh mesh = regular_triangles(box, regular);
    const std::clock_t begin = std::clock();
    const Manifold manifold = cut_cover(bodies.graph, mesh);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    fmt::print("{:>10} {:>10} {:>10} {:>10} {:>9.3f}\n", joints, mesh.triangles.size(), manifold.elements.size(),
               manifold.covers.size(), seconds);
  }
}

}  // namespace
}  // namespace keyblock

int main() {
  using namespace keyblock;
  // Length times the root of the count is constant in the random series: crossings per line stay the same.
  const std::vector<Series> all = {
      {"random directions, length 4 / sqrt(count)",
       {1000, 10000, 100000},
       [](int n) { return random_lines(n, 4 / std::sqrt(n), 1); }},
      {"two dense joint sets, length 0.2", {1000, 3000, 10000}, [](int n) { return two_joint_sets(n, 0.2, 2); }},
      {"lattice, overlaps and many lines through one point",
       {1000, 10000, 100000},
       [](int n) { return lattice_lines(n, static_cast<int>(std::sqrt(n)), 4, 3); }},
      {"two joint sets with e0 = 1e-9 (merging on)",
       {1000, 3000, 10000},
       [](int n) {
         Drawing drawing = two_joint_sets(n, 0.2, 2);
         drawing.edge_node_ratio = 1e-9;
         return drawing;
       }},
  };
  for (const Series& series : all) measure(series);
  measure_covers();
  return 0;
}
