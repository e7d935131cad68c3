// Contents of the pictures of costs and of maps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tradeoff_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <string>

#include "report/drawing/ticks.hpp"
#include "report/sweep_picture.hpp"
#include "report/values_picture.hpp"

namespace keyblock::report::tradeoff_picture_test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(TradeoffPicture, names_profiles_and_the_front_and_tells_all_details) {
  const std::string svg = tradeoff_picture({"an arch",
                                            "against theory",
                                            {{"standard", 1, 1e-3, true, true, true, "details of standard"},
                                             {"rigid", 0.1, 1e-1, false, true, true, "details of rigid"},
                                             {"step /4", 4, 1e-2, false, false, false, "details <of> step"}},
                                            1e-9});
  for (const char* part : {"an arch", "against theory", ">standard<", ">rigid<", "<title>details of standard</title>",
                           "<title>details &lt;of&gt; step</title>", "1e-3", "</svg>"})
    EXPECT_TRUE(contains(svg, part)) << part;
  EXPECT_FALSE(contains(svg, ">step /4<"));
}

TEST(TradeoffPicture, is_a_page_with_its_titles_where_no_run_has_a_result) {
  EXPECT_TRUE(contains(tradeoff_picture({"an arch", "nothing", {}, 0}), "an arch"));
}

TEST(TradeoffPicture, log_axes_end_on_ticks_around_the_data) {
  const Axis wide = make_log_axis(3e-5, 0.2);
  EXPECT_EQ(wide.ticks.front(), -5);
  EXPECT_EQ(wide.ticks.back(), 0);
  EXPECT_EQ(wide.labels.front(), "1e-5");
  const Axis narrow = make_log_axis(0.3, 0.7);
  EXPECT_EQ(narrow.labels, (std::vector<std::string>{"0.2", "0.5", "1"}));
  const Axis point = make_log_axis(1, 1);
  EXPECT_LT(point.low(), point.high());
}

TEST(SweepPicture, writes_errors_into_cells_and_crosses_those_that_failed) {
  const double none = std::numeric_limits<double>::infinity();
  const std::string svg = sweep_picture(
      {"a map", "", {"x2", "x1"}, {"1e9"}, "step", "stiffness", {{{1e-3, "", "why"}, {none, "failed", "it fell"}}}});
  for (const char* part : {"a map", ">0.001<", ">failed<", "<title>it fell</title>", ">x2<", ">1e9<"})
    EXPECT_TRUE(contains(svg, part)) << part;
}

TEST(ValuesPicture, the_heading_of_the_colours_ends_within_the_page) {
  const std::string name = "largest displacement of a point that was named at length [m]";
  const std::string svg = values_picture({"two keys",
                                          {{"angle", {10, 20}, {"10", "20"}}, {"steps", {1, 2}, {"1", "2"}}},
                                          {{name, {0.5, 1}, {}}},
                                          {"finished", "finished"}});
  std::smatch page, heading;
  ASSERT_TRUE(std::regex_search(svg, page, std::regex("viewBox=\"0 0 ([0-9.]+) "))) << svg;
  const std::regex ends("<text x=\"([0-9.]+)\"[^>]*text-anchor=\"end\"[^>]*>largest displacement of");
  ASSERT_TRUE(std::regex_search(svg, heading, ends)) << svg;
  EXPECT_LT(std::stod(heading[1]), std::stod(page[1]));
}

}  // namespace keyblock::report::tradeoff_picture_test
