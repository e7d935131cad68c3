// A single element driven along a path of strains and stresses: the answer of a material alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/text/csv.hpp"
#include "material/yield_law.hpp"

namespace keyblock::study {

/// What a component of the element is brought to by the end of a leg.
struct DrivenComponent {
  bool is_stress = false;
  double target = 0;
};

/// From where the leg before ended, each component in proportion: xx, yy, xy (strain 2xy), zz.
using ElementLeg = std::array<DrivenComponent, 4>;

struct ElementPath {
  Eigen::Vector4d initial_stress = Eigen::Vector4d::Zero();  ///< xx, yy, xy, zz; strains count from it
  std::vector<ElementLeg> legs;
};

/// Of the strains that a path may ask for: far beyond the small strain that an element answers to.
inline constexpr double kGreatestStrain = 10;

enum class NamedPath { uniaxial, triaxial, biaxial, oedometer, shear };

/// The path of a test of rock: yy is brought to each of `targets` in turn (of `shear`: 2xy). uniaxial: nothing presses
/// the sides; triaxial: `confining` presses all sides, before and all along; biaxial: it presses two, and zz keeps its
/// strain; oedometer and shear: the sides keep their strain.
ElementPath named_path(NamedPath name, const std::vector<double>& targets, double confining);

/// Rows are ends of legs; columns, in any order, exx or sxx, eyy or syy, gxy or sxy, ezz or szz. A component without a
/// column keeps its strain. Throws InputError for other columns, both of one component, or no row.
ElementPath read_path(const formats::CsvTable& table);

struct ElementPoint {
  int leg = 0;  ///< from 1; 0: the start
  Eigen::Vector4d strain = Eigen::Vector4d::Zero();
  Eigen::Vector4d stress = Eigen::Vector4d::Zero();
  YieldState state;
  double plastic_work = 0;  ///< per volume, ∫ σ · dεᵖ with the stress at the end of each step
};

struct ElementCurve {
  std::vector<ElementPoint> points;
  /// Why it ends early: no strain bears the stress asked for, or the answer is not a finite number. Empty: it does not.
  std::string failure;
};

/// `steps` a leg. A step's strains under prescribed stresses by Newton's method with the law's tangent, the least of
/// those that a plateau leaves free; a step that finds none is halved down to 1/1024.
ElementCurve drive(const YieldLaw& law, const ElementPath& path, int steps, double size);

/// leg, exx, eyy, gxy, ezz, sxx, syy, sxy, szz, s1, s2, s3, kappa, plastic_work, region.
std::string element_csv(const ElementCurve& curve, const Units& units = {});

}  // namespace keyblock::study
