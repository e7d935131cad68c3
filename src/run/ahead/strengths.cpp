// Rejects strengths and cracks that would be ignored, and elements too large for softening.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/strengths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "base/sentences/sentences.hpp"
#include "material/strength.hpp"
#include "model/continuum.hpp"
#include "model/material_choices.hpp"
#include "model/state.hpp"
#include "terms/yield/cover_yield.hpp"

namespace keyblock {

namespace {

bool softens_by_energy(const BlockMaterial& material) {
  return material.strength && material.strength->change && material.strength->change->fracture_energy > 0;
}

const char* named_law(const BlockMaterial& material) {
  return material.strength ? "strength" : "crack_closure";
}

// Rounded down, so that the reported value is allowed.
std::string four_digits_below(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 3);
  return fmt::format("{:.4g}", std::isnormal(unit) ? unit * std::floor(value / unit) : value);
}

// Checks the largest part of a material that softens at once. `size`, √area, counts; `side` is set for a mesh, and is
// at least `ratio` times that.
void require_size(const BlockMaterial& material, const char* what, double side, double size, double ratio) {
  // Modulus that unloads a softening point: with cracks that of open ones, which return more energy.
  const double modulus = material.crack_closure ? material.crack_closure->initial_modulus : material.youngs_modulus;
  const double allowed = largest_size(*material.strength, modulus);
  if (size >= allowed)
    throw InputError(
        material.place,
        fmt::format("expected {} below {}, so that softening by this fracture_energy does not snap back, found {:.4g}",
                    what, four_digits_below(allowed * ratio), side));
}

double longest_side(const Manifold& manifold, int element) {
  const std::array<Point, 3> corners = manifold.triangle(manifold.elements[static_cast<std::size_t>(element)]);
  double longest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    longest = std::max(longest, length(corners[(k + 1) % corners.size()] - corners[k]));
  return longest;
}

// Interior points of a regular mesh are alike. In other meshes some are large for their sides, in finer ones too.
void require_sizes(const Continuum& continuum) {
  const CoverYield yield(continuum, CoverBasis(continuum.manifold, continuum.functions));
  for (std::size_t i = 0; i < continuum.materials.size(); ++i) {
    if (!continuum.materials[i].strength) continue;
    double side = 0, size = 0, ratio = std::numeric_limits<double>::infinity();
    for (const YieldPoints::Extent& point : yield.extents(i)) {
      const double longest = longest_side(continuum.manifold, point.element);
      ratio = std::min(ratio, longest / point.size);
      if (point.size <= size) continue;
      size = point.size;
      side = longest;
    }
    if (size > 0) require_size(continuum.materials[i], "triangles with a side", side, size, ratio);
  }
}

// Gradients averaged over covers miss motion that alternates from row to row. On a lattice of equilateral triangles
// their symbol is Σ a sin(k · a) over the six neighbours a. Besides rigid motion, it vanishes for three such patterns.
// These have stiffness only by their slow change over the body (tests/terms/cover_yield_test.cpp counts them).
Warning soft_patterns(const Continuum& continuum, const Place& place) {
  std::set<int> covers;
  for (std::size_t e = 0; e < continuum.manifold.elements.size(); ++e) {
    const std::array<int, 3>& own = continuum.manifold.elements[e].covers;
    if (continuum.material(static_cast<int>(e)).is_nonlinear()) covers.insert(own.begin(), own.end());
  }
  return warning_of({"soft_patterns", {{{"covers", covers.size()}, {"vibrations", 2 * covers.size()}}}}, place);
}

Warnings look_at_covers(const Scene& scene, const Place& place) {
  const Continuum& continuum = *scene.model.continuum;
  Warnings warnings;
  const auto has_body = [&](const auto& holds) {
    return std::ranges::any_of(continuum.manifold.body_materials, [&](int material) {
      return holds(continuum.materials[static_cast<std::size_t>(material)]);
    });
  };
  const bool is_in_time = !scene.is_untouched && !is_static(scene.settings, scene.model) &&
                          scene.settings.standard.motion == MotionRule::dynamic;
  if (is_in_time && continuum.functions == CoverFunctions::constant &&
      has_body([](const BlockMaterial& material) { return material.is_nonlinear(); }))
    warnings.push_back(soft_patterns(continuum, place));
  if (!has_body([](const BlockMaterial& material) { return material.strength != nullptr; })) return warnings;
  if (continuum.functions == CoverFunctions::derived)
    warnings.push_back(
        {"functions_lock", place,
         "derived functions lock if rock flows without change of volume: limit loads are far too high (a tresca "
         "footing: by 64 % with 1,006 unknowns, 32 % with 2,706). Constant functions, the default, do not (1.4 %)"});
  if (std::ranges::none_of(continuum.materials, softens_by_energy)) return warnings;
  require_sizes(continuum);
  return warnings;
}

void look_at_blocks(const Model& model, const Settings& settings) {
  Table<VertexIndex, Point> start;
  for (const Point& place : model.start_vertices) start.push_back(place);
  for (const ElementIndex e : indices(model.elements)) {
    const Element& element = model.elements[e];
    const BlockMaterial& material = model.material_of(element);
    if (element.is_on_covers() || !element.can_move() || !material.is_nonlinear()) continue;
    const bool is_elastic = material.strength && !is_reachable(*material.strength) && !material.crack_closure;
    if (element.basis == &rigid_basis() && !is_elastic)
      throw InputError(
          material.place,
          fmt::format(
              "expected basis affine of blocks whose material has a {}, found rigid: a rigid block never yields",
              named_law(material)));
    if (!softens_by_energy(material)) continue;
    const double size = std::sqrt(keyblock::place(model, start, e, settings).moments.area);
    require_size(material, "blocks with a √area", size, size, 1);
  }
}

}  // namespace

void require_readable_strengths(const Problem& problem, const Settings& settings) {
  if (settings.dynamics == Dynamics::standard) return;
  for (const BlockMaterial& material : problem.analysis->block_materials)
    if (material.is_nonlinear())
      throw InputError(material.place,
                       fmt::format("expected profile standard for a {}, found legacy, whose rock is linear elastic",
                                   named_law(material)));
}

Warnings look_at_strengths(const Scene& scene, const Place& place) {
  if (!scene.is_untouched) look_at_blocks(scene.model, scene.settings);
  return scene.model.continuum ? look_at_covers(scene, place) : Warnings();
}

}  // namespace keyblock
