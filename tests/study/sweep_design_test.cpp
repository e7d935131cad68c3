// Values, distributions and rows of a sweep against their definitions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/sweep/sweep_design.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "base/error.hpp"
#include "study/sweep/sweep_outputs.hpp"
#include "study/sweep/sweep_table.hpp"

namespace keyblock::sweep_design_test {
namespace {

using Json = nlohmann::ordered_json;
using study::Design;
using study::sweep_rows;
using study::varied_key_of;

std::string values_of(const std::string& text) {
  return Json(varied_key_of(text).values).dump();
}

std::vector<double> sample(const std::string& law, std::size_t count) {
  std::vector<double> values;
  for (const study::SweepRow& row : sweep_rows({varied_key_of("a=" + law)}, {Design::random, count, 7}))
    values.push_back(row["a"]);
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += (value - mean(values)) * (value - mean(values));
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace

TEST(SweepDesign, lists_and_ranges_are_read_with_their_units) {
  EXPECT_EQ(values_of("/a=20:40:5"), "[20,25,30,35,40]");
  EXPECT_EQ(values_of("/a=0.1:0.3:0.1"), "[0.1,0.2,0.3]") << "with both ends, without round-off";
  EXPECT_EQ(values_of("/a=3:1:-1 kN"), R"(["3 kN","2 kN","1 kN"])");
  EXPECT_EQ(values_of("/a=0,50 kN"), R"(["0 kN","50 kN"])");
  EXPECT_EQ(values_of("/a=1 MPa,50 kPa"), R"(["1 MPa","50 kPa"])");
  EXPECT_EQ(values_of("/a=true,[1,2],sand"), R"([true,[1,2],"sand"])");
  EXPECT_EQ(values_of("/a=1..2,1:3"), R"(["1..2","1:3"])") << "no numbers with units";
  for (const char* wrong : {"", "/a", "/a=", "=1", "/a=1,,2", "/a=1,null", "/a=normal(1)", "/a=uniform(2,1)",
                            "/a=normal(1,0)", "/a=1:2:0", "/a=1:2:-1", "/a=0:1:1e-9"})
    EXPECT_THROW(varied_key_of(wrong), std::invalid_argument) << wrong;
}

TEST(SweepDesign, the_key_decides_whether_a_word_is_a_name) {
  const auto values = [](const std::string& text, WordKind kind) {
    return Json(varied_key_of(text, [&](const std::string&) { return kind; }).values).dump();
  };
  EXPECT_EQ(values("/a=1m,2m", WordKind::amount), R"(["1 m","2 m"])");
  EXPECT_EQ(values("/a=2*t,50 kN", WordKind::amount), R"(["2*t","50 kN"])") << "a formula has no unit";
  EXPECT_EQ(values("/a=1.csv,2.csv", WordKind::plain), R"(["1.csv","2.csv"])");
  EXPECT_EQ(values("/a=1,2m", WordKind::plain), R"([1,"2m"])");
  EXPECT_EQ(values("/a=1:3:1", WordKind::plain), "[1,2,3]");
  EXPECT_EQ(values("/a=12,\"13\"", WordKind::name), R"(["12","13"])");
  EXPECT_EQ(values("/a=1:3:1", WordKind::name), R"(["1:3:1"])");
  const std::string json =
      R"({"blocks":{"blocks":[{}]},"analysis":{"joint_materials":[{"name":"bedding"}]},"run":{"set":{}}})";
  EXPECT_EQ(words_at("/analysis/joint_materials/bedding/cohesion", json), WordKind::amount);
  EXPECT_EQ(words_at("/analysis/joint_materials/bedding/friction_angle_deg", json), WordKind::amount);
  EXPECT_EQ(words_at("/analysis/joint_materials/bedding/name", json), WordKind::name);
  EXPECT_EQ(words_at("/blocks/blocks/0/material", json), WordKind::plain);
  EXPECT_EQ(words_at("/run/set/body_acceleration_file", json), WordKind::plain);
  EXPECT_EQ(words_of_setting("body_acceleration_file"), WordKind::plain);
  EXPECT_EQ(words_of_setting("time_step"), WordKind::amount);
}

// Mean of a normal distribution above t deviations: t + 1/t - 2/t^3 + 10/t^5, the series of the inverse Mills ratio.
TEST(SweepDesign, a_normal_distribution_cut_far_from_its_mean_has_the_mean_of_its_tail) {
  for (const double t : {8.0, 10.0, 20.0, 50.0, 1e4}) {
    const double expected = t + 1 / t - 2 / std::pow(t, 3) + 10 / std::pow(t, 5);
    const std::vector<double> above = sample(fmt::format("normal(0,1,{},{})", t, 2 * t), 1000);
    const std::vector<double> below = sample(fmt::format("normal(0,1,{},{})", -2 * t, -t), 1000);
    EXPECT_NEAR((mean(above) - t) * t, (expected - t) * t, 0.01) << t;
    EXPECT_NEAR((mean(below) + t) * t, (t - expected) * t, 0.01) << t;
    EXPECT_GE(std::ranges::min(above), t);
    EXPECT_EQ(std::set<double>(above.begin(), above.end()).size(), above.size()) << t;
  }
}

TEST(SweepDesign, grids_and_zipped_lists_have_rows_in_order) {
  const std::vector<study::VariedKey> keys{varied_key_of("/a=1,2"), varied_key_of("b=x,y")};
  EXPECT_EQ(Json(sweep_rows(keys, {})).dump(),
            R"([{"/a":1,"b":"x"},{"/a":1,"b":"y"},{"/a":2,"b":"x"},{"/a":2,"b":"y"}])");
  EXPECT_EQ(Json(sweep_rows(keys, {Design::zipped})).dump(), R"([{"/a":1,"b":"x"},{"/a":2,"b":"y"}])");
  EXPECT_THROW(sweep_rows({keys[0], varied_key_of("b=x")}, {Design::zipped}), std::invalid_argument);
  EXPECT_THROW(sweep_rows({keys[0], keys[0]}, {}), std::invalid_argument);
  EXPECT_THROW(sweep_rows({varied_key_of("a=normal(1,1)")}, {}), std::invalid_argument);
}

TEST(SweepDesign, random_rows_use_each_part_of_equal_probability_once) {
  std::set<int> parts;
  for (const double value : sample("uniform(2,4)", 200)) parts.insert(static_cast<int>((value - 2) * 100));
  EXPECT_EQ(parts.size(), 200U);
  EXPECT_EQ(sample("uniform(2,4)", 5), sample("uniform(2,4)", 5));
}

TEST(SweepDesign, samples_have_the_moments_of_their_distributions) {
  const std::vector<double> normal = sample("normal(30,2)", 2000);
  EXPECT_NEAR(mean(normal), 30, 0.01);
  EXPECT_NEAR(deviation(normal), 2, 0.01);
  const std::vector<double> lognormal = sample("lognormal(5,1)", 2000);
  EXPECT_NEAR(mean(lognormal), 5, 0.01);
  EXPECT_NEAR(deviation(lognormal), 1, 0.02);
  const std::vector<double> triangular = sample("triangular(0,1,4)", 2000);
  EXPECT_NEAR(mean(triangular), 5.0 / 3, 0.01);
  EXPECT_NEAR(deviation(triangular), std::sqrt(13.0 / 18), 0.01) << "(a² + b² + c² − ab − ac − bc)/18";
  const std::vector<double> cut = sample("normal(0,1,0,2)", 100);
  EXPECT_GE(std::ranges::min(cut), 0);
  EXPECT_LE(std::ranges::max(cut), 2);
  EXPECT_NEAR(study::Distribution({study::Law::normal, {0, 1}}).quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(study::Distribution({study::Law::normal, {0, 1}}).quantile(1e-12), -7.034483825301131, 1e-9);
}

TEST(SweepDesign, the_name_of_a_job_depends_on_its_values_alone) {
  const Json row = {{"/a", 1}, {"b", "x"}};
  EXPECT_EQ(study::job_name(row), study::job_name(row));
  EXPECT_EQ(study::job_name(row), study::job_name({{"/a", 1.0}, {"b", "x"}}));
  EXPECT_NE(study::job_name(row), study::job_name({{"/a", 2}, {"b", "x"}}));
  EXPECT_NE(study::job_name(row), study::job_name({{"/a", "1"}, {"b", "x"}}));
}

TEST(SweepDesign, a_file_of_rows_has_the_same_keys_in_each) {
  EXPECT_EQ(study::rows_of_file("f", R"([{"a":1,"b":2},{"b":3,"a":4}])")[1].dump(), R"({"a":4,"b":3})");
  for (const char* wrong : {"{", "{}", "[]", "[1]", R"([{"a":1},{"b":1}])", R"([{"a":1},{"a":1,"b":1}])"})
    EXPECT_THROW(study::rows_of_file("f", wrong), InputError) << wrong;
}

TEST(SweepDesign, outputs_are_known_by_their_form) {
  EXPECT_EQ(study::sweep_outputs_of("displacement,fos_rock,tip1.k1,crest.dx,/counts/blocks").size(), 5U);
  EXPECT_EQ(study::sweep_outputs_of("fos_rock").front().reduced, "rock");
  for (const char* wrong : {"", "colour", "fos,fos", "fos,"})
    EXPECT_THROW(study::sweep_outputs_of(wrong), std::invalid_argument) << wrong;
}

TEST(SweepDesign, a_table_has_the_shortest_numbers_and_a_cut_journal_its_whole_lines) {
  const Json out{{"x", 0.1}, {"y", nullptr}, {"z", 2.0}};
  study::SweepResult result{"j", "finished", "a, b", "toe_wedged slivers", out, 1.5};
  const study::SweepTable table{{"x", "y", "z"}, {Json{{"/a", 20}}}, {result}};
  EXPECT_EQ(table_csv(table),
            "/a,verdict,doubt,warnings,x,y,z,job\n20,finished,\"a, b\",toe_wedged slivers,0.1,,2,j\n");
  EXPECT_EQ(times_csv(table), "job,seconds\nj,1.500\n");
  const std::string text = study::sweep_journal_head("t") + study::sweep_journal_line(result);
  EXPECT_EQ(study::read_sweep_journal(text + "{\"job\"").lines, text);
  EXPECT_EQ(study::read_sweep_journal(text).results.at("j").out.dump(), result.out.dump());
}

}  // namespace keyblock::sweep_design_test
