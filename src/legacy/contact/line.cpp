// Takes the points of a triple from the state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/contact/line.hpp"

namespace keyblock {

Line line_of(const State& state, const Triple& triple) {
  return {state.vertices[triple.vertex], state.vertices[triple.start], state.vertices[triple.end]};
}

}  // namespace keyblock
