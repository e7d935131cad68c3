// A picture of a run has start, end and curves, and leaves out absent items.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <pugixml.hpp>
#include <regex>
#include <string>
#include <vector>

namespace keyblock::report::run_picture_test {
namespace {

Frame square_at(double x, double y, double time) {
  Frame frame;
  frame.time = time;
  frame.elements.resize(1);
  frame.elements[0].loops = {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  return frame;
}

RunPicture slide() {
  return {.title = "slide & stop",
          .start = square_at(0, 0, 0),
          .end = square_at(3, 0, 1),
          .curves = {{"theory", {0, 0.5, 1}, {0, 0.75, 3}, Curve::Style::line},
                     {"run", {0, 0.5, 1}, {0, 0.8, 2.9}, Curve::Style::points}},
          .axes = {"time [s]", "displacement [m]"},
          .time_unit = "s"};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool is_well_formed(const std::string& picture) {
  return pugi::xml_document{}.load_string(picture.c_str());
}

}  // namespace

TEST(RunPicture, start_end_and_curves_are_named) {
  const std::string picture = run_picture(slide());
  EXPECT_TRUE(is_well_formed(picture));
  for (const char* words : {"slide &amp; stop", ">start, t = 0 s<", ">end, t = 1 s<", ">theory<", ">run<", ">time [s]<",
                            ">displacement [m]<"})
    EXPECT_TRUE(has(picture, words)) << words;
}

// Corners of the square: lower left, lower right, upper right, upper left. The edge that arrives at the third is the
// right one, of joint material 2. The edge that arrives at the fourth, the upper one, has no material.
TEST(RunPicture, joints_of_two_materials_are_told_apart) {
  RunPicture picture = slide();
  picture.curves.clear();
  picture.joints = {{0, 0, 0, 0}};
  EXPECT_FALSE(has(run_picture(picture), "joint material"));
  const auto edges = [](const std::string& svg, const std::string& colour) {
    const std::regex edge("<polyline[^>]*points=\"([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+)\"[^>]*stroke=\"" + colour);
    return std::vector<std::smatch>(std::sregex_iterator(svg.begin(), svg.end(), edge), std::sregex_iterator());
  };
  const std::string plain = run_picture(picture);
  picture.joints = {{0, 0, 1, -1}};
  const std::string svg = run_picture(picture);
  EXPECT_TRUE(has(svg, ">joint material 1<"));
  EXPECT_TRUE(has(svg, ">joint material 2<"));
  EXPECT_FALSE(has(svg, "joint material 0"));
  picture.joint_names = {"", "Bedding"};
  EXPECT_TRUE(has(run_picture(picture), ">joint material 1<"));
  EXPECT_TRUE(has(run_picture(picture), ">Bedding (joint material 2)<"));
  const std::vector<std::smatch> coloured = edges(svg, "#d55e00");
  ASSERT_EQ(coloured.size(), 2U) << "the line of the legend and the edge";
  const std::smatch& edge = coloured[1];
  EXPECT_EQ(edge[1], edge[3]) << "upright";
  EXPECT_GT(std::abs(std::stod(edge[2]) - std::stod(edge[4])), 50);
  picture.joints = {{0, 0, -1, -1}};
  EXPECT_TRUE(edges(run_picture(picture), "#d55e00").empty());
}

// A missing bolt would look like one that never was; one without properties like one that carries load.
TEST(RunPicture, broken_bolts_and_bolts_without_properties_are_told_apart) {
  RunPicture picture = slide();
  picture.end.bolts = {{{3, 0.2}, {4, 0.2}, 5, false, 0, "A"},
                       {{3, 0.5}, {4, 0.5}, 0, true, 1, "B"},
                       {{3, 0.8}, {4, 0.8}, 0, false, 2, "C"}};
  picture.idle_bolts = {2};
  const std::string svg = run_picture(picture);
  for (const char* words :
       {">bolt (1)<", ">broken bolt (1)<", ">bolt without properties, carries nothing (1)<", ">A<", ">B<", ">C<"})
    EXPECT_TRUE(has(svg, words)) << words;
  EXPECT_TRUE(has(svg, "stroke=\"#777777\" stroke-width=\"2\" stroke-dasharray")) << "dots of the third";
  EXPECT_FALSE(has(svg, "stroke=\"#5e3c99\" stroke-width=\"2\" stroke-dasharray")) << "dashes are the start's";
  picture.end.bolts.resize(1);
  EXPECT_FALSE(has(run_picture(picture), "broken"));
}

// 4 micrometres of 95 drawn from edge to edge would look like a collapse.
TEST(RunPicture, what_varies_little_is_drawn_over_zero_in_a_short_unit) {
  RunPicture picture = slide();
  picture.curves = {{"block 1", {0, 0.5, 1}, {90.5e-6, 92e-6, 94.9e-6}, Curve::Style::line}};
  picture.axes = {{"time", measures::kTime, {"m", "kg", "s"}}, {"displacement", measures::kLength, {"m", "kg", "s"}}};
  const std::string svg = run_picture(picture);
  EXPECT_TRUE(has(svg, ">displacement [mm]<"));
  EXPECT_TRUE(has(svg, ">0.10<")) << "the highest tick";
  EXPECT_FALSE(has(svg, "1e-6"));
  EXPECT_FALSE(has(svg, ">90.5<"));
  picture.curves[0].y = {0.1, 2, 4};
  EXPECT_TRUE(has(run_picture(picture), ">displacement [m]<"));
}

TEST(RunPicture, only_what_moved_has_an_outline_of_its_start) {
  RunPicture picture = slide();
  EXPECT_TRUE(has(run_picture(picture), "Z\" fill=\"none\" stroke=\"#b03060\""));
  picture.end = picture.start;
  EXPECT_FALSE(has(run_picture(picture), "Z\" fill=\"none\" stroke=\"#b03060\""));
}

TEST(RunPicture, without_a_point_to_draw_there_is_no_chart) {
  RunPicture picture = slide();
  picture.curves = {{"nothing", {0}, {std::numeric_limits<double>::quiet_NaN()}, Curve::Style::line}};
  EXPECT_FALSE(has(run_picture(picture), "time [s]"));
}

TEST(RunPicture, a_run_without_blocks_is_a_page_with_its_chart) {
  RunPicture picture = slide();
  picture.start = picture.end = Frame{};
  EXPECT_TRUE(is_well_formed(run_picture(picture)));
  EXPECT_TRUE(has(run_picture(picture), "time [s]"));
}

TEST(RunPicture, a_tall_scene_has_its_chart_beside_it) {
  RunPicture picture = slide();
  picture.start = square_at(0, 60, 0);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(run_picture(picture).c_str()));
  EXPECT_LT(document.child("svg").attribute("height").as_double(), 800);
}

TEST(RunPicture, the_same_run_gives_the_same_bytes) {
  EXPECT_EQ(run_picture(slide()), run_picture(slide()));
}

// A sliver that fell out of a slope must not squeeze the slope into a corner of the page.
TEST(RunPicture, small_blocks_far_away_are_left_out_and_counted) {
  RunPicture picture = slide();
  picture.end = Frame{};
  for (int i = 0; i < 40; ++i) {
    ElementFrame block = square_at(i, 0, 1).elements[0];
    block.area = 1;
    block.centroid = {i + 0.5, 0.5};
    picture.end.elements.push_back(block);
  }
  picture.start = picture.end;
  const std::string alone = run_picture(picture);
  ElementFrame sliver;
  sliver.loops = {{{0, -20}, {0.1, -20}, {0.1, -19.9}}};
  sliver.centroid = {0.05, -20};
  sliver.area = 0.005;
  picture.end.elements.push_back(sliver);
  const auto leaves_out = [](const RunPicture& of) { return !left_out_of(of.start, of.end, of.marked).empty(); };
  EXPECT_FALSE(has(alone, "outside of the picture"));
  EXPECT_EQ(left_out_of(picture.start, picture.end, {}), std::vector<std::size_t>{40});
  picture.left_out = {40};
  EXPECT_TRUE(has(run_picture(picture), "1 small block lies outside of the picture"));
  const auto polygons = [](const std::string& text) { return std::count(text.begin(), text.end(), 'Z'); };
  EXPECT_EQ(polygons(run_picture(picture)), polygons(alone) + 1) << "the square of the legend, and no block";
  RunPicture marked = picture;
  marked.marked = {40};  // the failed block is shown at any place
  EXPECT_FALSE(leaves_out(marked));
  RunPicture measured = picture;
  measured.end.measured_points = {{{0.05, -20}, {}, 40}};
  EXPECT_FALSE(leaves_out(measured));
  RunPicture large = picture;
  large.end.elements.back().area = 3;  // of 43
  EXPECT_FALSE(leaves_out(large));
  RunPicture of_few = picture;
  of_few.end.elements.erase(of_few.end.elements.begin(), of_few.end.elements.begin() + 31);
  EXPECT_FALSE(leaves_out(of_few));
}

// The drawing has the number of a curve beside its object, and the legend explains numbers.
TEST(RunPicture, what_has_a_curve_has_its_number_in_the_drawing) {
  RunPicture picture = slide();
  EXPECT_FALSE(has(run_picture(picture), "whose curve is drawn"));
  picture.numbers = {{"17", {3.5, 0.5}}};
  picture.numbered_words = "block whose curve is drawn";
  EXPECT_TRUE(has(run_picture(picture), ">17<"));
  EXPECT_TRUE(has(run_picture(picture), ">block whose curve is drawn<"));
  picture.curves.clear();  // of a run without a step
  EXPECT_FALSE(has(run_picture(picture), "whose curve is drawn"));
}

TEST(RunPicture, several_materials_have_a_legend) {
  RunPicture picture = slide();
  EXPECT_FALSE(has(run_picture(picture), "block material"));
  picture.end.elements.push_back(square_at(5, 0, 1).elements[0]);
  picture.end.elements.back().material = 2;
  EXPECT_TRUE(has(run_picture(picture), "block material 3"));
}

}  // namespace keyblock::report::run_picture_test
