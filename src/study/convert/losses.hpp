// Lists the losses of a conversion: compares two contents item by item, as full case files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"
#include "formats/views/views.hpp"

namespace keyblock::study {

/// One kind of item that is missing or changed in the target.
struct Loss {
  std::string item;       ///< "drawing.bolts[].stiffness", as a case file names it
  int times = 0;          ///< number of such items
  std::string sentence;   ///< change of the first: "3 → nothing"
  bool is_added = false;  ///< the first was not there before

  bool operator==(const Loss&) const = default;
};

/// Returns the losses in the order of the case file. The dialect of an analysis is not an item, because conversion is
/// meant to change it.
std::vector<Loss> losses(const formats::Content& original, const formats::Content& converted);

/// Returns the items left out by a view, from which nothing can be read back.
std::vector<Loss> losses(const formats::Content& original, const formats::LeftOut& left_out);

}  // namespace keyblock::study
