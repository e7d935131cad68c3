// Tables have the agreed columns and numbers that read back the same; reading gives each fault its place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/csv.hpp"

#include <gtest/gtest.h>

#include <array>

namespace keyblock::formats::csv_test {
namespace {

std::string complaint(const std::string& text) {
  try {
    const CsvTable table = read_csv({"a.csv", text});
    csv_real(table, table.rows.at(0), csv_column(table, "value"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

Frame two_blocks() {
  Frame frame;
  frame.step = 5;
  frame.time = 0.1;
  frame.elements.resize(2);
  frame.elements[1] = {.loops = {},
                       .material = 2,
                       .centroid = {1.0 / 3.0, -2},
                       .displacement = {0.5, 0.25},
                       .rotation = 1e-9,
                       .velocity = {},
                       .stress = {1, 2, 3, 5},
                       .area = 4};
  return frame;
}

}  // namespace

TEST(Csv, steps_table_has_the_columns_of_the_reference_traces) {
  const std::array<StepReport, 1> steps{{{.step = 1,
                                          .time = 0.001,
                                          .dt = 0.001,
                                          .passes = 2,
                                          .redos = 0,
                                          .contacts = 3,
                                          .closed = 1,
                                          .matrix_blocks = 4,
                                          .penalty = 5e9,
                                          .displacement_ratio = 0.5,
                                          .greatest_penetration = 1e-6,
                                          .residual = 0,
                                          .residual_at = {}}}};
  EXPECT_EQ(steps_csv(steps),
            "step,time,dt,oci,contacts,closed,k_blocks,penalty,disp_ratio,max_penetration\n"
            "1,0.001,0.001,2,3,1,4,5e+09,0.5,1e-06\n");
}

TEST(Csv, blocks_table_counts_blocks_and_materials_from_one) {
  const std::array<Frame, 1> frames{two_blocks()};
  EXPECT_EQ(blocks_csv(frames),
            "step,time,block,material,cx,cy,rot,dx,dy,sxx,syy,sxy,area,szz\n"
            "5,0.1,1,1,0,0,0,0,0,0,0,0,0,0\n"
            "5,0.1,2,3,0.3333333333333333,-2,1e-09,0.5,0.25,1,2,3,4,5\n");
}

TEST(Csv, written_numbers_read_back_the_same) {
  const std::array<Frame, 1> frames{two_blocks()};
  const CsvTable table = read_csv({"blocks.csv", blocks_csv(frames)});
  EXPECT_EQ(csv_real(table, table.rows.at(1), csv_column(table, "cx")), 1.0 / 3.0);
}

TEST(Csv, history_names_dimensions_and_every_point) {
  History history;
  history.rows.push_back({1, 0.5, {{{1, 2}, {3, 4}, 0, {}}, {{5, 6}, {7, 8}, 1, {}}}, {}});
  EXPECT_EQ(history_csv(history),
            "step,time [T],x1 [L],y1 [L],dx1 [L],dy1 [L],x2 [L],y2 [L],dx2 [L],dy2 [L]\n"
            "1,0.5,1,2,3,4,5,6,7,8\n");
}

TEST(Csv, history_ends_with_the_forces_of_bolts) {
  History history;
  history.rows.push_back({1, 0.5, {{{1, 2}, {3, 4}, 0, {}}}, {-50, 100.5}});
  EXPECT_EQ(history_csv(history),
            "step,time [T],x1 [L],y1 [L],dx1 [L],dy1 [L],bolt1 [F],bolt2 [F]\n"
            "1,0.5,1,2,3,4,-50,100.5\n");
}

// A table of 300 blocks would have 1,202 columns.
TEST(Csv, history_of_chosen_points_keeps_their_numbers) {
  History history;
  history.rows.push_back({1, 0.5, {{{1, 2}, {3, 4}, 0, {}}, {{5, 6}, {7, 8}, 1, {}}, {{9, 10}, {11, 12}, 2, {}}}, {}});
  EXPECT_EQ(history_csv(history, {}, {2}), "step,time [T],x3 [L],y3 [L],dx3 [L],dy3 [L]\n1,0.5,9,10,11,12\n");
}

TEST(Csv, history_without_rows_is_a_header_alone) {
  EXPECT_EQ(history_csv({}), "step,time [T]\n");
}

TEST(Csv, quoted_cells_may_hold_commas_quotes_and_line_breaks) {
  const CsvTable table = read_csv({"a.csv", "a,b\n\"x, \"\"y\"\"\",\"two\nlines\"\n1,2\n"});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].cells, (std::vector<std::string>{"x, \"y\"", "two\nlines"}));
  EXPECT_EQ(table.rows[1].line, 4);
}

TEST(Csv, mark_carriage_returns_empty_lines_and_a_missing_last_line_end_are_passed_over) {
  const CsvTable table = read_csv({"a.csv",
                                   "\xEF\xBB\xBF"
                                   "a,b\r\n\r\n1,\r\n,4"});
  EXPECT_EQ(table.header, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].cells, (std::vector<std::string>{"1", ""}));
  EXPECT_EQ(table.rows[1].cells, (std::vector<std::string>{"", "4"}));
  EXPECT_EQ(table.rows[1].line, 4);
}

TEST(Csv, a_lone_carriage_return_ends_a_line) {
  const CsvTable table = read_csv({"a.csv", "a,b\r1,2\r\"x\ry\",4\r5,6"});
  EXPECT_EQ(table.header, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].cells, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(table.rows[1].cells, (std::vector<std::string>{"x\ry", "4"}));
  EXPECT_EQ(table.rows[2].line, 5);
}

TEST(Csv, a_message_shows_forty_characters_of_what_was_found) {
  const std::string message = complaint(std::string(100, 'x') + "\n1\n");
  EXPECT_EQ(message, "a.csv:1:1: error: expected a column \"value\", found \"" + std::string(40, 'x') + "…\"");
}

TEST(Csv, faults_are_named_with_line_and_column) {
  EXPECT_EQ(complaint(""), "a.csv: error: expected a header line, found nothing");
  EXPECT_EQ(complaint("value,b\n1,2\n3\n"), "a.csv:3:2: error: expected 2 cells as in the header, found 1");
  EXPECT_EQ(complaint("value,b\n1,2\n3,4,5,6\n"), "a.csv:3:5: error: expected 2 cells as in the header, found 4");
  EXPECT_EQ(complaint("value\n\"1\n"), "a.csv:2:1: error: expected a closing quote, found the end of the file");
  EXPECT_EQ(complaint("value\n\"1\"2\n"),
            "a.csv:2:4: error: expected a comma or the end of the line after a closing quote");
  EXPECT_EQ(complaint("a,b\n1,2\n"), "a.csv:1:1: error: expected a column \"value\", found \"a,b\"");
  EXPECT_EQ(complaint("value\nabc\n"), "a.csv:2:1: error: expected a number in column \"value\", found \"abc\"");
}

}  // namespace keyblock::formats::csv_test
