// JSON with places: values come through, keys know their line, faults are found where they stand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/placed_json.hpp"

#include <gtest/gtest.h>

namespace keyblock::formats::placed_json_test {
namespace {

using Kind = PlacedJson::Kind;

std::string fault(const std::string& text) {
  try {
    read_json({"f", text});
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST(PlacedJson, values_come_with_the_place_of_their_key) {
  const PlacedJson json =
      read_json({"f", "\xEF\xBB\xBF{\n  \"a\": [1, -2.5e1, \"x\", true, null],\r\n \"b\" : {\"c\": 7}}"});
  EXPECT_EQ(json.keys, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(json.items[0].place, (Place{"f", 2, 3}));
  ASSERT_EQ(json.items[0].items.size(), 5u);
  EXPECT_EQ(json.items[0].items[1].number, -25);
  EXPECT_EQ(json.items[0].items[1].place, (Place{"f", 2, 12}));
  EXPECT_EQ(json.items[0].items[2].text, "x");
  EXPECT_EQ(json.items[0].items[3].kind, Kind::flag);
  EXPECT_EQ(json.items[0].items[4].kind, Kind::null);
  EXPECT_EQ(json.items[1].items[0].place, (Place{"f", 3, 9}));
  EXPECT_EQ(json.items[1].items[0].number, 7);
  EXPECT_EQ(read_json({"f", " 3 "}).number, 3);
}

TEST(PlacedJson, faults_are_found_at_their_line_and_column) {
  EXPECT_EQ(fault("{\"a\": 1,\n \"a\": 2}"), "f:2:2: error: expected each key once, found \"a\" a second time");
  EXPECT_EQ(fault("{\"a\":\n 1 x}").substr(0, 6), "f:2:4:");
  EXPECT_EQ(fault(""), "f:1:1: error: expected sound JSON, found the end of the file");
  EXPECT_EQ(fault("{\"a\": [1,"), "f:1:10: error: expected sound JSON, found the end of the file");
  EXPECT_NE(fault(std::string(100000, '[')).find("expected at most 12 levels of brackets"), std::string::npos);
  EXPECT_NE(fault("{\"a\": 1e999}"), "");
  EXPECT_NE(fault("{\"a\": nan}"), "");
}

TEST(PlacedJson, an_option_is_an_object) {
  const PlacedJson json = json_of_option("--set", "dip=60,law=normal");
  EXPECT_EQ(json.keys, (std::vector<std::string>{"dip", "law"}));
  EXPECT_EQ(json.items[0].number, 60);
  EXPECT_EQ(json.items[1].text, "normal");
  for (const char* bad : {"dip", "=3", "a=1,a=2", "a=1,,b=2"})
    EXPECT_THROW(json_of_option("--set", bad), InputError) << bad;
}

}  // namespace keyblock::formats::placed_json_test
