// `keyblock element`: computes one element of a case's material along a path of strains and stresses, and writes its
// curve.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/helpers/picture_file.hpp"
#include "app/messages.hpp"
#include "app/option_checks.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "formats/text/tokens.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "material/strength.hpp"
#include "problem/limits.hpp"
#include "problem/units/measure.hpp"
#include "report/rock/element_picture.hpp"
#include "run/ahead/plausible_units.hpp"
#include "study/element/element_path.hpp"

namespace keyblock {
namespace {

struct ElementOptions {
  std::string input;
  int material = 1;
  std::string path = "uniaxial";
  std::vector<double> targets{-0.01};
  double confining = 0;
  int cycles = 1;
  int steps = 100;
  double size = 1;
  std::string output;
  std::string picture;
  bool may_overwrite = false;
  bool as_json = false;
  std::vector<std::string> given = {};  ///< given options among those that some paths do not read
};

const std::map<std::string, study::NamedPath> kPaths{
    {"uniaxial", study::NamedPath::uniaxial},   {"cyclic", study::NamedPath::triaxial},
    {"triaxial", study::NamedPath::triaxial},   {"biaxial", study::NamedPath::biaxial},
    {"oedometer", study::NamedPath::oedometer}, {"shear", study::NamedPath::shear}};

/// Requested material, and the units of its case.
struct Chosen {
  YieldLaw law;
  Units units;
};

Chosen chosen_material(const ElementOptions& options) {
  const formats::Case loaded = formats::load_case({options.input});
  log_warnings(loaded.warnings);
  if (!loaded.problem.analysis) throw InputError({options.input, 0, 0}, "expected an analysis, found none");
  const std::vector<BlockMaterial>& materials = loaded.problem.analysis->block_materials;
  if (options.material > static_cast<int>(materials.size()))
    throw UsageError(fmt::format("--material: expected 1 to {}, found {}", materials.size(), options.material));
  const BlockMaterial& material = materials[static_cast<std::size_t>(options.material) - 1];
  if (!(material.poissons_ratio < 0.5))
    throw InputError(material.place, fmt::format("expected poissons_ratio below 0.5 of a single element, found {}",
                                                 material.poissons_ratio));
  log_warnings(contradictions_of(material, loaded.problem.units));
  if (!loaded.problem.analysis->plane_strain)
    log_warnings({{"plane_not_read",
                   {options.input, 0, 0},
                   "plane stress of the case has no effect on an element: its path sets zz (free in uniaxial, triaxial "
                   "and cyclic paths, zero strain in biaxial, oedometer and shear)"}});
  YieldLaw law = yield_law(material);
  if (const double allowed = largest_size(law.strength, law.youngs_modulus); options.size >= allowed)
    throw UsageError(fmt::format("--size: expected below {:.4g}, so that this softening does not snap back, found {}",
                                 allowed, options.size));
  return {law, loaded.problem.units};
}

void require_read(const ElementOptions& options, std::string_view option, bool is_read) {
  if (!is_read && std::ranges::find(options.given, option) != options.given.end())
    throw UsageError(fmt::format("{}: expected none with --path {}, which does not read it", option, options.path));
}

/// Throws UsageError for a value that is not a number, or beyond `greatest` in either direction.
void require_within(std::string_view option, double value, double greatest) {
  if (!(std::abs(value) <= greatest))
    throw UsageError(
        fmt::format("{}: expected a number from {:g} to {:g}, found {:g}", option, -greatest, greatest, value));
}

/// Returns the targets, repeated per cycle; a cyclic path with a single target gets 0 after it.
std::vector<double> targets_of(const ElementOptions& options) {
  std::vector<double> once = options.targets;
  if (options.path == "cyclic" && once.size() == 1) once.push_back(0);
  std::vector<double> all;
  for (int i = 0; i < options.cycles; ++i) all.insert(all.end(), once.begin(), once.end());
  return all;
}

study::ElementPath path_of(const ElementOptions& options) {
  const auto named = kPaths.find(options.path);
  const bool has_name = named != kPaths.end();
  if (!has_name && !options.path.ends_with(".csv"))
    throw UsageError(
        fmt::format("--path: expected uniaxial, triaxial, biaxial, oedometer, shear, cyclic or a file .csv, found {}",
                    formats::in_quotes(options.path)));
  require_read(options, "--to", has_name);
  require_read(options, "--cycles", has_name);
  require_read(options, "--confining",
               has_name && (named->second == study::NamedPath::triaxial || named->second == study::NamedPath::biaxial));
  for (const double target : options.targets) require_within("--to", target, study::kGreatestStrain);
  require_within("--confining", options.confining, kGreatestQuantity);
  if (has_name) return study::named_path(named->second, targets_of(options), options.confining);
  return study::read_path(formats::read_csv(formats::load(options.path)));
}

/// Limits on points: about 300 bytes each in memory, and as many in the table.
constexpr double kMostPoints = 1e7;
constexpr double kManyPoints = 1e6;

/// Rejects, before any work, a curve with too many points for the memory.
void require_few_points(const ElementOptions& options, const study::ElementPath& path) {
  const double points = static_cast<double>(path.legs.size()) * options.steps;
  if (points > kMostPoints)
    throw UsageError(fmt::format("--steps: expected at most {:g} points of a curve, found {:g} of {} legs of {} steps",
                                 kMostPoints, points, path.legs.size(), options.steps));
  if (points > kManyPoints)
    spdlog::info("{:g} points, {} legs of {} steps: this takes minutes and gigabytes; fewer --steps take less", points,
                 path.legs.size(), options.steps);
}

ExitCode run_element(const ElementOptions& options) {
  const study::ElementPath path = path_of(options);
  require_few_points(options, path);
  require_picture_name("--svg", options.picture);
  require_no_picture_name("-o", options.output, "--svg");
  require_writable({options.output, options.picture}, {options.input}, overwrite_if(options.may_overwrite));
  const auto [law, units] = chosen_material(options);
  const study::ElementCurve curve = study::drive(law, path, options.steps, options.size);
  const int shown = options.path == "shear" ? 2 : 1;
  double least = 0, greatest = 0;
  std::vector<double> strain, stress;
  for (const study::ElementPoint& point : curve.points) {
    strain.push_back(point.strain(shown));
    stress.push_back(point.stress(shown));
    least = std::min(least, point.stress(shown));
    greatest = std::max(greatest, point.stress(shown));
  }
  if (!options.output.empty())
    write_output(options.output, study::element_csv(curve, units), overwrite_if(options.may_overwrite));
  const std::string axis = shown == 2 ? "xy" : "yy";
  if (!options.picture.empty())
    write_picture(
        options.picture,
        report::element_picture(fmt::format("material {}, {}", options.material, options.path), "strain " + axis,
                                strain, with_unit("stress " + axis, measures::kStress, units), stress),
        overwrite_if(options.may_overwrite));
  const study::ElementPoint& end = curve.points.back();
  if (options.as_json) {
    const nlohmann::ordered_json json{{"points", curve.points.size()},
                                      {"least_stress", least},
                                      {"greatest_stress", greatest},
                                      {"end",
                                       {{"strain", {end.strain(0), end.strain(1), end.strain(2), end.strain(3)}},
                                        {"stress", {end.stress(0), end.stress(1), end.stress(2), end.stress(3)}},
                                        {"kappa", end.state.kappa},
                                        {"plastic_work", end.plastic_work}}},
                                      {"units", {{"stress", unit_of(measures::kStress, units)}}},
                                      {"failure", curve.failure}};
    fmt::print("{}\n", json.dump(2));
  } else if (options.output.empty()) {
    fmt::print("{}", study::element_csv(curve, units));
  }
  spdlog::info("stress {} from {:.9g} to {:.9g}; at the end strain {:.9g}, stress {:.9g}, plastic work {:.9g}", axis,
               least, greatest, end.strain(shown), end.stress(shown), end.plastic_work);
  if (curve.failure.empty()) return ExitCode::ok;
  spdlog::error("keyblock: error: {}", curve.failure);
  return ExitCode::numerical_failure;
}

}  // namespace

Action configure_element(CLI::App& app) {
  auto options = std::make_shared<ElementOptions>();
  app.add_option("CASE", options->input, "case or analysis file with the material")->required();
  app.add_option("--material", options->material, "number of the block material, from 1")->check(above_zero());
  app.add_option(
      "--path", options->path,
      "path: uniaxial, triaxial or biaxial (yy driven, sides under --confining), oedometer (sides fixed), or shear "
      "(2xy driven). cyclic: triaxial between the targets, --cycles times; with one target, back to 0. Or a .csv file "
      "with one row per leg, and columns exx or sxx, eyy or syy, gxy or sxy, ezz or szz");
  app.add_option("--to", options->targets, "target strains of yy, or 2xy, in order")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--confining", options->confining, "confining pressure, F/L², compression positive");
  app.add_option("--cycles", options->cycles, "number of cycles")->check(CLI::Range(1, 10000));
  app.add_option("--steps", options->steps, "steps per leg")->check(CLI::Range(1, 1000000));
  app.add_option("--size", options->size, "size of the element, L, for softening by fracture_energy")
      ->check(above_zero());
  app.add_option("-o,--output", options->output, "write the curve (CSV) instead of printing it")->type_name("FILE");
  app.add_option("--svg", options->picture, "write a picture of stress over strain")->type_name("FILE");
  app.add_flag("--force", options->may_overwrite, "overwrite files that exist");
  app.add_flag("--json", options->as_json, "print extremes and end as JSON");
  return [options, &app] {
    for (const char* name : {"--to", "--cycles", "--confining"})
      if (app.get_option(name)->count() > 0) options->given.emplace_back(name);
    return run_element(*options);
  };
}

}  // namespace keyblock
