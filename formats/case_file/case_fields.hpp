// Declares the keys of a case file once for reading, writing and the schema: each `describe` passes the fields of one
// struct to a visitor. A new field takes one line here; if a file lacks it, it keeps its default.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "formats/format.hpp"
#include "formats/text/demands.hpp"

namespace keyblock::formats {

/// Type that a visitor F receives: const if it writes. Functions of a visitor for values: `real`, `integer` (with the
/// condition on the value), `index` (from 1 in the file, from 0 inside), `formula` (a number or a text). Also `flag`,
/// `word` (of an enumeration), `text`, `mass_by` (units that may replace a unit of mass), `optional_real`,
/// `optional_integer`. For structs: `row` (a struct as an array), `object`, `optional_object`, `optional_row`. For
/// vectors: `rows`, `objects` and `lists` (of rows), with their least size if the list is required. For curves:
/// `curve`, `curves` (rows of time and value); for words: `pairs` (an object of words).
template <class F, class T>
using In = std::conditional_t<F::is_writing, const T, T>;

inline constexpr Demand kAny{{}, "a number"};
inline constexpr Demand kWhole{{0}, "a whole number, 0 or more", true};

inline constexpr Demand kHalfRows{{0, false, 1000}, "a whole number from 0 to 1000", true};
inline constexpr Demand kMeshError{kMeshErrorRange, "at least 0 and below 1"};
inline constexpr Demand kMostUnknowns{kMeshLimitRange, kMeshLimitExpected, true};
inline constexpr Demand kStageSteps{{0, false, 1e9}, "a whole number from 0 to 1000000000", true};
inline constexpr Demand kStep{{}, "a whole number", true};

inline constexpr std::array<std::string_view, 4> kDialects{"berkeley", "shi", "ddaml", "manifold"};
inline constexpr std::array<std::string_view, 4> kCoverFunctions{"constant", "derived", "linear", "quadratic"};
inline constexpr std::array<std::string_view, 2> kCoverContacts{"felt", "ignored"};
inline constexpr std::array<std::string_view, 4> kHeld{"both", "normal", "x", "y"};
inline constexpr std::array<std::string_view, 2> kMeshKinds{"regular", "unstructured"};
inline constexpr std::array<std::string_view, 2> kMeshShapes{"equilateral", "old"};
inline constexpr std::array<std::string_view, 2> kMeshPlacements{"free", "aligned"};
inline constexpr std::array<std::string_view, 2> kTipFunctions{"none", "williams"};
inline constexpr std::array<std::string_view, 4> kYieldSurfaces{"tresca", "von_mises", "mohr_coulomb",
                                                                "drucker_prager"};
inline constexpr std::array<std::string_view, 3> kConeMatchings{"compression", "extension", "plane_strain"};
inline constexpr std::array<std::string_view, 3> kGrowthCriteria{"hoop_stress", "strain_energy", "energy_release"};
inline constexpr std::array<std::string_view, 3> kGrowthLoads{"automatic", "scaled", "given"};
inline constexpr std::array<std::string_view, 4> kContactTables{"automatic", "all", "chosen", "none"};
inline constexpr std::array<std::string_view, 2> kRotations{"first_order", "exact"};

inline constexpr double kDefaultEdgeNodeRatio = 0.001;  // as in DXF files and joint sets

template <class F>
void describe(F& f, In<F, Point>& point) {
  f.real("x", point.x);
  f.real("y", point.y);
}

template <class F>
void describe(F& f, In<F, Segment>& segment) {
  f.real("x1", segment.start.x);
  f.real("y1", segment.start.y);
  f.real("x2", segment.end.x);
  f.real("y2", segment.end.y);
}

template <class F>
void describe(F& f, In<F, JointLine>& line) {
  describe(f, line.segment);
  f.index("joint_material", line.joint_material);
}

template <class F>
void describe(F& f, In<F, MaterialLine>& line) {
  describe(f, line.segment);
  f.index("block_material", line.block_material);
}

template <class F>
void describe(F& f, In<F, BoltLine>& bolt) {
  describe(f, bolt.segment);
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
  f.index("type", bolt.type);
  f.name_at_end("name", bolt.name);
}

template <class F>
void describe(F& f, In<F, FixedLine>& line) {
  describe(f, line.segment);
}

template <class F>
void describe(F& f, In<F, MarkedPoint>& point) {
  describe(f, point.position);
}

template <class F>
void describe(F& f, In<F, Drawing>& drawing) {
  f.real("edge_node_ratio", drawing.edge_node_ratio, kEdgeNodeRatio);
  f.integer("boundary_count", drawing.boundary_count, kWhole);
  f.rows("joints", drawing.joints);
  f.rows("material_lines", drawing.material_lines);
  f.rows("bolts", drawing.bolts);
  f.rows("fixed_lines", drawing.fixed_lines);
  f.rows("loading_points", drawing.loading_points);
  f.rows("measured_points", drawing.measured_points);
  f.rows("hole_points", drawing.hole_points);
}

template <class F>
void describe(F& f, In<F, BlockVertex>& vertex) {
  describe(f, vertex.position);
  f.index("joint_material", vertex.joint_material);
}

template <class F>
void describe(F& f, In<F, BlockPolygon>& block) {
  f.index("material", block.material);
  f.rows("outer", block.outer, 3);
  f.lists("holes", block.holes);
}

template <class F>
void describe(F& f, In<F, BlockBolt>& bolt) {
  describe(f, bolt.segment);
  f.index("first_block", bolt.first_block);
  f.index("second_block", bolt.second_block);
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
  f.name_at_end("name", bolt.name);
}

template <class F>
void describe(F& f, In<F, BlockPoint>& point) {
  describe(f, point.position);
  f.index("block", point.block);
}

template <class F>
void describe(F& f, In<F, Blocks>& blocks) {
  f.objects("blocks", blocks.blocks);
  f.rows("bolts", blocks.bolts);
  f.rows("fixed_points", blocks.fixed_points);
  f.rows("loading_points", blocks.loading_points);
  f.rows("measured_points", blocks.measured_points);
}

template <class F>
void describe(F& f, In<F, SlotRange>& range) {
  f.index("first", range.first);
  f.integer("size", range.size, kWhole);
}

template <class F>
void describe(F& f, In<F, CoverElement>& element) {
  describe(f, element.vertices);
  f.index("material", element.material);
  f.index("cover_1", element.covers[0]);
  f.index("cover_2", element.covers[1]);
  f.index("cover_3", element.covers[2]);
}

template <class F>
void describe(F& f, In<F, LoopVertex>& vertex) {
  f.index("slot", vertex.slot);
  f.index("joint_material", vertex.joint_material);
}

template <class F>
void describe(F& f, In<F, CoverPoint>& point) {
  describe(f, point.position);
  f.index("element", point.element);
}

template <class F>
void describe(F& f, In<F, Cover>& cover) {
  f.rows("elements", cover.elements);
  f.rows("vertices", cover.vertices);
  f.rows("nodes", cover.nodes);
  f.rows("loops", cover.loops);
  f.rows("loop_vertices", cover.loop_vertices);
  f.rows("fixed_points", cover.fixed_points);
  f.rows("loading_points", cover.loading_points);
  f.rows("measured_points", cover.measured_points);
}

template <class F>
void describe(F& f, In<F, Stress>& stress) {
  f.real("xx", stress.xx);
  f.real("yy", stress.yy);
  f.real("xy", stress.xy);
}

template <class F>
void describe(F& f, In<F, Velocity>& velocity) {
  f.real("x", velocity.x);
  f.real("y", velocity.y);
  f.real("rotation", velocity.rotation);
}

template <class F>
void describe(F& f, In<F, std::array<double, 3>>& strain) {
  f.real("xx", strain[0]);
  f.real("yy", strain[1]);
  f.real("xy", strain[2]);
}

template <class F>
void describe(F& f, In<F, StrengthValues>& values) {
  f.real("cohesion", values.cohesion, kNotNegative);
  f.real("friction_deg", values.friction_deg, kFrictionAngle);
  f.real("dilation_deg", values.dilation_deg, kFrictionAngle);
  f.real("yield_stress", values.yield_stress, kNotNegative);
  f.optional_real("tensile_strength", values.tensile_strength, kNotNegative);
}

template <class F>
void describe(F& f, In<F, StrengthChange>& change) {
  describe(f, change.values);
  f.real("plastic_strain", change.plastic_strain, kNotNegative);
  f.real("fracture_energy", change.fracture_energy, kNotNegative);
}

template <class F>
void describe(F& f, In<F, Strength>& strength) {
  f.word("surface", strength.surface, kYieldSurfaces);
  f.word("matching", strength.matching, kConeMatchings);
  describe(f, strength.values);
  // Values that it does not name stay unchanged.
  f.optional_object("after", strength.change, StrengthChange{.values = strength.values});
}

template <class F>
void describe(F& f, In<F, CrackClosure>& closure) {
  f.real("initial_modulus", closure.initial_modulus, kNotNegative);
  f.real("closure_strain", closure.closure_strain, kNotNegative);
}

template <class F>
void describe(F& f, In<F, Toughness>& toughness) {
  f.real("mode_1", toughness.mode_1, kPositive);
  f.optional_real("mode_2", toughness.mode_2, kPositive);
  f.optional_real("tensile_strength", toughness.tensile_strength, kPositive);
  f.optional_real("cohesion", toughness.cohesion, kPositive);
  f.real("friction_deg", toughness.friction_deg, kFrictionAngle);
}

template <class F>
void describe(F& f, In<F, BlockMaterial>& material) {
  f.name("name");
  f.of_library("like", material);
  f.real("density", material.density, kPositive);
  f.real("unit_weight", material.unit_weight);
  f.real("youngs_modulus", material.youngs_modulus, kPositive);
  f.real("poissons_ratio", material.poissons_ratio, kPoissonPlaneStress);
  f.real("damping", material.damping);
  f.real("horizontal_force", material.horizontal_force);
  f.row("initial_stress", material.initial_stress);
  f.row("stress_gradient", material.stress_gradient);
  f.row("initial_velocity", material.initial_velocity);
  f.row("initial_strain", material.initial_strain);
  std::optional<double> zz, gradient_zz;
  if (material.gives_zz) zz = material.initial_stress.zz;
  if (material.gives_zz) gradient_zz = material.stress_gradient.zz;
  f.optional_real("initial_stress_zz", zz, kAny);
  f.optional_real("stress_gradient_zz", gradient_zz, kAny);
  std::optional<Strength> strength;
  if (material.strength) strength = *material.strength;
  f.optional_object("strength", strength);
  std::optional<CrackClosure> crack_closure = material.crack_closure;
  f.optional_object("crack_closure", crack_closure);
  std::optional<Toughness> toughness = material.toughness;
  f.optional_object("toughness", toughness);
  if constexpr (!F::is_writing) {
    material.gives_zz = zz || gradient_zz;
    material.initial_stress.zz = zz.value_or(0);
    if (strength) material.strength = std::make_shared<const Strength>(*strength);
    material.crack_closure = crack_closure;
    material.toughness = toughness;
    material.stress_gradient.zz = gradient_zz.value_or(0);
  }
}

template <class F>
void describe(F& f, In<F, JointMaterial>& material) {
  f.name("name");
  f.of_library("like", material);
  f.real("friction_angle_deg", material.friction_angle_deg, kFrictionAngle);
  f.real("cohesion", material.cohesion, kNotNegative);
  f.real("tensile_strength", material.tensile_strength, kNotNegative);
}

template <class F>
void describe(F& f, In<F, BoltProperties>& bolt) {
  f.real("stiffness", bolt.stiffness);
  f.real("strength", bolt.strength);
  f.real("pretension", bolt.pretension);
}

template <class F>
void describe(F& f, In<F, OpenCloseConstants>& constants) {
  f.real("closing_ratio", constants.closing_ratio);
  f.real("opening_ratio", constants.opening_ratio);
  f.real("allowed_penetration", constants.allowed_penetration);
  f.real("angle_overlap_deg", constants.angle_overlap_deg);
  f.real("normal_to_shear_stiffness", constants.normal_to_shear_stiffness, kPositive);
}

template <class F>
void describe(F& f, In<F, Analysis>& analysis) {
  f.word("dialect", analysis.dialect, kDialects);
  f.real("velocity_carry_over", analysis.velocity_carry_over, kShare);
  f.integer("step_count", analysis.step_count, kStepCount);
  f.real("time_step", analysis.time_step, kPositive);
  f.real("allowed_displacement_ratio", analysis.allowed_displacement_ratio, kPositive);
  f.flag("automatic_time_step", analysis.automatic_time_step);
  f.flag("automatic_penalty", analysis.automatic_penalty);
  f.optional_real("contact_penalty", analysis.contact_penalty, kPositive);
  f.real("penalty_factor", analysis.penalty_factor, kNotNegative);
  f.flag("plane_strain", analysis.plane_strain);
  f.word("rotation", analysis.rotation, kRotations);
  f.optional_real("gravity", analysis.gravity, kAny);
  f.integer("open_close_limit", analysis.open_close_limit, kAtLeastOne);
  f.object("open_close", analysis.open_close);
  f.real("contact_damping", analysis.contact_damping);
  f.optional_real("over_relaxation", analysis.over_relaxation, kAny);
  f.optional_integer("save_interval", analysis.save_interval, kAtLeastOne);
  f.objects("block_materials", analysis.block_materials);
  f.objects("joint_materials", analysis.joint_materials);
  f.objects("bolt_properties", analysis.bolt_properties);
  f.curves("fixed_point_motions", analysis.fixed_point_motions);
  f.curves("point_loads", analysis.point_loads);
  f.curve("body_acceleration", analysis.body_acceleration);
}

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
