// Saves and restores State, member by member.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/describe_state.hpp"

namespace keyblock {
namespace {

void describe(Archive& a, const char* name, Point& point) {
  a.group(name, [&] {
    a.value("x", point.x);
    a.value("y", point.y);
  });
}

void describe(Archive& a, ElementState& element) {
  describe(a, "centroid", element.centroid);
  a.value("area", element.moments.area);
  a.value("moment_x", element.moments.x);
  a.value("moment_y", element.moments.y);
  a.value("moment_xx", element.moments.xx);
  a.value("moment_yy", element.moments.yy);
  a.value("moment_xy", element.moments.xy);
  keyblock::describe(a, "velocity", element.velocity);
  keyblock::describe(a, "last_step", element.last_step);
  a.value("stress_xx", element.stress.xx);
  a.value("stress_yy", element.stress.yy);
  a.value("stress_xy", element.stress.xy);
  a.value("stress_zz", element.stress.zz);
  a.value("rotation", element.rotation);
}

void describe(Archive& a, const char* name, std::vector<PointState>& points) {
  a.table(name, points, [&](PointState& point) {
    describe(a, "position", point.position);
    describe(a, "displacement", point.displacement);
  });
}

}  // namespace

void describe(Archive& a, const char* name, Unknowns& unknowns) {
  a.values(name, {unknowns.data(), static_cast<std::size_t>(unknowns.size())});
}

void describe(Archive& a, State& state) {
  a.value("step", state.step);
  a.value("time", state.time);
  a.value("dt", state.dt);
  a.table("vertices", state.vertices, [&](Point& vertex) {
    a.value("x", vertex.x);
    a.value("y", vertex.y);
  });
  a.table("elements", state.elements, [&](ElementState& element) { describe(a, element); });
  a.table("nodes", state.nodes, [&](NodeState& node) {
    describe(a, "position", node.position);
    describe(a, "velocity", node.velocity);
    describe(a, "last_step", node.last_step);
  });
  describe(a, "fixed_points", state.fixed_points);
  describe(a, "loading_points", state.loading_points);
  describe(a, "measured_points", state.measured_points);
  a.table("bolts", state.bolts, [&](BoltState& bolt) {
    describe(a, "first", bolt.first);
    describe(a, "second", bolt.second);
    a.value("force", bolt.force);
    a.value("is_broken", bolt.is_broken);
  });
}

}  // namespace keyblock
