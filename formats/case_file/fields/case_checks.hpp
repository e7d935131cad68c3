// Declares the checks of a case file beyond single numbers: references, outlines, stages, choices of one of several.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "formats/format.hpp"
#include "formats/text/json_text.hpp"

namespace keyblock::formats {

/// Throws InputError at the place of the part that is not sound.
void require_sound(const Units& units, const Place& place);
void require_sound(const Drawing& drawing);
void require_sound(const Blocks& blocks);
void require_sound(const Cover& cover);
void require_sound(const LoadList& loads);
void require_sound(const CoverPlan& covers);
void require_sound(const std::vector<Stage>& stages);
void require_sound(const Analysis& analysis);
void require_sound(const OutputPlan& outputs);
/// Requires enough corners in the outer loop and in holes: areas and pictures need them. `from`: the list of frames.
void require_sound(const std::vector<Frame>& frames, const JsonValue& from);
/// `count`: of the stages of the case.
void check_stages_of(const CoverPlan& covers, int count);
void check_stages_of(const LoadList& loads, int count);
void check_joints_of_cracks(const CoverPlan& covers, const Analysis& analysis);

}  // namespace keyblock::formats
