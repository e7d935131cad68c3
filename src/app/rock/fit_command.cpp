// `keyblock fit`: fits parameters of rock to measurements, with their errors and a picture.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "base/printable.hpp"
#include "formats/registry.hpp"
#include "formats/text/csv.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "report/rock/element_picture.hpp"
#include "study/fit/curve_fit.hpp"
#include "study/fit/fit_doubts.hpp"
#include "study/fit/strength_fit.hpp"
#include "study/fit/toughness_fit.hpp"

namespace keyblock {
namespace {

using Json = nlohmann::ordered_json;

struct FitOptions {
  std::string input;
  bool is_triaxial = false;
  std::string toughness;  ///< kind of test; empty: none
  std::string compression = "auto";
  std::optional<double> strain_factor;  ///< empty: by the heading
  double friction_deg = 0;
  std::string output;
  std::string material;
  std::string picture;
  bool may_overwrite = false;
  bool as_json = false;
};

const std::map<std::string, study::CompressionSign> kSigns{{"auto", study::CompressionSign::found},
                                                           {"positive", study::CompressionSign::positive},
                                                           {"negative", study::CompressionSign::negative}};

const std::map<std::string, study::ToughnessTest> kTests{{"chevron_bend", study::ToughnessTest::chevron_bend},
                                                         {"semicircular_bend", study::ToughnessTest::semicircular_bend},
                                                         {"notched_disc", study::ToughnessTest::notched_disc}};

struct NamedFound {
  const char* name;
  std::string unit;
  study::Found found;
};

/// Output of a fit of either kind.
struct Outcome {
  std::vector<NamedFound> values;
  study::Agreement agreement;
  Json material;
  std::string title;
  study::MeasuredPairs measured;
  report::AxisLabels axes;
  report::Curve line;
  bool is_mean = false;  ///< of specimens: no R²
  Warnings warnings;
};

Json json_of(const NamedFound& named) {
  // JSON has no infinity.
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  const study::Found& f = named.found;
  return {{"value", f.value},
          {"standard_error", number(f.standard_error)},
          {"interval", {number(f.low), number(f.high)}},
          {"unit", named.unit}};
}

/// Stresses of one table, in the form of the output.
class Stresses {
 public:
  explicit Stresses(std::string unit) : unit_(std::move(unit)) {}

  std::string in_words() const { return unit_.empty() ? "F/L²" : unit_; }
  /// Returns a value of a case file, which takes "20 GPa" in any units.
  Json value(double stress) const { return unit_.empty() ? Json(stress) : Json(fmt::format("{} {}", stress, unit_)); }

 private:
  std::string unit_;
};

/// Returns the strength for a plateau: that of Mohr and Coulomb if there is a friction angle.
Json strength_json(const Stresses& stresses, double compressive, double friction_deg) {
  if (friction_deg == 0) return {{"surface", "tresca"}, {"cohesion", stresses.value(compressive / 2)}};
  const double phi = friction_deg * std::numbers::pi / 180;
  return {{"surface", "mohr_coulomb"},
          {"cohesion", stresses.value(compressive * (1 - std::sin(phi)) / (2 * std::cos(phi)))},
          {"friction_deg", friction_deg}};
}

Outcome curve_outcome(const FitOptions& options, study::MeasuredPairs pairs) {
  const Stresses stresses(study::stress_unit(pairs, false));
  const double factor = options.strain_factor ? *options.strain_factor : study::strain_factor(pairs);
  for (double& strain : pairs.x) strain *= factor;
  const study::CurveFit fit = study::fit_curve(pairs, kSigns.at(options.compression));
  Outcome out;
  if (fit.is_turned)
    for (std::vector<double>* values : {&pairs.x, &pairs.y})
      for (double& value : *values) value = -value;
  const study::BilinearCurve curve{fit.initial_modulus.value_or(fit.youngs_modulus).value, fit.youngs_modulus.value,
                                   fit.closure_strain.value_or(study::Found{}).value,
                                   fit.strength ? fit.strength->value : std::numeric_limits<double>::infinity()};
  out.material["youngs_modulus"] = stresses.value(fit.youngs_modulus.value);
  out.values.push_back({"youngs_modulus", stresses.in_words(), fit.youngs_modulus});
  if (fit.initial_modulus) {
    out.values.push_back({"initial_modulus", stresses.in_words(), *fit.initial_modulus});
    out.values.push_back({"closure_strain", "1", *fit.closure_strain});
    out.material["crack_closure"] = {{"initial_modulus", stresses.value(curve.initial_modulus)},
                                     {"closure_strain", curve.closure_strain}};
  }
  if (!fit.strength && options.friction_deg != 0)
    spdlog::warn("the curve has no plateau: no strength was found, and --friction has no effect");
  if (fit.strength) {
    out.values.push_back({"strength", stresses.in_words(), *fit.strength});
    out.material["strength"] = strength_json(stresses, curve.strength, options.friction_deg);
  }
  // Corners of the curve.
  std::vector<double> corners{std::min(0.0, pairs.x.front()), curve.closure_strain, pairs.x.back()};
  if (fit.strength)
    corners.push_back(curve.closure_strain +
                      (curve.strength - curve.initial_modulus * curve.closure_strain) / curve.youngs_modulus);
  std::ranges::sort(corners);
  out.line.label = "fitted";
  for (const double strain : corners) {
    out.line.x.push_back(strain);
    out.line.y.push_back(curve.stress(strain));
  }
  out.agreement = fit.agreement;
  out.title = "uniaxial compression, measured and fitted";
  out.axes = {"strain", fmt::format("stress [{}]", stresses.in_words())};
  out.measured = std::move(pairs);
  out.warnings = joined(study::doubts_of_curve(out.measured), study::doubts_of_fit(out.measured, out.agreement));
  return out;
}

Outcome triaxial_outcome(study::MeasuredPairs tests) {
  const Stresses stresses(study::stress_unit(tests, true));
  const study::StrengthFit fit = study::fit_strength(tests);
  Outcome out;
  out.values = {{"cohesion", stresses.in_words(), fit.cohesion},
                {"friction_deg", "degrees", fit.friction_deg},
                {"ratio", "1", fit.ratio},
                {"compressive_strength", stresses.in_words(), fit.compressive_strength}};
  out.material["strength"] = {{"surface", "mohr_coulomb"},
                              {"cohesion", stresses.value(fit.cohesion.value)},
                              {"friction_deg", fit.friction_deg.value}};
  const auto [least, greatest] = std::ranges::minmax_element(tests.x);
  out.line.label = "fitted";
  for (const double s3 : {std::min(0.0, *least), *greatest}) {
    out.line.x.push_back(s3);
    out.line.y.push_back(fit.ratio.value * s3 + fit.compressive_strength.value);
  }
  out.agreement = fit.agreement;
  out.title = "strength in triaxial tests, measured and fitted";
  out.axes = {fmt::format("s3 [{}]", stresses.in_words()), fmt::format("s1 [{}]", stresses.in_words())};
  out.measured = std::move(tests);
  return out;
}

Outcome toughness_outcome(const formats::CsvTable& tests, study::ToughnessTest test) {
  const study::ToughnessFit fit = study::fit_toughness(tests, test);
  const std::string unit = fit.unit.empty() ? "F/L^1.5" : fit.unit;
  Outcome out;
  out.values = {{"toughness", unit, fit.mean}};
  out.material["toughness"] = {
      {"mode_1", fit.unit.empty() ? Json(fit.mean.value) : Json(fmt::format("{} {}", fit.mean.value, fit.unit))}};
  out.measured.y = fit.of_specimen;
  out.measured.y_unit = fit.unit;
  for (std::size_t i = 1; i <= fit.of_specimen.size(); ++i) out.measured.x.push_back(static_cast<double>(i));
  out.agreement = study::agreement(out.measured.y, std::vector<double>(out.measured.y.size(), fit.mean.value));
  out.line = {"mean", {out.measured.x.front(), out.measured.x.back()}, {fit.mean.value, fit.mean.value}};
  out.is_mean = true;
  out.title = "toughness of specimens, and their mean";
  out.axes = {"specimen", fmt::format("K_Ic [{}]", unit)};
  return out;
}

std::string residuals_csv(const Outcome& out, const FitOptions& options) {
  const std::string& unit = out.measured.y_unit;
  const std::string of_y = unit.empty() ? "" : fmt::format(" [{}]", unit);
  const char* heading = !options.toughness.empty() ? "specimen,toughness{0},fitted{0},residual{0}\n"
                        : options.is_triaxial      ? "s3{0},s1{0},fitted{0},residual{0}\n"
                                                   : "strain,stress{0},fitted{0},residual{0}\n";
  std::string text = fmt::format(fmt::runtime(heading), of_y);
  for (std::size_t i = 0; i < out.measured.x.size(); ++i) {
    const double fitted = out.agreement.fitted[i];
    text += fmt::format("{},{},{},{}\n", out.measured.x[i], out.measured.y[i], fitted, out.measured.y[i] - fitted);
  }
  return text;
}

void print(const Outcome& out, bool as_json) {
  const std::size_t count = out.measured.x.size();
  if (as_json) {
    Json json{{"points", count}};
    for (const NamedFound& value : out.values) json["parameters"][value.name] = json_of(value);
    json["residual"] = {
        {"rms", out.agreement.rms}, {"largest", out.agreement.largest}, {"r_squared", out.agreement.r_squared}};
    if (out.is_mean) json["residual"]["r_squared"] = nullptr;
    json["warnings"] = warning_list_json(out.warnings);
    json["material"] = out.material;
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{:<22}{:>14}{:>16}{:>16}{:>16}  unit\n", "", "value", "standard error", "95 % from", "to");
  for (const NamedFound& v : out.values)
    fmt::print("{:<22}{:>14.6g}{:>16.3g}{:>16.6g}{:>16.6g}  {}\n", v.name, v.found.value, v.found.standard_error,
               v.found.low, v.found.high, v.unit);
  if (out.is_mean) {
    const auto [least, greatest] = std::ranges::minmax_element(out.measured.y);
    fmt::print("{} specimen{}, from {:.4g} to {:.4g}\n", count, count == 1 ? "" : "s", *least, *greatest);
    return;
  }
  fmt::print("{} points, residual rms {:.4g}, largest {:.4g}, R² {:.6f}\n", count, out.agreement.rms,
             out.agreement.largest, out.agreement.r_squared);
}

ExitCode run_fit(const FitOptions& options) {
  const Overwrite overwrite = overwrite_if(options.may_overwrite);
  for (const std::string& name : {options.output, options.material, options.picture})
    if (name == "-") throw UsageError("expected the name of a file to write, found -; --json prints the material too");
  require_picture_name("--svg", options.picture);
  require_no_picture_name("-o", options.output, "--svg");
  require_writable({options.output, options.material, options.picture}, {options.input}, overwrite);
  const formats::CsvTable table = formats::read_csv(formats::load(options.input));
  const auto is_syy = [](const std::string& heading) { return heading.starts_with("syy"); };
  const bool is_of_element =
      std::ranges::count(table.header, "eyy") == 1 && std::ranges::count_if(table.header, is_syy) == 1;
  const Outcome out = !options.toughness.empty() ? toughness_outcome(table, kTests.at(options.toughness))
                      : options.is_triaxial      ? triaxial_outcome(study::read_pairs(table, "s3", "s1"))
                      : is_of_element            ? curve_outcome(options, study::read_pairs(table, "eyy", "syy"))
                                                 : curve_outcome(options, study::read_pairs(table, "strain", "stress"));
  print(out, options.as_json);
  log_warnings(out.warnings);
  if (!options.output.empty()) write_output(options.output, residuals_csv(out, options), overwrite);
  if (!options.material.empty()) write_output(options.material, out.material.dump(2) + "\n", overwrite);
  if (!options.picture.empty()) {
    const report::Curve measured{"measured", out.measured.x, out.measured.y, report::Curve::Style::points};
    write_picture(options.picture, report::curves_picture(out.title, out.axes, {measured, out.line}), overwrite);
  }
  return out.warnings.empty() ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Action configure_fit(CLI::App& app) {
  auto options = std::make_shared<FitOptions>();
  app.add_option(
         "CURVE", options->input,
         "table (CSV) with columns strain and stress of one uniaxial compression test, or the output of `element -o`. "
         "With --triaxial: columns s3 and s1 at failure, compression positive. A unit in the heading, as in "
         "\"stress [MPa]\", is the unit of the results")
      ->required();
  CLI::Option* triaxial = app.add_flag("--triaxial", options->is_triaxial, "fit cohesion and friction to s1 over s3");
  CLI::Option* toughness =
      app.add_option(
             "--toughness", options->toughness,
             "compute the toughness from failure loads of notched specimens, one row each. Columns by test: "
             "chevron_bend diameter, span, notch, load; semicircular_bend radius, thickness, notch, span, load; "
             "notched_disc diameter, thickness, notch, end, load")
          ->check(CLI::IsMember(kTests))
          ->excludes(triaxial);
  app.add_option("--compression", options->compression, "sign of compression in the file")
      ->check(CLI::IsMember(kSigns))
      ->excludes(triaxial)
      ->excludes(toughness);
  app.add_option("--strain-factor", options->strain_factor,
                 "strain that 1 in the column means: 0.01 for per cent (default: by the heading, \"strain [%]\")")
      ->check(above_zero())
      ->excludes(triaxial)
      ->excludes(toughness);
  app.add_option("--friction", options->friction_deg,
                 "friction angle from other tests, degrees; the strength becomes one of mohr_coulomb")
      ->check(CLI::Range(0.0, 89.0))
      ->excludes(triaxial)
      ->excludes(toughness);
  app.add_option("-o,--output", options->output, "write measured value, fit and residual of each point (CSV)")
      ->type_name("FILE");
  app.add_option("--material", options->material, "write the keys of a block material for a case file (JSON)");
  app.add_option("--svg", options->picture, "write a picture of both curves")->type_name("FILE");
  app.add_flag("--force", options->may_overwrite, "overwrite files that exist");
  app.add_flag("--json", options->as_json, "print values, errors and residuals as JSON");
  return [options] { return run_fit(*options); };
}

}  // namespace keyblock
