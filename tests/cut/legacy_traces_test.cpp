// Cutting the drawings of the reference runs gives the blocks that the Berkeley program printed, in its order.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "formats/case.hpp"
#include "formats/text/csv.hpp"
#include "tests/cut/drawings.hpp"
#include "tests/support/shared_folder.hpp"

namespace keyblock::legacy_traces_test {
namespace {

namespace fs = std::filesystem;

Drawing read_drawing(const fs::path& path) {
  return std::get<Drawing>(formats::load_case({path.string()}).problem.geometry);
}

std::string print(const BlockLoop& loop) {
  std::string text;
  for (const BlockVertex& v : loop)
    text += fmt::format("{}{:.9g} {:.9g}", text.empty() ? "" : " ", v.position.x, v.position.y);
  return text;
}

// cut_blocks.csv: block, material, area (12 digits), vertices, polygon (nine digits).
void expect_trace(const fs::path& drawing, const fs::path& trace) {
  SCOPED_TRACE(trace.string());
  const Blocks blocks = cut_blocks(read_drawing(drawing)).blocks;
  const formats::CsvTable table = formats::read_csv(formats::load(trace.string()));
  const auto cell = [&](std::size_t row, const char* name) {
    return table.rows[row].cells[formats::csv_column(table, name)];
  };
  ASSERT_EQ(blocks.blocks.size(), table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const BlockPolygon& block = blocks.blocks[i];
    EXPECT_EQ(std::to_string(block.material + 1), cell(i, "material"));
    EXPECT_EQ(std::to_string(block.outer.size()), cell(i, "vertices"));
    EXPECT_EQ(print(block.outer), cell(i, "polygon"));
    const double printed = formats::csv_real(table, table.rows[i], formats::csv_column(table, "area"));
    EXPECT_NEAR(area(block), printed, 1e-11 * printed);
  }
}

}  // namespace

TEST(LegacyTraces, every_reference_run_is_cut_as_the_old_program_cut_it) {
  int count = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(KEYBLOCK_SOURCE_DIR) / "legacy_cases" / "reference_traces")) {
    if (!entry.is_directory()) continue;
    expect_trace(entry.path() / (entry.path().filename().string() + ".geo"), entry.path() / "cut_blocks.csv");
    ++count;
  }
  EXPECT_EQ(count, 16);
}

TEST(LegacyTraces, circle_slope_is_cut_into_seven_blocks_of_area_2_2) {
  const fs::path shared = shared_folder();
  if (!fs::exists(shared / "legacy_samples")) GTEST_SKIP() << "the sample has no licence and lies only in ../shared";
  const fs::path drawing = shared / "legacy_samples/ntdda/circleslope.geo";
  expect_trace(drawing, shared / "reference_runs/example_circleslope_cut_blocks.csv");
  EXPECT_NEAR(total_area(cut_blocks(read_drawing(drawing)).blocks), 2.2, 1e-14);
}

TEST(LegacyTraces, fixed_lines_give_as_many_points_as_in_the_old_program) {
  const fs::path shared = shared_folder();
  if (!fs::exists(shared / "legacy_samples")) GTEST_SKIP() << "the samples have no licence and lie only in ../shared";
  const std::vector<std::size_t> counts = {2, 1, 1, 1, 2, 4, 2, 1};  // reference_runs/README.md, fixedlines 1..8
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const fs::path path = shared / fmt::format("legacy_samples/ntdda/fixedlines/case{}.geo", i + 1);
    EXPECT_EQ(cut_blocks(read_drawing(path)).blocks.fixed_points.size(), counts[i]) << path;
  }
}

TEST(LegacyTraces, malformed_drawings_are_refused_or_warned_of_by_name) {
  const fs::path folder = fs::path(KEYBLOCK_SOURCE_DIR) / "tests" / "malformed";
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

}  // namespace keyblock::legacy_traces_test
