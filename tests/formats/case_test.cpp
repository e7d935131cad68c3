// Files of a case are paired in any order; files without a partner are reported.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/formats/dxf_samples.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::case_test {
namespace {

/// A folder of its own for each test, removed at its end.
class CaseFiles : public testing::Test {
 protected:
  CaseFiles() : folder_(std::filesystem::temp_directory_path() / ("keyblock_case_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~CaseFiles() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }

 private:
  std::filesystem::path folder_;
};

const std::string kGeometry = "0.01 1 0 0 0 2 1 0 0\n0 0 1 0 1\n.1 0 .1 0\n.2 0 .2 0\n.5 0\n";
const std::string kShi =
    "1 20 1 1 .006 .01 1e7\n0 2 2\n0 0 0 5 1 1\n0 7 7 5 8 8\n5 161 1e6 .25\n0 0 0 0 0 0 0 0 0\n30 0 0\n1.5\n";

}  // namespace

TEST_F(CaseFiles, a_drawing_is_brought_to_the_length_unit_of_the_case_file_beside_it) {
  const std::string line = "0\nLINE\n8\nJOINT_1\n10\n0\n20\n0\n11\n1000\n21\n2000\n";
  const std::string drawing = file("a.dxf", dxf_text(line, "9\n$INSUNITS\n70\n4\n"));  // millimetres
  const auto end_beside = [&](const std::string& units) {
    const std::string path = file("a.json", "{\"keyblock\": 1, \"units\": " + units + "}");
    const auto files = read_files({drawing, path});
    const Problem problem = pair({files.at(0).reading->content, files.at(1).reading->content});
    EXPECT_EQ(problem.units.time, "s");
    return std::get<Drawing>(problem.geometry).joints.at(0).segment.end;
  };
  EXPECT_EQ(end_beside(R"({"length": "mm", "mass": "t", "time": "s"})"), (Point{1000, 2000}));
  EXPECT_EQ(end_beside(R"({"length": "m", "mass": "kg", "time": "s"})"), (Point{1, 2}));
  EXPECT_EQ(end_beside(R"({"length": "", "mass": "kg", "time": "s"})"), (Point{1, 2}));
}

TEST(CaseUnits, files_may_complete_each_others_units_but_not_contradict_them) {
  std::optional<Units> units;
  put_units(units, Units{"m", "", ""}, {"a"});
  put_units(units, Units{"m", "kg", "s"}, {"b"});
  EXPECT_EQ(units, (Units{"m", "kg", "s"}));
  EXPECT_THROW(put_units(units, Units{"mm", "", ""}, {"c"}), InputError);
}

TEST_F(CaseFiles, shi_analysis_is_read_with_the_points_of_the_geometry_in_either_order) {
  const std::string geometry = file("a.geo", kGeometry);
  const std::string analysis = file("a.ana", kShi);
  for (const auto& paths : {std::vector<std::string>{geometry, analysis}, {analysis, geometry}}) {
    const Case loaded = load_case(paths);
    EXPECT_EQ(loaded.warnings, Warnings{});
    EXPECT_EQ(loaded.problem.analysis->fixed_point_motions.size(), 2u);
    EXPECT_EQ(loaded.problem.analysis->point_loads.at(0).values.at(0), (Point{7, 7}));
    EXPECT_TRUE(std::holds_alternative<Drawing>(loaded.problem.geometry));
  }
}

TEST_F(CaseFiles, second_geometry_is_an_error_that_names_the_first) {
  const std::string first = file("a.geo", kGeometry);
  const std::string second = file("b.geo", kGeometry);
  try {
    load_case({first, second});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), second + ": error: expected one geometry, found a second; the first is " + first);
  }
}

TEST_F(CaseFiles, every_file_is_read_whatever_befalls_the_others) {
  const std::vector<FileReading> files = read_files({"/no/such", file("a.geo", kGeometry)});
  EXPECT_TRUE(files.at(0).error);
  EXPECT_FALSE(files.at(0).choice);
  EXPECT_TRUE(files.at(1).reading);
}

}  // namespace keyblock::formats::case_test
