// Draws elements: as they were, displaced, and coloured by stress or displacement.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/block_numbers.hpp"
#include "report/drawing/field_patches.hpp"
#include "result/field_frame.hpp"
#include "result/frame.hpp"

namespace keyblock::report {

/// Components of the stress, its principal values in the plane, the von Mises stress, and the length of the
/// displacement; or both principal stresses with their directions, as crosses.
enum class FieldShown { xx, yy, xy, greatest, least, von_mises, displacement, crosses };

/// Words of the command line, in their order: "sxx", "s1", "von_mises".
inline constexpr std::array<const char*, 8> kFieldWords{"sxx", "syy",       "sxy",          "s1",
                                                        "s3",  "von_mises", "displacement", "crosses"};
/// Throws std::invalid_argument for any other word.
FieldShown field_of_word(const std::string& word);

/// Scale of a field: colours, magnification and the part of the plane.
struct FieldScale {
  ColourScale colours;
  double most_stress = 0;  ///< of the longest cross
  double factor = 1;       ///< of displacements in the deformed mesh
  Box box;
};

struct FieldPicture {
  std::string title;
  FieldFrame start;  ///< the mesh before any excavation; without elements: that of the end
  FieldFrame end;
  std::vector<PointFrame> measured;  ///< at the end
  FieldShown shown = FieldShown::xx;
  bool is_of_motion = false;  ///< displacements may be large: never drawn smaller, and true ones carry the stress
  Units units = {};
  std::vector<std::size_t> left_out = {};  ///< elements of the end, in their order, that the picture leaves out
  /// Numbers written into the elements, from 1; start and end have the same elements then. Empty: none.
  std::vector<int> numbers = {};
  std::vector<std::size_t> held = {};    ///< blocks of the end, in their order, with a fixed point
  std::optional<FieldScale> scale = {};  ///< shared with other pictures; none: that of this picture
  /// Width of the page in its units, in which letters are 11 to 17 high; a narrow one shows the field alone.
  double wide = 900;
};

/// Visits all frames that share a scale, without the elements that pictures leave out.
using EachFrame = std::function<void(const std::function<void(const FieldFrame&)>&)>;

/// Returns the scale of the field of all frames; `each` is called twice.
FieldScale common_scale(const FieldFrame& start, FieldShown shown, bool is_of_motion, const EachFrame& each);

/// Returns the component of the stress that varies most.
FieldShown most_varied(const FieldFrame& field);

/// Returns an SVG document with three panels: the mesh, the deformed mesh, and the field. The field lies below the
/// meshes; beside them if the body is about as high as wide; all three stand side by side if it is tall. A page
/// narrower than `kLeastForThree` shows the field alone. The deformed mesh is scaled to be seen; the factor is named.
/// Colours are of mean corner values over triangles from each element's middle, with lines of equal value if elements
/// of a mesh have other values at each corner. Fixed blocks without computed stress are grey.
std::string field_picture(const FieldPicture& picture);

/// Returns the mesh alone, elements over their bodies' colours, for `keyblock cut`.
std::string mesh_picture(const std::string& title, const FieldFrame& mesh, const Units& units = {},
                         Numbers numbers = Numbers::none);

}  // namespace keyblock::report
