// Builds the benchmarks of linear elasticity on covers: geometry, loads, and the answer of theory or of a fine mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "tests/support/continuum_scenes.hpp"

namespace keyblock {

struct ContinuumBenchmark {
  Continuum continuum;
  ExactField exact;  ///< empty where there is none
  /// Quantity that is compared with `reference`.
  std::function<double(const Continuum&, const ContinuumSolution&)> value;
  double reference = 0;
};

/// nmm-10: unit square, both components sin πx sin πy, all sides fixed; E 1, ν 0.3, plane strain.
ContinuumBenchmark unit_square(CoverFunctions functions, double h);

/// nmm-03: L 48, D 12, E 3e7, ν 0.3, P 1000 as parabolic shear, the exact displacement at the root (Timoshenko &
/// Goodier).
ContinuumBenchmark exact_cantilever(CoverFunctions functions, double h);

/// nmm-04: L 10, D 1, E 1000, ν 0.3, clamped, P 1 at the end: 4.0238 (quadrilaterals of second order, 200 × 20). The
/// mesh lies along the beam, with `rows` of triangles in its height, none on its faces. Triangles are 1.3 times as long
/// as high.
ContinuumBenchmark clamped_cantilever(CoverFunctions functions, double rows);

/// nmm-05: half of a beam on two supports, L 10, height 1, E 1000, ν 0.3, P 1 on top of its middle: Seewald's
/// deflection of the middle plane (Timoshenko & Goodier). The supports are parabolic shear on the end, because a point
/// support settles without limit as the mesh is refined.
ContinuumBenchmark supported_beam(CoverFunctions functions, double h);

/// nmm-07: quarter ring, a 1, b 2, inner pressure 1, E 1000, plane strain; 64 chords per quarter. Value: u at r = a.
ContinuumBenchmark thick_cylinder(CoverFunctions functions, double h, double poissons_ratio = 0.3);

/// nmm-08: quarter plate 5 × 5 with a hole of radius 1 (64 chords), the tractions of the infinite plate on its outer
/// sides.
/// Value: the tension at the edge of the hole, 3.
ContinuumBenchmark kirsch_plate(CoverFunctions functions, double h);

/// nmm-09: Cook's membrane, E 1, ν 1/3, plane stress, shear 1 in all: 23.966 at (48, 52).
ContinuumBenchmark cook_membrane(CoverFunctions functions, double h);

/// A plate 1 × ½, fixed at the left, pulled down at the right, on a mesh of side 1/8. Its rows lie `share` of their
/// height, its columns `share` of their width, off the upper right corner of the plate.
Continuum swept_plate(CoverFunctions functions, double share);

/// Scaling of the conjugate gradients: the diagonal, or the inverse of the matrix that couples the unknowns of each
/// cover, up to twelve.
enum class GradientScaling { diagonal, covers };

/// Solves to a residual of 1e-8. The condition is that of the scaled matrix without its null space, from the
/// coefficients of the iteration (Lanczos).
struct GradientRun {
  int iterations = 0;
  double condition = 0;
};
GradientRun conjugate_gradients(const Continuum& continuum, GradientScaling scaling);

}  // namespace keyblock
