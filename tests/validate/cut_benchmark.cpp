// Prints how much processor time cutting takes as the drawing grows, and the exponent of the growth over
// lines plus crossings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "cut/cut_blocks.hpp"
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
  return 0;
}
