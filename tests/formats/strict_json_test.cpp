// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/strict_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/error.hpp"

namespace keyblock::formats {

TEST(StrictJson, keeps_names_units_and_the_order_of_keys) {
  const std::string text = strict_json({"a.json", R"({
    "keyblock": 2,  // the layout
    "analysis": {"time_step": "2 ms", "steps": 10, "factor": 0.25, "flag": true, "none": null,},
    "list": [1, -2.5e-3, "x", [],],
  })"});
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(text);
  EXPECT_EQ(json.begin().key(), "keyblock");
  EXPECT_EQ(json["analysis"]["time_step"], "2 ms");
  EXPECT_TRUE(json["analysis"]["steps"].is_number_integer());
  EXPECT_EQ(json["analysis"]["factor"], 0.25);
  EXPECT_EQ(json["analysis"]["flag"], true);
  EXPECT_TRUE(json["analysis"]["none"].is_null());
  EXPECT_EQ(json["list"].dump(), R"([1,-0.0025,"x",[]])");
}

TEST(StrictJson, yaml_gives_the_same_values) {
  const std::string yaml = "keyblock: 2\nunits: {length: m, mass: kg, time: s}\nlist: [1, two, 3.5]\n";
  const std::string json = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
    "list": [1, "two", 3.5]})";
  EXPECT_EQ(strict_json({"a.yaml", yaml}), strict_json({"a.json", json}));
}

TEST(StrictJson, a_text_that_breaks_off_is_refused_with_its_place) {
  EXPECT_THROW(strict_json({"a.json", "{\"keyblock\": 2, \"list\": [1"}), InputError);
}

}  // namespace keyblock::formats
