// `keyblock cut` writes the files that it names, never overwrites, and names drawings that it cannot cut.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "formats/case.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::cut_command_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed at the end.
class CutCommand : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("keyblock_" + name);
    fs::create_directories(folder_);
    // Two unit squares side by side, one measured point.
    std::ofstream(folder_ / "squares.geo") << "0.01 5 0 0 0 0 0 1 0\n0 0 2 0 1\n2 0 2 1 1\n2 1 0 1 1\n0 1 0 0 1\n"
                                              "1 0 1 1 2\n0.5 0.5\n";
    std::ofstream(folder_ / "open.geo") << "0.01 2 0 0 0 0 0 0 0\n0 0 2 0 1\n2 0 2 1 1\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  int run(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder_.string() + "' && '" KEYBLOCK_PROGRAM "' cut " + arguments + " > out 2> err";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  std::string text(const std::string& name) const {
    std::ifstream file(folder_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
};

}  // namespace

TEST_F(CutCommand, numbers_stand_in_the_picture_where_asked_for) {
  ASSERT_EQ(run("squares.geo --svg numbered.svg --numbers"), 0) << text("err");
  ASSERT_EQ(run("squares.geo --svg plain.svg"), 0) << text("err");
  for (const char* number : {">1<", ">2<"}) {
    EXPECT_NE(text("numbered.svg").find(number), std::string::npos) << number;
    EXPECT_EQ(text("plain.svg").find(number), std::string::npos) << number;
  }
  EXPECT_NE(run("squares.geo --numbers"), 0) << "of no picture";
}

TEST_F(CutCommand, writes_a_block_file_that_reads_back) {
  ASSERT_EQ(run("squares.geo -o squares.blk --svg squares.svg"), 0) << text("err");
  const formats::Case cut = formats::load_case({(folder_ / "squares.blk").string()});
  const auto& blocks = std::get<Blocks>(cut.problem.geometry);
  EXPECT_EQ(blocks.blocks.size(), 2U);
  EXPECT_EQ(blocks.measured_points.size(), 1U);
  EXPECT_NE(text("squares.svg").find("<svg"), std::string::npos);
}

// Two squares on a mesh of 2 × 2 rows; the joint between them parts every cover that it crosses.
TEST_F(CutCommand, writes_a_cover_file_with_a_mesh) {
  ASSERT_EQ(run("squares.geo --mesh 2 -o squares.cv --json"), 0) << text("err");
  const formats::Case cut = formats::load_case({(folder_ / "squares.cv").string()});
  const auto& cover = std::get<Cover>(cut.problem.geometry);
  double sum = 0;
  for (const CoverElement& element : cover.elements) sum += area(cover.polygon(element));
  EXPECT_NEAR(sum, 2, 1e-12);
  EXPECT_EQ(cover.loops.size(), 2U);
  EXPECT_EQ(cover.measured_points.size(), 1U);
  EXPECT_NE(text("out").find("\"elements\": " + std::to_string(cover.elements.size())), std::string::npos);
}

TEST_F(CutCommand, refuses_options_of_a_mesh_without_one) {
  EXPECT_EQ(run("squares.geo --absorb"), 2);
  EXPECT_EQ(run("squares.geo --mesh-shape old"), 2);
  EXPECT_EQ(run("squares.geo --mesh-snap 0.01"), 2);
  EXPECT_EQ(run("squares.geo --mesh-refine 1 1 0.1"), 2);
  EXPECT_EQ(run("squares.geo --mesh 0"), 2);
  EXPECT_EQ(run("squares.geo --mesh 2 --mesh-side 0.1"), 2) << "one or the other";
}

TEST_F(CutCommand, refuses_a_mesh_that_would_fill_the_memory) {
  EXPECT_EQ(run("squares.geo --mesh-side 1e-5"), 2);
  EXPECT_NE(text("err").find("triangles"), std::string::npos) << text("err");
  EXPECT_EQ(run("squares.geo --mesh-side nan"), 2);
  EXPECT_EQ(run("squares.geo --mesh-side 1 --mesh-refine 0.5 0.5 0"), 2);
}

TEST_F(CutCommand, an_unstructured_mesh_is_finer_at_refined_points) {
  const auto elements = [&](const std::string& options) {
    EXPECT_EQ(run("squares.geo -o unstructured.cv --force --mesh-side 0.4 " + options), 0) << text("err");
    const formats::Case cut = formats::load_case({(folder_ / "unstructured.cv").string()});
    return std::get<Cover>(cut.problem.geometry).elements.size();
  };
  const std::size_t plain = elements("");
  EXPECT_GT(elements("--mesh-refine 0.5 0.5 0.02 --mesh-refine 1.5 0.5 0.02"), plain + 100);
}

TEST_F(CutCommand, overwrites_only_when_told_to) {
  std::ofstream(folder_ / "old.blk") << "precious";
  EXPECT_NE(run("squares.geo -o old.blk"), 0);
  EXPECT_EQ(text("old.blk"), "precious");
  EXPECT_EQ(run("squares.geo -o old.blk --force"), 0);
  EXPECT_NE(text("old.blk"), "precious");
}

TEST_F(CutCommand, refuses_lines_that_close_no_block) {
  EXPECT_EQ(run("open.geo"), 3);
  EXPECT_NE(text("err").find("open.geo"), std::string::npos);
  EXPECT_NE(text("err").find("at least one block"), std::string::npos);
}

TEST_F(CutCommand, prints_counts_as_json) {
  EXPECT_EQ(run("squares.geo --json"), 0);
  EXPECT_NE(text("out").find("\"blocks\": 2"), std::string::npos);
}

}  // namespace keyblock::cut_command_test
