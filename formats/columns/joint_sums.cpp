// Groups contacts by bodies, joint and material; see joint_sums.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/columns/joint_sums.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "formats/columns/column_filler.hpp"

namespace keyblock::formats {
namespace {

/// Columns of contacts, found once.
struct ContactColumns {
  explicit ContactColumns(const FramePart& part)
      : block(part.at("block").integers()),
        other(part.at("other").integers()),
        material(part.at("joint_material").integers()),
        joint(part.at("joint").integers()),
        state(part.at("state").integers()),
        place(part.at("place").reals()),
        normal(part.at("normal").reals()),
        normal_force(part.at("normal_force").reals()),
        shear_force(part.at("shear_force").reals()),
        force(part.at("force").reals()),
        gap(part.at("gap").reals()),
        slip(part.at("slip").reals()) {}

  std::span<const int> block, other, material, joint, state;
  std::span<const double> place, normal, normal_force, shear_force, force, gap, slip;
};

Point point_of(std::span<const double> numbers, std::size_t row) {
  return {numbers[2 * row], numbers[2 * row + 1]};
}

void add_contact(JointSum& sum, const ContactColumns& of, std::size_t i) {
  const Point at = point_of(of.place, i);
  if (sum.contacts == 0) {
    const Point normal = point_of(of.normal, i);
    const auto [low, high] = std::minmax({of.block[i], of.other[i]});
    sum.block = low;
    sum.other = high;
    sum.joint_material = of.material[i];
    sum.joint = of.joint[i];
    sum.tangent = {-normal.y, normal.x};
    sum.ends = {at, at};
  }
  const auto along = [&](const Point& p) { return dot(p, sum.tangent); };
  if (along(at) < along(sum.ends[0])) sum.ends[0] = at;
  if (along(at) > along(sum.ends[1])) sum.ends[1] = at;
  ++sum.contacts;
  sum.closed += of.state[i] != 0 ? 1 : 0;
  sum.sliding += of.state[i] == 2 ? 1 : 0;
  sum.normal_force += of.normal_force[i];
  sum.shear_force += of.shear_force[i];
  sum.force = sum.force + (of.block[i] == sum.block ? 1.0 : -1.0) * point_of(of.force, i);
  sum.greatest_gap = std::max(sum.greatest_gap, of.gap[i]);
  if (std::abs(of.slip[i]) > std::abs(sum.greatest_slip)) sum.greatest_slip = of.slip[i];
}

}  // namespace

std::vector<JointSum> joint_sums(const FramePart& contacts, JointsBy by) {
  if (contacts.rows == 0) return {};  // such a part has no columns
  const ContactColumns of(contacts);
  std::map<std::tuple<int, int, int, int>, JointSum> sums;
  for (std::size_t i = 0; i < contacts.rows; ++i) {
    const auto [low, high] = std::minmax({of.block[i], of.other[i]});
    if (by == JointsBy::piece) add_contact(sums[{low, high, of.joint[i], of.material[i]}], of, i);
    if (by == JointsBy::bodies) add_contact(sums[{low, high, 0, of.material[i]}], of, i);
    if (by == JointsBy::line && of.joint[i] > 0) add_contact(sums[{0, 0, of.joint[i], 0}], of, i);
  }
  std::vector<JointSum> all;
  all.reserve(sums.size());
  for (const auto& [key, sum] : sums) all.push_back(sum);
  return all;
}

FramePart joint_part(const FramePart& contacts) {
  using P = const JointSum&;
  const std::vector<JointSum> pieces = joint_sums(contacts, JointsBy::piece);
  FramePart part{"joints", pieces.size(), {}};
  const ColumnFiller fill(part, pieces);
  fill.integer("block", [](P p, std::size_t) { return p.block; });
  fill.integer("other", [](P p, std::size_t) { return p.other; });
  fill.integer("joint_material", [](P p, std::size_t) { return p.joint_material; });
  fill.integer("joint", [](P p, std::size_t) { return p.joint; });
  fill.integer("contacts", [](P p, std::size_t) { return p.contacts; });
  fill.integer("closed", [](P p, std::size_t) { return p.closed; });
  fill.integer("sliding", [](P p, std::size_t) { return p.sliding; });
  fill.real("normal_force", [](P p) { return p.normal_force; });
  fill.real("shear_force", [](P p) { return p.shear_force; });
  fill.real("greatest_gap", [](P p) { return p.greatest_gap; });
  fill.real("greatest_slip", [](P p) { return p.greatest_slip; });
  fill.ends("ends", [](P p) { return p.ends; });
  return part;
}

}  // namespace keyblock::formats
