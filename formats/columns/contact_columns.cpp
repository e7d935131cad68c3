// Declares the columns of contacts. To add one: a row here, its meaning in docs/reference/result_columns.csv, and, if
// ContactFrame lacks the value, a member that both step/scene/contact_frames.cpp and its counterpart in legacy set.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/contact_columns.hpp"

#include <type_traits>

namespace keyblock::formats {
namespace {

namespace m = measures;
using C = const ContactFrame&;

constexpr std::array kContactColumns{
    ContactColumn{"block", m::kNumber, [](C c) { return c.element + 1; }},
    ContactColumn{"other", m::kNumber, [](C c) { return c.other + 1; }},
    ContactColumn{"joint_material", m::kNumber, [](C c) { return c.joint_material + 1; }},
    ContactColumn{"joint", m::kNumber, [](C c) { return c.joint_line + 1; }},
    ContactColumn{"state", m::kNumber, [](C c) { return static_cast<int>(c.condition); }},
    ContactColumn{"place", m::kLength, [](C c) { return c.position; }, {"x", "y"}},
    ContactColumn{"normal", m::kNumber, [](C c) { return c.normal; }, {"normal_x", "normal_y"}, Digits::seven},
    ContactColumn{"gap", m::kLength, [](C c) { return c.gap; }},
    ContactColumn{"slip", m::kLength, [](C c) { return c.slip; }},
    ContactColumn{"normal_force", m::kForce, [](C c) { return c.normal_force; }},
    ContactColumn{"shear_force", m::kForce, [](C c) { return c.shear_force; }},
    ContactColumn{"force", m::kForce, [](C c) { return c.force(); }, {"force_x", "force_y"}},
};

}  // namespace

std::span<const ContactColumn> contact_columns() {
  return kContactColumns;
}

FramePart contact_part(const ContactFrames& contacts) {
  FramePart part{"contacts", contacts.size(), {}};
  const ColumnFiller fill(part, contacts);
  for (const auto& [name, measure, value, of_point, digits] : kContactColumns)
    std::visit(
        [&, &name = name, &digits = digits](auto of) {
          using Number = std::invoke_result_t<decltype(of), C>;
          if constexpr (std::is_same_v<Number, int>)
            fill.integer(name, [of](C c, std::size_t) { return of(c); });
          else if constexpr (std::is_same_v<Number, double>)
            fill.real(name, of, digits);
          else
            fill.xy(name, of, digits);
        },
        value);
  return part;
}

}  // namespace keyblock::formats
