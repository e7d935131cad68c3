// DXF, the exchange format of drawing programs: lines by layer to a drawing and back.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// ASCII text of groups: a line with a code, a line with its value [D]. Sections between 0 SECTION and 0 ENDSEC, 0 EOF
// at the end; layout as published for R12 (AC1009) to 2018 (AC1032) [S].
//   HEADER    $INSUNITS: coordinates are multiplied to metres, or to the length unit of a case file read beside it, and
//             that is
//             declared; absent or 0: taken as they are, nothing declared
//   TABLES    LAYER: 62 below 0 (off) and 70 bit 1 (frozen) hide what lies on it (dxf_visibility.hpp)
//   ENTITIES  in one level plane of model space; 8: the layer, whose name says the part in the drawing (dxf_layers.hpp)
//     LINE        10 20, 11 21: ends; extended data 1001 KEYBLOCK, 1040 × 3: stiffness, strength, pre-tension of a bolt
//     LWPOLYLINE  10 20 and 42 (bulge of the side that begins there) a vertex; 70 bit 1: closed
//     POLYLINE    70 bit 1: closed; VERTEX 10 20 42 …; SEQEND
//     ARC         10 20 centre, 40 radius, 50 51 angles in degrees, counter-clockwise
//     CIRCLE      10 20 centre, 40 radius
//     ELLIPSE     10 20 centre, 11 21 the greater half axis, 40 ratio of the axes, 41 42 parameters in radians
//     SPLINE      71 degree; 40 knots, 10 20 control points, 41 weights; else 11 21 points that it runs through
//     POINT       10 20
//     INSERT      2: a block of the section BLOCKS; 10 20 its place, 41 42 scales, 50 angle in degrees; 70 71 columns
//                 and rows, 44 45 their distances
//   999 keyblock edge-node ratio R  a comment: the edge-node ratio of the drawing; absent: kDxfEdgeNodeRatio. Written
//                                   with
//                                   blocks: kBlockEdgeNodeRatio
// Curves become chords (curves/). Everything else is skipped and listed, one warning a kind.
// Written: R12, $INSUNITS of the declared length unit (0: none is declared), a LINE or POINT a record. A closed
// POLYLINE on BLOCK_n gives the sides of a block, each a joint of the material that the layer JOINT_n of the VERTEX
// where it begins names, and a point that carries the block material. Gaps that blocks enclose need a HOLE point to
// stay empty when cut.
#pragma once

#include "formats/format.hpp"

namespace keyblock::formats {

/// The edge-node ratio of a drawing that says none: drawing programs snap ends exactly, so nothing much is to be
/// merged.
inline constexpr double kDxfEdgeNodeRatio = 0.001;

/// That of blocks as lines: their corners are where they are, only what rounding parts is to be merged. With a
/// drawing's own ratio corners that cutting had left apart would merge.
inline constexpr double kBlockEdgeNodeRatio = 1e-6;

extern const Format kDxf;

/// "a binary DXF file …", "a DWG file …" where the bytes begin as one; empty else.
std::string_view drawing_program_binary(std::string_view text);

}  // namespace keyblock::formats
