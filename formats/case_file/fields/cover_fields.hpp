// Declares the keys of NMM bodies in a case file: mesh, loads, supports, cracks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/case_file/fields/geometry_fields.hpp"

namespace keyblock::formats {

template <class F>
void describe(F& f, In<F, RefinedPoint>& point) {
  describe(f, point.at);
  f.real("side", point.side, kPositive);
}

template <class F>
void describe(F& f, In<F, MeshedMaterial>& meshed) {
  f.index("material", meshed.material);
}

template <class F>
void describe(F& f, In<F, MeshPlan>& mesh) {
  f.word("kind", mesh.kind, kMeshKinds);
  f.integer("half_rows", mesh.half_rows, kHalfRows);
  f.real("side", mesh.side, kNotNegative);
  f.word("shape", mesh.shape, kMeshShapes);
  f.real("angle", mesh.angle_deg);
  f.word("placement", mesh.placement, kMeshPlacements);
  f.optional_real("through_x", mesh.through_x, kAny);
  f.optional_real("through_y", mesh.through_y, kAny);
  f.rows("refined", mesh.refined);
  f.real("error", mesh.error, kMeshError);
  f.integer("most_unknowns", mesh.most_unknowns, kMostUnknowns);
  f.real("tip_side", mesh.tip_side, kNotNegative);
  f.word("tip_functions", mesh.tip_functions.kind, kTipFunctions);
  f.real("tip_radius", mesh.tip_functions.radius, kNotNegative);
  f.real("snap_ratio", mesh.snap_ratio, kNotNegative);
  f.rows("materials", mesh.materials);
}

template <class F>
void describe(F& f, In<F, FactorAt>& row) {
  f.real("time", row.time);
  f.real("factor", row.factor);
}

template <class F>
void describe(F& f, In<F, ActiveStages>& stages) {
  f.optional_index("first_stage", stages.first);
  f.optional_index("last_stage", stages.last);
}

template <class F>
void describe(F& f, In<F, TractionPlan>& traction) {
  f.rows("along", traction.along);
  f.formula("x", traction.x);
  f.formula("y", traction.y);
  f.formula("pressure", traction.pressure);
  f.rows("over_time", traction.over_time);
  describe(f, traction.stages);
}

template <class F>
void describe(F& f, In<F, DisplacementPlan>& displacement) {
  f.rows("along", displacement.along);
  f.word("held", displacement.held, kHeld);
  f.formula("x", displacement.x);
  f.formula("y", displacement.y);
  f.formula("normal", displacement.normal);
  f.rows("over_time", displacement.over_time);
  describe(f, displacement.stages);
}

template <class F>
void describe(F& f, In<F, LoadList>& loads) {
  f.objects("tractions", loads.tractions);
  f.objects("displacements", loads.displacements);
}

template <class F>
void describe(F& f, In<F, ForcePlan>& force) {
  describe(f, force.at);
  f.real("force_x", force.force.x);
  f.real("force_y", force.force.y);
}

template <class F>
void describe(F& f, In<F, SpringPlan>& spring) {
  describe(f, spring.at);
  f.real("direction_x", spring.direction.x);
  f.real("direction_y", spring.direction.y);
  f.real("stiffness", spring.stiffness, kPositive);
}

template <class F>
void describe(F& f, In<F, BodyForcePlan>& force) {
  f.formula("x", force.x);
  f.formula("y", force.y);
}

template <class F>
void describe(F& f, In<F, StressPlan>& stress) {
  f.formula("xx", stress.xx);
  f.formula("yy", stress.yy);
  f.formula("xy", stress.xy);
  f.optional_formula("zz", stress.zz);
}

template <class F>
void describe(F& f, In<F, ExcavationPlan>& excavation) {
  f.integer("step", excavation.step, kStepCount);
  f.rows("outline", excavation.outline);
}

template <class F>
void describe(F& f, In<F, CrackPlan>& crack) {
  f.rows("along", crack.along);
  f.index("joint_material", crack.joint_material);
}

template <class F>
void describe(F& f, In<F, GrowthPlan>& growth) {
  f.word("criterion", growth.criterion, kGrowthCriteria);
  f.word("loads", growth.loads, kGrowthLoads);
  f.real("increment", growth.increment, kPositive);
  f.flag("corrector", growth.has_corrector);
}

template <class F>
void describe(F& f, In<F, CoverPlan>& covers) {
  f.optional_word("functions", covers.functions, kCoverFunctions);
  f.word("contact", covers.contact, kCoverContacts);
  f.object("mesh", covers.mesh);
  f.objects("tractions", covers.tractions);
  f.objects("displacements", covers.displacements);
  f.rows("forces", covers.forces);
  f.rows("springs", covers.springs);
  f.object("body_force", covers.body_force);
  f.object("initial_stress_field", covers.initial_stress);
  f.objects("excavations", covers.excavations);
  f.objects("cracks", covers.cracks);
  f.optional_object("growth", covers.growth);
}

}  // namespace keyblock::formats
