// Holds the table of quantities.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/cases/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <variant>

namespace keyblock::study {
namespace {

/// Block now and at the start of the run.
struct Block {
  const ElementFrame& now;
  const ElementFrame& start;
};

using OfBlock = double (*)(const Block&);
using OfPoint = double (*)(const PointFrame&);
using OfScene = double (*)(const RunSoFar&);
using OfSupport = double (*)(Point reaction);
using OfTip = double (*)(const TipState&);
using Quantity = std::variant<OfBlock, OfPoint, OfSupport, OfTip, OfScene>;  // in the order of Owner

double speed(const ElementFrame& e) {
  return std::hypot(e.velocity.x, e.velocity.y);
}

// Energy of translation and rotation: both profiles agree on it, although their strain rates have different frames.
double kinetic_energy(const ElementFrame& e) {
  return (e.mass * speed(e) * speed(e) + e.moment_of_inertia * e.velocity.rotation * e.velocity.rotation) / 2;
}

template <class OfElement>
double sum(const Frame& frame, OfElement of) {
  double total = 0;
  for (const ElementFrame& e : frame.elements) total += of(e);
  return total;
}

double mean_by_mass(const Frame& frame, double Point::*coordinate) {
  return sum(frame, [&](const ElementFrame& e) { return e.mass * e.centroid.*coordinate; }) /
         sum(frame, [](const ElementFrame& e) { return e.mass; });
}

double area_change(const Frame& start, const Frame& now) {
  double greatest = 0;
  const ElementsByNumber first(start);
  for (std::size_t e = 0; e < now.elements.size(); ++e) {
    const ElementFrame* before = first.find(number_of(now, e));
    if (before != nullptr && before->mass == now.elements[e].mass)
      greatest = std::max(greatest, std::abs(now.elements[e].area / before->area - 1));
  }
  return greatest;
}

double greatest_speed(const RunSoFar& run) {
  double greatest = 0;
  for (const ElementFrame& e : run.now().elements) greatest = std::max(greatest, speed(e));
  return greatest;
}

// Returns zero values for rock that cannot yield.
template <class Of>
PlasticState plastic(const Of& of) {
  return of.plastic.value_or(PlasticState{});
}

double plastic_work(const Frame& frame) {
  if (!frame.plastic) return 0;
  return frame.plastic->work.value_or(std::numeric_limits<double>::quiet_NaN());
}

const std::map<std::string, Quantity>& table() {
  static const std::map<std::string, Quantity> quantities{
      {"displacement", OfBlock([](const Block& b) { return length(b.now.displacement); })},
      {"travel", OfBlock([](const Block& b) { return distance(b.now.centroid, b.start.centroid); })},
      {"dx", OfBlock([](const Block& b) { return b.now.displacement.x; })},
      {"dy", OfBlock([](const Block& b) { return b.now.displacement.y; })},
      {"cx", OfBlock([](const Block& b) { return b.now.centroid.x; })},
      {"cy", OfBlock([](const Block& b) { return b.now.centroid.y; })},
      {"rotation", OfBlock([](const Block& b) { return b.now.rotation; })},
      {"vx", OfBlock([](const Block& b) { return b.now.velocity.x; })},
      {"vy", OfBlock([](const Block& b) { return b.now.velocity.y; })},
      {"speed", OfBlock([](const Block& b) { return speed(b.now); })},
      {"spin", OfBlock([](const Block& b) { return b.now.velocity.rotation; })},
      {"sxx", OfBlock([](const Block& b) { return b.now.stress.xx; })},
      {"syy", OfBlock([](const Block& b) { return b.now.stress.yy; })},
      {"sxy", OfBlock([](const Block& b) { return b.now.stress.xy; })},
      {"szz", OfBlock([](const Block& b) { return b.now.stress.zz; })},
      {"plastic_strain_xx", OfBlock([](const Block& b) { return plastic(b.now).xx; })},
      {"plastic_strain_yy", OfBlock([](const Block& b) { return plastic(b.now).yy; })},
      {"plastic_strain_xy", OfBlock([](const Block& b) { return plastic(b.now).xy; })},
      {"plastic_strain_zz", OfBlock([](const Block& b) { return plastic(b.now).zz; })},
      {"equivalent_plastic_strain", OfBlock([](const Block& b) { return plastic(b.now).equivalent; })},
      {"area", OfBlock([](const Block& b) { return b.now.area; })},

      {"px", OfPoint([](const PointFrame& p) { return p.position.x; })},
      {"py", OfPoint([](const PointFrame& p) { return p.position.y; })},
      {"point_dx", OfPoint([](const PointFrame& p) { return p.displacement.x; })},
      {"point_dy", OfPoint([](const PointFrame& p) { return p.displacement.y; })},

      {"point_sxx", OfPoint([](const PointFrame& p) { return p.stress.xx; })},
      {"point_syy", OfPoint([](const PointFrame& p) { return p.stress.yy; })},
      {"point_sxy", OfPoint([](const PointFrame& p) { return p.stress.xy; })},
      {"point_szz", OfPoint([](const PointFrame& p) { return p.stress.zz; })},

      {"point_plastic_strain_xx", OfPoint([](const PointFrame& p) { return plastic(p).xx; })},
      {"point_plastic_strain_yy", OfPoint([](const PointFrame& p) { return plastic(p).yy; })},
      {"point_plastic_strain_xy", OfPoint([](const PointFrame& p) { return plastic(p).xy; })},
      {"point_plastic_strain_zz", OfPoint([](const PointFrame& p) { return plastic(p).zz; })},
      {"point_equivalent_plastic_strain", OfPoint([](const PointFrame& p) { return plastic(p).equivalent; })},

      {"reaction_x", OfSupport([](Point reaction) { return reaction.x; })},
      {"reaction_y", OfSupport([](Point reaction) { return reaction.y; })},

      {"K_I", OfTip([](const TipState& t) { return t.mode_1; })},
      {"K_II", OfTip([](const TipState& t) { return t.mode_2; })},
      {"J", OfTip([](const TipState& t) { return t.energy_release; })},
      {"K_eq", OfTip([](const TipState& t) { return t.equivalent; })},
      {"kink_deg", OfTip([](const TipState& t) { return t.kink * 180 / std::numbers::pi; })},
      {"tip_x", OfTip([](const TipState& t) { return t.at.x; })},
      {"tip_y", OfTip([](const TipState& t) { return t.at.y; })},
      {"crack_length", OfTip([](const TipState& t) { return t.length; })},

      {"load_factor", OfScene([](const RunSoFar& r) { return r.now().load_factor; })},
      {"total_area",
       OfScene([](const RunSoFar& r) { return sum(r.now(), [](const ElementFrame& e) { return e.area; }); })},
      {"block_count", OfScene([](const RunSoFar& r) { return static_cast<double>(r.now().elements.size()); })},
      {"fixed_point_count",
       OfScene([](const RunSoFar& r) { return static_cast<double>(r.now().fixed_points.size()); })},
      {"kinetic_energy", OfScene([](const RunSoFar& r) { return sum(r.now(), kinetic_energy); })},
      {"momentum_x", OfScene([](const RunSoFar& r) {
         return sum(r.now(), [](const ElementFrame& e) { return e.mass * e.velocity.x; });
       })},
      {"momentum_y", OfScene([](const RunSoFar& r) {
         return sum(r.now(), [](const ElementFrame& e) { return e.mass * e.velocity.y; });
       })},
      {"centre_of_mass_x", OfScene([](const RunSoFar& r) { return mean_by_mass(r.now(), &Point::x); })},
      {"centre_of_mass_y", OfScene([](const RunSoFar& r) { return mean_by_mass(r.now(), &Point::y); })},
      {"greatest_centre_of_mass_y", OfScene([](const RunSoFar& r) { return r.greatest_height(); })},
      {"area_change", OfScene([](const RunSoFar& r) { return area_change(r.start(), r.now()); })},
      {"greatest_area_change", OfScene([](const RunSoFar& r) { return r.greatest_area_change(); })},
      {"greatest_speed", OfScene(greatest_speed)},
      {"yielded_fraction",
       OfScene([](const RunSoFar& r) { return r.now().plastic ? r.now().plastic->yielded_fraction() : 0; })},
      {"plastic_work", OfScene([](const RunSoFar& r) { return plastic_work(r.now()); })},
      {"converged_share", OfScene([](const RunSoFar& r) { return r.converged_share(); })},
      {"factor_of_safety", OfScene([](const RunSoFar& r) { return r.factor_of_safety(); })},
  };
  return quantities;
}

}  // namespace

std::optional<Owner> owner_of(const std::string& quantity) {
  const auto found = table().find(quantity);
  return found == table().end() ? std::nullopt : std::optional(static_cast<Owner>(found->second.index()));
}

void RunSoFar::add(const StepReport& step) {
  ++steps_;
  if (step.redos == 0 && step.unsettled_contacts == 0) ++converged_;
}

void RunSoFar::add(const Frame& frame) {
  now_ = frame;
  if (!has_begun_) start_ = frame;
  const double height = mean_by_mass(now_, &Point::y);
  greatest_height_ = has_begun_ ? std::max(greatest_height_, height) : height;
  greatest_area_change_ = std::max(greatest_area_change_, area_change(start_, now_));
  has_begun_ = true;
}

double RunSoFar::converged_share() const {
  return steps_ == 0 ? 1 : static_cast<double>(converged_) / steps_;
}

double quantity_of(const RunSoFar& run, const std::string& quantity, std::optional<int> number) {
  const Quantity& found = table().at(quantity);
  const int index = number.value_or(1) - 1;
  constexpr double kGone = std::numeric_limits<double>::quiet_NaN();
  if (const auto* of_block = std::get_if<OfBlock>(&found)) {
    const ElementFrame* now = element_of(run.now(), index);
    const ElementFrame* start = element_of(run.start(), index);
    return now == nullptr || start == nullptr ? kGone : (*of_block)({*now, *start});
  }
  if (const auto* of_point = std::get_if<OfPoint>(&found)) {
    const PointFrame* now = measured_point_of(run.now(), index);
    return now == nullptr ? kGone : (*of_point)(*now);
  }
  if (const auto* of_support = std::get_if<OfSupport>(&found)) {
    const auto place = static_cast<std::size_t>(index);
    return place < run.now().reactions.size() ? (*of_support)(run.now().reactions[place]) : kGone;
  }
  if (const auto* of_tip = std::get_if<OfTip>(&found)) {
    const auto place = static_cast<std::size_t>(index);
    return place < run.now().tips.size() ? (*of_tip)(run.now().tips[place]) : kGone;
  }
  return std::get<OfScene>(found)(run);
}

}  // namespace keyblock::study
