// Cutting, model and settings put together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/prepare.hpp"

#include "model/from_blocks.hpp"
#include "run/profile.hpp"
#include "run/settings_table.hpp"

namespace keyblock {
namespace {

CutResult blocks_of(const Problem& problem) {
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) return cut_blocks(*drawing);
  return {std::get<Blocks>(problem.geometry), {}, {}, {}};
}

Place place_of(const Problem& problem) {
  if (problem.analysis) return problem.analysis->place;
  if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) return drawing->place;
  if (const auto* blocks = std::get_if<Blocks>(&problem.geometry)) return blocks->place;
  return {};
}

}  // namespace

Prepared prepare(const Problem& problem, const std::string& profile, const std::vector<Override>& overrides) {
  if (std::holds_alternative<std::monostate>(problem.geometry))
    throw InputError(place_of(problem), "expected a geometry or block file beside it, found none");
  if (!problem.analysis)
    throw InputError(place_of(problem), "expected an analysis file beside it, found none");
  Settings settings = profile_settings(profile, *problem.analysis);
  for (const auto& [name, value] : overrides) set(settings, name, value);
  CutResult cut = blocks_of(problem);
  Model model = model_from_blocks(cut.blocks, *problem.analysis);
  Requirements needs = requirements(model, settings);
  const bool was_drawing = std::holds_alternative<Drawing>(problem.geometry);
  return {std::move(cut.blocks), was_drawing ? std::optional(cut.report) : std::nullopt,
          std::move(cut.snaps),  std::move(cut.warnings),
          std::move(needs),      scene_of(std::move(model), settings, problem.analysis->dialect)};
}

}  // namespace keyblock
