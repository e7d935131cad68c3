// The malformed inputs that brought Berkeley's program down each get the error or the named warning of the table.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "formats/case.hpp"

namespace keyblock {
namespace {

const std::string kFolder = std::string(KEYBLOCK_SOURCE_DIR) + "/tests/malformed/";

/// A row of expected.csv. `place` and `says` may be empty: anything will do.
struct Expectation {
  std::string input, stage, outcome, place, says;
};

/// Fields of a line, quoted ones with "" for a quote.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line.substr(i, 2) == "\"\"")
      fields.back() += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

std::vector<Expectation> expectations() {
  std::ifstream table(kFolder + "expected.csv");
  std::vector<Expectation> rows;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    const auto fields = fields_of(line);
    rows.push_back({fields.at(0), fields.at(1), fields.at(2), fields.at(3), fields.at(4)});
  }
  return rows;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_error(const Expectation& row, const InputError& error) {
  EXPECT_EQ(row.outcome, "error") << error.what();
  EXPECT_EQ(to_string(error.place()), kFolder + row.place);
  EXPECT_TRUE(contains(error.sentence(), row.says)) << error.sentence();
}

void expect_warnings(const Expectation& row, const Warnings& warnings) {
  EXPECT_NE(row.outcome, "error") << "it was read without error";
  const auto is_expected = [&](const Warning& w) {
    return w.name == row.says && to_string(w.place) == kFolder + row.place;
  };
  if (row.outcome == "ok") {
    EXPECT_EQ(warnings, Warnings{});
  } else {
    EXPECT_EQ(std::ranges::count_if(warnings, is_expected), 1);
  }
}

}  // namespace

TEST(Malformed, inputs_that_the_readers_judge_get_the_answer_of_the_table) {
  ASSERT_EQ(expectations().size(), 45u);
  for (const Expectation& row : expectations()) {
    if (row.stage != "read") continue;
    SCOPED_TRACE(row.input);
    try {
      expect_warnings(
          row, formats::load_case({kFolder + row.input + ".geo", kFolder + row.input + ".ana"}).warnings);
    } catch (const InputError& error) {
      expect_error(row, error);
    }
  }
}

TEST(Malformed, inputs_that_the_cutter_judges_are_read) {
  for (const Expectation& row : expectations()) {
    if (row.stage != "cut") continue;
    EXPECT_NO_THROW(formats::load_case({kFolder + row.input + ".geo", kFolder + row.input + ".ana"}))
        << row.input;
  }
}

}  // namespace keyblock
