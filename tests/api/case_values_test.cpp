// Values of a case by pointers, names and *.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_values.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "api/asked_case.hpp"
#include "formats/all_content.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::case_values_test {
namespace {

constexpr const char* kList = R"({"list": [{"name": "bedding", "x": 1}, {"name": "cross/joint", "x": 2}], "a~b": 3})";

using Pointers = std::vector<std::string>;

}  // namespace

TEST(CaseValues, names_and_stars_stand_for_numbers) {
  EXPECT_EQ(pointers_to("/list/bedding/x", kList), Pointers{"/list/0/x"});
  EXPECT_EQ(pointers_to("/list/cross~1joint/x", kList), Pointers{"/list/1/x"});
  EXPECT_EQ(pointers_to("/list/*/x", kList), (Pointers{"/list/0/x", "/list/1/x"}));
  EXPECT_EQ(pointers_to("/a~0b", kList), Pointers{"/a~0b"});
  EXPECT_EQ(value_at("/list/*/x", kList), "[1,2]");
  EXPECT_EQ(value_at("/list/1/x", kList), "2");
  for (const char* wrong : {"/list/2", "/list/fault/x", "list", "/list/*/y", "/a~b/0"})
    EXPECT_THROW(pointers_to(wrong, kList), std::invalid_argument) << wrong;
  EXPECT_EQ(pointers_to("/list/0/y", kList, true), Pointers{"/list/0/y"});
  EXPECT_THROW(pointers_to("/none/y", kList, true), std::invalid_argument);
}

TEST(CaseValues, keys_of_rows_stand_for_their_places) {
  const std::string bolts = R"({"blocks": {"bolts": [[0, 0, 1, 1, 1, 2, 3, 4, 5], [0, 0, 2, 2, 1, 2, 6, 7, 8]]}})";
  EXPECT_EQ(pointers_to("/blocks/bolts/*/pretension", bolts), (Pointers{"/blocks/bolts/0/8", "/blocks/bolts/1/8"}));
  EXPECT_EQ(value_at("/blocks/bolts/1/stiffness", bolts), "6");
  EXPECT_EQ(row_key_at("/blocks/bolts/0/8"), "pretension");
  EXPECT_EQ(row_key_at("/blocks/bolts/0"), "");
  EXPECT_THROW(pointers_to("/blocks/bolts/0/tension", bolts, true), std::invalid_argument);
}

TEST(CaseValues, a_pointer_to_nothing_is_told_by_the_part_that_is_wrong) {
  const auto told = [](const char* pointer, bool or_new) {
    try {
      pointers_to(pointer, kList, or_new);
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.substr(text.find(pointer) + std::string(pointer).size());
    }
    return std::string("found");
  };
  EXPECT_EQ(told("/lists/0/x", true), ": the case has no lists; did you mean \"list\"?");
  EXPECT_EQ(told("/list/2/x", true), ": /list, 2 items from 0, has no 2");
  EXPECT_EQ(told("/list/beding/x", true), ": /list, 2 items from 0, has no beding; did you mean \"bedding\"?");
  EXPECT_EQ(told("/list/0/colour", false), ": /list/0 has no colour");
  EXPECT_EQ(told("/list/0/x/y", false), ": /list/0/x has no y");
  EXPECT_EQ(told("/list/*/y", false), ": /list/0 has no y");
}

TEST(CaseValues, a_case_beside_a_drawing_keeps_names_and_other_values) {
  const std::string root = KEYBLOCK_SOURCE_DIR "/docs/";
  const OpenCase open =
      opened(asked_case({{root + "quarry.dxf", root + "bench.json", root + "quarry_layers.csv"}, {}, {}, {}}));
  const auto* drawing = std::get_if<Drawing>(&open.input.problem.geometry);
  const formats::Case same = with_values(open.input, {});
  EXPECT_EQ(std::get<Drawing>(same.problem.geometry).joints.size(), drawing->joints.size());
  EXPECT_EQ(same.problem.analysis->joint_materials.size(), open.input.problem.analysis->joint_materials.size());
  const formats::Case changed = with_values(open.input, {{"/analysis/joint_materials/*/friction_angle_deg", "12.5"}});
  for (const JointMaterial& joint : changed.problem.analysis->joint_materials)
    EXPECT_EQ(joint.friction_angle_deg, 12.5);
  EXPECT_THROW(with_values(open.input, {{"/analysis/no_such_key", "1"}}), InputError);
}

}  // namespace keyblock::case_values_test
