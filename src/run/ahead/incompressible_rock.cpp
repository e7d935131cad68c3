// Judges by Poisson's ratio: constant strains of triangles cannot keep their area and bend.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/incompressible_rock.hpp"

#include <algorithm>

#include "base/sentences/sentences.hpp"
#include "model/continuum.hpp"

namespace keyblock {
namespace {

// A cantilever of two to three sides over its depth, with derived functions: 3 % too stiff at this Poisson's ratio, 9 %
// at 0.499, 22 % at 0.4999.
constexpr double kMayLock = 0.49;

}  // namespace

Warnings incompressible_rock(const Scene& scene, const Place& place) {
  const auto& continuum = scene.model.continuum;
  if (!continuum || scene.settings.plane != Plane::strain || continuum->functions >= CoverFunctions::linear) return {};
  const auto most = std::ranges::max_element(continuum->materials, {}, &BlockMaterial::poissons_ratio);
  if (most == continuum->materials.end() || most->poissons_ratio < kMayLock) return {};
  const char* const functions = continuum->functions == CoverFunctions::constant ? "constant" : "derived";
  const char* const advice = may_yield(scene) ? "" : "; functions \"linear\" of the section `covers` hardly lock";
  return {warning_of(
      {"rock_may_lock",
       {{{"poissons_ratio", most->poissons_ratio}, {"block_material", most - continuum->materials.begin() + 1}},
        {{"functions", functions}, {"advice", advice}}}},
      place)};
}

}  // namespace keyblock
