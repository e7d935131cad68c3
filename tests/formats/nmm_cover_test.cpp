// The cover file: every record in its place, written back word by word, and faults at their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/shi/nmm_cover.hpp"

#include <gtest/gtest.h>

#include "formats/case.hpp"
#include "geometry/polygon.hpp"
#include "problem/checks/check.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::formats::nmm_cover_test {
namespace {

using support::kTwoTrianglesFile;
using support::two_triangles;

std::string with(const std::string& old_text, const std::string& new_text) {
  std::string text = kTwoTrianglesFile;
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

}  // namespace

TEST(NmmCover, every_record_lands_in_its_place) {
  const Reading reading = read({"f", kTwoTrianglesFile});
  EXPECT_EQ(reading.warnings, Warnings{});
  const Cover& cover = *reading.content.cover;
  EXPECT_EQ(cover.elements, two_triangles().elements);
  EXPECT_EQ(cover.vertices, two_triangles().vertices);
  EXPECT_EQ(cover.nodes, two_triangles().nodes);
  EXPECT_EQ(cover.loops, two_triangles().loops);
  EXPECT_EQ(cover.loop_vertices, two_triangles().loop_vertices);
  EXPECT_EQ(cover.fixed_points.at(0).place, (Place{"f", 3, 1}));
  EXPECT_EQ(cover.loading_points.at(0).element, 1);
  EXPECT_EQ(cover.elements.at(0).place, (Place{"f", 7, 1})) << "an edge of it that is in no loop is named there";
  EXPECT_EQ(cover.measured_points.at(1).position, (Point{0.25, 0.75}));
}

TEST(NmmCover, writing_gives_the_words_of_the_layout) {
  EXPECT_EQ(kNmmCover.write({{}, {}, {}, two_triangles()}), kTwoTrianglesFile);
}

TEST(NmmCover, polygons_and_loops_of_the_square_have_its_area) {
  const Cover cover = two_triangles();
  for (const CoverElement& element : cover.elements) EXPECT_EQ(area(cover.polygon(element)), 0.5);
  for (const SlotRange& loop : cover.loops) EXPECT_EQ(area(cover.corners(loop)), 0.5);
}

TEST(NmmCover, counts_and_numbers_out_of_range_are_errors_at_their_place) {
  EXPECT_EQ(error_of(with("8 6 2 8", "8 6 2 1000000000")),
            "f:2:7: error: expected the number of loop-vertex slots (at most 72: so many values follow), found "
            "\"1000000000\"");
  EXPECT_EQ(
      error_of(with("0.25 0 1.000000", "0.25 0 3.000000")),
      "f:3:8: error: expected the element of fixed point 1 of 1 (a whole number from 0 to 2), found \"3.000000\"");
  EXPECT_EQ(error_of(with("5 7 1", "5 8 1")),
            "f:7:3: error: expected the last vertex slot of element 1 of 2 (a whole number from 7 to 7), found \"8\"");
  EXPECT_EQ(error_of(with("2 6 4", "2 7 4")),
            "f:24:3: error: expected a physical cover of element 2 of 2 (a whole number from 1 to 6), found \"7\"");
  EXPECT_EQ(error_of(with("7 2\n5 1", "9 2\n5 1")),
            "f:29:1: error: expected the vertex slot of loop-vertex slot 3 of 8 (a whole number from 1 to 8), found "
            "\"9\"");
}

TEST(NmmCover, an_absurd_number_of_elements_is_the_fault_that_is_named) {
  EXPECT_EQ(error_of(with("2 1 1 2\n8", "20 1 1 2\n8")),
            "f:1:1: error: expected the number of elements (at most 2: there are 8 vertex slots), found \"20\"");
  EXPECT_EQ(
      error_of(with("2 1 1 2\n8", "36200 1 1 2\n8")).rfind("f:1:1: error: expected the number of elements (at most", 0),
      0U);
}

TEST(NmmCover, file_that_breaks_off_is_an_error_where_it_ends) {
  EXPECT_EQ(error_of(kTwoTrianglesFile.substr(0, kTwoTrianglesFile.size() - 3)),
            "f:34:2: error: expected the joint material of loop-vertex slot 8 of 8, found end of file");
}

TEST(NmmCover, a_fault_among_the_positions_is_told_though_they_are_read_beside_the_other_lists) {
  EXPECT_EQ(error_of(with("\n1 1\n0 1\n0 0", "\n1 x\n0 1\n0 0")),
            "f:10:3: error: expected y of vertex slot 2 of 8, found \"x\"");
  std::string text = with("\n1 1\n0 1\n0 0", "\n1 x\n0 1\n0 0");
  text.replace(text.find("5 7 1"), 5, "5 8 1");
  EXPECT_TRUE(error_of(text).starts_with("f:7:3: error: expected the last vertex slot")) << error_of(text);
}

TEST(NmmCover, a_long_file_is_read_on_two_threads_with_the_same_faults) {
  Cover cover = two_triangles();
  cover.vertices.resize(600000, {0.5, -2.25});
  std::string text = kNmmCover.write({{}, {}, {}, cover});
  EXPECT_EQ(read({"f", text}).content.cover->vertices, cover.vertices);
  text.replace(text.rfind("-2.25"), 5, "-2.2x");
  EXPECT_EQ(error_of(text), "f:600008:5: error: expected y of vertex slot 600000 of 600000, found \"-2.2x\"");
}

TEST(NmmCover, points_in_no_element_are_left_out_and_loads_there_refused) {
  const Reading reading = read({"f", with("0.25 0 1.000000", "0.25 0 0.000000")});
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"point_outside_elements"});
  EXPECT_TRUE(reading.content.cover->fixed_points.empty());
  EXPECT_NE(error_of(with("0.5 1 2.000000", "0.5 1 0.000000")), "");
}

TEST(NmmCover, material_numbers_are_brought_into_the_range_of_the_analysis) {
  Content content = read({"f", kTwoTrianglesFile}).content;
  content.analysis = Analysis{};
  content.analysis->block_materials.resize(1);
  content.analysis->joint_materials.resize(1);
  const Checked checked = check(pair({content}));
  EXPECT_EQ(names(checked.warnings), (std::vector<std::string>{"joint_material_clamped", "block_material_clamped",
                                                               "loading_points_without_load"}));
  const Cover& cover = std::get<Cover>(checked.problem.geometry);
  EXPECT_EQ(cover.elements[1].material, 0);
  EXPECT_EQ(cover.loop_vertices[2].joint_material, 0);
}

TEST(NmmCover, elements_turned_over_are_a_fault_of_the_problem) {
  Content content;
  content.cover = two_triangles();
  std::swap(content.cover->vertices[5], content.cover->vertices[6]);
  EXPECT_EQ(check(pair({content})).errors.size(), 1u);
}

}  // namespace keyblock::formats::nmm_cover_test
