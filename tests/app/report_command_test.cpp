// Reports of runs: the printed values equal the record, and damaged folders give an error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::report_command_test {
namespace {

namespace fs = std::filesystem;
using support::contains;
using support::fresh_folder;
using support::ProgramRun;
using support::read_text;
using support::run_keyblock;
using support::write_text;

/// The folder of a run of the template of a sliding block, whose case has `name` as the name of its rock.
std::string run_of_block(const std::string& folder, const std::string& name = "rock") {
  const std::string file = folder + "/block.json";
  run_keyblock({"new", "block", "-o", file});
  std::string text = read_text(file);
  for (std::size_t at = text.find("\"rock\""); at != std::string::npos; at = text.find("\"rock\"", at + name.size()))
    text.replace(at, 6, "\"" + name + "\"");
  write_text(file, text);
  EXPECT_EQ(run_keyblock({"run", file, "-o", folder + "/out"}).exit_code, 0);
  return folder + "/out";
}

TEST(ReportCommand, a_run_becomes_a_page_with_verdict_results_materials_and_checksums) {
  const std::string out = run_of_block(fresh_folder("report_run"), "a <b> & c");
  const ProgramRun made = run_keyblock({"report", out, "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.messages;
  const std::string page = read_text(out + "/report.html");
  const auto record = nlohmann::json::parse(read_text(out + "/run.json"));
  EXPECT_TRUE(contains(page, "class=\"verdict doubtful\""));
  EXPECT_TRUE(contains(page, record["inputs"][0]["sha256"].get<std::string>()));
  EXPECT_TRUE(contains(page, record["outcome"]["motion"]["sentences"][0].get<std::string>().substr(1)));
  EXPECT_TRUE(contains(page, "<td>a &lt;b&gt; &amp; c</td>"));
  EXPECT_FALSE(contains(page, "<b>"));
  EXPECT_TRUE(contains(page, "<td>20°</td>"));
  EXPECT_TRUE(contains(page, "data:image/svg+xml;base64,"));
  EXPECT_FALSE(contains(page, "http://") || contains(page, "https://") || contains(page, "<script"));
  EXPECT_EQ(nlohmann::json::parse(made.output)["file"], out + "/report.html");
}

TEST(ReportCommand, an_existing_page_stays_unless_force_says_otherwise) {
  const std::string out = run_of_block(fresh_folder("report_force"));
  write_text(out + "/report.html", "mine");
  EXPECT_EQ(run_keyblock({"report", out}).exit_code, 2);
  EXPECT_EQ(read_text(out + "/report.html"), "mine");
  EXPECT_EQ(run_keyblock({"report", out, "--force"}).exit_code, 0);
  EXPECT_TRUE(contains(read_text(out + "/report.html"), "<!doctype html>"));
  EXPECT_EQ(run_keyblock({"report", out, "-o", out + "/report.pdf"}).exit_code, 2);
}

TEST(ReportCommand, materials_of_a_changed_file_are_not_listed) {
  const std::string folder = fresh_folder("report_changed");
  const std::string out = run_of_block(folder);
  write_text(folder + "/block.json", read_text(folder + "/block.json") + "\n");
  ASSERT_EQ(run_keyblock({"report", out}).exit_code, 0);
  const std::string page = read_text(out + "/report.html");
  EXPECT_TRUE(contains(page, "Not listed: "));
  EXPECT_FALSE(contains(page, "<td>20°</td>"));
}

TEST(ReportCommand, a_run_that_failed_is_reported_as_failed_with_its_reason) {
  const std::string folder = fresh_folder("report_failed");
  run_keyblock({"new", "block", "-o", folder + "/block.json"});
  EXPECT_EQ(run_keyblock({"run", folder + "/block.json", "--set", "motion=static", "-o", folder + "/out"}).exit_code,
            4);
  ASSERT_EQ(run_keyblock({"report", folder + "/out"}).exit_code, 0);
  const std::string page = read_text(folder + "/out/report.html");
  EXPECT_TRUE(contains(page, "class=\"verdict bad\""));
  EXPECT_TRUE(contains(page, "no equilibrium: block 2 accelerates"));
}

TEST(ReportCommand, a_folder_of_runs_becomes_a_table_with_a_section_for_each) {
  const std::string folder = fresh_folder("report_archive");
  fs::create_directories(folder + "/a");
  run_of_block(folder + "/a");
  fs::copy(folder + "/a/out", folder + "/b", fs::copy_options::recursive);
  ASSERT_EQ(run_keyblock({"report", folder, "-o", folder + "/all.html"}).exit_code, 0);
  const std::string page = read_text(folder + "/all.html");
  EXPECT_TRUE(contains(page, "2 runs: 0 trusted and at rest, 2 still moving or not at their end, 0 not trusted."));
  EXPECT_TRUE(contains(page, "<td>a/out</td>"));
  EXPECT_TRUE(contains(page, "<h2>b</h2>"));
}

TEST(ReportCommand, folders_without_a_run_and_damaged_records_are_input_errors) {
  const std::string folder = fresh_folder("report_damaged");
  EXPECT_EQ(run_keyblock({"report", folder}).exit_code, 3);
  write_text(folder + "/run.json", "{\"outcome\": ");
  const ProgramRun made = run_keyblock({"report", folder});
  EXPECT_EQ(made.exit_code, 3);
  EXPECT_TRUE(contains(made.messages, "expected the record of a run (JSON), found another file")) << made.messages;
  for (const char* odd :
       {R"({"outcome": 3})", R"({"outcome": {"motion": {"sentences": [3, null, ""]}}, "stages": [1, {"steps": 2}],
      "warnings": [{"name": 4}], "inputs": [{"file": 1}], "settings": [1], "ledger": {"end": 4}})"}) {
    write_text(folder + "/run.json", odd);
    const int code = run_keyblock({"report", folder, "--force"}).exit_code;
    EXPECT_TRUE(code == 0 || code == 3) << code << odd;
  }
  EXPECT_EQ(run_keyblock({"report", folder + "/none"}).exit_code, 2);
}

TEST(PlotCurves, columns_of_the_tables_are_drawn_over_time_or_another_column) {
  const std::string out = run_of_block(fresh_folder("plot_curves"));
  ASSERT_EQ(run_keyblock({"plot", out, "--curve", "dx1,dy1"}).exit_code, 0);
  const std::string picture = read_text(out + "/curve_dx1.svg");
  EXPECT_TRUE(contains(picture, ">dx1<"));
  EXPECT_TRUE(contains(picture, ">time [s]<"));
  ASSERT_EQ(run_keyblock({"plot", out, "--curve", "kinetic", "--against", "dx1", "-o", out + "/k.svg", "--width", "84"})
                .exit_code,
            0);
  EXPECT_TRUE(contains(read_text(out + "/k.svg"), "width=\"84mm\""));
  const ProgramRun two_units = run_keyblock({"plot", out, "--curve", "dx1,kinetic", "-o", out + "/two.svg"});
  EXPECT_EQ(two_units.exit_code, 2);
  EXPECT_TRUE(contains(two_units.messages, "expected curves of one unit")) << two_units.messages;
  const ProgramRun unknown = run_keyblock({"plot", out, "--curve", "kinetik", "-o", out + "/none.svg"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.messages, "did you mean \"kinetic\"?")) << unknown.messages;
}

TEST(PlotCurves, pdf_and_png_are_written_where_their_converter_is_installed) {
  if (std::system("command -v rsvg-convert >/dev/null 2>&1") != 0) GTEST_SKIP() << "rsvg-convert is not installed";
  const std::string out = run_of_block(fresh_folder("plot_formats"));
  ASSERT_EQ(run_keyblock({"plot", out, "--curve", "dx1", "-o", out + "/a.pdf", "--width", "84"}).exit_code, 0);
  EXPECT_TRUE(read_text(out + "/a.pdf").starts_with("%PDF-"));
  ASSERT_EQ(run_keyblock({"plot", out, "--field", "displacement", "-o", out + "/a.png"}).exit_code, 0);
  EXPECT_TRUE(read_text(out + "/a.png").starts_with("\x89PNG"));
}

}  // namespace
}  // namespace keyblock::report_command_test
