// The refusal of strengths that would be dropped in silence, and of elements too large for softening.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/strengths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "material/strength.hpp"
#include "model/continuum.hpp"
#include "terms/cover_yield.hpp"

namespace keyblock {

void require_readable_strengths(const Problem& problem, const Settings& settings) {
  if (settings.dynamics == Dynamics::standard && problem.covers) return;
  for (const BlockMaterial& material : problem.analysis->block_materials)
    if (material.strength)
      throw InputError(material.place,
                       "expected a strength in a run of profile standard with bodies on covers; found one in a run "
                       "where rock stays elastic");
}

Warnings look_at_strengths(const Scene& scene, const Place& place) {
  const Continuum& continuum = *scene.model.continuum;
  Warnings warnings;
  const bool yields =
      std::ranges::any_of(continuum.materials, [](const BlockMaterial& m) { return m.strength != nullptr; });
  if (!yields) return warnings;
  if (continuum.functions == CoverFunctions::derived)
    warnings.push_back(
        {"functions_lock", place,
         "derived functions lock where rock flows without change of volume: limit loads come out 10 to 20 % "
         "too high; constant ones (the default) do not"});
  const bool softens = std::ranges::any_of(continuum.materials, [](const BlockMaterial& m) {
    return m.strength && m.strength->change && m.strength->change->fracture_energy > 0;
  });
  if (!softens) return warnings;
  const CoverYield yield(continuum, CoverBasis(continuum.manifold, continuum.functions));
  for (std::size_t i = 0; i < continuum.materials.size(); ++i) {
    const BlockMaterial& material = continuum.materials[i];
    if (!material.strength) continue;
    const double allowed = largest_size(*material.strength, material.youngs_modulus);
    const double largest = yield.greatest_size(i);
    if (largest >= allowed)
      throw InputError(material.place,
                       fmt::format("strength: expected points of a size below {:.4g}, where softening by this "
                                   "fracture_energy does not snap back, found {:.4g}",
                                   allowed, largest));
  }
  return warnings;
}

}  // namespace keyblock
