// Reports of runs: the printed values equal the record, and damaged folders give an error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

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
  EXPECT_TRUE(contains(page, "2 results: 2 still moving."));
  EXPECT_TRUE(contains(page, "<td>a/out</td>"));
  EXPECT_TRUE(contains(page, "<h2>b</h2>"));
  EXPECT_TRUE(contains(page, "<li class=\"card doubtful\" data-state=\"still moving\"><a href=\"#a/out\">"));
  EXPECT_TRUE(contains(page, "<span>standard: 0.906 m after 100 steps</span>"));
}

TEST(ReportCommand, an_archive_tells_states_apart_and_keeps_warnings_and_broken_records) {
  const std::string folder = fresh_folder("report_states");
  const std::string file = folder + "/block.json", runs = folder + "/runs";
  run_keyblock({"new", "block", "-o", file});
  run_keyblock({"run", file, "-o", runs + "/moves"});
  run_keyblock({"run", file, "-o", runs + "/stops", "--history", "a=block:2", "--stop-when", "a.d>0.01"});
  run_keyblock({"run", file, "-o", runs + "/fails", "--set", "motion=static"});
  fs::create_directories(runs + "/breaks");
  write_text(runs + "/breaks/run.json", "{\"outcome\": ");
  const ProgramRun made = run_keyblock({"report", runs, "-o", folder + "/all.html"});
  EXPECT_EQ(made.exit_code, 1) << made.messages;
  EXPECT_TRUE(contains(made.messages, runs + "/breaks/run.json: error: expected the record of a run")) << made.messages;
  const std::string page = read_text(folder + "/all.html");
  EXPECT_TRUE(contains(page, "4 results: 1 still moving, 1 stopped early, 1 failed, 1 record broken."));
  EXPECT_TRUE(contains(page, "<li class=\"card bad\" data-state=\"record broken\"><a href=\"#breaks\">"));
  EXPECT_TRUE(contains(page, "The record cannot be read: "));
  EXPECT_TRUE(contains(page, "The run was stopped before its end: "));
  EXPECT_TRUE(contains(page, "<option>still moving</option>\n<option>stopped early</option>\n<option>failed</option>"));
  const std::size_t section = page.find("<h2>moves</h2>");
  ASSERT_NE(section, std::string::npos);
  EXPECT_TRUE(contains(page.substr(section, page.find("</section>", section) - section), "defaults taken: "));
}

TEST(ReportCommand, materials_have_the_values_that_were_changed_after_reading) {
  const std::string folder = fresh_folder("report_values");
  run_keyblock({"new", "block", "-o", folder + "/block.json"});
  const std::string change = "/analysis/joint_materials/0/friction_angle_deg=25.5";
  run_keyblock({"run", folder + "/block.json", "-o", folder + "/out", "--at", change});
  run_keyblock({"report", folder + "/out"});
  EXPECT_TRUE(contains(read_text(folder + "/out/report.html"), "<td>25.5°</td>"));
}

TEST(ReportCommand, answers_of_both_profiles_share_a_card) {
  const std::string folder = fresh_folder("report_both");
  run_keyblock({"new", "block", "-o", folder + "/block.json"});
  ASSERT_EQ(run_keyblock({"run", folder + "/block.json", "--both", "-o", folder + "/runs/block"}).exit_code, 0);
  ASSERT_EQ(run_keyblock({"report", folder + "/runs", "-o", folder + "/all.html", "--json"}).exit_code, 0);
  const std::string page = read_text(folder + "/all.html");
  const std::size_t first = page.find("<li class=\"card");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(page.find("<li class=\"card", first + 1), std::string::npos) << "one card";
  EXPECT_TRUE(contains(page, "<span>legacy: ") && contains(page, "<span>standard: "));
}

TEST(ReportCommand, frames_that_are_damaged_or_gone_are_reported_with_exit_code_1) {
  const std::string folder = fresh_folder("report_frames");
  const std::string out = run_of_block(folder);
  const std::string frame = out + "/frames/00000100.vtu", whole = read_text(frame);
  write_text(frame, whole.substr(0, whole.size() / 2));
  ProgramRun made = run_keyblock({"report", out, "-o", folder + "/cut.html"});
  EXPECT_EQ(made.exit_code, 1) << made.messages;
  EXPECT_TRUE(contains(made.messages, "cannot be read; the first: ")) << made.messages;
  EXPECT_TRUE(
      contains(read_text(folder + "/cut.html"), "class=\"verdict bad\">The results in this folder are damaged: "));
  EXPECT_EQ(run_keyblock({"report", folder, "-o", folder + "/archive.html"}).exit_code, 1);
  fs::remove(frame);
  made = run_keyblock({"report", out, "-o", folder + "/gone.html"});
  EXPECT_EQ(made.exit_code, 1) << made.messages;
  EXPECT_TRUE(contains(made.messages, "1 file of its results is gone; the first: frames/00000100.vtu"))
      << made.messages;
  made = run_keyblock({"view", out, "-o", folder + "/page.html"});
  EXPECT_EQ(made.exit_code, 1) << made.messages;
  EXPECT_TRUE(contains(made.messages, "frames/00000100.vtu; the page shows what is there")) << made.messages;
}

TEST(ReportCommand, tables_that_are_not_as_the_run_wrote_them_are_reported_with_exit_code_1) {
  const std::string folder = fresh_folder("report_altered");
  const std::string out = run_of_block(folder);
  const std::string history = read_text(out + "/history.csv");
  write_text(out + "/history.csv", history.substr(0, history.size() / 2));
  const std::string words = "1 file of its results is not as the run wrote them; the first: history.csv";
  for (const char* command : {"report", "view"}) {
    const ProgramRun made = run_keyblock({command, out, "-o", folder + "/" + command + ".html"});
    EXPECT_EQ(made.exit_code, 1) << made.messages;
    EXPECT_TRUE(contains(made.messages, words)) << made.messages;
  }
  EXPECT_TRUE(contains(read_text(folder + "/report.html"), words));
}

TEST(ReportCommand, a_record_that_is_none_makes_no_page) {
  const std::string folder = fresh_folder("report_no_record");
  const std::string out = run_of_block(folder);
  write_text(out + "/run.json", "{}");
  const ProgramRun made = run_keyblock({"view", out, "-o", folder + "/page.html"});
  EXPECT_EQ(made.exit_code, 3) << made.messages;
  EXPECT_FALSE(fs::exists(folder + "/page.html"));
}

TEST(ReportCommand, jobs_of_a_sweep_are_no_results_of_an_archive) {
  const std::string folder = fresh_folder("report_sweep");
  const std::string out = run_of_block(folder);
  ASSERT_EQ(
      run_keyblock({"sweep", folder + "/block.json", "--over", "/analysis/joint_materials/0/friction_angle_deg=20,40",
                    "--out", "displacement", "-o", folder + "/sweep"})
          .exit_code,
      0);
  const ProgramRun made = run_keyblock({"report", folder, "-o", folder + "/all.html"});
  EXPECT_TRUE(contains(made.messages, ": 1 result: 1 still moving")) << made.messages;
  EXPECT_FALSE(contains(read_text(folder + "/all.html"), "sweep/jobs"));
}

TEST(ReportCommand, contacts_units_and_checksums_are_listed_and_quirks_are_not) {
  const std::string folder = fresh_folder("report_sections");
  const std::string out = run_of_block(folder);
  ASSERT_EQ(run_keyblock({"report", out, "--project", "Pass <road>"}).exit_code, 0);
  const std::string page = read_text(out + "/report.html");
  EXPECT_TRUE(contains(page, "<dt>Project</dt><dd>Pass &lt;road&gt;</dd>"));
  EXPECT_TRUE(contains(page, "<dt>Computed</dt><dd>"));
  EXPECT_TRUE(contains(page, "Contacts by joint material in the last recorded frame, step 100."));
  EXPECT_TRUE(contains(page, "<td>m, kg, s; force N/m, stress Pa</td>") || contains(page, "m, kg, s; force"));
  EXPECT_TRUE(contains(page, "<td>ledger.csv</td><td>result</td><td class=\"code\">"));
  EXPECT_FALSE(contains(page, "quirk."));
}

TEST(ReportCommand, a_factor_of_safety_has_a_report_and_a_page) {
  const std::string folder = fresh_folder("report_fos");
  run_keyblock({"new", "block", "-o", folder + "/block.json"});
  run_keyblock({"fos", folder + "/block.json", "-o", folder + "/fos"});
  ASSERT_EQ(run_keyblock({"report", folder + "/fos"}).exit_code, 0);
  const auto record = nlohmann::json::parse(read_text(folder + "/fos/fos.json"));
  const std::string page = read_text(folder + "/fos/report.html");
  EXPECT_TRUE(contains(page, "class=\"verdict bad\">Factor of safety 0.6"));
  EXPECT_TRUE(contains(page, "<td>factor of safety</td>"));
  EXPECT_TRUE(contains(page, "largest displacement [m]"));
  EXPECT_TRUE(contains(page, "<h2>Materials</h2>") && contains(page, "<td>20°</td>"));
  EXPECT_TRUE(contains(page, "<td>2350 kg/m³</td><td>2305")) << "2350 kg/m³ times 9.81 m/s² is 23053.5 N/m³";
  EXPECT_TRUE(contains(page, record["inputs"][0]["sha256"].get<std::string>()));
  EXPECT_TRUE(contains(page, "<td>trials.csv</td><td>result</td><td class=\"code\">"));
  EXPECT_EQ(run_keyblock({"view", folder + "/fos", "-o", folder + "/page.html"}).exit_code, 0);
  EXPECT_TRUE(contains(read_text(folder + "/page.html"), "Trials"));
}

TEST(ReportCommand, a_report_becomes_pdf_where_a_browser_is_installed) {
  const std::string out = run_of_block(fresh_folder("report_pdf"));
  setenv("CHROMIUM", "/none/chromium", 1);
  const ProgramRun missing = run_keyblock({"report", out, "--pdf"});
  unsetenv("CHROMIUM");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(contains(missing.messages, "--pdf needs a browser that prints, and none is installed"));
  EXPECT_TRUE(fs::exists(out + "/report.html"));
  EXPECT_FALSE(fs::exists(out + "/report.pdf"));
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
  for (const char* empty : {",", "dx1,", ",dx1"})
    EXPECT_EQ(run_keyblock({"plot", out, "--curve", empty, "-o", out + "/empty.svg"}).exit_code, 2) << empty;
  EXPECT_FALSE(fs::exists(out + "/empty.svg"));
  const ProgramRun unknown = run_keyblock({"plot", out, "--curve", "kinetik", "-o", out + "/none.svg"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.messages, "did you mean \"kinetic\"?")) << unknown.messages;
}

/// Letters of a picture, in points of print.
double least_letter(const std::string& svg) {
  const auto number_behind = [&](const char* name, std::size_t from = 0) {
    const std::size_t at = svg.find(name, from);
    return std::pair(at, at == std::string::npos ? 0.0 : std::stod(svg.substr(at + std::string(name).size())));
  };
  const double millimetres = number_behind("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").second;
  const std::size_t box = svg.find("viewBox=\"0 0 ");
  const double wide = std::stod(svg.substr(box + 13));
  double least = 1e9;
  for (auto [at, size] = number_behind("font-size=\""); at != std::string::npos;
       std::tie(at, size) = number_behind("font-size=\"", at + 1))
    least = std::min(least, size);
  return least * millimetres / wide * 72 / 25.4;
}

TEST(PlotCommand, letters_of_a_narrow_picture_are_readable_in_print) {
  const std::string out = run_of_block(fresh_folder("plot_letters"));
  for (const char* width : {"84", "120", "170"})
    for (const char* field : {"displacement", "s1", "crosses"}) {
      const std::string file = out + "/" + field + width + ".svg";
      ASSERT_EQ(run_keyblock({"plot", out, "--field", field, "--width", width, "-o", file}).exit_code, 0);
      EXPECT_GE(least_letter(read_text(file)), 6) << file;
    }
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
