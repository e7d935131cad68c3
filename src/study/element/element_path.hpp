// Drives a single element along a path of strains and stresses, to show the response of a material alone. Theory:
// docs/theory/09-plasticity.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/text/csv.hpp"
#include "material/yield_law.hpp"

namespace keyblock::study {

/// Target of a component of the element at the end of a leg.
struct DrivenComponent {
  bool is_stress = false;
  double target = 0;
};

/// Leg from the end of the last one, each component in proportion: xx, yy, xy (strain 2xy), zz.
using ElementLeg = std::array<DrivenComponent, 4>;

struct ElementPath {
  Eigen::Vector4d initial_stress = Eigen::Vector4d::Zero();  ///< xx, yy, xy, zz; strains count from it
  std::vector<ElementLeg> legs;
};

/// Largest strain of a path: far beyond the small strain to which an element responds.
inline constexpr double kGreatestStrain = 10;

enum class NamedPath { uniaxial, triaxial, biaxial, oedometer, shear };

/// Returns the path of a rock test: yy goes to each of `targets` in turn (`shear`: 2xy). uniaxial: no pressure on the
/// sides. triaxial: `confining` acts on all sides, before and throughout. biaxial: it acts on two sides, and zz keeps
/// its strain. oedometer and shear: the sides keep their strain.
ElementPath named_path(NamedPath name, const std::vector<double>& targets, double confining);

/// Reads a path. Rows are ends of legs; columns, in any order, are exx or sxx, eyy or syy, gxy or sxy, ezz or szz. A
/// component without a column keeps its strain. Throws InputError for other columns, both of one component, or no row.
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
  /// Reason of an early end: no strain gives the requested stress, or the response is not finite. Empty: no early end.
  std::string failure;
};

/// Drives the path with `steps` per leg. Newton's method with the law's tangent finds the strains under prescribed
/// stress. If a plateau leaves several, it takes the least. A step without a solution is halved down to 1/1024.
ElementCurve drive(const YieldLaw& law, const ElementPath& path, int steps, double size);

/// Returns the columns leg, exx, eyy, gxy, ezz, sxx, syy, sxy, szz, s1, s2, s3, kappa, plastic_work, region.
std::string element_csv(const ElementCurve& curve, const Units& units = {});

}  // namespace keyblock::study
