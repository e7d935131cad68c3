// Contacts under Shi's rules as frames report them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"
#include "result/contact_frame.hpp"

namespace keyblock {

/// All contacts of the list, with the forces that springs and friction had in the last solve. `before`: vertices at the
/// start of the last step, along whose lines they acted; empty where nothing moved since.
ContactFrames contact_frames(const Contacts& contacts, const Model& model, const State& state,
                             const StartPlaces& unloaded, const ContactRules& rules,
                             const Table<VertexIndex, Point>& before);

}  // namespace keyblock
