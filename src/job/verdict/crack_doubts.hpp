// Declares the doubts about cracks of a completed run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "job/verdict/judgement.hpp"
#include "result/crack_notes.hpp"
#include "result/frame.hpp"
#include "run/prepare.hpp"

namespace keyblock {

/// Compares the cracks of a run and the frame `last` with what their numbers need: room and mesh at the tips, faces
/// that do not overlap, increments that do not bend.
void add_doubts_of_cracks(Judgement& judgement, const Prepared& prepared, const CrackNotes& cracks, const Frame& last,
                          const Place& place);

}  // namespace keyblock
