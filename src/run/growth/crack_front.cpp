// Extends the cracks tip by tip; see crack_front.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/crack_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/continuum.hpp"
#include "result/describe.hpp"

namespace keyblock {
namespace {

constexpr double kReach = 1.25;  // of an increment: a nearer tip is joined

Point next_place(const CrackFront& front, const Manifold& manifold, double increment, std::size_t i, double more) {
  const CrackTip& tip = tip_of(manifold, front.tips[i]);
  if (!front.tips[i].has_room)
    if (const std::optional<Point> through = way_through(manifold, tip, increment)) return *through;
  const Point direction = turned_to_left(tip.ahead, front.tips[i].kink + more);
  if (const std::optional<Point> other = facing_tip(manifold, tip.at, direction, 2 * kReach * increment)) {
    const bool comes = std::ranges::any_of(front.tips, [&](const TipState& t) { return t.goes_on && t.at == *other; });
    if (comes) return 0.5 * (tip.at + *other);
    if (distance(tip.at, *other) < kReach * increment) return *other;
  }
  return advance_of(manifold, tip.at, direction, increment).to;
}

}  // namespace

std::vector<TipState> tips_of(const CoverSolution& solution, const std::vector<CrackPlan>& cracks,
                              GrowthCriterion criterion) {
  std::vector<TipState> tips = followed_tips(solution.continuum.manifold, cracks);
  for (TipState& tip : tips) put_factors(tip, solution, criterion);
  return tips;
}

std::optional<Point> way_through(const Manifold& manifold, const CrackTip& tip, double increment) {
  const Advance ahead = advance_of(manifold, tip.at, tip.ahead, increment);
  return ahead.meets_line ? std::optional(ahead.to) : line_beside(manifold, tip, increment);
}

std::vector<CrackPlan> prolonged(const CrackFront& front, const Manifold& manifold, double increment,
                                 const std::vector<double>& more) {
  std::vector<CrackPlan> cracks = front.cracks;
  // Tips come first: tips of joints get numbers after the existing cracks.
  for (std::size_t i = 0; i < front.tips.size(); ++i)
    if (front.tips[i].goes_on) prolong(cracks, front.tips[i], next_place(front, manifold, increment, i, more[i]));
  for (const CrackStart& start : front.starts) {
    const Point half = start.half_length * start.along;
    cracks.push_back({{start.at - half, start.at + half}, {}, 0, start.is_shear});
  }
  return cracks;
}

std::vector<double> kink_corrections(const CrackFront& front, const std::vector<TipState>& found) {
  std::vector<double> more(front.tips.size(), 0);
  for (std::size_t i = 0; i < more.size(); ++i) {
    const TipState& tip = front.tips[i];
    if (!tip.goes_on || !tip.has_room) continue;
    for (const TipState& now : found)
      if (now.crack == tip.crack && now.at_end == tip.at_end && now.has_room) more[i] = now.kink / 2;
  }
  return more;
}

void note_front(CrackNotes& notes, int step, const CrackFront& front) {
  for (const TipState& tip : front.tips) {
    const StressIntensity k{tip.mode_1, tip.mode_2};
    const double ratio = tip.mode_1 / std::hypot(k.mode_1, k.mode_2);
    if (tip.goes_on && tip.has_room && faces_overlap(k) && ratio < notes.overlapping.ratio)
      notes.overlapping = {step, tip.crack, tip.at, 0, ratio};
  }
  for (const CrackStart& start : front.starts) {
    if (!start.is_coarse()) continue;
    CrackNotes::Start& first = notes.coarse_start;
    if (first.count++ == 0)
      first = {step, 1, start.at, start.side, start.length_of_rock, start.strength, start.strength_of_rock};
  }
}

void note_bends(CrackNotes& notes, int step, const CrackFront& before, const CrackFront& now) {
  for (const TipState& tip : now.tips) {
    const auto was = std::ranges::find_if(before.tips, [&](const TipState& t) {
      return t.goes_on && t.has_room && t.crack == tip.crack && t.at_end == tip.at_end;
    });
    if (was == before.tips.end() || !tip.has_room || !(tip.mode_1 > 0)) continue;
    const double ratio = tip.mode_2 / tip.mode_1;
    if (std::abs(ratio) > std::abs(notes.bent.ratio))
      notes.bent = {step, tip.crack, tip.at, distance(was->at, tip.at), ratio};
  }
}

std::string words_of(const TipState& tip, std::size_t number) {
  return fmt::format("tip {} (crack {}) at ({:.6g}, {:.6g})", number + 1, tip.crack + 1, tip.at.x, tip.at.y);
}

void describe(Archive& archive, const char* name, std::vector<CrackPlan>& cracks) {
  archive.list(name, cracks, [&](CrackPlan& crack) {
    archive.list("along", crack.along, [&](Point& point) {
      archive.value("x", point.x);
      archive.value("y", point.y);
    });
    archive.value("joint_material", crack.joint_material);
    archive.value("is_shear", crack.is_shear);
  });
}

void describe(Archive& archive, CrackFront& front) {
  describe(archive, "cracks_shown", front.cracks);
  archive.list("tips", front.tips, [&](TipState& tip) { describe(archive, tip); });
  archive.list("starts", front.starts, [&](CrackStart& start) {
    archive.value("x", start.at.x);
    archive.value("y", start.at.y);
    archive.value("along_x", start.along.x);
    archive.value("along_y", start.along.y);
    archive.value("half_length", start.half_length);
    archive.value("is_shear", start.is_shear);
  });
}

}  // namespace keyblock
