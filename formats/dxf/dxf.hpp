// Reads DXF, the exchange format of drawing programs, into a drawing by layers, and writes it.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// ASCII text of groups: a line with a code, a line with its value [D]. Sections are between 0 SECTION and 0 ENDSEC,
// with 0 EOF at the end; layout as published for R12 (AC1009) to 2018 (AC1032) [S].
//   HEADER    $INSUNITS: coordinates are converted to metres, or to the length unit of the case file, and the unit is
//             declared; absent or 0: coordinates are not converted, and no unit is declared
//   TABLES    LAYER: 62 below 0 (off) and 70 bit 1 (frozen) hide the entities of the layer (dxf_visibility.hpp)
//   ENTITIES  in one level plane of model space; 8: the layer, whose name is the part in the drawing (dxf_layers.hpp)
//     LINE        10 20, 11 21: ends; extended data 1001 KEYBLOCK, 1040 × 3: stiffness, strength, pre-tension of a bolt
//     LWPOLYLINE  10 20 and 42 (bulge of the side that begins there) per vertex; 70 bit 1: closed
//     POLYLINE    70 bit 1: closed; VERTEX 10 20 42 …; SEQEND
//     ARC         10 20 centre, 40 radius, 50 51 angles in degrees, counter-clockwise
//     CIRCLE      10 20 centre, 40 radius
//     ELLIPSE     10 20 centre, 11 21 the greater half axis, 40 ratio of the axes, 41 42 parameters in radians
//     SPLINE      71 degree; 40 knots, 10 20 control points, 41 weights; otherwise 11 21 points on the curve
//     POINT       10 20
//     INSERT      2: a block of the section BLOCKS; 10 20 its place, 41 42 scales, 50 angle in degrees; 70 71 columns
//                 and rows, 44 45 their distances
//   999 keyblock edge-node ratio R  a comment: the edge-node ratio of the drawing; absent: kDxfEdgeNodeRatio. Written
//                                   with blocks: kBlockEdgeNodeRatio
// Curves become chords (curves/). All other entities are skipped and listed, with one warning per kind. Files are
// written as R12, with $INSUNITS of the declared length unit (0: none is declared) and a LINE or POINT per record. A
// closed POLYLINE on BLOCK_n gives the sides of a block, and a point with the block material. Each side is a joint; the
// layer JOINT_n of the VERTEX where it begins names its material. Gaps enclosed by blocks need a HOLE point to stay
// empty when cut.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

/// Default edge-node ratio of a drawing: drawing programs snap ends exactly, so few points need merging.
inline constexpr double kDxfEdgeNodeRatio = 0.001;

/// Edge-node ratio of blocks drawn as lines: only corners separated by rounding are merged. With the ratio of a
/// drawing, corners that cutting had kept apart would merge.
inline constexpr double kBlockEdgeNodeRatio = 1e-6;

extern const Format kDxf;

/// Returns "a binary DXF file …" or "a DWG file …" if the bytes begin as one; otherwise an empty text.
std::string_view drawing_program_binary(std::string_view text);

}  // namespace keyblock::formats
