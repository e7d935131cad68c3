// What a conversion could not carry over: two contents compared item by item, as case files of all they hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "formats/format.hpp"
#include "formats/views/views.hpp"

namespace keyblock::study {

/// One kind of item that is not in the target, or not as it was.
struct Loss {
  std::string item;      ///< "drawing.bolts[].stiffness", as a case file names it
  int times = 0;         ///< how many such items
  std::string sentence;  ///< what became of the first: "3 → nothing"

  bool operator==(const Loss&) const = default;
};

/// In the order of the case file. The dialect of an analysis is no item: it is what is converted.
std::vector<Loss> losses(const formats::Content& original, const formats::Content& converted);

/// What a view, from which nothing can be read back, leaves out.
std::vector<Loss> losses(const formats::Content& original, const formats::LeftOut& left_out);

}  // namespace keyblock::study
