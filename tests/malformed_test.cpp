// The malformed inputs that crashed the Berkeley program each get the error or the named warning of the table, from the
// program itself, in little time and memory.
// The places, sentences and warning names of the table are Keyblock's own wording, copied from its output after a
// reading: they guard against change. Only `final_dy` comes from elsewhere (the Berkeley program, or free fall). Four
// accepted inputs have none: 00_control_orig, 10_crlf_orig, 08_open_polygon_xml, 11_fixed_outside_xml.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::malformed_test {
namespace {

const std::string kFolder = std::string(KEYBLOCK_SOURCE_DIR) + "/tests/malformed/";

#if defined(__SANITIZE_ADDRESS__)
constexpr double kMostMegabytes = 1e9;  // the sanitizer's own memory is not the program's
constexpr double kMostSeconds = 20;
#else
constexpr double kMostMegabytes = 100;
constexpr double kMostSeconds = 1;
#endif

/// A row of expected.csv.
struct Expectation {
  std::string input;
  std::string outcome;  ///< ok, warning or error
  std::string place;    ///< of the error or warning; empty: anywhere
  std::string says;     ///< part of the error's sentence, or the names of the warnings, separated by blanks
  double final_dy = 0;  ///< of the measured point: the right result
  bool has_result = false;
};

std::vector<Expectation> expectations() {
  const formats::CsvTable table = formats::read_csv(formats::load(kFolder + "expected.csv"));
  const auto column = [&](const char* name) { return formats::csv_column(table, name); };
  std::vector<Expectation> rows;
  for (const formats::CsvRow& row : table.rows) {
    Expectation e{row.cells[column("input")],
                  row.cells[column("outcome")],
                  row.cells[column("place")],
                  row.cells[column("says")],
                  0,
                  !row.cells[column("final_dy")].empty()};
    if (e.has_result) e.final_dy = formats::csv_real(table, row, column("final_dy"));
    rows.push_back(std::move(e));
  }
  return rows;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_error(const Expectation& row, const support::ProgramRun& run) {
  EXPECT_EQ(run.exit_code, 3) << run.messages;
  EXPECT_TRUE(contains(run.messages, kFolder + row.place + ": error: ")) << run.messages;
  EXPECT_TRUE(contains(run.messages, row.says)) << run.messages;
  EXPECT_EQ(run.output, "");
}

void expect_warnings(const Expectation& row, const support::ProgramRun& run) {
  EXPECT_EQ(run.exit_code, 0) << run.messages;
  const auto record = nlohmann::json::parse(run.output);
  std::string names;
  for (const auto& warning : record["warnings"]) {
    names += (names.empty() ? "" : " ") + warning["name"].get<std::string>();
    if (!row.place.empty()) {
      EXPECT_TRUE(contains(warning["first"], kFolder + row.place + ": ")) << warning["first"];
    }
  }
  EXPECT_EQ(names, row.says);
}

// The last dy of the measured point. It is that of the Berkeley program on the same scene without the fault (its
// tables, nine digits), on the faulty input if it was right there, or free fall.
void expect_result(const Expectation& row, const std::string& folder) {
  const formats::CsvTable history = formats::read_csv(formats::load(folder + "/history.csv"));
  // Behind the name stands the unit that the case declares.
  const auto column =
      std::ranges::find_if(history.header, [](const std::string& heading) { return heading.starts_with("dy1 ["); });
  ASSERT_NE(column, history.header.end());
  const double dy =
      formats::csv_real(history, history.rows.back(), static_cast<std::size_t>(column - history.header.begin()));
  EXPECT_NEAR(dy, row.final_dy, 1e-5 * std::abs(row.final_dy)) << "measured point";
}

struct HostileRow {
  std::string input;
  std::string command;  ///< check, run (profile legacy), standard (run under it), cut, fit or joints
  std::string outcome;  ///< warning, error, doubt (a run that ends with 1), or ok (no message)
  std::string place;    ///< line and column; empty: the file
  std::string says;     ///< part of the sentence
};

std::vector<HostileRow> hostile_rows() {
  const formats::CsvTable table = formats::read_csv(formats::load(kFolder + "hostile/expected.csv"));
  std::vector<HostileRow> rows;
  for (const formats::CsvRow& row : table.rows)
    rows.push_back({row.cells[0], row.cells[1], row.cells[2], row.cells[3], row.cells[4]});
  return rows;
}

support::ProgramRun run_hostile(const HostileRow& row, const std::string& out) {
  const std::string input = kFolder + "hostile/" + row.input;
  // `check` does not decide if a run would end well.
  if (row.command == "check") return support::run_keyblock({"check", input, "--trial", "0"});
  if (row.command == "cut") return support::run_keyblock({"cut", input, "-o", out});
  if (row.command == "fit") return support::run_keyblock({"fit", input});
  if (row.command == "standard") return support::run_keyblock({"run", input, "-o", out, "--profile", "standard"});
  if (row.command == "joints") return support::run_keyblock({"joints", input, "-o", out});
  return support::run_keyblock({"run", input, "-o", out, "--profile", "legacy"});
}

bool has_control_characters(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; });
}

}  // namespace

// Numbers, places and shapes that no engineer writes, but programs may. Each crashed, hung, gave nothing or was ignored
// without a message before. The table is Keyblock's own wording, as that beside it.
TEST(Malformed, hostile_inputs_are_refused_or_named_at_their_place) {
  const std::vector<HostileRow> rows = hostile_rows();
  ASSERT_GE(rows.size(), 60U);
  for (const HostileRow& row : rows) {
    SCOPED_TRACE(row.command + " " + row.input);
    const std::string out = support::fresh_folder("hostile") + "/out";
    const support::ProgramRun run = run_hostile(row, out);
    const bool is_error = row.outcome == "error";
    const std::string file = kFolder + "hostile/" + row.input + (row.place.empty() ? "" : ":") + row.place;
    const bool is_doubted = row.outcome == "doubt";
    EXPECT_EQ(run.exit_code, is_error ? 3 : is_doubted ? 1 : 0) << run.messages;
    const std::string all = run.messages + run.output;
    if (row.outcome != "ok") {
      const bool is_named = is_error ? contains(all, file + ": error: expected ")
                                     : contains(all, file + ": warning: ") || contains(all, file + ": note: ") ||
                                           contains(all, file + ": error: ");
      EXPECT_TRUE(is_named) << all;
    }
    EXPECT_TRUE(contains(all, row.says)) << all;
    EXPECT_FALSE(has_control_characters(all)) << all;
    EXPECT_FALSE(is_error && std::filesystem::exists(out)) << "nothing is written for input that cannot be used";
    EXPECT_LT(run.cpu_seconds, kMostSeconds);
    EXPECT_LT(run.peak_megabytes, kMostMegabytes);
  }
}

TEST(Malformed, every_input_gets_the_answer_of_the_table_quickly_and_in_little_memory) {
  const std::vector<Expectation> rows = expectations();
  ASSERT_EQ(rows.size(), 50U);
  for (const Expectation& row : rows) {
    SCOPED_TRACE(row.input);
    const std::string folder = support::fresh_folder("malformed") + "/out";
    const std::string input = kFolder + row.input;
    const support::ProgramRun run =
        support::run_keyblock({"run", input + ".geo", input + ".ana", "-o", folder, "--profile", "legacy", "--json"});
    EXPECT_LT(run.cpu_seconds, kMostSeconds);
    EXPECT_LT(run.peak_megabytes, kMostMegabytes);
    if (row.outcome == "error") {
      expect_error(row, run);
      EXPECT_FALSE(std::filesystem::exists(folder)) << "nothing is written for input that cannot be read";
    } else {
      expect_warnings(row, run);
      if (row.has_result) expect_result(row, folder);
    }
  }
}

}  // namespace keyblock::malformed_test
