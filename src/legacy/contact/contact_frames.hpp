// Reports the contacts under Shi's rules as contact frames.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "legacy/contact/contact.hpp"
#include "legacy/contact/rules.hpp"
#include "model/state.hpp"
#include "result/contact_frame.hpp"

namespace keyblock {

/// Returns all contacts of the list, with the forces of springs and friction in the last solve. `before`: vertices at
/// the start of the last step, whose lines gave the directions of the forces; empty if nothing moved since.
ContactFrames contact_frames(const Contacts& contacts, const Model& model, const State& state,
                             const StartPlaces& unloaded, const ContactRules& rules,
                             const Table<VertexIndex, Point>& before);

}  // namespace keyblock
