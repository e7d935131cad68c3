// Names the reasons of cuts and computes the parts of increments from their change; see newton.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/newton/newton.hpp"

#include <algorithm>

namespace keyblock {

std::string_view in_words(RoundsEnd end) {
  switch (end) {
    case RoundsEnd::open:
      return "forces out of balance";
    case RoundsEnd::balanced:
      return "balance";
    case RoundsEnd::too_many_rounds:
      return "too many iterations";
    case RoundsEnd::not_finite:
      return "an element without area, or stress beyond its law";
    case RoundsEnd::no_factor:
      return "a tangent without inverse";
    case RoundsEnd::off_path:
      return "no load increment at the length of the step";
    case RoundsEnd::no_contact_forces:
      return "contact forces that do not settle";
    case RoundsEnd::turned_over:
      return "an element turned over";
  }
  return {};
}

// `left`: change of this iteration over that of the last.
double PartsByChange::next(double left) {
  using namespace tolerances;
  if (left > of_line_search::kStalls) {
    kept_ = 0;
    return part_ = std::max(part_ / 2, of_line_search::kLeastPart);
  }
  kept_ = left <= 1 - of_line_search::kPromised * part_ ? kept_ + 1 : 0;
  if (left < of_line_search::kLeads || kept_ > 1) {
    kept_ = 0;
    part_ = std::min(1.0, 2 * part_);
  }
  return part_;
}

}  // namespace keyblock
