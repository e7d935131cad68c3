// The picture of a field names its contents: elements, scale of the displacement, component of the stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/field_picture.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "report/drawing/field_patches.hpp"
#include "report/field_panels.hpp"

namespace keyblock::report::field_picture_test {
namespace {

/// A unit square whose upper edge moves right by 0.01, stress yy from -4 at the bottom to 1 on top.
FieldFrame sheared() {
  const FieldCorner low{{0, 0}, {0, 0}, {0, -4, 0}}, low_right{{1, 0}, {0, 0}, {0, -4, 0}};
  const FieldCorner high_right{{1, 1}, {0.01, 0}, {0, 1, 0}}, high{{0, 1}, {0.01, 0}, {0, 1, 0}};
  FieldFrame field{1, 1, {}};
  field.elements.push_back({0, 0, {{low, low_right, high_right, high}}, {{0.5, 0.5}, {0.005, 0}, {0, -1.5, 0}}});
  return field;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(FieldPicture, it_names_elements_scale_and_stress) {
  const FieldFrame field = sheared();
  EXPECT_EQ(most_varied(field), FieldShown::yy);
  const std::string svg = field_picture({"a title", field, field, {}, FieldShown::yy});
  EXPECT_TRUE(contains(svg, "a title"));
  EXPECT_TRUE(contains(svg, "1 block"));
  EXPECT_TRUE(contains(svg, "displacement × 10"));  // 0.08 of the extent √2, rounded down to 1, 2 or 5
  EXPECT_TRUE(contains(svg, "σyy"));
  EXPECT_TRUE(contains(svg, ">-3.17<"));  // mean of two corners of -4 and the middle; white is zero stress
  EXPECT_TRUE(contains(svg, ">0.167<"));  // of the upper corners and the middle: no larger tension is on the bar
}

TEST(FieldPicture, without_a_start_it_shows_the_mesh_of_the_end) {
  const FieldFrame field = sheared();
  EXPECT_EQ(field_picture({"t", {}, field, {}, FieldShown::yy}),
            field_picture({"t", field, field, {}, FieldShown::yy}));
}

// All compressive, but of a wide range: white is zero stress, blue the largest pressure, and nothing on the bar is red.
// Far from 0 the colours are of the range itself, pale to strong.
TEST(FieldPicture, a_stress_of_one_sign_has_one_side_of_the_colours) {
  const auto scale = [](std::vector<double> values) {
    std::vector<Patch> patches;
    for (const double value : values) patches.push_back({{{{0, 0}, {1, 0}, {0, 1}}}, value});
    return scale_of(patches);
  };
  const std::string white = "#f7f7f7", blue = "#2166ac", red = "#b2182b";
  const ColourScale wide = scale({-8, -3, -1});
  EXPECT_EQ(wide.high, 0);
  EXPECT_EQ(wide.colour(-8), blue);
  EXPECT_EQ(wide.colour(0), white);
  const ColourScale narrow = scale({-10.1, -10, -9.9});
  EXPECT_EQ(narrow.high, -9.9) << "0 is far away, and would leave no colours to tell the values apart";
  EXPECT_EQ(narrow.colour(-10.1), blue);
  EXPECT_NE(narrow.colour(-9.9), white) << "there is stress";
  EXPECT_NE(narrow.colour(-9.9), narrow.colour(-10));
  EXPECT_EQ(scale({9.9, 10, 10.1}).colour(10.1), red);
  FieldFrame field = sheared();
  for (FieldCorner& corner : field.elements[0].loops[0]) corner.stress.yy -= 2;  // -6 to -1
  field.elements[0].middle.stress.yy = -3.5;
  const std::string svg = field_picture({"t", field, field, {}, FieldShown::yy});
  EXPECT_FALSE(contains(svg, red));
  EXPECT_FALSE(contains(svg, "#f4a582")) << "pale red";
  EXPECT_TRUE(contains(svg, ">0<")) << "the bar ends at no stress";
}

TEST(FieldPicture, elements_bear_their_numbers_at_both_places) {
  const FieldFrame field = sheared();
  FieldPicture picture{"t", field, field, {}, FieldShown::yy};
  const auto count = [](const std::string& svg, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count(field_picture(picture), ">417<"), 0U);
  picture.numbers = {417};
  EXPECT_EQ(count(field_picture(picture), ">417<"), 2U) << "as drawn and displaced";
  EXPECT_EQ(count(mesh_picture("t", field, {}, Numbers::all), ">1<"), 1U);
}

TEST(FieldPicture, a_field_at_rest_is_drawn_as_it_is) {
  FieldFrame field = sheared();
  for (auto& corner : field.elements[0].loops[0]) corner.displacement = {};
  EXPECT_TRUE(contains(field_picture({"t", field, field, {}, FieldShown::xx}), "displacement × 1<"));
  EXPECT_TRUE(contains(mesh_picture("3 elements", field), "3 elements"));
}

TEST(FieldPicture, a_motion_is_never_drawn_smaller_than_it_is) {
  FieldFrame field = sheared();
  for (auto& corner : field.elements[0].loops[0]) corner.displacement = {3, 0};
  field.elements[0].middle.displacement = {3, 0};
  FieldPicture picture{"t", field, field, {}, FieldShown::yy};
  EXPECT_TRUE(contains(field_picture(picture), "displacement × 0.02<"));
  picture.is_of_motion = true;
  EXPECT_TRUE(contains(field_picture(picture), "displacement × 1<"));
}

TEST(FieldPicture, rigid_blocks_have_no_stress) {
  FieldFrame field = sheared();
  field.elements[0].middle.stress = {};
  for (FieldCorner& corner : field.elements[0].loops[0]) corner.stress = {};
  const std::string svg = field_picture({"", field, field, {}, most_varied(field)});
  EXPECT_TRUE(contains(svg, "no stress"));
  EXPECT_FALSE(contains(svg, "tension positive"));
}

// At the corners of the lower edge σxx = σxy = 0 and σyy = -4, at the upper ones σyy = 1. There σ1 is 0 and 1, σ3 -4
// and 0, and the von Mises stress without σzz is |σyy|. A piece has the mean of its edge and the middle's -1.5.
TEST(FieldPicture, principal_stresses_von_mises_and_displacement_may_be_shown) {
  const FieldFrame field = sheared();
  const auto shown = [&](const char* word) {
    FieldPicture picture{"t", field, field, {}, field_of_word(word)};
    picture.units = {"m", "kg", "s"};
    return field_picture(picture);
  };
  EXPECT_TRUE(contains(shown("s1"), ">σ1 [Pa]<"));
  EXPECT_TRUE(contains(shown("s1"), "σ1, the greatest, tension positive"));
  EXPECT_TRUE(contains(shown("s3"), ">σ3 [Pa]<"));
  EXPECT_TRUE(contains(shown("s3"), ">-3.17<"));
  EXPECT_TRUE(contains(shown("von_mises"), ">von Mises stress [Pa]<"));
  EXPECT_TRUE(contains(shown("von_mises"), ">3.17<"));
  EXPECT_TRUE(contains(shown("displacement"), ">displacement [mm]<")) << "0.01 m";
  EXPECT_THROW(field_of_word("szz"), std::invalid_argument);
}

TEST(FieldPicture, stresses_stand_in_a_unit_that_keeps_them_short) {
  FieldFrame field = sheared();
  for (FieldCorner& corner : field.elements[0].loops[0]) corner.stress.yy *= 4e4;  // -160 to 40 kPa
  field.elements[0].middle.stress.yy *= 4e4;
  FieldPicture picture{"t", field, field, {}, FieldShown::yy};
  EXPECT_TRUE(contains(field_picture(picture), ">σyy [F/L²]  × 1e3<")) << "no units are declared";
  EXPECT_TRUE(contains(field_picture(picture), ">-127<"));
  picture.units = {"m", "kg", "s"};
  const std::string svg = field_picture(picture);
  EXPECT_TRUE(contains(svg, ">σyy [kPa]<"));
  EXPECT_TRUE(contains(svg, ">-127<"));
  picture.units = {"mm", "t", "s"};  // MPa
  EXPECT_TRUE(contains(field_picture(picture), ">σyy [GPa]<"));
}

// Stress of a fixed block is not computed: white would mean zero.
TEST(FieldPicture, held_blocks_without_stress_are_grey_and_in_the_legend) {
  FieldFrame field = sheared();
  FieldElement held = field.elements[0];
  held.body = 1;
  held.middle.stress = {};
  for (FieldCorner& corner : held.loops[0]) {
    corner.stress = {};
    corner.position.y -= 1;
  }
  held.middle.position.y -= 1;
  field.elements.push_back(held);
  FieldPicture picture{"t", field, field, {}, FieldShown::yy};
  EXPECT_FALSE(contains(field_picture(picture), "held"));
  picture.held = {1};
  const std::string once = field_picture(picture);
  EXPECT_TRUE(contains(once, ">fixed, stress not computed<"));
  picture.held = {1, 1};  // of two fixed points
  EXPECT_EQ(field_picture(picture), once);
  EXPECT_TRUE(contains(field_picture(picture), "fill=\"#b4b4b4\"/>"));
  picture.held = {0};
  EXPECT_FALSE(contains(field_picture(picture), "held")) << "its stress is known";
  picture.held = {1};
  picture.shown = FieldShown::displacement;
  EXPECT_FALSE(contains(field_picture(picture), "held")) << "its displacement is known";
  picture.shown = FieldShown::yy;
  picture.left_out = {0};
  EXPECT_TRUE(contains(field_picture(picture), ">fixed, stress not computed<")) << "the second, now the first";
}

TEST(FieldPicture, steps_of_a_run_share_colours_magnification_and_place) {
  const FieldFrame first = sheared();
  FieldFrame last = sheared();
  for (FieldCorner& corner : last.elements[0].loops[0]) {
    corner.stress.yy *= 2;
    corner.displacement = 5 * corner.displacement;
  }
  last.elements[0].middle.stress.yy *= 2;
  const EachFrame each = [&](const auto& visit) {
    visit(first);
    visit(last);
  };
  FieldPicture picture{"t", first, first, {}, FieldShown::yy};
  EXPECT_TRUE(contains(field_picture(picture), "displacement × 10<"));
  picture.scale = common_scale(first, FieldShown::yy, false, each);
  const std::string of_first = field_picture(picture);
  picture.end = last;
  const std::string of_last = field_picture(picture);
  for (const std::string& svg : {of_first, of_last}) {
    EXPECT_TRUE(contains(svg, "displacement × 2<"));  // 0.08 of √2 over 0.05, rounded down
    EXPECT_TRUE(contains(svg, ">-6.33<"));            // twice -3.17
    EXPECT_TRUE(contains(svg, ">0.333<"));
  }
  const auto size_of = [](const std::string& svg) { return svg.substr(svg.find("viewBox"), 30); };
  EXPECT_EQ(size_of(of_first), size_of(of_last));
  EXPECT_EQ(common_scale(first, FieldShown::crosses, false, each).most_stress, 3) << "twice that of the middle";
}

// Neither three panels in a third of the page, nor a field in its half.
TEST(FieldPicture, the_field_fills_the_page) {
  for (const double width : {0.5, 0.8, 1.0, 1.5, 4.0}) {
    FieldFrame field = sheared();
    for (FieldCorner& corner : field.elements[0].loops[0]) corner.position.x *= width;
    field.elements[0].middle.position.x *= width;
    const std::string svg = field_picture({"t", field, field, {}, FieldShown::yy});
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, std::regex("viewBox=\"0 0 900 ([0-9.]+)\"")));
    double right = 0;
    const std::regex corner("([0-9.]+),[0-9.]+Z");
    for (std::sregex_iterator i(svg.begin(), svg.end(), corner), end; i != end; ++i)
      right = std::max(right, std::stod((*i)[1]));
    EXPECT_GT(right, 450) << width;
    EXPECT_LT(std::stod(found[1]), 850) << width;
  }
}

// The crosses of pure shear stand at 45 degrees, as long in tension as in compression.
TEST(FieldPicture, principal_stresses_are_shown_as_crosses) {
  FieldFrame field = sheared();
  field.elements[0].middle.stress = {0, 0, 3};
  FieldPicture picture{"t", field, field, {}, field_of_word("crosses")};
  picture.units = {"m", "kg", "s"};
  const std::string svg = field_picture(picture);
  for (const char* words : {"principal stresses in the plane", ">compression<", ">tension<", ">2 Pa<"})
    EXPECT_TRUE(contains(svg, words)) << words;
  const auto line_of = [&](const std::string& colour) {
    const std::regex line("points=\"([-0-9.]+),([-0-9.]+) ([-0-9.]+),([-0-9.]+)\"[^>]*" + colour);
    std::smatch ends;
    EXPECT_TRUE(std::regex_search(svg, ends, line)) << svg;
    const auto at = [&](std::size_t i) { return std::stod(ends[i]); };
    return Point{at(3) - at(1), -(at(4) - at(2))};  // pages run down
  };
  const Point tension = line_of("#b2182b"), compression = line_of("#2166ac");
  EXPECT_NEAR(tension.x, tension.y, 0.02) << "to the right and up";
  EXPECT_NEAR(compression.x, -compression.y, 0.02);
  EXPECT_NEAR(length(tension), length(compression), 0.02);
  EXPECT_GT(length(tension), 10);
  field.elements[0].middle.stress = {};
  picture.end = field;
  EXPECT_TRUE(contains(field_picture(picture), "no stress"));
}

// σyy rises from -4 to the middle's -1.5 and on to 1 in four triangles, linearly in each: a level of -2 is met below
// the middle only, from side to side.
TEST(FieldPatches, contours_run_through_triangles_of_linear_values) {
  const FieldFrame field = sheared();
  const auto yy = [](const FieldCorner& corner) { return corner.stress.yy; };
  const auto lines = contours_of(field, yy, as_drawn, {-2.0});
  ASSERT_EQ(lines.size(), 3U);
  Box box;
  for (const ContourLine& line : lines) {
    for (const Point end : line) {
      box.include(end);
      EXPECT_NEAR(end.y, 0.4, 1e-12);  // -4 + 5 y = -2
    }
  }
  EXPECT_NEAR(box.low.x, 0, 1e-12);
  EXPECT_NEAR(box.high.x, 1, 1e-12);
  EXPECT_TRUE(contours_of(field, yy, as_drawn, {5.0}).empty());
}

// The same blocks are left out in all pictures of a run.
TEST(FieldPicture, it_leaves_out_what_it_is_told_to) {
  FieldFrame field = sheared();
  field.elements.push_back(field.elements[0]);
  field.elements[1].body = 1;
  FieldPicture picture{"t", field, field, {}, FieldShown::yy};
  picture.left_out = {1};
  EXPECT_TRUE(contains(field_picture(picture), "1 small block lies outside of the picture"));
  picture.numbers = {1, 2};
  picture.wide = kLeastForThree - 1;
  const std::string narrow = field_picture(picture);
  EXPECT_TRUE(contains(narrow, "1 small block lies outside of the picture")) << "without the panels of the mesh too";
  EXPECT_TRUE(contains(narrow, ">1 block")) << narrow;
  EXPECT_TRUE(contains(narrow, ">1</text>") || contains(narrow, "too small for its number")) << narrow;
}

}  // namespace keyblock::report::field_picture_test
