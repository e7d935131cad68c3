// A picture of a run has start, end and curves, and leaves out what there is none of.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <pugixml.hpp>

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

}  // namespace keyblock::report::run_picture_test
