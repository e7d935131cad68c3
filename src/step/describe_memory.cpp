// Saves and restores a motion, member by member.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/describe_memory.hpp"

#include <string>

#include "model/describe_state.hpp"

namespace keyblock {
namespace {

void describe(Archive& a, Facing& facing, VertexIndex vertices) {
  a.index("lower", facing.lower, vertices);
  a.index("upper", facing.upper, vertices);
  a.value("place", facing.place);
}

void describe(Archive& a, Touch& touch, VertexIndex vertices) {
  a.index("vertex", touch.vertex, vertices);
  a.index("start", touch.start, vertices);
  a.index("end", touch.end, vertices);
  a.choice("kind", touch.kind, TouchKind::arc);
  a.index("other", touch.other, vertices);
  a.value("along", touch.along);
  a.index("first_start", touch.first.start, vertices);
  a.index("first_end", touch.first.end, vertices);
  a.index("second_start", touch.second.start, vertices);
  a.index("second_end", touch.second.end, vertices);
  a.value("tangent", touch.tangent);
  describe(a, touch.facing, vertices);
  a.value("stretch", touch.stretch);
  a.value("share", touch.share);
  a.value("joint_material", touch.joint_material);
  a.value("rest_gap", touch.rest_gap);
}

void describe(Archive& a, ContactMemory& memory) {
  a.value("normal", memory.normal);
  a.value("tangential", memory.tangential);
  a.value("spring_stretch", memory.stretch);
  a.value("normal_compliance", memory.normal_compliance);
  a.value("tangential_compliance", memory.tangential_compliance);
  a.value("normal_at_end", memory.normal_at_end);
  a.value("compression", memory.compression);
  a.value("removed_in", memory.removed_in);
}

void describe(Archive& a, ConstraintMemory& constraints) {
  a.values("bolt_forces", constraints.bolt_forces);
  a.group("bolts", [&] {
    for (std::size_t i = 0; i < constraints.broken.size(); ++i) {
      bool broken = constraints.broken[i];
      a.value("broken", broken);
      constraints.broken[i] = broken;
    }
  });
  a.values("point_forces",
           {constraints.point_forces.data(), static_cast<std::size_t>(constraints.point_forces.size())});
}

void describe_points(Archive& a, const char* name, std::vector<YieldState>& points) {
  if (!points.empty()) a.table(name, points, [&](YieldState& point) { keyblock::describe(a, point); });
}

void describe(Archive& a, const char* name, UnknownsTable& table) {
  a.table(name, table, [&](Unknowns& unknowns) { describe(a, "unknowns", unknowns); });
  if (table.shared.size() > 0)
    a.values((std::string(name) + "_covers").c_str(),
             {table.shared.data(), static_cast<std::size_t>(table.shared.size())});
}

}  // namespace

void describe(Archive& a, ClosedContacts& contacts, VertexIndex vertices) {
  a.list("contacts", contacts.by_touch_, [&](ClosedContact& contact) {
    describe(a, contact.touch, vertices);
    describe(a, contact.memory);
  });
  if (a.is_restoring()) contacts = ClosedContacts(std::move(contacts.by_touch_));
}

void describe(Archive& a, YieldState& point) {
  a.values("elastic", {point.elastic.data(), static_cast<std::size_t>(point.elastic.size())});
  a.values("plastic", {point.plastic.data(), static_cast<std::size_t>(point.plastic.size())});
  a.value("kappa", point.kappa);
  a.choice("region", point.region, YieldRegion::tension);
}

void describe(Archive& a, Motion& motion, VertexIndex vertices) {
  describe(a, "q", motion.q);
  describe(a, "v", motion.v);
  describe(a, "a", motion.a);
  a.group("closed", [&] { describe(a, motion.closed, vertices); });
  a.map("bonds", motion.bonds, [&](Facing& facing, Bond& bond) {
    describe(a, facing, vertices);
    a.value("gap", bond.gap);
    a.value("length", bond.length);
  });
  a.group("ties", [&] { describe(a, motion.constraints); });
  if (motion.q.shared.size() > 0) a.value("given_up", motion.given_up);
  describe_points(a, "points_of_blocks", motion.points.blocks);
  describe_points(a, "points_of_covers", motion.points.covers);
}

}  // namespace keyblock
