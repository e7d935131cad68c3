// Fifty scenes with parts that cross themselves, overlap, are tiny or huge, or are missing. Each is computed rightly,
// gets a named warning, or is refused with its place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::hostile_scenes_test {
namespace {

constexpr int kScenesOfAKind = 10;
constexpr double kGravity = 9.81;
constexpr double kDensity = 2500;
constexpr double kModulus = 5e9;

std::string outline(const std::vector<Point>& corners) {
  std::string text;
  for (const Point p : corners) text += fmt::format("{}[{:.17g}, {:.17g}, 1]", text.empty() ? "" : ", ", p.x, p.y);
  return "{\"outer\": [" + text + "]}";
}

std::vector<Point> rectangle(Point low, double width, double height) {
  return {low, low + Point{width, 0}, low + Point{width, height}, low + Point{0, height}};
}

/// Block by block, the first one fixed; one line per block, so that places identify blocks.
std::string case_of(const std::vector<std::string>& blocks, Point held, double floor_width, Point measured) {
  std::string list;
  for (const std::string& block : blocks) list += (list.empty() ? "\n" : ",\n") + block;
  return fmt::format(
      "{{\"keyblock\": 2, \"units\": {{\"length\": \"m\", \"mass\": \"kg\", \"time\": \"s\"}},\n"
      "\"blocks\": {{\"blocks\": [{}],\n"
      "\"fixed_points\": [[{:.17g}, {:.17g}, 1], [{:.17g}, {:.17g}, 1]],\n"
      "\"measured_points\": [[{:.17g}, {:.17g}, 2]]}},\n"
      "\"analysis\": {{\"step_count\": 3, \"time_step\": 0.001,\n"
      "\"block_materials\": [{{\"density\": {}, \"youngs_modulus\": {}, \"poissons_ratio\": 0.25}}],\n"
      "\"joint_materials\": [{{\"friction_angle_deg\": 30}}]}}}}\n",
      list, held.x, held.y, held.x + floor_width / 2, held.y, measured.x, measured.y, kDensity, kModulus);
}

struct Seen {
  support::ProgramRun run;
  std::string file;
  double fall = 0;  ///< of the measured point [m]; empty without results
};

Seen seen_of(const std::string& text, const std::string& profile) {
  const std::string folder = support::fresh_folder("hostile_scenes");
  Seen seen;
  seen.file = folder + "/scene.json";
  support::write_text(seen.file, text);
  seen.run = support::run_keyblock({"run", seen.file, "-o", folder + "/out", "--profile", profile, "--json"});
  if (seen.run.output.empty()) return seen;
  const std::string history = support::read_text(folder + "/out/history.csv");
  const std::size_t last = history.rfind('\n', history.size() - 2) + 1;
  std::string cells = history.substr(last);
  for (int i = 0; i < 5; ++i) cells.erase(0, cells.find(',') + 1);  // step, time, x, y, dx
  seen.fall = -std::stod(cells);
  return seen;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Checks for exit code 3 and an error at this line of the file.
void expect_refused(const Seen& seen, int line, const std::string& sentence) {
  EXPECT_EQ(seen.run.exit_code, 3) << seen.run.messages;
  EXPECT_TRUE(contains(seen.run.messages, fmt::format("{}:{}:", seen.file, line))) << seen.run.messages;
  EXPECT_TRUE(contains(seen.run.messages, sentence)) << seen.run.messages;
}

/// A floor of 4 by 1 of this size with its upper side at `at`, to the left of `at` a quarter of its width.
std::vector<Point> floor_below(Point at, double size) {
  return rectangle(at - Point{size, size}, 4 * size, size);
}

class Dice {
 public:
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Point place() { return {(*this)(-100, 100), (*this)(-100, 100)}; }

 private:
  std::mt19937_64 engine_{20261127};
};

}  // namespace

TEST(HostileScenes, outlines_that_cross_themselves_are_refused_at_the_block) {
  Dice dice;
  for (int i = 0; i < kScenesOfAKind; ++i) {
    const double size = std::pow(10, dice(-3, 3));
    const Point at = size * dice.place();
    const double angle = dice(0, 6);
    // Random quadrangles whose first and third edge cross at shares s and t of their lengths.
    const double s = dice(0.2, 0.8), t = dice(0.2, 0.8), reach = dice(0.5, 2) * size;
    const Point u = reach * Point{std::cos(angle), std::sin(angle)};
    const Point v = reach * Point{std::cos(angle + dice(0.5, 2.5)), std::sin(angle + dice(0.5, 2.5))};
    const Point centre = at + Point{size, 3 * size};
    const std::vector<Point> crossed{centre - s * u, centre + (1 - s) * u, centre - t * v, centre + (1 - t) * v};
    const std::string text =
        case_of({outline(floor_below(at, size)), outline(crossed)}, at - Point{0.5 * size, 0.5 * size}, size, centre);
    for (const char* profile : {"legacy", "standard"})
      expect_refused(seen_of(text, profile), 3 + 1, "that do not cross");
  }
}

TEST(HostileScenes, blocks_that_overlap_are_told_of) {
  Dice dice;
  for (int i = 0; i < kScenesOfAKind; ++i) {
    const double size = std::pow(10, dice(-1, 2));
    const Point at = size * dice.place();
    const double share = dice(0.02, 1);
    const std::vector<Point> sunk = rectangle(at - Point{0, share * size}, size, size);
    const std::string text =
        case_of({outline(floor_below(at, size)), outline(sunk)}, at - Point{0.5 * size, 0.5 * size}, size, sunk[2]);
    const Seen seen = seen_of(text, "standard");
    EXPECT_TRUE(contains(seen.run.messages, "[blocks_overlap]")) << share << seen.run.messages;
    EXPECT_TRUE(contains(seen.run.messages, fmt::format("{}:4:", seen.file))) << seen.run.messages;
  }
}

// A block at rest settles by the strain of its weight, ρ g h² / 2E at its middle, and by its penetration into the
// floor.
TEST(HostileScenes, tiny_and_huge_blocks_rest_or_are_told_of) {
  Dice dice;
  for (int i = 0; i < 2 * kScenesOfAKind; ++i) {
    const double ratio = std::pow(10, i < kScenesOfAKind ? dice(-6, -2) : dice(2, 4));
    const double size = i < kScenesOfAKind ? dice(1, 100) : dice(0.01, 1);
    const double block = ratio * size;
    const Point at = 10 * dice.place();
    const std::vector<Point> resting = rectangle(at, block, block);
    const double floor = std::max(size, block);
    const std::string text = case_of({outline(floor_below(at, floor)), outline(resting)},
                                     at - Point{0.5 * floor, 0.5 * floor}, floor, resting[3]);
    const Seen seen = seen_of(text, "standard");
    const bool is_refused = seen.run.exit_code == 3 && contains(seen.run.messages, seen.file + ":");
    const bool is_doubted = seen.run.exit_code == 1 && contains(seen.run.messages, "results are unreliable");
    if (is_refused || is_doubted) continue;
    EXPECT_EQ(seen.run.exit_code, 0) << seen.run.messages;
    const double strain = kDensity * kGravity * std::max(block, floor) / kModulus;
    EXPECT_LT(std::abs(seen.fall), 10 * strain * block + 1e-9 * floor) << ratio;
  }
}

TEST(HostileScenes, what_is_missing_is_refused_with_its_place) {
  Dice dice;
  for (int i = 0; i < kScenesOfAKind; ++i) {
    const double size = std::pow(10, dice(-2, 2));
    const Point at = size * dice.place();
    const Point held = at - Point{0.5 * size, 0.5 * size};
    const std::string floor = outline(floor_below(at, size));
    const std::string block = outline(rectangle(at, size, size));
    const std::string whole = case_of({floor, block}, held, size, at + Point{size, size});
    const auto without = [&](const std::string& part, const std::string& instead) {
      std::string text = whole;
      const std::size_t from = text.find(part);
      EXPECT_NE(from, std::string::npos) << part;
      return text.replace(from, part.size(), instead);
    };
    const std::vector<std::pair<std::string, int>> faulty = {
        {case_of({floor, outline({at, at + Point{size, size}})}, held, size, at), 4},
        {case_of({floor, outline({at, at + Point{size, 0}, at + Point{2 * size, 0}})}, held, size, at), 4},
        {case_of({floor}, held, size, at), 5},  // the measured point names block 2
        {without("\"density\": 2500, ", ""), 8},
        {without("\"time_step\": 0.001", "\"time_step\": 0"), 7},
        {without("\"block_materials\": [{\"density\"", "\"block_materials\": [], \"x\": [{\"density\""), 8},
        {without("[\n" + floor + ",\n" + block + "]", "[]"), 3},
        {without("\"step_count\": 3, ", ""), 7}};
    const auto& [text, line] = faulty[static_cast<std::size_t>(i) % faulty.size()];
    const Seen seen = seen_of(text, i % 2 == 0 ? "standard" : "legacy");
    EXPECT_EQ(seen.run.exit_code, 3) << i << ": " << seen.run.messages;
    EXPECT_TRUE(contains(seen.run.messages, fmt::format("{}:{}:", seen.file, line))) << i << ": " << seen.run.messages;
  }
}

}  // namespace keyblock::hostile_scenes_test
