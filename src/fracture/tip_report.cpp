// Tries every domain in turn; see tip_report.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/tip_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Radii of circles per room around a tip, the largest first.
constexpr std::array<double, 4> kCircles{0.9, 0.675, 0.45, 0.225};
constexpr double kInner = 0.4;  // per outer radius: where q begins to fall
constexpr std::array<int, 5> kLevels{1, 2, 3, 4, 6};
// Limits beyond which K is doubted: spread per K, and sides per room around the tip. Benchmarks fra-01 to 12 stay below
// a hundredth of K; K is 3 % low at a fortieth.
constexpr double kMostSpread = 0.03;
constexpr double kMostDifferenceOfJ =
    0.1;  // per J, from (K_I² + K_II²)/E'; except for closed faces with friction they are within 0.02
constexpr double kLargestSide = 1.0 / 40;
constexpr double kLargestSideOfFunctions = 1.0 / 3;  // with near-tip functions K is within 0.1 % at a quarter
constexpr double kLeastSides = 1;                    // sides of the tip's triangle in the inner radius of a circle

DomainChoice circle(const CrackTip& tip, double share) {
  return {DomainKind::circle, kInner * share * tip.room, share * tip.room, 0};
}

/// Returns the tip with the room that its continuum leaves: point loads and fixed edges must lie outside a domain.
CrackTip with_loads_in_the_way(const Continuum& continuum, CrackTip tip) {
  const auto look = [&](double d, const char* what) {
    if (d >= tip.room) return;
    tip.room = d;
    tip.nearest = what;
  };
  for (const PointForce& force : continuum.point_forces) look(distance(force.at, tip.at), "a force");
  for (const PointSpring& spring : continuum.point_springs) look(distance(spring.at, tip.at), "a spring");
  for (const PrescribedDisplacement& part : continuum.prescribed)
    for (std::size_t i = 0; i + 1 < part.along.size(); ++i)
      look(distance(Segment{part.along[i], part.along[i + 1]}, tip.at), "a fixed edge");
  return tip;
}

double side_at(const Manifold& manifold, const CrackTip& tip) {
  const int e = element_of(manifold, tip);
  if (e < 0) return std::numeric_limits<double>::infinity();
  const auto t = manifold.triangle(manifold.elements[static_cast<std::size_t>(e)]);
  return std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
}

DomainResult result_of(const CoverSolution& solution, const CrackTip& tip, const DomainChoice& choice, double side) {
  DomainResult result{choice, std::nullopt};
  if (choice.kind == DomainKind::circle && choice.inner < kLeastSides * side) {
    result.refusal = fmt::format(
        "its inner radius {:.4g} is below the side of the mesh at the tip, {:.4g}: {} is {:.4g} "
        "away (tip_side refines)",
        choice.inner, side, tip.nearest, tip.room);
    return result;
  }
  const CrackDomain domain(solution.continuum.manifold, tip, choice);
  if (const auto obstacle = domain.obstacle())
    result.refusal = *obstacle;
  else
    result.factors = factors_at(solution, tip, domain);
  return result;
}

double spread(const std::vector<DomainResult>& domains, double StressIntensity::*mode) {
  double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
  for (const DomainResult& domain : domains) {
    if (domain.choice.kind != DomainKind::circle || !domain.factors) continue;
    least = std::min(least, domain.factors->k.*mode);
    greatest = std::max(greatest, domain.factors->k.*mode);
  }
  return greatest < least ? 0 : greatest - least;
}

// Returns an empty string, or the reason why sides at a tip are too long for its factors.
std::string coarse(double side, double room, bool has_functions) {
  if (has_functions && side > kLargestSideOfFunctions * room)
    return fmt::format("sides of {:.3g} at the tip are more than a third of the {:.3g} about it (tip_side refines)",
                       side, room);
  if (!has_functions && side > kLargestSide * room)
    return fmt::format(
        "sides of {:.3g} at the tip are more than a fortieth of the {:.3g} about it: K may be off by 3 % or "
        "more (tip_side refines)",
        side, room);
  return {};
}

}  // namespace

std::string doubt_of(const TipReport& report) {
  if (!report.factors) return "no domain about it has room";
  const double spread = std::max(report.spread_1, report.spread_2);
  if (spread > kMostSpread)
    return fmt::format("its circles differ by {:.1f} % of K: something acts on the rock between them", 100 * spread);
  const StressIntensity& k = report.factors->k;
  if (faces_overlap(k))
    return fmt::format(
        "K_I is {:.4g}, below 0: its faces overlap there, because contact is ignored; with contact=felt they touch, "
        "K_I is 0, and friction acts on K_II",
        k.mode_1);
  const double by_factors = energy_release(report.rock, k);
  if (std::abs(report.factors->j - by_factors) > kMostDifferenceOfJ * std::max(by_factors, report.factors->j))
    return fmt::format("J {:.4g} and (K_I² + K_II²)/E' {:.4g} differ", report.factors->j, by_factors);
  return coarse(report.side, report.tip.room, report.has_functions);
}

std::string coarse_mesh_at(const Continuum& continuum, const CrackTip& alone) {
  const CrackTip tip = with_loads_in_the_way(continuum, alone);
  return coarse(side_at(continuum.manifold, tip), tip.room, continuum.tip_functions.are_asked());
}

std::vector<DomainChoice> domain_choices(const CrackTip& tip) {
  std::vector<DomainChoice> choices;
  for (const double share : kCircles) choices.push_back(circle(tip, share));
  for (const DomainKind kind : {DomainKind::element_levels, DomainKind::node_levels})
    for (const int levels : kLevels) choices.push_back({kind, 0, 0, levels});
  return choices;
}

TipReport tip_report(const CoverSolution& solution, const CrackTip& alone) {
  const CrackTip tip = with_loads_in_the_way(solution.continuum, alone);
  TipReport report{tip,
                   rock_at(solution.continuum, tip),
                   side_at(solution.continuum.manifold, tip),
                   solution.basis.has_tip_functions(),
                   {}};
  for (const DomainChoice& choice : domain_choices(tip)) {
    report.domains.push_back(result_of(solution, tip, choice, report.side));
    const bool is_circle = choice.kind == DomainKind::circle;
    if (is_circle && !report.factors) report.factors = report.domains.back().factors;
  }
  if (!report.factors) return report;
  const double size = std::hypot(report.factors->k.mode_1, report.factors->k.mode_2);
  if (size > 0) {
    report.spread_1 = spread(report.domains, &StressIntensity::mode_1) / size;
    report.spread_2 = spread(report.domains, &StressIntensity::mode_2) / size;
  }
  return report;
}

std::optional<TipFactors> tip_factors(const CoverSolution& solution, const CrackTip& alone) {
  const CrackTip tip = with_loads_in_the_way(solution.continuum, alone);
  return result_of(solution, tip, circle(tip, kCircles.front()), side_at(solution.continuum.manifold, tip)).factors;
}

}  // namespace keyblock
