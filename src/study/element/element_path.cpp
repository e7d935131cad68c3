// Builds paths, and computes strains under prescribed stress step by step; see element_path.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/element/element_path.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "base/error.hpp"
#include "material/crack_return.hpp"
#include "problem/limits.hpp"
#include "problem/units/measure.hpp"

namespace keyblock::study {
namespace {

constexpr std::array<std::string_view, 4> kStrains{"exx", "eyy", "gxy", "ezz"};
constexpr std::array<std::string_view, 4> kStresses{"sxx", "syy", "sxy", "szz"};
constexpr std::array<std::string_view, 5> kRegions{"elastic", "plane", "edge", "apex", "tension"};

// Tolerance of prescribed stresses, relative to the current stress.
constexpr double kReached = 1e-12;
constexpr int kMostTries = 60;
constexpr double kLeastPart = 1.0 / 1024;
// Fraction of the greatest pivot of a tangent, below which a direction has no stiffness.
constexpr double kNoStiffness = 1e-10;

struct Step {
  Eigen::Vector4d increment;
  Response response;
};

/// Returns the free components of a leg.
std::vector<int> stressed(const ElementLeg& leg) {
  std::vector<int> free;
  for (int i = 0; i < 4; ++i)
    if (leg[static_cast<std::size_t>(i)].is_stress) free.push_back(i);
  return free;
}

std::optional<Step> solved(const YieldLaw& law, const YieldState& before, const ElementLeg& leg,
                           const Eigen::Vector4d& wanted, double size) {
  const std::vector<int> free = stressed(leg);
  const auto count = static_cast<Eigen::Index>(free.size());
  Step step{Eigen::Vector4d::Zero(), {}};
  for (int i = 0; i < 4; ++i)
    if (!leg[static_cast<std::size_t>(i)].is_stress) step.increment(i) = wanted(i);
  const auto missing_of = [&](const Response& r) {
    Eigen::VectorXd missing(count);
    for (Eigen::Index i = 0; i < count; ++i)
      missing(i) = r.stress(free[static_cast<std::size_t>(i)]) - wanted(free[static_cast<std::size_t>(i)]);
    return missing;
  };
  step.response = respond(law, step.increment, before, size);
  // The stress of elastic rock under the strains alone is the scale if the resulting stress is zero.
  double scale = std::max((law.modulus() * before.elastic).norm(), (law.modulus() * step.increment).norm());
  for (const int i : free) scale = std::max(scale, std::abs(wanted(i)));
  Eigen::VectorXd missing = missing_of(step.response);
  for (int round = 0; round < kMostTries && missing.norm() > kReached * scale; ++round) {
    Eigen::MatrixXd tangent(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        tangent(i, j) = step.response.tangent(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(count, count);
    solver.setThreshold(kNoStiffness);
    Eigen::VectorXd change = -solver.compute(tangent).solve(missing);
    for (int halving = 0; halving < 10; ++halving) {
      Eigen::Vector4d next = step.increment;
      for (Eigen::Index i = 0; i < count; ++i) next(free[static_cast<std::size_t>(i)]) += change(i);
      const Response response = respond(law, next, before, size);
      const Eigen::VectorXd left = missing_of(response);
      const bool falls = left.norm() < missing.norm();
      if (!falls && halving < 9) {
        change /= 2;
        continue;
      }
      step = {next, response};
      missing = left;
      break;
    }
  }
  if (missing.norm() <= kReached * scale && step.response.is_found) return step;
  return std::nullopt;
}

class Element {
 public:
  Element(const YieldLaw& law, const ElementPath& path, double size) : law_(law), size_(size) {
    now_.stress = path.initial_stress;
    now_.state.elastic = law.elastic_strain(path.initial_stress);
  }

  const ElementPoint& now() const { return now_; }

  /// Goes a fraction of the way to the end of the leg from `began`; returns false if no strain gives the stress.
  bool go(const ElementLeg& leg, const ElementPoint& began, double from, double to, double part) {
    while (from < to) {
      const double end = std::min(to, from + part);
      Eigen::Vector4d wanted;
      for (int i = 0; i < 4; ++i) {
        const DrivenComponent& driven = leg[static_cast<std::size_t>(i)];
        const double first = driven.is_stress ? began.stress(i) : began.strain(i);
        const double aim = first + end * (driven.target - first);
        wanted(i) = driven.is_stress ? aim : aim - now_.strain(i);
      }
      const std::optional<Step> step = solved(law_, now_.state, leg, wanted, size_);
      if (step) {
        now_.strain += step->increment;
        now_.stress = step->response.stress;
        now_.state = step->response.after;
        now_.plastic_work += step->response.stress.dot(step->response.plastic);
        from = end;
      } else if ((part /= 2) < kLeastPart * (to - from)) {
        return false;
      }
    }
    return true;
  }

  void begin(int leg) { now_.leg = leg; }

 private:
  const YieldLaw& law_;
  double size_;
  ElementPoint now_;
};

bool is_finite(const ElementPoint& point) {
  return point.strain.allFinite() && point.stress.allFinite() && std::isfinite(point.state.kappa) &&
         std::isfinite(point.plastic_work);
}

}  // namespace

ElementPath named_path(NamedPath name, const std::vector<double>& targets, double confining) {
  ElementPath path;
  const bool is_confined = name == NamedPath::triaxial || name == NamedPath::biaxial;
  const double kept = is_confined ? -confining : 0;
  if (is_confined) path.initial_stress = {kept, kept, 0, kept};
  const DrivenComponent held{}, pressed{true, kept};
  for (const double target : targets) {
    const DrivenComponent driven{false, target};
    switch (name) {
      case NamedPath::uniaxial:
      case NamedPath::triaxial:
        path.legs.push_back({pressed, driven, held, pressed});
        break;
      case NamedPath::biaxial:
        path.legs.push_back({pressed, driven, held, held});
        break;
      case NamedPath::oedometer:
        path.legs.push_back({held, driven, held, held});
        break;
      case NamedPath::shear:
        path.legs.push_back({held, held, driven, held});
        break;
    }
  }
  return path;
}

ElementPath read_path(const formats::CsvTable& table) {
  std::array<std::optional<std::size_t>, 4> columns;
  ElementLeg shape;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    const auto in = [&](const auto& names) {
      return static_cast<std::size_t>(std::ranges::find(names, table.header[c]) - names.begin());
    };
    const std::size_t strain = in(kStrains), stress = in(kStresses), at = std::min(strain, stress);
    if (at == 4)
      throw InputError({table.name, 1, 1},
                       fmt::format("expected columns exx or sxx, eyy or syy, gxy or sxy, ezz or szz, found \"{}\"",
                                   table.header[c]));
    if (columns[at])
      throw InputError({table.name, 1, 1},
                       fmt::format("expected one of {} and {}, found both or one twice", kStrains[at], kStresses[at]));
    columns[at] = c;
    shape[at].is_stress = stress < 4;
  }
  ElementPath path;
  for (const formats::CsvRow& row : table.rows) {
    ElementLeg& leg = path.legs.emplace_back(shape);
    for (std::size_t i = 0; i < 4; ++i)
      if (columns[i]) {
        leg[i].target = formats::csv_real(table, row, *columns[i]);
        if (const double greatest = shape[i].is_stress ? kGreatestQuantity : kGreatestStrain;
            !(std::abs(leg[i].target) <= greatest))
          throw InputError({table.name, row.line, row.columns[*columns[i]]},
                           fmt::format("expected {} from {:g} to {:g}, found {:g}", table.header[*columns[i]],
                                       -greatest, greatest, leg[i].target));
      }
  }
  if (path.legs.empty()) throw InputError({table.name, 1, 1}, "expected a row for each leg of the path, found none");
  return path;
}

ElementCurve drive(const YieldLaw& law, const ElementPath& path, int steps, double size) {
  Element element(law, path, size);
  ElementCurve curve{{element.now()}, {}};
  for (std::size_t l = 0; l < path.legs.size(); ++l) {
    const ElementPoint began = element.now();
    element.begin(static_cast<int>(l) + 1);
    for (int i = 0; i < steps; ++i) {
      const double from = static_cast<double>(i) / steps, to = static_cast<double>(i + 1) / steps;
      if (!element.go(path.legs[l], began, from, to, to - from)) {
        curve.failure = fmt::format("leg {}, step {} of {}: no strain was found that carries the requested stress",
                                    l + 1, i + 1, steps);
        return curve;
      }
      if (!is_finite(element.now())) {
        curve.failure = fmt::format("leg {}, step {} of {}: the answer is not a finite number", l + 1, i + 1, steps);
        return curve;
      }
      curve.points.push_back(element.now());
    }
  }
  return curve;
}

std::string element_csv(const ElementCurve& curve, const Units& units) {
  std::string text = "leg,exx,eyy,gxy,ezz";
  for (const char* stress : {"sxx", "syy", "sxy", "szz", "s1", "s2", "s3"})
    text += ',' + with_declared(stress, measures::kStress, units);
  text += ",kappa," + with_declared("plastic_work", measures::kStress, units) + ",region\n";
  for (const ElementPoint& p : curve.points) {
    const double centre = (p.stress(0) + p.stress(1)) / 2;
    const double radius = std::hypot((p.stress(0) - p.stress(1)) / 2, p.stress(2));
    std::array<double, 3> principal{centre + radius, centre - radius, p.stress(3)};
    std::ranges::sort(principal, std::greater<>());
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", p.leg, p.strain(0), p.strain(1), p.strain(2),
                    p.strain(3), p.stress(0), p.stress(1), p.stress(2), p.stress(3), principal[0], principal[1],
                    principal[2], p.state.kappa, p.plastic_work, kRegions[static_cast<std::size_t>(p.state.region)]);
  }
  return text;
}

}  // namespace keyblock::study
