// Lists the columns of contacts: frames, contacts.csv and viewer files have all of them, with their units.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <variant>

#include "formats/columns/column_filler.hpp"
#include "problem/units/measure.hpp"
#include "result/contact_frame.hpp"

namespace keyblock::formats {

/// Column of the part `contacts` of a frame.
struct ContactColumn {
  using C = const ContactFrame&;

  std::string_view name;
  Measure measure;
  std::variant<int (*)(C), double (*)(C), Point (*)(C)> value;
  std::array<std::string_view, 2> of_point = {};  ///< names of x and y in contacts.csv, which has a column for each
  Digits digits = Digits::all;

  bool is_point() const { return value.index() == 2; }
};

/// Returns the columns in the order of contacts.csv.
std::span<const ContactColumn> contact_columns();

/// Returns the part `contacts` of an instant.
FramePart contact_part(const ContactFrames& contacts);

}  // namespace keyblock::formats
