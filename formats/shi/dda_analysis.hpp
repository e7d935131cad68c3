// Reads and writes the two native analysis (parameter) files of the DDA programs: Berkeley's and Shi's.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in this order, line breaks without meaning. [D] shown by data, [C] comments of public source, [R] inferred.
//   k01 n5 nb nj g2 g1     velocity carry-over 0..1, steps, block and joint materials, displacement per step over w0,
//                          upper limit of the time step                                                    [D]
//   Shi only:  g0          contact stiffness; 0: chosen by the program                                     [C], 0 [R]
//              k5          one per fixed point, then one per loading point: rows of its curve, 0 or ≥ 2    [C]
//              t x y       sum of k5 rows: time and displacement (fixed) or force (loading point)          [C]
//   nb × ma we E nu  s11 s22 s12  t11 t22 t12  vx vy vr   mass and weight (positive down) per unit area, stress at
//                          y = 0, its gradient with y, initial velocity                                    [D]
//   nj × phi c T           friction angle (degrees), cohesion, tensile strength                            [D]
//   Shi only:  SOR         over-relaxation 1..2, may be absent                                             [R]
// Totals: Berkeley 6 + 13 nb + 3 nj; Shi 7 + points + 3 rows + 13 nb + 3 nj + (0 or 1).
// Other settings are in neither file; they follow Berkeley's native reader. They are plane stress; automatic time step
// on (confirmed by its own example, reference_runs/examples.csv); contact stiffness 50 × the largest E. Automatic
// penalty is on: only then do passes, contacts and penetrations of the same example agree.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

extern const Format kDdaAnalysisBerkeley;
extern const Format kDdaAnalysisShi;

}  // namespace keyblock::formats
