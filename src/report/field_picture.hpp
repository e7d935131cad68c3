// A picture of elements: as they were, displaced, and one component of the stress in colour.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::report {

enum class StressShown { xx, yy, xy };

struct FieldPicture {
  std::string title;
  FieldFrame start;  ///< the mesh before anything is dug out
  FieldFrame end;
  std::vector<PointFrame> measured;  ///< at the end
  StressShown stress = StressShown::xx;
  bool is_of_motion = false;  ///< displacements may be large: never drawn smaller, and true ones carry the stress
  Units units = {};
};

/// The component that varies most.
StressShown most_varied(const FieldFrame& field);

/// An SVG document: three panels below each other, for tall bodies beside each other. The deformed mesh is scaled to be
/// seen; the factor is named. Colours are of mean corner values over triangles from each element's middle.
std::string field_picture(const FieldPicture& picture);

/// The mesh alone, elements over their bodies' colours: what `keyblock cut` shows.
std::string mesh_picture(const std::string& title, const FieldFrame& mesh, const Units& units = {});

}  // namespace keyblock::report
