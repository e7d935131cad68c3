// Declares the keys of a case file once for reading, writing and the schema: each `describe` passes the fields of one
// struct to a visitor. A new field takes one line here; if a file lacks it, it keeps its default.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case_file/fields/cover_fields.hpp"
#include "formats/case_file/fields/geometry_fields.hpp"
#include "formats/case_file/fields/material_fields.hpp"

namespace keyblock::formats {

template <class F>
void describe(F& f, In<F, Units>& units) {
  f.text("length", units.length);
  f.text("mass", units.mass);
  f.text("time", units.time);
  f.mass_by("force", "stress", units);
}

template <class F>
void describe(F& f, In<F, RunChoices>& run) {
  f.text("profile", run.profile);
  f.pairs("set", run.settings);
}

template <class F>
void describe(F& f, In<F, BlockPair>& pair) {
  f.index("first_block", pair.first);
  f.index("second_block", pair.second);
}

template <class F>
void describe(F& f, In<F, HistoryPlan>& history) {
  f.text("name", history.name);
  f.optional_row("point", history.point);
  f.optional_index("block", history.block);
  f.optional_row("contact", history.contact);
  f.optional_index("joint", history.joint);
  f.optional_row("line", history.line);
  f.optional_index("bolt", history.bolt);
}

template <class F>
void describe(F& f, In<F, OutputPlan>& outputs) {
  f.objects("histories", outputs.histories);
  f.word("contacts", outputs.contacts, kContactTables);
  f.integer("contacts_every", outputs.contacts_every, kAtLeastOne);
}

template <class F>
void describe(F& f, In<F, StageExcavation>& excavation) {
  f.rows("outline", excavation.outline);
  f.index("joint_material", excavation.joint_material);
}

template <class F>
void describe(F& f, In<F, StageMaterial>& change) {
  f.rows("outline", change.outline);
  f.index("block_material", change.block_material);
}

template <class F>
void describe(F& f, In<F, StageJointMaterial>& change) {
  f.index("from", change.from);
  f.index("to", change.to);
}

template <class F>
void describe(F& f, In<F, StageRelease>& release) {
  f.rows("outline", release.outline);
}

template <class F>
void describe(F& f, In<F, StageForce>& force) {
  describe(f, force.at);
  f.real("force_x", force.force.x);
  f.real("force_y", force.force.y);
}

template <class F>
void describe(F& f, In<F, StageBolt>& bolt) {
  f.index("bolt", bolt.bolt);
}

template <class F>
void describe(F& f, In<F, Stage>& stage) {
  f.text("name", stage.name);
  f.integer("steps", stage.steps, kStageSteps);
  f.real("duration", stage.duration, kNotNegative);
  f.optional_real("equilibrium", stage.equilibrium, kPositive);
  f.objects("excavations", stage.excavations);
  f.rows("cuts", stage.cuts);
  f.objects("block_materials", stage.block_materials);
  f.rows("joint_materials", stage.joint_materials);
  f.rows("bolts", stage.bolts);
  f.rows("removed_bolts", stage.removed_bolts);
  f.rows("held_points", stage.held);
  f.objects("released", stage.released);
  f.rows("forces", stage.forces);
  f.flag("removes_forces", stage.removes_forces);
  f.optional_object("mesh", stage.mesh);
  f.text("profile", stage.profile);
  f.pairs("set", stage.settings);
}

template <class F>
void describe(F& f, In<F, ElementFrame>& element) {
  f.index("material", element.material);
  f.lists("loops", element.loops, 1);
  f.real("x", element.centroid.x);
  f.real("y", element.centroid.y);
  f.real("displacement_x", element.displacement.x);
  f.real("displacement_y", element.displacement.y);
  f.real("rotation", element.rotation);
  f.real("velocity_x", element.velocity.x);
  f.real("velocity_y", element.velocity.y);
  f.real("velocity_rotation", element.velocity.rotation);
  f.real("stress_xx", element.stress.xx);
  f.real("stress_yy", element.stress.yy);
  f.real("stress_xy", element.stress.xy);
  f.real("area", element.area);
  f.real("mass", element.mass);
  f.real("moment_of_inertia", element.moment_of_inertia);
}

template <class F>
void describe(F& f, In<F, PointFrame>& point) {
  describe(f, point.position);
  f.real("displacement_x", point.displacement.x);
  f.real("displacement_y", point.displacement.y);
  f.index("element", point.element);
}

template <class F>
void describe(F& f, In<F, BoltFrame>& bolt) {
  f.real("x1", bolt.first.x);
  f.real("y1", bolt.first.y);
  f.real("x2", bolt.second.x);
  f.real("y2", bolt.second.y);
  f.real("force", bolt.force);
  f.flag("is_broken", bolt.is_broken);
}

template <class F>
void describe(F& f, In<F, Frame>& frame) {
  f.integer("step", frame.step, kStep);
  f.real("time", frame.time);
  f.rows("elements", frame.elements, 1);
  f.rows("bolts", frame.bolts);
  f.rows("fixed_points", frame.fixed_points);
  f.rows("loading_points", frame.loading_points);
  f.rows("measured_points", frame.measured_points);
}

template <class F>
void describe(F& f, In<F, MeasuredRow>& row) {
  f.integer("step", row.step, kStep);
  f.real("time", row.time);
  f.real("time_step", row.time_step);
  describe(f, row.position);
  f.real("displacement", row.displacement);
  f.real("velocity_x", row.velocity.x);
  f.real("velocity_y", row.velocity.y);
  f.real("speed", row.speed);
}

template <class F>
void describe(F& f, In<F, MeasuredTrack>& track) {
  f.index("point", track.point);
  f.rows("rows", track.rows, 0);
}

/// Describes all keys except the version, which comes first.
template <class F>
void describe(F& f, In<F, Content>& content) {
  f.name("$schema");
  f.optional_object("units", content.units);
  f.object_or_file("drawing", content.drawing, content.drawing_file, content.drawing_file_place);
  f.optional_object("blocks", content.blocks);
  f.optional_object("cover", content.cover);
  f.optional_object("covers", content.covers);
  f.optional_object("loads", content.loads);
  f.optional_object("analysis", content.analysis, f.start_of_analysis());
  f.optional_curve("motion", content.motion);
  f.objects("frames", content.frames);
  f.objects("tracks", content.tracks);
  f.optional_object("run", content.choices);
  f.optional_object("outputs", content.outputs);
  f.pairs("layers", content.layers.rows);
  f.text("drawing_unit", content.drawing_unit);
  f.optional_real("join", content.join, kPositive);
  f.objects("stages", content.stages);
}

}  // namespace keyblock::formats
