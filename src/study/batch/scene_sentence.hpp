// What a scene is, in one sentence for a catalogue: its motion, its bodies and what holds and drives them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/analysis.hpp"
#include "problem/blocks.hpp"
#include "problem/cover.hpp"

namespace keyblock::study {

/// "static, 5 steps of 0.2; 2 pieces, 1 of them held, of 43 elements on 37 covers; 1 point load of up to 2; E 10,
/// Poisson's ratio 0.25; weight 0.2; friction 30 degrees". Elements that share a cover are of one piece; it is held
/// where a point of it is fixed.
std::string scene_sentence(const Cover& cover, const Analysis& analysis);

/// The same of blocks, each of which is a body.
std::string scene_sentence(const Blocks& blocks, const Analysis& analysis);

}  // namespace keyblock::study
