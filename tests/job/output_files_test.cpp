// Commands write only the outputs that the user named: nothing beside them, nothing through them, nothing twice.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::output_files_test {
namespace {

namespace fs = std::filesystem;
using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

const std::string kCases = KEYBLOCK_SOURCE_DIR "/legacy_cases/";
const std::string kStack = kCases + "stack/five_blocks/five_blocks.geo";

support::ProgramRun cut_to(const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"cut", kStack, "-o", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_keyblock(arguments);
}

support::ProgramRun joints_to(const std::string& file) {
  return run_keyblock(
      {"joints", "--slope", "height=10,angle=60", "--set", "dip=60,spacing=1,trace=5", "-o", file, "--force"});
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(OutputFiles, what_lies_beside_an_output_is_left_alone_whatever_its_name) {
  const std::string folder = fresh_folder("beside");
  write_text(folder + "/out.blk.part", "precious");
  write_text(folder + "/victim", "precious");
  fs::create_symlink(folder + "/victim", folder + "/linked.blk.part");
  EXPECT_EQ(cut_to(folder + "/out.blk").exit_code, 0);
  EXPECT_EQ(cut_to(folder + "/linked.blk").exit_code, 0);
  EXPECT_EQ(read_text(folder + "/out.blk.part"), "precious");
  EXPECT_EQ(read_text(folder + "/victim"), "precious");
  EXPECT_TRUE(fs::is_symlink(folder + "/linked.blk.part"));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder + "/linked.blk")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 5) << "no draft is left";
}

TEST(OutputFiles, a_name_may_be_as_long_as_names_can_be) {
  const std::string folder = fresh_folder("long_name");
  for (const std::size_t length : {250U, 251U, 255U})
    EXPECT_EQ(cut_to(folder + "/" + std::string(length - 4, 'a') + ".blk").exit_code, 0) << length;
  const auto too_long = cut_to(folder + "/" + std::string(252, 'a') + ".blk");
  EXPECT_EQ(too_long.exit_code, 4);
  EXPECT_TRUE(contains(too_long.messages, "File name too long")) << too_long.messages;
}

TEST(OutputFiles, what_is_no_file_is_not_replaced) {
  const std::string folder = fresh_folder("no_file");
  ASSERT_EQ(support::run_script("mkfifo " + folder + "/pipe").exit_code, 0);
  fs::create_directory(folder + "/folder");
  std::vector<std::string> outputs{folder + "/pipe", folder + "/folder"};
  // A device made for this test, if permitted: a fault here would replace the machine's.
  const std::string device = folder + "/device";
  if (support::run_script("mknod " + device + " c 1 3").exit_code == 0) outputs.push_back(device);
  for (const std::string& output : outputs) {
    const auto type = fs::status(output).type();
    const auto run = joints_to(output);
    EXPECT_EQ(run.exit_code, 2) << output;
    EXPECT_TRUE(contains(run.messages, "is no regular file")) << run.messages;
    EXPECT_EQ(fs::status(output).type(), type) << output;
    EXPECT_EQ(cut_to(output, {"--force"}).exit_code, 2) << output;
  }
}

TEST(OutputFiles, a_link_is_followed_if_told_to_and_stays) {
  const std::string folder = fresh_folder("linked");
  write_text(folder + "/old.blk", "old");
  fs::create_symlink("old.blk", folder + "/latest.blk");
  fs::create_symlink("nothing", folder + "/dangling.blk");
  EXPECT_EQ(cut_to(folder + "/latest.blk").exit_code, 2);
  EXPECT_EQ(read_text(folder + "/old.blk"), "old");
  EXPECT_EQ(cut_to(folder + "/latest.blk", {"--force"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(folder + "/latest.blk"));
  EXPECT_EQ(cut_to(folder + "/plain.blk").exit_code, 0);
  EXPECT_EQ(read_text(folder + "/old.blk"), read_text(folder + "/plain.blk"));
  for (const std::vector<std::string>& force : {std::vector<std::string>{}, {"--force"}}) {
    const auto run = cut_to(folder + "/dangling.blk", force);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(contains(run.messages, "is a link to nothing")) << run.messages;
  }
  EXPECT_FALSE(fs::exists(folder + "/nothing"));
}

TEST(OutputFiles, two_outputs_of_one_name_are_refused_before_anything_is_written) {
  const std::string folder = fresh_folder("two");
  fs::create_directory(folder + "/below");
  for (const std::string& picture : {folder + "/x", folder + "/below/../x"}) {
    const auto run = cut_to(folder + "/x", {"--svg", picture});
    EXPECT_EQ(run.exit_code, 2) << picture;
    EXPECT_TRUE(contains(run.messages, "is named for two outputs")) << run.messages;
  }
  const std::string slide = kCases + "sliding_block/a30_p20";
  EXPECT_EQ(run_keyblock({"sweep", slide, "--table", folder + "/x", "--picture", folder + "/x"}).exit_code, 2);
  EXPECT_EQ(run_keyblock({"tradeoff", slide, "--error", "1", "-o", folder + "/x", "--picture", folder + "/x"})
                .exit_code,
            2);
  EXPECT_FALSE(fs::exists(folder + "/x"));
}

TEST(OutputFiles, a_picture_of_a_comparison_is_not_overwritten_unless_told_to) {
  const std::string picture = fresh_folder("compared") + "/fall.svg";
  write_text(picture, "precious");
  std::vector<std::string> compare{"compare", kCases + "free_fall/released", "--picture", picture};
  EXPECT_EQ(run_keyblock(compare).exit_code, 2);
  EXPECT_EQ(read_text(picture), "precious");
  compare.emplace_back("--force");
  EXPECT_EQ(run_keyblock(compare).exit_code, 0);
  EXPECT_TRUE(contains(read_text(picture), "</svg>"));
}

TEST(OutputFiles, an_input_is_not_overwritten_by_another_command_either) {
  const std::string folder = fresh_folder("sweep_input");
  const std::string fall = kCases + "free_fall/released/released";
  for (const char* ending : {".geo", ".ana"}) fs::copy_file(fall + ending, folder + "/fall" + ending);
  const std::string before = read_text(folder + "/fall.geo");
  EXPECT_EQ(run_keyblock(
                {"tradeoff", folder + "/fall.geo", folder + "/fall.ana", "--picture", folder + "/fall.geo", "--force"})
                .exit_code,
            2);
  EXPECT_EQ(read_text(folder + "/fall.geo"), before);
}

TEST(OutputFiles, a_file_of_a_case_folder_is_an_input_too) {
  const std::string folder = fresh_folder("case_input");
  std::filesystem::copy(KEYBLOCK_SOURCE_DIR "/legacy_cases/domino/tips", folder + "/tips");
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/tips")) {
    const std::string file = entry.path().string();
    const std::string before = read_text(file);
    const auto run = run_keyblock({"compare", folder + "/tips", "--picture", file, "--force"});
    EXPECT_EQ(run.exit_code, 2) << file << run.messages;
    EXPECT_EQ(read_text(file), before);
  }
}

}  // namespace keyblock::output_files_test
