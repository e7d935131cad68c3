// Frames read back from the .vtu files that a run left, to draw them anew. Not a general reader of VTK: arrays are
// ASCII and named as `vtu` names them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/format.hpp"
#include "result/field_frame.hpp"

namespace keyblock::formats {

/// Elements with displacement and stress at corners and middle; the stress of a block is that of all its corners. Holes
/// are part of one closed chain, as the file has them. Plastic states and cracks are left there. Throws InputError.
FieldFrame read_vtu(const Source& source);

}  // namespace keyblock::formats
