// A page is well-formed for any contents, and the map keeps shape and orientation of the plane.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/svg.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <pugixml.hpp>

namespace keyblock::report::svg_test {

TEST(Svg, words_are_made_safe_and_control_characters_dropped) {
  SvgPage page(10, 10);
  page.text({1, 1}, "a < b & \"c\"\x01");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(page.str().c_str()));
  EXPECT_STREQ(document.child("svg").child("text").text().get(), "a < b & \"c\"");
}

TEST(Svg, a_name_that_is_no_utf8_leaves_the_page_well_formed) {
  SvgPage page(10, 10);
  page.text({1, 1}, "B\xf6schung");
  page.begin_group("\xff");
  page.end_group();
  EXPECT_NE(page.str().find("B\xef\xbf\xbdschung"), std::string::npos);
  for (const char byte : {'\xf6', '\xff'}) EXPECT_EQ(page.str().find(byte), std::string::npos);
}

TEST(Svg, shapes_that_are_not_finite_are_left_out) {
  SvgPage page(10, 10);
  page.circle({std::numeric_limits<double>::quiet_NaN(), 0}, 1, {});
  page.polyline({{0, 0}, {std::numeric_limits<double>::infinity(), 0}}, {});
  EXPECT_EQ(page.str(), SvgPage(10, 10).str());
}

TEST(Svg, holes_are_cut_out_by_the_even_odd_rule) {
  SvgPage page(10, 10);
  page.polygon({{{0, 0}, {4, 0}, {4, 4}}, {{1, 1}, {2, 1}, {2, 2}}}, {.fill = "red"});
  EXPECT_NE(page.str().find("fill-rule=\"evenodd\""), std::string::npos);
  EXPECT_NE(page.str().find("M0,0 4,0 4,4ZM1,1 2,1 2,2Z"), std::string::npos);
}

TEST(Svg, the_map_fits_the_box_and_turns_y_down) {
  const Box box{{1e7, -5}, {1e7 + 20, 5}};
  const PageMap map(box, {30, 40}, {400, 400});
  EXPECT_DOUBLE_EQ(map.scale(), 20);
  EXPECT_EQ(map(Point{1e7, 5}), (Point{30, 40}));
  EXPECT_EQ(map(Point{1e7 + 20, -5}), (Point{430, 240}));
}

TEST(Svg, a_box_of_one_point_and_an_empty_box_still_map) {
  EXPECT_EQ(PageMap({{2, 3}, {2, 3}}, {0, 0}, {100, 100})(Point{2, 3}), (Point{0, 0}));
  EXPECT_EQ(PageMap(Box{}, {0, 0}, {100, 100}).scale(), 100);
}

}  // namespace keyblock::report::svg_test
