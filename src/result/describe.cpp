// Saves and restores the reports of runs, member by member.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/describe.hpp"

namespace keyblock {
namespace {

void describe(Archive& a, Point& point) {
  a.value("x", point.x);
  a.value("y", point.y);
}

void describe(Archive& a, const char* name, Point& point) {
  a.group(name, [&] { describe(a, point); });
}

void describe(Archive& a, Rare<PlasticState>& state) {
  bool may_yield = state.has_value();
  a.value("may_yield", may_yield);
  if (!may_yield) return;
  PlasticState& s = state ? *state : state.emplace();
  a.value("plastic_xx", s.xx);
  a.value("plastic_yy", s.yy);
  a.value("plastic_xy", s.xy);
  a.value("plastic_zz", s.zz);
  a.value("equivalent", s.equivalent);
  a.choice("region", s.region, YieldRegion::tension);
  a.value("has_yielded", s.has_yielded);
}

void describe(Archive& a, const char* name, std::optional<PlasticTotals>& totals) {
  a.group(name, [&] {
    bool may_yield = totals.has_value();
    a.value("may_yield", may_yield);
    if (!may_yield) return;
    PlasticTotals& t = totals ? *totals : totals.emplace();
    a.value("area", t.area);
    a.value("yielded", t.yielded);
    a.value("yielding", t.yielding);
    bool has_work = t.work.has_value();
    a.value("has_work", has_work);
    if (has_work) a.value("work", t.work ? *t.work : t.work.emplace());
  });
}

void describe(Archive& a, PointFrame& point) {
  describe(a, "position", point.position);
  describe(a, "displacement", point.displacement);
  a.value("element", point.element);
  a.value("stress_xx", point.stress.xx);
  a.value("stress_yy", point.stress.yy);
  a.value("stress_xy", point.stress.xy);
  a.value("stress_zz", point.stress.zz);
  a.value("number", point.number);
  describe(a, point.plastic);
}

void describe(Archive& a, const char* name, std::vector<PointFrame>& points) {
  a.list(name, points, [&](PointFrame& point) { describe(a, point); });
}

void describe(Archive& a, BoltFrame& bolt) {
  describe(a, "first", bolt.first);
  describe(a, "second", bolt.second);
  a.value("force", bolt.force);
  a.value("is_broken", bolt.is_broken);
  a.value("number", bolt.number);
  a.value("name", bolt.name);
}

void describe(Archive& a, const char* name, std::vector<std::vector<Point>>& loops) {
  a.list(name, loops,
         [&](std::vector<Point>& loop) { a.list("points", loop, [&](Point& point) { describe(a, point); }); });
}

void describe(Archive& a, ElementFrame& element) {
  describe(a, "loops", element.loops);
  a.value("material", element.material);
  describe(a, "centroid", element.centroid);
  describe(a, "displacement", element.displacement);
  a.value("rotation", element.rotation);
  a.value("velocity_x", element.velocity.x);
  a.value("velocity_y", element.velocity.y);
  a.value("velocity_r", element.velocity.rotation);
  a.value("stress_xx", element.stress.xx);
  a.value("stress_yy", element.stress.yy);
  a.value("stress_xy", element.stress.xy);
  a.value("stress_zz", element.stress.zz);
  a.value("area", element.area);
  a.value("mass", element.mass);
  a.value("moment_of_inertia", element.moment_of_inertia);
  a.value("number", element.number);
  a.value("origin", element.origin);
  describe(a, element.plastic);
}

void describe(Archive& a, const char* name, Momentum& momentum) {
  a.group(name, [&] {
    describe(a, momentum.linear);
    a.value("angular", momentum.angular);
  });
}

}  // namespace

void describe(Archive& a, Frame& frame) {
  a.value("step", frame.step);
  a.value("time", frame.time);
  a.list("elements", frame.elements, [&](ElementFrame& element) { describe(a, element); });
  describe(a, "fixed_points", frame.fixed_points);
  describe(a, "loading_points", frame.loading_points);
  describe(a, "measured_points", frame.measured_points);
  a.list("bolts", frame.bolts, [&](BoltFrame& bolt) { describe(a, bolt); });
  describe(a, "outlines", frame.outlines);
  a.list("reactions", frame.reactions, [&](Point& force) { describe(a, force); });
  describe(a, "plastic", frame.plastic);
  a.list("tips", frame.tips, [&](TipState& tip) { describe(a, tip); });
  a.value("load_factor", frame.load_factor);
}

void describe(Archive& a, HistoryRow& row) {
  a.value("step", row.step);
  a.value("time", row.time);
  describe(a, "points", row.points);
  a.numbers("bolt_forces", row.bolt_forces);
  a.list("reactions", row.reactions, [&](Point& force) { describe(a, force); });
  a.numbers("driven", row.driven);
  bool has_share = row.load_share.has_value();
  a.value("has_load_share", has_share);
  if (has_share) a.value("load_share", row.load_share ? *row.load_share : row.load_share.emplace());
  describe(a, "plastic", row.plastic);
  a.list("tips", row.tips, [&](TipState& tip) { describe(a, tip); });
  a.value("load_factor", row.load_factor);
}

void describe(Archive& a, TipState& tip) {
  a.value("crack", tip.crack);
  a.value("at_end", tip.at_end);
  describe(a, tip.at);
  a.value("length", tip.length);
  a.value("mode_1", tip.mode_1);
  a.value("mode_2", tip.mode_2);
  a.value("energy_release", tip.energy_release);
  a.value("equivalent", tip.equivalent);
  a.value("kink", tip.kink);
  a.value("toughness", tip.toughness);
  a.value("has_room", tip.has_room);
  a.value("goes_on", tip.goes_on);
  a.value("is_shear", tip.is_shear);
}

void describe(Archive& a, CrackNotes& notes) {
  const auto at_tip = [&](const char* name, CrackNotes::AtTip& tip) {
    a.group(name, [&] {
      a.value("step", tip.step);
      a.value("crack", tip.crack);
      describe(a, tip.at);
      a.value("increment", tip.increment);
      a.value("ratio", tip.ratio);
    });
  };
  at_tip("bent", notes.bent);
  at_tip("overlapping", notes.overlapping);
  a.group("coarse_start", [&] {
    CrackNotes::Start& start = notes.coarse_start;
    a.value("step", start.step);
    a.value("count", start.count);
    describe(a, start.at);
    a.value("side", start.side);
    a.value("length", start.length);
    a.value("strength", start.strength);
    a.value("of_rock", start.of_rock);
  });
}

void describe(Archive& a, LedgerRow& row) {
  a.value("step", row.step);
  a.value("time", row.time);
  a.value("kinetic", row.stored.kinetic);
  a.value("strain", row.stored.strain);
  a.value("gravity", row.stored.gravity);
  a.value("contact", row.stored.contact);
  a.value("external", row.flow.external);
  a.value("projection", row.flow.projection);
  a.value("geometric", row.flow.geometric);
  a.value("creep", row.flow.creep);
  a.value("change", row.flow.change);
  a.value("friction", row.flow.friction);
  a.value("damping", row.flow.damping);
  a.value("impact", row.flow.impact);
  a.value("closing", row.flow.closing);
  a.value("clean_up", row.flow.clean_up);
  a.value("rupture", row.flow.rupture);
  a.value("fracture", row.flow.fracture);
  a.value("plastic", row.flow.plastic);
  a.value("algorithmic", row.flow.algorithmic);
  describe(a, "momentum", row.momentum);
  describe(a, "impulse", row.impulse);
  a.value("linear_size", row.momentum_size.linear);
  a.value("angular_size", row.momentum_size.angular);
}

void describe(Archive& a, LedgerSums& sums) {
  a.value("is_begun", sums.is_begun);
  a.group("first", [&] { describe(a, sums.first); });
  a.value("largest", sums.largest);
  a.value("largest_stored", sums.largest_stored);
  a.value("least", sums.least);
  a.value("made", sums.made);
  a.value("above_start", sums.above_start);
  a.value("energy_gap", sums.energy_gap);
  a.value("linear_gap", sums.linear_gap);
  a.value("linear_size", sums.linear_size);
  a.value("angular_gap", sums.angular_gap);
  a.value("angular_size", sums.angular_size);
}

void describe(Archive& a, StepTotals& totals) {
  a.value("steps", totals.steps);
  a.value("most_contacts", totals.most_contacts);
  a.value("redos", totals.redos);
  a.value("fallbacks", totals.fallbacks);
  a.value("passes", totals.passes);
  a.value("most_passes", totals.most_passes);
  a.group("steps_by_passes", [&] {
    for (int& steps : totals.steps_by_passes) a.value("steps", steps);
  });
  a.value("unresolved_parts", totals.unresolved_parts);
  a.value("locked_overlaps", totals.locked_overlaps);
  a.value("greatest_penetration", totals.greatest_penetration);
  a.value("penetration_share", totals.penetration_share);
  a.value("area_share", totals.area_share);
  a.value("crushed_element", totals.crushed_element);
  a.value("greatest_displacement_ratio", totals.greatest_displacement_ratio);
  a.value("greatest_residual", totals.greatest_residual);
  a.value("unbalanced_steps", totals.unbalanced_steps);
  a.value("least_dt", totals.least_dt);
  a.value("greatest_dt", totals.greatest_dt);
}

void describe(Archive& a, StepReport& report) {
  a.value("step", report.step);
  a.value("time", report.time);
  a.value("dt", report.dt);
  a.value("passes", report.passes);
  a.value("redos", report.redos);
  a.value("fallbacks", report.fallbacks);
  a.value("contacts", report.contacts);
  a.value("closed", report.closed);
  a.value("matrix_blocks", report.matrix_blocks);
  a.value("penalty", report.penalty);
  a.value("displacement_ratio", report.displacement_ratio);
  a.value("greatest_penetration", report.greatest_penetration);
  a.value("penetration_share", report.penetration_share);
  a.value("area_share", report.area_share);
  a.value("crushed_element", report.crushed_element);
  a.value("residual", report.residual);
  a.value("residual_element", report.residual_element);
  a.value("residual_other", report.residual_other);
  describe(a, "residual_at", report.residual_at);
  a.value("parts", report.parts);
  a.numbers("residuals", report.residuals);
  a.value("unresolved_parts", report.unresolved_parts);
  a.value("locked_overlaps", report.locked_overlaps);
  a.value("unsettled_contacts", report.unsettled_contacts);
}

void describe(Archive& a, ForceBalance& balance) {
  const auto describe_resultant = [&](Resultant& resultant) {
    a.value("x", resultant.force.x);
    a.value("y", resultant.force.y);
    a.value("moment", resultant.moment);
  };
  a.group("loads", [&] { describe_resultant(balance.loads); });
  a.group("springs", [&] { describe_resultant(balance.springs); });
  a.list("supports", balance.supports, describe_resultant);
}

}  // namespace keyblock
