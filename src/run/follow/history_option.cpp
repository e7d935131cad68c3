// Parses words into plans, and turns plans into measured points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/follow/history_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest.hpp"
#include "base/words/plain_number.hpp"
#include "cut/bodies/place_points.hpp"
#include "geometry/polygon.hpp"

namespace keyblock {
namespace {

constexpr const char* kForms =
    "point:X,Y, block:N, contact:A,B, joint:N, line:X1,Y1,X2,Y2 or bolt:N, with NAME= before it or not";

[[noreturn]] void refuse_history(const std::string& text, const std::string& more = {}) {
  throw std::invalid_argument(fmt::format("expected {}; found \"{}\"{}", kForms, text, more));
}

std::vector<double> numbers_in(std::string_view list, const std::string& text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t end = std::min(list.find(','), list.size());
    double& number = numbers.emplace_back();
    const auto [stop, error] = std::from_chars(list.data(), list.data() + end, number);
    if (error != std::errc{} || stop != list.data() + end || !std::isfinite(number)) refuse_history(text);
    if (end == list.size()) return numbers;
    list.remove_prefix(end + 1);
  }
}

int index_of(double number, const std::string& text) {
  constexpr double kMost = 1e9;
  if (number < 1 || number > kMost || number != std::floor(number))
    refuse_history(text, ", whose numbers count from 1");
  return static_cast<int>(number) - 1;
}

std::optional<int> element_at(const Cover& cover, Point p) {
  for (std::size_t e = 0; e < cover.elements.size(); ++e) {
    const auto polygon = cover.polygon(cover.elements[e]);
    if (side(std::vector<Point>(polygon.begin(), polygon.end()), p) != Side::outside) return static_cast<int>(e);
  }
  return std::nullopt;
}

[[noreturn]] void refuse_outside(const HistoryPlan& plan) {
  throw InputError(plan.place, fmt::format("expected the point of a history within a block, found {}, {} in none",
                                           plain(plan.point->x, 6), plain(plan.point->y, 6)));
}

/// Distance up to which a point lies on an outline. Turned by the same angle, both differ by their last digits.
double round_off_of(const Blocks& blocks) {
  constexpr double kOnOutline = 1e-12;
  double farthest = 0;
  for (const BlockPolygon& block : blocks.blocks)
    for (const BlockVertex& corner : block.outer) farthest = std::max(farthest, length(corner.position));
  return kOnOutline * farthest;
}

void add_point(Problem& problem, const HistoryPlan& plan) {
  if (auto* drawing = std::get_if<Drawing>(&problem.geometry)) {
    drawing->measured_points.push_back({*plan.point, plan.place});
  } else if (auto* blocks = std::get_if<Blocks>(&problem.geometry)) {
    if (const std::optional<int> block = block_at(blocks->blocks, *plan.point, 0)) {
      blocks->measured_points.push_back({*plan.point, *block, plan.place});
      return;
    }
    const auto beside = block_beside(blocks->blocks, *plan.point, round_off_of(*blocks));
    if (!beside) refuse_outside(plan);
    blocks->measured_points.push_back({*plan.point, beside->block, plan.place});
  } else if (auto* cover = std::get_if<Cover>(&problem.geometry)) {
    const std::optional<int> element = element_at(*cover, *plan.point);
    if (!element) refuse_outside(plan);
    cover->measured_points.push_back({*plan.point, *element, plan.place});
  }
}

}  // namespace

HistoryPlan history_of(const std::string& text) {
  HistoryPlan plan;
  std::string_view rest = text;
  if (const std::size_t equals = rest.find('='); equals != std::string_view::npos) {
    plan.name = rest.substr(0, equals);
    rest.remove_prefix(equals + 1);
  }
  const std::size_t colon = rest.find(':');
  if (colon == std::string_view::npos) refuse_history(text);
  const std::string word(rest.substr(0, colon));
  constexpr std::array<std::pair<const char*, std::size_t>, 6> kWords{
      {{"point", 2}, {"block", 1}, {"contact", 2}, {"joint", 1}, {"line", 4}, {"bolt", 1}}};
  std::size_t wanted = 0;
  std::vector<std::string> known;
  for (const auto& [name, count] : kWords) {
    known.emplace_back(name);
    if (word == name) wanted = count;
  }
  if (wanted == 0) refuse_history(text, nearest_words(word, known));
  const std::string_view what = rest.substr(colon + 1);
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  if (word == "bolt" && std::ranges::any_of(what, is_letter))
    refuse_history(text, ": bolts have numbers here, names in the case file");
  const std::vector<double> values = numbers_in(what, text);
  if (values.size() != wanted) refuse_history(text);
  if (word == "point") plan.point = Point{values[0], values[1]};
  if (word == "block") plan.block = index_of(values[0], text);
  if (word == "contact") plan.contact = BlockPair{index_of(values[0], text), index_of(values[1], text)};
  if (word == "joint") plan.joint = index_of(values[0], text);
  if (word == "line") plan.line = Segment{{values[0], values[1]}, {values[2], values[3]}};
  if (word == "bolt") plan.bolt = index_of(values[0], text);
  if (plan.line && plan.line->start == plan.line->end) refuse_history(text, ", a line without length");
  return plan;
}

Problem with_followed_points(Problem problem) {
  std::set<std::pair<double, double>> added;
  for (const HistoryPlan& plan : problem.outputs.histories)
    if (plan.point && added.emplace(plan.point->x, plan.point->y).second) add_point(problem, plan);
  return problem;
}

}  // namespace keyblock
