// Case files in YAML: the same values as in JSON, and faults at their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/case_file/yaml_text.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/content_text.hpp"
#include "tests/support/random_contents.hpp"

namespace keyblock::formats::yaml_case_test {
namespace {

const std::string kYaml = R"(# A block on a held one.
keyblock: 2
units: {length: m, force: kN, time: s}
blocks:
  blocks:
    - material: rock
      outer:
        - [0, 0, bedding]
        - [2 m, 0, bedding]
        - [200 cm, 1, bedding]
        - [0, 1, bedding]
analysis:
  step_count: 10
  time_step: 2 ms
  plane_strain: false   # as the file says
  block_materials:
    - name: rock
      density: 2600 kg/m3
      youngs_modulus: 20 GPa
      poissons_ratio: 0.25
  joint_materials:
    - name: bedding
      friction_angle_deg: "30 deg"
)";
const std::string kJson = R"({"keyblock": 2, "units": {"length": "m", "force": "kN", "time": "s"},
 "blocks": {"blocks": [{"material": "rock", "outer": [[0, 0, "bedding"], ["2 m", 0, "bedding"],
   ["200 cm", 1, "bedding"], [0, 1, "bedding"]]}]},
 "analysis": {"step_count": 10, "time_step": "2 ms", "plane_strain": false,
  "block_materials": [{"name": "rock", "density": "2600 kg/m3", "youngs_modulus": "20 GPa", "poissons_ratio": 0.25}],
  "joint_materials": [{"name": "bedding", "friction_angle_deg": "30 deg"}]}})";

std::string with(const std::string& what, const std::string& by) {
  std::string text = kYaml;
  text.replace(text.find(what), what.size(), by);
  return text;
}

/// Returns the value as text, in which kinds of values differ.
std::string shown(const JsonValue& value) {
  switch (value.kind()) {
    case JsonKind::null:
      return "null";
    case JsonKind::no:
      return "false";
    case JsonKind::yes:
      return "true";
    case JsonKind::number:
      return std::to_string(value.number());
    case JsonKind::string:
      return '"' + std::string(value.string()) + '"';
    default: {
      std::string text = value.kind() == JsonKind::array ? "[" : "{";
      for (const JsonValue item : value) text += shown(item) + " ";
      return text + (value.kind() == JsonKind::array ? "]" : "}");
    }
  }
}

std::string values_of(const std::string& text) {
  const Source source{"f", text};
  JsonText tree(source, JsonText::Unread{});
  read_yaml(tree, source);
  return shown(tree.root());
}

}  // namespace

TEST(YamlCase, a_case_means_what_it_means_in_json) {
  EXPECT_EQ(support::content_text(read({"f", kYaml}).content), support::content_text(read({"f", kJson}).content));
  EXPECT_EQ(read({"f", kYaml}).warnings.size(), read({"f", kJson}).warnings.size());
}

// The core schema of YAML 1.2.2, section 10.3.2.
TEST(YamlCase, plain_words_are_of_the_core_schema_and_quoted_ones_are_texts) {
  EXPECT_EQ(values_of("[1, -2.5, 1e3, .5, +4, 010, 0x1F, .inf, 20 GPa, true, False, ~, null, yes, \"7\", 'true']"),
            "[1.000000 -2.500000 1000.000000 0.500000 4.000000 10.000000 \"0x1F\" \".inf\" \"20 GPa\" true false null "
            "null \"yes\" \"7\" \"true\" ]");
  EXPECT_EQ(values_of("1: a\n2 b: {c: [d]}\n"), "{\"1\" \"a\" \"2 b\" {\"c\" [\"d\" ] } }");
}

TEST(YamlCase, faults_are_named_at_line_and_column) {
  EXPECT_EQ(error_of(with("youngs_modulus: 20 GPa", "youngs_modulus: 20 m")),
            "f:19:23: error: expected youngs_modulus: a number, or a stress, such as \"20 GPa\", found \"20 m\"");
  EXPECT_TRUE(error_of(with("step_count: 10", "step_cuont: 10"))
                  .starts_with("f:13:3: error: expected a key of analysis (did you mean \"step_count\"?)"))
      << error_of(with("step_count: 10", "step_cuont: 10"));
  EXPECT_TRUE(
      error_of(with("[2 m, 0, bedding]", "[2 m, 0, beding]")).starts_with("f:9:20: error: expected the number or"))
      << error_of(with("[2 m, 0, bedding]", "[2 m, 0, beding]"));
  const std::string endless = error_of(with("[0, 1, bedding]", "[0, 1, bedding"));
  // Noticed where the next list begins.
  EXPECT_TRUE(endless.starts_with("f:17:5: error: expected sound YAML")) << endless;
  const std::string indented = error_of(with("  time_step", " time_step"));
  EXPECT_TRUE(indented.starts_with("f:14:2: error: expected sound YAML")) << indented;
  EXPECT_TRUE(
      error_of(with("time_step: 2 ms", "time_step: 1e999")).starts_with("f:14:14: error: expected a number of double"));
}

TEST(YamlCase, what_a_case_file_has_no_use_for_is_refused) {
  EXPECT_EQ(error_of(with("poissons_ratio: 0.25", "poissons_ratio: &nu 0.25")),
            "f:20:23: error: expected a value, found an anchor; write the value out");
  EXPECT_NE(error_of(kYaml + "---\nkeyblock: 2\n").find("expected one document, found another"), std::string::npos);
  std::string deep = "keyblock: 2\nunits: ";
  deep.append(1000, '[');
  EXPECT_NE(error_of(deep), "");
  EXPECT_NE(error_of("keyblock: 2\n? [a, b]\n: c\n"), "");
}

// JSON is YAML: both readers agree on any JSON text.
TEST(YamlCase, json_reads_as_yaml) {
  const std::vector<support::ContentKind> kinds = support::content_kinds();
  const auto kind = std::ranges::find(kinds, &kKeyblockCase, &support::ContentKind::format);
  ASSERT_NE(kind, kinds.end());
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Dice dice(seed);
    const std::string text = kKeyblockCase.write(kind->draw(dice));
    const Source source{"f", text};
    const JsonText json(source);
    JsonText yaml(source, JsonText::Unread{});
    read_yaml(yaml, source);
    EXPECT_EQ(shown(yaml.root()), shown(json.root())) << "seed " << seed;
  }
}

}  // namespace keyblock::formats::yaml_case_test
