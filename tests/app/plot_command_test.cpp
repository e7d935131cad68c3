// Pictures drawn again from the frames of a run equal those of the run, at any step with a frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::plot_command_test {
namespace {

using support::contains;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

/// Without marks of measured points, which are not in the frames.
std::string without_marks(const std::string& picture) {
  std::string kept;
  std::istringstream lines(picture);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("<circle")) kept += line + "\n";
  return kept;
}

/// A plate with a hole within one of its elements, pressed by its own weight.
constexpr const char* kPlateWithHole = R"({"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
 "blocks": {"blocks": [{"material": "rock", "outer": [[0, 0, "j"], [4, 0, "j"], [4, 4, "j"], [0, 4, "j"]],
   "holes": [[[1.9, 1.4, "j"], [2.3, 1.4, "j"], [2.3, 1.0, "j"], [1.9, 1.0, "j"]]]}]},
 "covers": {"mesh": {"side": "2.5 m"}, "displacements": [{"along": [[0, 0], [4, 0]]}],
   "tractions": [{"along": [[4, 4], [0, 4]], "y": -1000000}]},
 "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 1,
  "block_materials": [{"name": "rock", "like": "sandstone"}], "joint_materials": [{"name": "j"}]}})";

/// Forty blocks on a fixed one, and a small one that falls beside them: far away at the end, and left out.
std::string with_a_small_block_that_falls() {
  std::string blocks = R"({"outer": [[-1, -1, 1], [41, -1, 1], [41, 0, 1], [-1, 0, 1]]})";
  for (int i = 0; i < 40; ++i)
    blocks += fmt::format(R"(, {{"outer": [[{0}, 0, 1], [{1}, 0, 1], [{1}, 0.9, 1], [{0}, 0.9, 1]]}})", i, i + 0.9);
  blocks += R"(, {"outer": [[42, 0, 1], [42.2, 0, 1], [42.2, 0.2, 1], [42, 0.2, 1]]})";
  return R"({"keyblock": 2, "blocks": {"blocks": [)" + blocks + R"(],
   "fixed_points": [[0, -0.5, 1], [40, -0.5, 1]]},
   "analysis": {"step_count": 4, "time_step": 0.5, "gravity": 9.81,
   "allowed_displacement_ratio": 10, "block_materials": [{"density": 2500, "youngs_modulus": 5e9}],
   "joint_materials": [{"friction_angle_deg": 40}]}})";
}

/// The folder of a run, its field.svg of `field`; from a template or a case.
std::string run_of(const std::string& kind, const std::string& field, const std::string& case_text = "",
                   const std::string& frames = "raw") {
  const std::string folder = fresh_folder("plot_" + kind + field);
  if (case_text.empty()) {
    EXPECT_EQ(run_keyblock({"new", kind, "-o", folder + "/case.json"}).exit_code, 0);
  } else {
    write_text(folder + "/case.json", case_text);
  }
  std::vector<std::string> words{
      "run", folder + "/case.json", "-o", folder + "/out", "--record-every", "2", "--field", field, "--frames", frames};
  if (kind != "tunnel" && case_text.empty()) words.insert(words.end(), {"--set", "steps=4"});
  const ProgramRun run = run_keyblock(words);
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  return folder + "/out";
}

void expect_same_picture(const std::string& out, const std::string& field) {
  const ProgramRun plot = run_keyblock({"plot", out, "--field", field, "--json"});
  EXPECT_EQ(plot.exit_code, 0) << plot.messages;
  const auto told = nlohmann::json::parse(plot.output);
  EXPECT_EQ(told.at("field"), field);
  EXPECT_EQ(without_marks(read_text(told.at("file"))), without_marks(read_text(out + "/field.svg")))
      << out << ", " << field;
}

}  // namespace

TEST(PlotCommand, what_it_draws_is_what_the_run_drew) {
  for (const char* kind : {"slope", "beam", "tunnel"})
    for (const char* field : {"s1", "displacement", "crosses"}) expect_same_picture(run_of(kind, field), field);
}

TEST(PlotCommand, holes_and_blocks_left_out_are_those_of_the_run) {
  expect_same_picture(run_of("hole", "displacement", kPlateWithHole), "displacement");
  const std::string out = run_of("far", "s3", with_a_small_block_that_falls());
  EXPECT_TRUE(contains(read_text(out + "/field.svg"), "1 small block lies outside of the picture"));
  expect_same_picture(out, "s3");
}

TEST(PlotCommand, the_frame_of_a_step_may_be_chosen) {
  const std::string out = run_of("slope", "s3");
  EXPECT_EQ(run_keyblock({"plot", out, "--field", "s3", "--step", "2"}).exit_code, 0);
  EXPECT_NE(read_text(out + "/field_s3_2.svg"), read_text(out + "/field.svg"));
  const ProgramRun none = run_keyblock({"plot", out, "--step", "3"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(contains(none.messages, "there is no frame of step 3 in ")) << none.messages;
  EXPECT_TRUE(contains(none.messages, "of the 3 there are, of steps 0 to 4, that of step 2 is the nearest"));
}

// The scale of displacements and the numbers on the bar are those of all steps; with --own-scale those of the step.
TEST(PlotCommand, pictures_of_steps_make_a_film) {
  const std::string out = run_of("block", "s3");
  const auto scale_of = [&](const std::string& step, const std::vector<std::string>& more) {
    std::vector<std::string> words{"plot", out,  "--field",      "displacement", "--step",
                                   step,   "-o", out + "/x.svg", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_keyblock(words).exit_code, 0);
    const std::string svg = read_text(out + "/x.svg");
    std::string scale = svg.substr(svg.find("displacement ×"), 20);
    const std::regex number("font-size=\"11\"[^>]*>([^<]*)</text>");
    for (std::sregex_iterator i(svg.begin(), svg.end(), number), end; i != end; ++i) scale += " " + (*i)[1].str();
    return scale;
  };
  EXPECT_EQ(scale_of("2", {}), scale_of("4", {}));
  EXPECT_NE(scale_of("2", {"--own-scale"}), scale_of("4", {"--own-scale"}));
  EXPECT_EQ(run_keyblock({"plot", out, "--own-scale"}).exit_code, 2);
}

TEST(PlotCommand, nothing_is_overwritten_unless_told) {
  const std::string out = run_of("slope", "sxx");
  const std::string before = read_text(out + "/field.svg");
  EXPECT_EQ(run_keyblock({"plot", out, "-o", out + "/field.svg", "--field", "syy"}).exit_code, 2);
  EXPECT_EQ(read_text(out + "/field.svg"), before);
  EXPECT_EQ(run_keyblock({"plot", out, "-o", out + "/field.svg", "--field", "syy", "--force"}).exit_code, 0);
  EXPECT_NE(read_text(out + "/field.svg"), before);
}

// Frames, record and tables cannot be made again: not even --force replaces them by a picture.
TEST(PlotCommand, what_the_run_left_is_never_replaced) {
  const std::string out = run_of("slope", "sxy");
  for (const char* name : {"/frames/00000004.vtu", "/run.json", "/history.csv"}) {
    const std::string before = read_text(out + name);
    EXPECT_EQ(run_keyblock({"plot", out, "-o", out + name, "--force"}).exit_code, 2) << name;
    EXPECT_EQ(read_text(out + name), before) << name;
  }
}

TEST(PlotCommand, what_is_no_run_or_no_frame_is_an_error_at_its_place) {
  const std::string empty = fresh_folder("plot_empty");
  const ProgramRun none = run_keyblock({"plot", empty});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(contains(none.messages, "expected the folder of a run, with frames/*.vtu, found none")) << none.messages;
  const std::string out = run_of("slope", "syy", "", "text");
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
  EXPECT_TRUE(contains(refused("<VTKFile/>"), "of a frame that a run wrote (.vtu), found none"));
  std::string odd = good;
  const std::size_t array = odd.find("Name=\"stress_yy");
  odd.replace(odd.find('\n', array) + 1, 1, "x");
  const std::string messages = refused(odd);
  EXPECT_TRUE(contains(messages, "00000004.vtu:")) << messages;
  EXPECT_TRUE(contains(messages, "expected a finite number in the array stress_yy, found \"x")) << messages;
  std::string far = good;
  const std::size_t order = far.find("Name=\"connectivity");
  far.insert(far.find('\n', order) + 1, "999999999 ");
  EXPECT_TRUE(contains(refused(far), "in the array connectivity"));
}

TEST(PlotCommand, endings_other_than_those_of_pictures_are_refused) {
  const std::string out = run_of("slope", "sxx");
  const ProgramRun plot = run_keyblock({"plot", out, "-o", out + "/x.eps"});
  EXPECT_EQ(plot.exit_code, 2);
  EXPECT_TRUE(contains(plot.messages, "expected a name that ends in .svg, .pdf or .png, found " + out + "/x.eps"))
      << plot.messages;
  EXPECT_FALSE(std::filesystem::exists(out + "/x.eps"));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"cut", "a.geo", "--svg", "a.eps"},
                                                {"tradeoff", out, "--picture", "a.gif"},
                                                {"fit", "a.csv", "--svg", "a.jpg"},
                                                {"cut", "a.geo", "-o", "a.svg"},
                                                {"fit", "a.csv", "-o", "a.PNG"}}) {
    const ProgramRun run = run_keyblock(words);
    EXPECT_EQ(run.exit_code, 2) << run.messages;
    EXPECT_FALSE(std::filesystem::exists(words.back()));
  }
}

// A run that was killed has no record: its frames name the units.
TEST(PlotCommand, a_run_without_a_record_has_the_units_of_its_frames) {
  const std::string out = run_of("slope", "s3");
  const std::regex unit(">σ3 \\[[kM]?Pa\\]<");
  ASSERT_TRUE(std::regex_search(read_text(out + "/field.svg"), unit));
  std::filesystem::remove(out + "/run.json");
  ASSERT_EQ(run_keyblock({"plot", out, "--field", "s3", "-o", out + "/killed.svg"}).exit_code, 0);
  const std::string picture = read_text(out + "/killed.svg");
  EXPECT_TRUE(std::regex_search(picture, unit)) << "the unit of stress";
  EXPECT_TRUE(contains(picture, " m<")) << "that of the scale bar";
  EXPECT_TRUE(contains(picture, " s<")) << "and that of the title's time";
}

TEST(PlotCommand, numbers_of_blocks_are_those_of_the_tables) {
  const std::string out = run_of("far", "s1", with_a_small_block_that_falls());
  ASSERT_EQ(run_keyblock({"plot", out, "--field", "s1", "--numbers", "-o", out + "/n.svg"}).exit_code, 0);
  const std::string picture = read_text(out + "/n.svg");
  EXPECT_TRUE(contains(picture, ">42 blocks; 1 is too small for its number<")) << "42, which fell";
  for (const char* number : {">2<", ">41<"}) EXPECT_TRUE(contains(picture, number)) << number;
  EXPECT_FALSE(contains(picture, ">42<"));
}

}  // namespace keyblock::plot_command_test
