// JSON values know their place, with any text between them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/text/json_text.hpp"

#include <gtest/gtest.h>

namespace keyblock::formats::json_text_test {
namespace {

Place place_of_last(const std::string& text) {
  const Source source{"f", text};
  const JsonText json(source);
  JsonValue last = json.root();
  for (const JsonValue item : json.root()) last = item;
  return last.place();
}

std::string error_in(const std::string& text) {
  try {
    JsonText({"f", text});
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST(JsonText, values_know_their_place) {
  EXPECT_EQ(place_of_last("[1,2.5e3]"), (Place{"f", 1, 4}));
  EXPECT_EQ(place_of_last("[ [1, 2],\n  true ]"), (Place{"f", 2, 3}));
  EXPECT_EQ(place_of_last("[[[]],{\"a\":[1]}, \"x\\n]\" , null]"), (Place{"f", 1, 27}));
  EXPECT_EQ(place_of_last("\xEF\xBB\xBF[ // 7, ]\n /* [ */ -3]"), (Place{"f", 2, 10}));
}

TEST(JsonText, values_are_what_was_written) {
  const Source source{"f", R"({"a": -0.25, "b": ["x\u0041", false, null], "": {}})"};
  const JsonText json(source);
  EXPECT_EQ(json.root().member("a")->number(), -0.25);
  EXPECT_EQ((*json.root().member("b")->begin()).string(), "xA");
  EXPECT_EQ(json.root().member("")->kind(), JsonKind::object);
  EXPECT_FALSE(json.root().member("c"));
}

TEST(JsonText, faults_are_errors_at_their_place) {
  EXPECT_EQ(error_in("{\"a\": 1,\n \"b\" 2}"), "f:2:6: error: expected sound JSON, found \"2\"");
  EXPECT_EQ(error_in("{\"a\": 0,001, \"b\": 2}"),
            "f:1:9: error: expected sound JSON, found \"0\"; numbers have a decimal point, a comma parts values");
  EXPECT_EQ(error_in("[1, # one\n 2]"),
            "f:1:5: error: expected sound JSON, found \"1, #\"; comments begin with // in JSON, with # in YAML");
  EXPECT_EQ(error_in("[1, 2"), "f:1:6: error: expected sound JSON, found the end of the file");
  EXPECT_EQ(error_in("[1, 1e999]"), "f:1:5: error: expected a number of double precision, found \"1e999]\"");
  EXPECT_EQ(error_in(std::string(100000, '[')), "f:1:13: error: expected at most 12 levels of brackets, found another");
}

}  // namespace keyblock::formats::json_text_test
