// Reads columns in SI, applies a formula per row, and computes mean and scatter; see toughness_fit.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/toughness_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::study {
namespace {

constexpr double kMega = 1e6;
constexpr double kSameProportion = 1e-9;  // of lengths that are written with decimals

/// Lengths and loads of a table, in SI if they have units.
class Specimens {
 public:
  explicit Specimens(const formats::CsvTable& table) : table_(table) {}

  std::vector<double> lengths(std::string_view word) { return column(word, kLengthDimension, "length, such as mm"); }
  /// Reads the loads, last of all columns: by then either all columns have units or none.
  std::vector<double> loads() {
    std::vector<double> read = column("load", kForceDimension, "force, such as kN");
    if (with_unit_ > 0 && without_unit_ > 0)
      throw InputError({table_.name, 1, 1}, "expected units in all headings or in none, found them in some");
    return read;
  }
  bool have_units() const { return with_unit_ > 0; }

  /// Rejects a specimen whose proportion is outside the range.
  void require(std::size_t row, const char* what, double found, double low, double high) const {
    if (found >= low * (1 - kSameProportion) && found <= high * (1 + kSameProportion)) return;
    throw InputError({table_.name, table_.rows[row].line, 1},
                     fmt::format("expected {} from {:.4g} to {:.4g}, for which the formula was made, found {:.4g}",
                                 what, low, high, found));
  }

 private:
  std::vector<double> column(std::string_view word, const Dimension& dimension, const char* kind) {
    MeasuredColumn read = read_column(table_, word);
    ++(read.unit.empty() ? without_unit_ : with_unit_);
    double factor = 1;
    if (!read.unit.empty()) {
      const std::optional<Unit> unit = unit_named(read.unit);
      if (!unit || unit->dimension != dimension)
        throw InputError({table_.name, 1, 1}, fmt::format("expected a unit of {} in the heading of {}, found \"{}\"",
                                                          kind, word, read.unit));
      factor = unit->factor;
    }
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      if (!(read.values[i] > 0))
        throw InputError({table_.name, table_.rows[i].line, 1},
                         fmt::format("expected a {} above 0, found {}", word, read.values[i]));
      read.values[i] *= factor;
    }
    return std::move(read.values);
  }

  const formats::CsvTable& table_;
  int with_unit_ = 0, without_unit_ = 0;
};

std::vector<double> of_chevron_bend(Specimens& table) {
  const std::vector<double> diameter = table.lengths("diameter"), span = table.lengths("span"),
                            notch = table.lengths("notch"), load = table.loads();
  std::vector<double> k;
  for (std::size_t i = 0; i < load.size(); ++i) {
    const double a = notch[i] / diameter[i], s = span[i] / diameter[i];
    table.require(i, "a notch over the diameter", a, 0.05, 0.25);
    table.require(i, "a span over the diameter", s, 3.2, 3.5);
    k.push_back((1.835 + 7.15 * a + 9.85 * a * a) * s * load[i] / std::pow(diameter[i], 1.5));
  }
  return k;
}

std::vector<double> of_semicircular_bend(Specimens& table) {
  const std::vector<double> radius = table.lengths("radius"), thickness = table.lengths("thickness"),
                            notch = table.lengths("notch"), span = table.lengths("span"), load = table.loads();
  std::vector<double> k;
  for (std::size_t i = 0; i < load.size(); ++i) {
    const double b = notch[i] / radius[i], s = span[i] / (2 * radius[i]);
    table.require(i, "a notch over the radius", b, 0.4, 0.6);
    table.require(i, "a span over the diameter", s, 0.5, 0.8);
    const double y = -1.297 + 9.516 * s - (0.47 + 16.457 * s) * b + (1.071 + 34.401 * s) * b * b;
    k.push_back(load[i] * std::sqrt(std::numbers::pi * notch[i]) * y / (2 * radius[i] * thickness[i]));
  }
  return k;
}

std::vector<double> of_notched_disc(Specimens& table) {
  const std::vector<double> diameter = table.lengths("diameter"), thickness = table.lengths("thickness"),
                            notch = table.lengths("notch"), end = table.lengths("end"), load = table.loads();
  std::vector<double> k;
  for (std::size_t i = 0; i < load.size(); ++i) {
    const double radius = diameter[i] / 2;
    table.require(i, "a notch over the radius", notch[i] / radius, 0.25, 0.275);
    table.require(i, "a thickness over the radius", thickness[i] / radius, 0.78, 0.82);
    table.require(i, "an end of the notch over the radius", end[i] / radius, 0.6, 0.7);
    k.push_back(load[i] * 0.2667 * std::exp(1.7676 * end[i] / radius) / (thickness[i] * std::sqrt(diameter[i])));
  }
  return k;
}

}  // namespace

ToughnessFit fit_toughness(const formats::CsvTable& tests, ToughnessTest test) {
  if (tests.rows.empty()) throw InputError({tests.name, 0, 0}, "expected at least one specimen, found none");
  Specimens table(tests);
  ToughnessFit fit;
  fit.of_specimen = test == ToughnessTest::chevron_bend        ? of_chevron_bend(table)
                    : test == ToughnessTest::semicircular_bend ? of_semicircular_bend(table)
                                                               : of_notched_disc(table);
  if (table.have_units()) {
    fit.unit = "MPa√m";
    for (double& k : fit.of_specimen) k /= kMega;
  }
  const auto count = static_cast<double>(fit.of_specimen.size());
  const double mean = std::accumulate(fit.of_specimen.begin(), fit.of_specimen.end(), 0.0) / count;
  double squares = 0;
  for (const double k : fit.of_specimen) squares += (k - mean) * (k - mean);
  fit.mean = found(mean, std::sqrt(squares / (count - 1) / count), static_cast<int>(fit.of_specimen.size()) - 1);
  return fit;
}

}  // namespace keyblock::study
