// Judges the end of motion: energies come from the energy balance, speeds and places from the last frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "job/verdict/end_of_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/words/plain_number.hpp"
#include "job/verdict/energy_scale.hpp"
#include "problem/units/readable.hpp"
#include "result/extremes.hpp"
#include "run/prepare.hpp"

namespace keyblock {
namespace {

// Fraction of the size of a block, in the time of the last tenth of the steps: no block moves visibly.
constexpr double kVisible = 1e-3;
// Fraction of the whole way in the last tenth of static steps, each from zero velocity: the motion has ended.
constexpr double kEndOfWay = 1e-3;

double speed_of(const ElementFrame& element) {
  double arm = 0;
  for (const auto& loop : element.loops)
    for (const Point& vertex : loop) arm = std::max(arm, distance(vertex, element.centroid));
  return std::hypot(element.velocity.x, element.velocity.y) + std::abs(element.velocity.rotation) * arm;
}

bool is_late(int step, int steps) {
  return step > (1 - kRestSteps) * steps;
}

std::optional<double> kinetic_share(const Prepared& prepared, const RunRecord& record, const Frame& first) {
  const std::vector<LedgerRow> rows = record.ledger.rows();
  if (!record.ledger_sums.is_begun || rows.empty() || prepared.scene.settings.ledger == Bookkeeping::off)
    return std::nullopt;
  double kinetic = 0;
  for (const LedgerRow& row : rows)
    if (is_late(row.step, rows.back().step)) kinetic = std::max(kinetic, row.stored.kinetic);
  const double stored = std::max(record.ledger_sums.largest_stored, least_energy(prepared, first));
  return stored > 0 ? kinetic / stored : 0;
}

double late_share_of_way(const RunRecord& record) {
  const std::vector<StepReport> rows = record.steps.rows();
  double all = 0;
  double late = 0;
  for (const StepReport& row : rows) {
    all += row.displacement_ratio;
    if (is_late(row.step, rows.back().step)) late += row.displacement_ratio;
  }
  return all > 0 ? late / all : 0;
}

MotionState state_at_rest(const RunRecord& record, const EndOfMotion& end) {
  if (record.outcome.end == RunEnd::failed) return MotionState::no_equilibrium;
  if (record.equilibrium_way)
    return record.equilibrium_way->share.value_or(0) > kNearEquilibrium ? MotionState::equilibrium
                                                                        : MotionState::not_equilibrium;
  return end.least_share_of_way <= kEndOfWay ? MotionState::equilibrium : MotionState::not_equilibrium;
}

bool moves_visibly(const Frame& last, double time) {
  return std::ranges::any_of(last.elements, [&](const ElementFrame& element) {
    return speed_of(element) * time > kVisible * std::sqrt(element.area);
  });
}

std::string name_of(const Prepared& prepared, int number) {
  return fmt::format("{} {}", prepared.scene.model.nodes.empty() ? "block" : "element", number + 1);
}

}  // namespace

std::string_view word_for(MotionState state) {
  switch (state) {
    case MotionState::at_rest:
      return "at_rest";
    case MotionState::moving:
      return "moving";
    case MotionState::equilibrium:
      return "equilibrium";
    case MotionState::no_equilibrium:
      return "no_equilibrium";
    case MotionState::not_equilibrium:
      break;
  }
  return "not_equilibrium";
}

std::string_view words_for(MotionState state) {
  switch (state) {
    case MotionState::at_rest:
      return "came to rest";
    case MotionState::moving:
      return "still moving";
    case MotionState::equilibrium:
      return "in equilibrium";
    case MotionState::no_equilibrium:
      return "no equilibrium";
    case MotionState::not_equilibrium:
      break;
  }
  return "not in equilibrium";
}

EndOfMotion end_of_motion(const Prepared& prepared, const RunRecord& record, const Frame& first, const Frame& last) {
  EndOfMotion end;
  for (std::size_t e = 0; e < last.elements.size(); ++e) {
    const double speed = speed_of(last.elements[e]);
    if (e > 0 && !is_clearly_greater(speed, end.speed)) continue;
    end.speed = speed;
    end.fastest = number_of(last, e);
    end.fastest_at = last.elements[e].centroid;
  }
  for (std::size_t i = 0; i < last.measured_points.size(); ++i) {
    const double way = is_there(last.measured_points[i]) ? length(last.measured_points[i].displacement) : 0;
    if (end.farthest_point && !is_clearly_greater(way, end.farthest_point_way)) continue;
    end.farthest_point = i;
    end.farthest_point_way = way;
  }
  if (record.is_static) {
    end.least_share_of_way = late_share_of_way(record);
    end.state = state_at_rest(record, end);
    return end;
  }
  end.kinetic_share = kinetic_share(prepared, record, first);
  const bool is_still = end.kinetic_share.value_or(0) <= kRestEnergy;
  const bool is_at_rest = is_still && !moves_visibly(last, kRestSteps * record.outcome.time);
  end.state = is_at_rest ? MotionState::at_rest : MotionState::moving;
  return end;
}

std::string state_in_words(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end) {
  const std::string fastest =
      fmt::format("{} near ({}, {}) at {}", name_of(prepared, end.fastest), plain(end.fastest_at.x, 4),
                  plain(end.fastest_at.y, 4), readable(end.speed, measures::kVelocity, record.units));
  const std::string energy = end.kinetic_share
                                 ? fmt::format("kinetic energy {:.1g} of the largest stored energy", *end.kinetic_share)
                                 : std::string("without a ledger, judged by speeds alone");
  const std::string words(words_for(end.state));
  switch (end.state) {
    case MotionState::at_rest:
      return fmt::format("{} ({})", words, energy);
    case MotionState::moving:
      return fmt::format("{}: {} ({})", words, fastest, energy);
    case MotionState::equilibrium:
      return std::ranges::count(record.doubts, "equilibrium_far_away", &Warning::name) == 0
                 ? words
                 : "in an equilibrium far from the drawing";
    case MotionState::no_equilibrium:
      return words;
    case MotionState::not_equilibrium:
      break;
  }
  if (record.equilibrium_way && record.equilibrium_way->share)
    return fmt::format("{}: {:.2g} % of the way", words, 100 * *record.equilibrium_way->share);
  return fmt::format("{}: the last tenth of the static steps made {:.2g} % of the way", words,
                     100 * end.least_share_of_way);
}

std::string farthest_in_words(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end) {
  const Extremes& found = record.extremes;
  if (found.displacement == 0) return "0, nothing moved";
  const auto length_of = [&](double length) { return readable(length, measures::kLength, record.units); };
  std::string words =
      fmt::format("{} near ({}, {}): {}", name_of(prepared, found.displaced_element), plain(found.displaced_from.x, 4),
                  plain(found.displaced_from.y, 4), length_of(found.displacement));
  if (end.farthest_point)
    words += fmt::format("; measured point {}: {}", *end.farthest_point + 1, length_of(end.farthest_point_way));
  return words;
}

std::vector<std::string> sentences(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end) {
  return {state_in_words(prepared, record, end), "largest displacement: " + farthest_in_words(prepared, record, end)};
}

nlohmann::ordered_json motion_json(const Prepared& prepared, const RunRecord& record, const EndOfMotion& end) {
  using Json = nlohmann::ordered_json;
  const char* const part = prepared.scene.model.nodes.empty() ? "block" : "element";
  const Extremes& found = record.extremes;
  Json json = {
      {"state", word_for(end.state)},
      {"sentences", sentences(prepared, record, end)},
      {"kinetic_share", end.kinetic_share ? Json(*end.kinetic_share) : Json()},
      {"fastest", {{part, end.fastest + 1}, {"speed", end.speed}, {"x", end.fastest_at.x}, {"y", end.fastest_at.y}}},
      {"farthest",
       {{part, found.displaced_element + 1},
        {"displacement", found.displacement},
        {"x", found.displaced_from.x},
        {"y", found.displaced_from.y}}}};
  return json;
}

}  // namespace keyblock
