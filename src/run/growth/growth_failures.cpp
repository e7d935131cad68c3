// Finds the crack that cuts an accelerating part off.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/growth/growth_failures.hpp"

#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "model/continuum.hpp"
#include "model/setup/free_pieces.hpp"

namespace keyblock {

StepFailure cannot_go_on(int step, const std::exception& error) {
  return failed("in_step_alone", {{{"step", step}}}, {"cracks_cannot_go_on", {{}, {{"input", error.what()}}}},
                FailureKind::cracks);
}

// Naming the cut is more helpful than numbers of elements.
StepFailure parted(StepFailure failure, const StandardStepper& now) {
  if (failure.kind != FailureKind::accelerates || failure.elements.empty()) return failure;
  Box moving;
  for (const ElementIndex e : failure.elements) moving.add(now.unloaded().elements[e].centroid);
  const FreePiece* nearest = nullptr;
  const std::vector<FreePiece> pieces = free_pieces(*now.model().continuum);
  for (const FreePiece& piece : pieces)
    if (piece.cut && (!nearest || distance(piece.middle, moving.middle()) < distance(nearest->middle, moving.middle())))
      nearest = &piece;
  if (!nearest) return failure;
  const Point middle = nearest->middle, start = nearest->cut->start, end = nearest->cut->end;
  StepFailure named = failed("in_step_alone", {{{"step", now.state().step + 1}}},
                             {"cracks_part_body",
                              {{{"start_x", start.x}, {"start_y", start.y}, {"end_x", end.x}, {"end_y", end.y}},
                               {},
                               {},
                               {{{middle.x, middle.y}}}}});
  failure.reason = std::move(named.reason);
  failure.cause = std::move(named.cause);
  return failure;
}

}  // namespace keyblock
