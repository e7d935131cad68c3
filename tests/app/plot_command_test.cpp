// Pictures drawn again from the frames of a run: the same as the run's own, at any step that has a frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::plot_command_test {
namespace {

using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The folder of a run of a template, its field.svg of `field`.
std::string run_of(const std::string& kind, const std::string& field) {
  const std::string folder = fresh_folder("plot_" + kind + field);
  EXPECT_EQ(run_keyblock({"new", kind, "-o", folder + "/case.json"}).exit_code, 0);
  const ProgramRun run = run_keyblock({"run", folder + "/case.json", "-o", folder + "/out", "--set", "steps=4",
                                       "--record-every", "2", "--field", field});
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return folder + "/out";
}

/// Without marks of measured points, which are not in the frames.
std::string without_marks(const std::string& picture) {
  std::string kept;
  std::istringstream lines(picture);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("<circle")) kept += line + "\n";
  return kept;
}

}  // namespace

TEST(PlotCommand, what_it_draws_is_what_the_run_drew) {
  for (const char* kind : {"slope", "beam"})
    for (const char* field : {"s1", "displacement", "crosses"}) {
      const std::string out = run_of(kind, field);
      const ProgramRun plot = run_keyblock({"plot", out, "--field", field, "--json"});
      EXPECT_EQ(plot.exit_code, 0) << plot.messages;
      const auto told = nlohmann::json::parse(plot.output);
      EXPECT_EQ(told.at("field"), field);
      EXPECT_EQ(without_marks(read_text(told.at("file"))), without_marks(read_text(out + "/field.svg")))
          << kind << ", " << field;
    }
}

TEST(PlotCommand, the_frame_of_a_step_may_be_chosen) {
  const std::string out = run_of("slope", "s3");
  EXPECT_EQ(run_keyblock({"plot", out, "--field", "s3", "--step", "2"}).exit_code, 0);
  EXPECT_NE(read_text(out + "/field_s3_2.svg"), read_text(out + "/field.svg"));
  const ProgramRun none = run_keyblock({"plot", out, "--step", "3"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(contains(none.messages, "no frame of step 3, only 3, from 0 to 4; the next is 4")) << none.messages;
}

TEST(PlotCommand, nothing_is_overwritten_unless_told) {
  const std::string out = run_of("slope", "sxx");
  const std::string before = read_text(out + "/field.svg");
  EXPECT_EQ(run_keyblock({"plot", out, "-o", out + "/field.svg", "--field", "syy"}).exit_code, 2);
  EXPECT_EQ(read_text(out + "/field.svg"), before);
  EXPECT_EQ(run_keyblock({"plot", out, "-o", out + "/field.svg", "--field", "syy", "--force"}).exit_code, 0);
  EXPECT_NE(read_text(out + "/field.svg"), before);
}

TEST(PlotCommand, what_is_no_run_or_no_frame_is_an_error_at_its_place) {
  const std::string empty = fresh_folder("plot_empty");
  const ProgramRun none = run_keyblock({"plot", empty});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(contains(none.messages, "expected the folder of a run, with frames/*.vtu, found none")) << none.messages;
  const std::string out = run_of("slope", "syy");
  const std::string frame = out + "/frames/00000004.vtu";
  const std::string good = read_text(frame);
  const auto refused = [&](const std::string& text) {
    write_text(frame, text);
    const ProgramRun plot = run_keyblock({"plot", out, "-o", out + "/bad.svg"});
    EXPECT_EQ(plot.exit_code, 3) << plot.messages;
    EXPECT_FALSE(std::filesystem::exists(out + "/bad.svg"));
    return plot.messages;
  };
  EXPECT_TRUE(contains(refused(good.substr(0, good.size() / 2)), "expected well-formed XML"));
  EXPECT_TRUE(contains(refused("<VTKFile/>"), "expected a frame that a run wrote (.vtu)"));
  std::string odd = good;
  const std::size_t array = odd.find("Name=\"stress_yy");
  odd.replace(odd.find('\n', array) + 1, 1, "x");
  const std::string messages = refused(odd);
  EXPECT_TRUE(contains(messages, "00000004.vtu:")) << messages;
  EXPECT_TRUE(contains(messages, "expected finite numbers in the array, found \"x")) << messages;
  std::string far = good;
  const std::size_t order = far.find("Name=\"connectivity");
  far.insert(far.find('\n', order) + 1, "999999999 ");
  EXPECT_TRUE(contains(refused(far), "in the array connectivity"));
}

}  // namespace keyblock::plot_command_test
