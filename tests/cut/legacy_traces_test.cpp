// Cutting the drawings of the reference runs gives the blocks that the old program printed, in its order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cut/cut_blocks.hpp"
#include "formats/case.hpp"
#include "tests/cut/drawings.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

Drawing read_drawing(const fs::path& path) {
  return std::get<Drawing>(formats::load_case({path.string()}).problem.geometry);
}

/// A row of cut_blocks.csv: block, material, area, vertices, polygon in nine digits.
struct TraceRow {
  int material;
  double area;
  std::size_t vertices;
  std::string polygon;
};

std::vector<TraceRow> read_trace(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<TraceRow> rows;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    int block = 0;
    TraceRow row{};
    words >> block >> row.material >> row.area >> row.vertices;
    const std::size_t quote = line.find('"');
    row.polygon = line.substr(quote + 1, line.rfind('"') - quote - 1);
    rows.push_back(row);
  }
  return rows;
}

std::string print(const BlockLoop& loop) {
  std::string text;
  for (const BlockVertex& v : loop)
    text += fmt::format("{}{:.9g} {:.9g}", text.empty() ? "" : " ", v.position.x, v.position.y);
  return text;
}

void expect_trace(const fs::path& drawing, const fs::path& trace) {
  SCOPED_TRACE(trace.string());
  const Blocks blocks = cut_blocks(read_drawing(drawing)).blocks;
  const std::vector<TraceRow> rows = read_trace(trace);
  ASSERT_EQ(blocks.blocks.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(blocks.blocks[i].material + 1, rows[i].material);
    EXPECT_EQ(blocks.blocks[i].outer.size(), rows[i].vertices);
    EXPECT_EQ(print(blocks.blocks[i].outer), rows[i].polygon);
    // Printed in 12 digits.
    EXPECT_NEAR(area(blocks.blocks[i]), rows[i].area, 1e-11 * rows[i].area);
  }
}

}  // namespace

TEST(LegacyTraces, every_reference_run_is_cut_as_the_old_program_cut_it) {
  const fs::path shared = shared_folder();
  if (shared.empty()) GTEST_SKIP() << "no shared folder with reference runs";
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(shared / "reference_runs")) {
    const fs::path trace = entry.path() / "cut_blocks.csv";
    if (!fs::exists(trace)) continue;
    for (const fs::directory_entry& file : fs::directory_iterator(entry.path())) {
      if (file.path().extension() == ".geo") expect_trace(file.path(), trace), ++count;
    }
  }
  EXPECT_EQ(count, 17);
}

TEST(LegacyTraces, circle_slope_is_cut_into_seven_blocks_of_area_2_2) {
  const fs::path shared = shared_folder();
  if (shared.empty()) GTEST_SKIP() << "no shared folder with reference runs";
  const fs::path drawing = shared / "legacy_samples/ntdda/circleslope.geo";
  expect_trace(drawing, shared / "reference_runs/example_circleslope_cut_blocks.csv");
  EXPECT_NEAR(total_area(cut_blocks(read_drawing(drawing)).blocks), 2.2, 1e-14);
}

TEST(LegacyTraces, fixed_lines_give_as_many_points_as_in_the_old_program) {
  const fs::path shared = shared_folder();
  if (shared.empty()) GTEST_SKIP() << "no shared folder with legacy samples";
  const std::vector<std::size_t> counts = {2, 1, 1, 1, 2, 4, 2, 1};  // reference_runs/README.md, fixedlines 1..8
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const fs::path path = shared / fmt::format("legacy_samples/ntdda/fixedlines/case{}.geo", i + 1);
    EXPECT_EQ(cut_blocks(read_drawing(path)).blocks.fixed_points.size(), counts[i]) << path;
  }
}

TEST(LegacyTraces, malformed_drawings_are_refused_or_warned_of_by_name) {
  const fs::path shared = shared_folder();
  if (shared.empty()) GTEST_SKIP() << "no shared folder with reference runs";
  const fs::path folder = shared / "reference_runs/malformed";
  const std::map<std::string, std::string> expected = {
      {"07_zero_length_joint_xml", "zero_length_line"},  {"07_zero_area_sliver_xml", "overlapping_lines"},
      {"08_open_polygon_xml", "dangling_lines_removed"}, {"09_duplicate_lines_xml", "duplicate_line"},
      {"09_partial_overlap_xml", "overlapping_lines"},   {"11_fixed_outside_xml", "point_outside_blocks"}};
  for (const auto& [name, warning] : expected) {
    const formats::Case loaded = formats::load_case({(folder / (name + ".geo")).string()});
    const CutResult cut = cut_blocks(std::get<Drawing>(loaded.problem.geometry));
    EXPECT_TRUE(has_warning(cut.warnings, warning) || has_warning(loaded.warnings, warning)) << name;
    const std::size_t blocks = name == "08_open_polygon_xml" ? 1 : 2;
    EXPECT_EQ(cut.blocks.blocks.size(), blocks) << name;
  }
  EXPECT_THROW(cut_blocks(read_drawing(folder / "08_no_closed_block_xml.geo")), InputError);
}

}  // namespace keyblock
