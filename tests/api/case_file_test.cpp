// case.json: every permitted key has its effect, and every other key is refused with file and key.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "api/case_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::case_file_test {
namespace {

namespace fs = std::filesystem;

CaseFolder folder_with(const std::string& json) {
  const fs::path folder = support::fresh_folder("case_file");
  support::write_text(folder / "case.json", json);
  return {folder, "case_file", true, false};
}

/// Returns the message of a file that is refused; empty if it is accepted.
std::string complaint(const std::string& json) {
  try {
    read_case_file(folder_with(json));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(CaseFile, without_one_nothing_is_set) {
  const CaseFile file = read_case_file({support::fresh_folder("no_case_file"), "none", true, false});
  EXPECT_FALSE(file.is_slow);
  EXPECT_TRUE(file.variants.empty());
  EXPECT_TRUE(file.overrides("legacy").empty());
}

TEST(CaseFile, settings_of_both_profiles_come_before_those_of_one) {
  const CaseFile file = read_case_file(folder_with(R"({
      "set": {"standard": {"steps": "20"}, "both": {"steps": "10", "time_step": 0.001}},
      "variants": [{"name": "v", "profile": "standard", "set": {"steps": "30"}}]})"));
  const std::vector<Override> legacy{{"steps", "10"}, {"time_step", "0.001"}};
  const std::vector<Override> standard{{"steps", "10"}, {"time_step", "0.001"}, {"steps", "20"}};
  EXPECT_EQ(file.overrides("legacy"), legacy);
  EXPECT_EQ(file.overrides("standard"), standard);
  EXPECT_EQ(file.variants.front().set, (std::vector<Override>{{"steps", "30"}}));
}

TEST(CaseFile, a_setting_that_is_off_or_on_may_be_a_flag) {
  const CaseFile file = read_case_file(folder_with(R"({"set": {"both": {"ledger": false}}})"));
  EXPECT_EQ(file.overrides("standard"), (std::vector<Override>{{"ledger", "off"}}));
}

TEST(CaseFile, variants_can_be_shared_by_naming_a_file_of_them) {
  const CaseFolder folder = folder_with(R"({"variants": [
      "shared.json", {"name": "own", "profile": "legacy", "set": {}}]})");
  support::write_text(folder.folder / "shared.json", R"([{"name": "a", "profile": "standard", "set": {}},
                                                          {"name": "b", "profile": "standard", "set": {}}])");
  const CaseFile file = read_case_file(folder);
  ASSERT_EQ(file.variants.size(), 3U);
  EXPECT_EQ(file.variants[0].name, "a");
  EXPECT_EQ(file.variants[2].name, "own");
  support::write_text(folder.folder / "shared.json", R"([{"name": "a"}])");
  EXPECT_THROW(read_case_file(folder), InputError);
}

TEST(CaseFile, says_which_profile_is_not_run_and_why) {
  const CaseFile file = read_case_file(folder_with(R"({"slow": true, "legacy": "not run: it has no bolts"})"));
  EXPECT_TRUE(file.is_slow);
  EXPECT_EQ(file.not_run.at("legacy"), "it has no bolts");
  EXPECT_FALSE(file.not_run.contains("standard"));
}

TEST(CaseFile, says_whose_strength_is_reduced_and_between_which_factors) {
  const CaseFile file = read_case_file(folder_with(R"({"reduce_strength": {"what": "rock", "from": 0.5, "to": 2}})"));
  ASSERT_TRUE(file.reduction);
  EXPECT_EQ(file.reduction->what, Reduced::rock);
  EXPECT_EQ(file.reduction->from, 0.5);
  EXPECT_EQ(file.reduction->to, 2);
  EXPECT_EQ(file.reduction->within, std::nullopt);
  EXPECT_TRUE(contains(complaint(R"({"reduce_strength": {}})"), "the key \"what\" in it"));
  EXPECT_TRUE(contains(complaint(R"({"reduce_strength": {"what": "bolts"}})"), "joints, rock or both"));
  EXPECT_TRUE(contains(complaint(R"({"reduce_strength": {"what": "rock", "to": 0.5}})"), "greater than that of"));
}

TEST(CaseFile, keys_and_values_that_are_none_are_refused_by_name) {
  for (const auto& [json, part] :
       {std::pair{R"({"sett": {}})", "\"sett\""},
        {R"({"set": {"modern": {}}})", "\"set.modern\""},
        {R"({"variants": [{"name": "a", "profile": "legacy", "set": {}, "dt": 1}]})", "\"variants[0].dt\""},
        {R"({"variants": [{"name": "a", "set": {}}]})", "variants[0]: expected the key"},
        {R"({"variants": [{"name": "a", "profile": "new", "set": {}}]})", "variants[0].profile"},
        {R"({"variants": [{"name": "a", "profile": "legacy", "set": {}, "tolerance": 1}]})", "\"reason\""},
        {R"({"variants": {}})", "variants: expected a list"},
        {R"({"slow": "yes"})", "slow: expected true or false"},
        {R"({"set": {"both": {"steps": true}}})", "set.both.steps: expected text"},
        {R"({"set": {"both": {"linear_metod": "factor"}}})",
         "key set.both.linear_metod: there is no setting \"linear_metod\"; did you mean \"linear_method\"?"},
        {R"({"set": {"legacy": {"linear_method": "fast"}}})",
         "key set.legacy.linear_method: setting linear_method: exp"},
        {R"({"legacy": "skipped"})", "legacy: expected \"not run: REASON\""},
        {R"([])", "(top): expected an object"},
        {R"({"slow": true)", "expected JSON"}}) {
    EXPECT_TRUE(contains(complaint(json), part)) << json << '\n' << complaint(json);
    EXPECT_TRUE(contains(complaint(json), "case.json: error: ")) << complaint(json);
  }
}

TEST(CaseFile, what_no_one_writes_by_hand_is_refused_shortly) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_TRUE(contains(complaint(deep), "case.json: error: expected at most 12 levels")) << complaint(deep);
  EXPECT_TRUE(contains(complaint(R"({"set": {"both": {"time_step": 1e400}}})"), "case.json: error: expected JSON"));
  std::string long_list = R"({"about": [0)";
  for (int i = 1; i < 10000; ++i) long_list += "," + std::to_string(i);
  EXPECT_LT(complaint(long_list + "]}").size(), 600U);
}

TEST(CaseFile, lists_of_variants_that_lead_back_to_themselves_and_links_to_nothing_are_refused) {
  const CaseFolder folder = folder_with(R"({"variants": ["more.json"]})");
  support::write_text(folder.folder / "more.json", R"(["more.json"])");
  try {
    read_case_file(folder);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "more.json: error: key [0]: expected a list that does not lead back"))
        << error.what();
  }
  const CaseFolder linked = folder_with("{}");
  fs::remove(linked.folder / "case.json");
  fs::create_symlink("nothere", linked.folder / "case.json");
  EXPECT_THROW(read_case_file(linked), InputError);
}

}  // namespace keyblock::case_file_test
