// Describes a scene in one sentence for a catalogue: motion, bodies, supports and loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"

namespace keyblock::study {

/// Returns a sentence such as "static, 5 steps of 0.2; 2 pieces, 1 of them fixed, of 43 elements on 37 covers; 1 point
/// load of up to 2; E 10, …; friction 30 degrees". Elements that share a cover form one piece; it is fixed if one of
/// its points is.
std::string scene_sentence(const Cover& cover, const Analysis& analysis);

/// Does the same for blocks, each of which is a body.
std::string scene_sentence(const Blocks& blocks, const Analysis& analysis);

}  // namespace keyblock::study
