// Outputs of runs of elastoplastic rock: plastic strain compared with closed forms, states, sums, reactions,
// iterations. Resumed runs write the same, elastic ones none of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "formats/text/csv.hpp"
#include "tests/support/killed_runs.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::plastic_outputs_test {
namespace {

using support::fresh_folder;
using support::read_text;
using support::run_keyblock;
using support::write_text;

constexpr double kE = 1e4, kNu = 0.3;

/// A unit square, smoothly supported below and on the left, with a measured point in each of two opposite corners.
std::string square(const std::string& displacements, const std::string& strength) {
  return R"({"keyblock": 1, "blocks": {"blocks": [{"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}],
    "measured_points": [[0, 0, 1], [1, 1, 1]]}, "covers": {
    "mesh": {"kind": "unstructured", "placement": "aligned", "side": 0.35},
    "displacements": [{"along": [[0, 0], [1, 0]], "held": "y"}, {"along": [[0, 0], [0, 1]], "held": "x"}, )" +
         displacements + R"(]}, "analysis": {"step_count": 8, "time_step": 1, "allowed_displacement_ratio": 0.1,
    "plane_strain": true, "velocity_carry_over": 0, "joint_materials": [{}], "block_materials": [{"density": 1,
    "unit_weight": 0, "youngs_modulus": 10000, "poissons_ratio": 0.3)" +
         strength + "}]}}";
}

const std::string kPressed = R"({"along": [[0, 1], [1, 1]], "held": "y", "y": -0.01})";
const std::string kMises = R"(, "strength": {"surface": "von_mises", "yield_stress": 20})";

/// The last row of a table.
std::map<std::string, std::string> last_row(const std::string& file) {
  const formats::CsvTable table = formats::read_csv({file, read_text(file)});
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < table.header.size(); ++i) row[table.header[i]] = table.rows.back().cells[i];
  return row;
}

struct Done {
  int exit_code = 0;
  std::string messages;
  std::string out;
  nlohmann::json record;

  std::map<std::string, std::string> last(const std::string& file) const { return last_row(out + "/" + file); }
};

Done run_of(const std::string& name, const std::string& text, const std::vector<std::string>& more = {}) {
  const std::string folder = fresh_folder("plastic_" + name);
  write_text(folder + "/in.json", text);
  std::vector<std::string> arguments = {"run",     folder + "/in.json", "-o",  folder + "/out",
                                        "--trace", "--frames",          "text"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto run = run_keyblock(arguments);
  Done done{run.exit_code, run.messages, folder + "/out", {}};
  if (run.exit_code != 3) done.record = nlohmann::json::parse(read_text(done.out + "/run.json"));
  return done;
}

/// Logarithmic strain of the square, and its stress, Cauchy stress times the change of volume; shear is zero.
struct Homogeneous {
  double xx = 0, yy = 0;
  double txx = 0, tyy = 0, tzz = 0;

  explicit Homogeneous(const std::string& points) {
    const formats::CsvTable table = formats::read_csv({points, read_text(points)});
    const auto value = [&](std::size_t from_end, const char* heading) {
      return formats::csv_real(table, table.rows[table.rows.size() - 1 - from_end],
                               formats::csv_column(table, heading));
    };
    xx = std::log1p(value(0, "dx [L]") - value(1, "dx [L]"));
    yy = std::log1p(value(0, "dy [L]") - value(1, "dy [L]"));
    const double volume = std::exp(xx + yy);
    txx = volume * value(0, "sxx");
    tyy = volume * value(0, "syy");
    tzz = volume * value(0, "szz");
  }
  double plastic(double strain, double own, double others) const { return strain - (own - kNu * others) / kE; }
};

// Edges give way by 1e-4 of the displacement of the rock (HeldEdges), in proportion to the size of their elements:
// strain is homogeneous to that.
constexpr double kGiven = 1e-4 * 0.01;

}  // namespace

// εᵖ = ε - D⁻¹ T in each direction; at constant volume; its work by a constant strength is σy κ.
TEST(PlasticOutputs, plastic_strain_of_a_pressed_square_is_the_strain_less_the_elastic_one) {
  const Done done = run_of("pressed", square(kPressed, kMises));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  const Homogeneous h(done.out + "/points.csv");
  auto point = done.last("points.csv");
  const double xx = std::stod(point["plastic_strain_xx"]), yy = std::stod(point["plastic_strain_yy"]);
  const double zz = std::stod(point["plastic_strain_zz"]), kappa = std::stod(point["equivalent_plastic_strain"]);
  EXPECT_NEAR(xx, h.plastic(h.xx, h.txx, h.tyy + h.tzz), kGiven);
  EXPECT_NEAR(yy, h.plastic(h.yy, h.tyy, h.txx + h.tzz), kGiven);
  EXPECT_NEAR(zz, h.plastic(0, h.tzz, h.txx + h.tyy), kGiven);
  EXPECT_LT(yy, -0.007);
  EXPECT_NEAR(xx + yy + zz, 0, 1e-12);
  EXPECT_NEAR(std::stod(point["plastic_strain_xy"]), 0, kGiven);
  EXPECT_EQ(point["yield_state"], "1");
  EXPECT_EQ(point["has_yielded"], "1");
  EXPECT_NEAR(std::stod(point["von_mises_stress"]), 20 / std::exp(h.xx + h.yy), 1e-6);
  auto history = done.last("history.csv");
  EXPECT_EQ(history["yielded_fraction"], "1");
  EXPECT_EQ(history["yielding_fraction"], "1");
  EXPECT_NEAR(std::stod(history["plastic_work [F L]"]), 20 * kappa, 20 * kGiven);
  EXPECT_NEAR(std::stod(history["driven3 [L]"]), 0.01, 1e-15);
  const auto& plastic = done.record["plastic"];
  EXPECT_EQ(plastic["yielded_fraction"], 1);
  EXPECT_NEAR(plastic["area"].get<double>(), 1, 1e-12);
  EXPECT_EQ(plastic["plastic_work"].get<double>(), std::stod(history["plastic_work [F L]"]));
  EXPECT_NEAR(plastic["greatest_equivalent_plastic_strain"]["value"].get<double>(), kappa, kGiven);
}

// c cot φ on all sides; εᵖ = ε - (1 - 2ν)/E c cot φ in each direction.
TEST(PlasticOutputs, a_square_pulled_on_all_sides_stands_at_its_apex) {
  const Done done = run_of("apex", square(R"({"along": [[0, 1], [1, 1]], "held": "y", "y": 0.01},
                                     {"along": [[1, 0], [1, 1]], "held": "x", "x": 0.01})",
                                          R"(, "strength": {"cohesion": 10, "friction_deg": 20, "dilation_deg": 20})"));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  const double apex = 10 / std::tan(20 * std::numbers::pi / 180);
  const double elastic = (1 - 2 * kNu) / kE * apex;
  const Homogeneous h(done.out + "/points.csv");
  auto point = done.last("points.csv");
  EXPECT_EQ(point["yield_state"], "3");
  EXPECT_NEAR(std::stod(point["mean_stress"]), apex / std::exp(h.xx + h.yy), 1e-5 * apex);
  EXPECT_NEAR(std::stod(point["plastic_strain_xx"]), h.xx - elastic, kGiven);
  EXPECT_NEAR(std::stod(point["plastic_strain_yy"]), h.yy - elastic, kGiven);
  EXPECT_NEAR(std::stod(point["plastic_strain_zz"]), -elastic, 1e-9);
}

// 40/√3 is met at a strain of 0.02 %; then the square grows wider by 0.4 % in all, and its reaction with it.
TEST(PlasticOutputs, a_limit_load_and_the_rounds_of_its_steps_are_told) {
  std::string text = square(R"({"along": [[0, 1], [1, 1]], "held": "y", "y": -0.004})", kMises);
  text.replace(text.find("10000"), 5, "1e5");
  const Done done = run_of("limit", text, {"--set", "steps=20"});
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  EXPECT_NE(done.messages.find("limit load of this mesh: reaction y of displacement 3 is -23."), std::string::npos)
      << done.messages;
  ASSERT_EQ(done.record["reactions"].size(), 1U);
  const auto& reaction = done.record["reactions"][0];
  EXPECT_EQ(reaction["displacement"], 3);
  EXPECT_NEAR(reaction["reaction"].get<double>(), -40 / std::numbers::sqrt3, 0.005 * 23);
  EXPECT_LT(reaction["slope"].get<double>(), 0.005);
  EXPECT_LE(reaction["plateau"]["since_step"].get<int>(), 17);
  EXPECT_TRUE(std::filesystem::exists(done.out + "/reactions.svg"));
  EXPECT_TRUE(std::filesystem::exists(done.out + "/plastic.svg"));
  EXPECT_EQ(done.record["steps"]["columns"].back(), "parts");
  auto round = done.last("rounds.csv");
  EXPECT_EQ(round["step"], "20");
  EXPECT_LE(std::stod(round["residual"]), 1e-9);
}

TEST(PlasticOutputs, frames_hold_the_numbers_of_the_tables) {
  const Done done = run_of("frames", square(kPressed, kMises));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  pugi::xml_document frame;
  ASSERT_TRUE(frame.load_file((done.out + "/frames/00000008.vtu").c_str()));
  const auto piece = frame.child("VTKFile").child("UnstructuredGrid").child("Piece");
  auto block = done.last("blocks.csv");
  for (const char* name : {"plastic_strain_xx", "plastic_strain_yy", "plastic_strain_zz", "equivalent_plastic_strain",
                           "mean_stress", "von_mises_stress", "yield_state", "has_yielded"}) {
    const auto cells = piece.child("CellData").find_child_by_attribute("DataArray", "Name", name);
    std::istringstream text(cells.text().get());
    double last = 0;
    int count = 0;
    for (double value = 0; text >> value; ++count) last = value;
    EXPECT_EQ(count, piece.attribute("NumberOfCells").as_int()) << name;
    EXPECT_EQ(last, std::stod(block[name])) << name;
  }
  EXPECT_TRUE(piece.child("PointData").find_child_by_attribute("DataArray", "Name", "equivalent_plastic_strain"));
}

TEST(PlasticOutputs, elastic_runs_leave_nothing_of_it) {
  const Done done = run_of("elastic", square(kPressed, ""));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  EXPECT_FALSE(done.record.contains("plastic"));
  EXPECT_FALSE(done.record.contains("reactions"));
  for (const char* file : {"plastic.svg", "reactions.svg", "rounds.csv"})
    EXPECT_FALSE(std::filesystem::exists(done.out + "/" + file)) << file;
  for (const char* file : {"history.csv", "points.csv", "blocks.csv", "frames/00000008.vtu"}) {
    const std::string text = read_text(done.out + "/" + file);
    for (const char* word : {"plastic", "yield", "driven", "lode"})
      EXPECT_EQ(text.find(word), std::string::npos) << file << word;
  }
}

// A block pressed down by its weight flows at constant volume; the work in the history is that of the energy balance.
TEST(PlasticOutputs, a_block_that_yields_in_time_tells_the_same) {
  const Done done = run_of("block", R"({"keyblock": 1, "blocks": {"blocks": [
    {"material": 1, "outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]},
    {"material": 2, "outer": [[-1, -1, 1], [2, -1, 1], [2, 0, 1], [-1, 0, 1]]}],
    "measured_points": [[0.5, 1, 1]], "fixed_points": [[-1, -1, 2], [2, -1, 2]]},
    "analysis": {"velocity_carry_over": 1, "step_count": 40, "time_step": 0.001, "gravity": 9.81,
    "allowed_displacement_ratio": 1, "plane_strain": true, "block_materials": [{"density": 2500, "unit_weight": 24525,
    "youngs_modulus": 1e7, "poissons_ratio": 0.2, "strength": {"surface": "von_mises", "yield_stress": 8000}},
    {"density": 2500, "unit_weight": 0, "youngs_modulus": 1e9, "poissons_ratio": 0.2}],
    "joint_materials": [{"friction_angle_deg": 0, "cohesion": 0, "tensile_strength": 0}], "penalty_factor": 10}})");
  ASSERT_TRUE(done.exit_code == 0 || done.exit_code == 1) << done.messages;
  auto point = done.last("points.csv");
  EXPECT_EQ(point["has_yielded"], "1");
  EXPECT_LT(std::stod(point["plastic_strain_yy"]), 0);
  EXPECT_NEAR(std::stod(point["plastic_strain_xx"]) + std::stod(point["plastic_strain_yy"]) +
                  std::stod(point["plastic_strain_zz"]),
              0, 1e-12);
  auto history = done.last("history.csv");
  EXPECT_EQ(history["yielded_fraction"], "1");  // of the elastoplastic rock
  EXPECT_GT(std::stod(history["plastic_work [F L]"]), 0);
  EXPECT_EQ(std::stod(history["plastic_work [F L]"]), done.record["ledger"]["end"]["plastic"].get<double>());
}

TEST(PlasticOutputs, resumed_runs_leave_the_same_bytes) {
  const std::string folder = fresh_folder("plastic_resumed");
  write_text(folder + "/in.json", square(kPressed, kMises));
  const auto runs =
      support::killed_runs({folder + "/in.json", "--trace", "--set", "steps=15", "--set", "mesh.side=0.2"}, 2, 3);
  EXPECT_EQ(runs.differs, "");
  EXPECT_GT(runs.resumed, 0);
}

namespace {

/// Values of the cells of the last frame.
std::vector<double> last_cells(const Done& done, const char* name) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(done.out + "/frames"))
    if (entry.path().extension() == ".vtu") files.insert(entry.path().string());
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file(files.rbegin()->c_str()));
  const pugi::xml_node piece = document.child("VTKFile").child("UnstructuredGrid").child("Piece");
  std::istringstream text(piece.child("CellData").find_child_by_attribute("DataArray", "Name", name).text().get());
  std::vector<double> values;
  for (double value = 0; text >> value;) values.push_back(value);
  return values;
}

}  // namespace

// Under plane strain a side free to move gives way by ν/(1-ν) of the displacement of the pressed one.
TEST(PlasticOutputs, elastic_strain_of_elastic_rock_is_that_of_its_displacement) {
  const std::string little = R"({"along": [[0, 1], [1, 1]], "held": "y", "y": -1e-5})";
  const Done done = run_of("elastic_strain", square(little, ""));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  const std::vector<double> yy = last_cells(done, "elastic_strain_yy");
  const std::vector<double> xx = last_cells(done, "elastic_strain_xx");
  const std::vector<double> zz = last_cells(done, "elastic_strain_zz");
  ASSERT_GT(yy.size(), 4U);
  for (std::size_t i = 0; i < yy.size(); ++i) {
    EXPECT_NEAR(yy[i], -1e-5,
                1e-8);  // edges give way by 1e-4 of the displacement of the rock, strain changes by its own square
    EXPECT_NEAR(xx[i], kNu / (1 - kNu) * 1e-5, 1e-8);
    EXPECT_NEAR(zz[i], 0, 1e-12);
  }
}

// To a hundredth of the elastic part, which is given by Cauchy stress, at a strain of 0.01.
TEST(PlasticOutputs, elastic_and_plastic_strain_add_up_to_that_of_the_displacement) {
  const Done done = run_of("sum_of_strains", square(kPressed, kMises));
  ASSERT_EQ(done.exit_code, 0) << done.messages;
  const Homogeneous h(done.out + "/points.csv");
  const auto sums = [&](const char* elastic, const char* plastic, double wanted) {
    const std::vector<double> one = last_cells(done, elastic);
    const std::vector<double> other = last_cells(done, plastic);
    ASSERT_GT(one.size(), 4U);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_NEAR(one[i] + other[i], wanted, 0.01 * std::abs(one[i]) + kGiven) << elastic;
      EXPECT_GT(std::abs(other[i]), 1e-4) << plastic;
    }
  };
  sums("elastic_strain_xx", "plastic_strain_xx", h.xx);
  sums("elastic_strain_yy", "plastic_strain_yy", h.yy);
  sums("elastic_strain_zz", "plastic_strain_zz", 0);
}

}  // namespace keyblock::plastic_outputs_test
