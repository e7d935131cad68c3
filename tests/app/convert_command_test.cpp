// `keyblock convert` as a user meets it: names of outputs, what is refused, kept and reported.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock {
namespace {

using testing::fresh_folder;
using testing::ProgramRun;
using testing::read_text;
using testing::run_keyblock;
using testing::write_text;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A triangle with two material lines, and an analysis with an initial velocity.
const std::string kLines =
    "0.001\n3 0\n2\n0\n1\n0\n0\n0\n0 0 2 0 1\n2 0 1 2 1\n1 2 0 0 1\n0.9 0.5 1.1 0.5 1\n0.9 0.6 1.1 0.6 1\n1 0.2 1 "
    "0.2\n";
const std::string kControls = "1\n10\n1\n1\n0.01\n0.1\n2 20 1e6 0.2\n0 0 0\n0 0 0\n1 0 0\n30 0 0\n";

class ConvertCommand : public ::testing::Test {
 protected:
  ConvertCommand() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fresh_folder(std::string("convert_") + test->name()) + "/";
    write_text(folder_ + "a.geo", kLines);
    write_text(folder_ + "a.ana", kControls);
  }

  ProgramRun convert(std::vector<std::string> more) const {
    more.insert(more.begin(), {"convert", folder_ + "a.geo", folder_ + "a.ana"});
    return run_keyblock(more);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ + name); }

  std::string folder_;
};

}  // namespace

TEST_F(ConvertCommand, two_files_have_the_endings_behind_the_whole_name) {
  EXPECT_EQ(convert({"-o", folder_ + "slope1.5", "--to", "berkeley"}).exit_code, 0);
  EXPECT_TRUE(exists("slope1.5.geo") && exists("slope1.5.ana"));
  EXPECT_EQ(convert({"-o", folder_ + "b.ana", "--to", "berkeley"}).exit_code, 0);
  EXPECT_TRUE(exists("b.geo") && exists("b.ana")) << "an ending of the target is replaced";
}

}  // namespace keyblock
