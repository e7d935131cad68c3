// Reads and writes the analysis (parameter) file of Shi's manifold program (`mfNN`).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning. [D] count and order shown by data, names [R] partly inferred.
//   k01 n5 nb nj g2 g1 g0     velocity carry-over 0..1, steps, block and joint materials, displacement per step over
//                             w0, upper limit of the time step, contact stiffness (0: chosen by the program [R])
//   nL × px py                constant force of each loading point; nL is in the cover file
//   nb × ma  fx fy  E nu      mass and force per unit area (signed: fy < 0 is weight), elasticity
//        s11 s22 s12          initial stress
//        a1 a2 a3             its gradient with y [R, by analogy with DDA; 0 in every file known]
//        vx vy vr             initial velocity [R, by the same analogy]
//   nj × phi c T              friction angle (degrees), cohesion, tensile strength
//   SOR  z1 z2 z3             over-relaxation; three numbers of unknown meaning, 0 in every file known
// Total: 11 + 2 nL + 14 nb + 3 nj. Without the cover file nL follows from the total.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kNmmAnalysis;

}  // namespace keyblock::formats
