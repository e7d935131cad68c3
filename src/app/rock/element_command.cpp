// `keyblock element`: one element of a case's material along a path of strains and stresses, its curve out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/above_zero.hpp"
#include "app/command.hpp"
#include "app/picture_name.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "formats/case.hpp"
#include "formats/registry.hpp"
#include "job/files.hpp"
#include "job/run_report.hpp"
#include "material/strength.hpp"
#include "problem/units/measure.hpp"
#include "report/rock/element_picture.hpp"
#include "study/element/element_path.hpp"

namespace keyblock {
namespace {

struct ElementOptions {
  std::string input;
  int material = 1;
  std::string path = "uniaxial";
  std::vector<double> targets{-0.01};
  double confining = 0;
  int steps = 100;
  double size = 1;
  std::string output;
  std::string picture;
  bool may_overwrite = false;
  bool as_json = false;
};

const std::map<std::string, study::NamedPath> kPaths{{"uniaxial", study::NamedPath::uniaxial},
                                                     {"triaxial", study::NamedPath::triaxial},
                                                     {"biaxial", study::NamedPath::biaxial},
                                                     {"oedometer", study::NamedPath::oedometer},
                                                     {"shear", study::NamedPath::shear}};

/// The material asked for, and the units of its case.
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
  YieldLaw law = yield_law(material);
  if (const double allowed = largest_size(law.strength, law.youngs_modulus); options.size >= allowed)
    throw UsageError(fmt::format("--size: expected below {:.4g}, where this softening does not snap back, found {}",
                                 allowed, options.size));
  return {law, loaded.problem.units};
}

study::ElementPath path_of(const ElementOptions& options) {
  if (const auto named = kPaths.find(options.path); named != kPaths.end())
    return study::named_path(named->second, options.targets, options.confining);
  if (!options.path.ends_with(".csv"))
    throw UsageError(fmt::format(
        "--path: expected uniaxial, triaxial, biaxial, oedometer, shear or a file .csv, found \"{}\"", options.path));
  return study::read_path(formats::read_csv(formats::load(options.path)));
}

ExitCode run_element(const ElementOptions& options) {
  require_picture_name("--svg", options.picture);
  require_no_picture_name("-o", options.output, "--svg");
  require_writable({options.output, options.picture}, {options.input}, overwrite_if(options.may_overwrite));
  const auto [law, units] = chosen_material(options);
  const study::ElementCurve curve = study::drive(law, path_of(options), options.steps, options.size);
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
    write_output(
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
  app.add_option("CASE", options->input, "the case or analysis file that holds the material")->required();
  app.add_option("--material", options->material, "number of the block material")->check(CLI::PositiveNumber);
  app.add_option(
      "--path", options->path,
      "uniaxial, triaxial or biaxial (yy driven, sides under --confining), oedometer (sides held), shear "
      "(2xy driven); or a file .csv with columns exx or sxx, eyy or syy, gxy or sxy, ezz or szz, a row a leg");
  app.add_option("--to", options->targets, "strains that yy, or 2xy, is brought to one after another")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--confining", options->confining, "pressure on the sides, F/L², above 0 presses");
  app.add_option("--steps", options->steps, "of each leg")->check(CLI::Range(1, 1000000));
  app.add_option("--size", options->size, "of the element, L: of softening by fracture_energy")
      ->check(CLI::PositiveNumber);
  app.add_option("-o,--output", options->output, "the curve to write (CSV); without it, it is printed")
      ->type_name("FILE");
  app.add_option("--svg", options->picture, "a picture of stress over strain to write")->type_name("FILE");
  app.add_flag("--force", options->may_overwrite, "overwrite files that exist");
  app.add_flag("--json", options->as_json, "print extremes and end as JSON");
  return [options] { return run_element(*options); };
}

}  // namespace keyblock
