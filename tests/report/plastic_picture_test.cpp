// Pictures of elastoplastic rock: names, colours about zero, present states, reactions and their plateaus.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/rock/plastic_picture.hpp"

#include <gtest/gtest.h>

#include "report/drawing/field_patches.hpp"
#include "report/reaction_picture.hpp"

namespace keyblock::report::plastic_picture_test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

FieldElement square(double left, const Stress& stress, const PlasticState& plastic) {
  FieldElement element;
  std::vector<FieldCorner>& loop = element.loops.emplace_back();
  for (const Point at : {Point{left, 0}, Point{left + 1, 0}, Point{left + 1, 1}, Point{left, 1}})
    loop.push_back({at, {}, stress, plastic});
  element.middle = {{left + 0.5, 0.5}, {}, stress, plastic};
  return element;
}

FieldFrame pressed() {
  FieldFrame field{1, 1, {}, PlasticTotals{}};
  field.elements = {square(0, {-3, -3, 0, -3}, {0.01, -0.01, 0, 0, 0.02, YieldRegion::edge, true}),
                    square(1, {-6, 0, 0, 0}, {0.01, -0.01, 0, 0, 0.01, YieldRegion::elastic, true}),
                    square(2, {0, 0, 0, 0}, {})};
  return field;
}

}  // namespace

TEST(PlasticPicture, it_names_what_is_shown_and_the_states_that_are_there) {
  const std::string svg = plastic_picture({"a title", pressed(), {}});
  for (const char* label : {"a title", "equivalent plastic strain", "κ [–]", "mean stress, tension positive",
                            "σm [F/L²]", "edge", "yielded before", "has not yielded", ">0.02<", ">-3<"})
    EXPECT_TRUE(contains(svg, label)) << label;
  for (const char* label : {"apex", "smooth part"}) EXPECT_FALSE(contains(svg, label)) << label;
}

TEST(PlasticPicture, signed_values_are_white_at_zero_and_as_strong_on_either_side) {
  const auto scale = [](std::vector<double> values) {
    std::vector<Patch> patches;
    for (const double value : values) patches.push_back({{}, value});
    return scale_of(patches, ColourScale::Map::about_zero);
  };
  const std::string white = scale({-1, 1}).colour(0);
  const ColourScale below = scale({-4, -1});
  EXPECT_EQ(below.low, -4);
  EXPECT_EQ(below.high, 0);
  EXPECT_EQ(below.colour(0), white);
  EXPECT_EQ(below.colour(-4), scale({-4, 4}).colour(-4));
  const ColourScale uneven = scale({-1, 4});
  EXPECT_EQ(uneven.colour(0), white);
  EXPECT_EQ(uneven.low, -1);
  EXPECT_EQ(uneven.colour(4), scale({-4, 4}).colour(4));
}

TEST(ReactionPicture, it_says_which_reaction_stands_and_since_when) {
  ReactionCurve curve{1, 'y', {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}, {0, -5, -7, -7, -7}};
  curve.steps.push_back(5);
  curve.driven.push_back(5);
  curve.reaction.push_back(-7);
  const std::string svg = reaction_picture("a title", {curve});
  for (const char* label : {"a title", "displacement 2, reaction y", "displacement [L]",
                            "displacement 2: the reaction stays at 7 since step 2"})
    EXPECT_TRUE(contains(svg, label)) << label;
}

}  // namespace keyblock::report::plastic_picture_test
