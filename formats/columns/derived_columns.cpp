// Computes columns that follow from stress and plastic strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "formats/columns/column_filler.hpp"
#include "formats/columns/frame_columns.hpp"
#include "material/stress_invariants.hpp"
#include "result/extremes.hpp"

namespace keyblock::formats {
namespace {

std::vector<Stress> stresses_of(const FrameColumn& column) {
  const std::span<const double> numbers = column.reals();
  std::vector<Stress> stresses(numbers.size() / 4);
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    const double* s = numbers.data() + 4 * i;
    stresses[i].xx = s[0];
    stresses[i].yy = s[1];
    stresses[i].xy = s[2];
    stresses[i].zz = s[3];
  }
  return stresses;
}

void add_principals(const ColumnFiller<Stress>& fill) {
  fill.real(
      "principal_stress_greatest", [](const Stress& s) { return principal(s).second; }, Digits::seven);
  fill.real(
      "principal_stress_least", [](const Stress& s) { return principal(s).first; }, Digits::seven);
  fill.xy(
      "principal_axis",
      [](const Stress& s) {
        const double angle = principal_angle(s);
        return Point{std::cos(angle), std::sin(angle)};
      },
      Digits::seven);
}

/// Hooke's law: (σ_a − ν (σ_b + σ_c)) / E along an axis, (1 + ν) σ_xy / E for the shear component of the tensor.
Components elastic_strain(const Stress& s, const BlockMaterial& rock) {
  const double nu = rock.poissons_ratio, modulus = rock.youngs_modulus;
  return {(s.xx - nu * (s.yy + s.zz)) / modulus, (s.yy - nu * (s.zz + s.xx)) / modulus, (1 + nu) * s.xy / modulus,
          (s.zz - nu * (s.xx + s.yy)) / modulus};
}

/// `material_of`: number of the material of a row, from 1.
template <class MaterialOf>
void add_elastic_strain(FramePart& part, const std::vector<Stress>& stresses, std::span<const BlockMaterial> materials,
                        const MaterialOf& material_of) {
  struct StressedRock {
    Stress stress;
    const BlockMaterial* material;
  };
  std::vector<StressedRock> rocks;
  rocks.reserve(stresses.size());
  for (std::size_t i = 0; i < stresses.size(); ++i)
    rocks.push_back({stresses[i], &materials[static_cast<std::size_t>(material_of(i) - 1)]});
  ColumnFiller(part, rocks)
      .tensor(
          "elastic_strain", [](const StressedRock& r) { return elastic_strain(r.stress, *r.material); }, Digits::seven);
}

void add_invariants(const ColumnFiller<Stress>& fill) {
  fill.real("mean_stress", [](const Stress& s) { return invariants_of(s).mean; });
  fill.real("von_mises_stress", [](const Stress& s) { return invariants_of(s).von_mises; });
  fill.real("lode_angle", [](const Stress& s) { return invariants_of(s).lode_deg; });
}

template <class MaterialOf>
void add_derived(FramePart& part, std::span<const BlockMaterial> materials, const MaterialOf& material_of) {
  const FrameColumn* stress = part.find("stress");
  if (!stress) return;
  const std::vector<Stress> stresses = stresses_of(*stress);
  const ColumnFiller fill(part, stresses);
  add_principals(fill);
  if (!materials.empty()) add_elastic_strain(part, stresses, materials, material_of);
  if (part.find("plastic_strain")) add_invariants(fill);
}

}  // namespace

FrameColumns with_derived(FrameColumns frame, std::span<const BlockMaterial> materials) {
  if (frame.part("blocks").rows == 0) return frame;
  const FrameColumn material = frame.part("blocks").at("material"), block_row = frame.part("corners").at("row");
  for (FramePart& part : frame.parts) {
    if (part.name == "blocks") add_derived(part, materials, [&](std::size_t i) { return material.integers()[i]; });
    if (part.name == "corners")
      add_derived(part, materials, [&](std::size_t i) {
        return material.integers()[static_cast<std::size_t>(block_row.integers()[i])];
      });
  }
  return frame;
}

}  // namespace keyblock::formats
