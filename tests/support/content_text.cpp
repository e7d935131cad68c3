// Lists drawings, blocks, covers and analyses field by field.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/content_text.hpp"

#include <fmt/format.h>

namespace keyblock::support {
namespace {

class Lister {
 public:
  void list(const Drawing& d) {
    line("drawing {:a} {}", d.edge_node_ratio, d.boundary_count);
    for (const auto& j : d.joints) line("joint {} {}", text(j.segment), j.joint_material);
    for (const auto& m : d.material_lines) line("material line {} {}", text(m.segment), m.block_material);
    for (const auto& b : d.bolts)
      line("bolt {} {:a} {:a} {:a} {}", text(b.segment), b.stiffness, b.strength, b.pretension, b.type);
    for (const auto& f : d.fixed_lines) line("fixed {}", text(f.segment));
    for (const auto& p : d.loading_points) line("loading {}", text(p.position));
    for (const auto& p : d.measured_points) line("measured {}", text(p.position));
    for (const auto& p : d.hole_points) line("hole {}", text(p.position));
  }

  void list(const Blocks& blocks) {
    for (const auto& block : blocks.blocks) {
      line("block {}", block.material);
      for (const auto& v : block.outer) line("vertex {} {}", text(v.position), v.joint_material);
      for (const auto& hole : block.holes) {
        line("hole");
        for (const auto& v : hole) line("vertex {} {}", text(v.position), v.joint_material);
      }
    }
    for (const auto& b : blocks.bolts)
      line("bolt {} {} {} {:a} {:a} {:a}", text(b.segment), b.first_block, b.second_block, b.stiffness, b.strength,
           b.pretension);
    for (const auto* points : {&blocks.fixed_points, &blocks.loading_points, &blocks.measured_points}) {
      line("points");
      for (const auto& p : *points) line("{} {}", text(p.position), p.block);
    }
  }

  void list(const Cover& cover) {
    for (const auto& e : cover.elements)
      line("element {} {} {} {} {} {}", e.vertices.first, e.vertices.size, e.material, e.covers[0], e.covers[1],
           e.covers[2]);
    for (const auto& p : cover.vertices) line("vertex {}", text(p));
    for (const auto& p : cover.nodes) line("node {}", text(p));
    for (const auto& l : cover.loops) line("loop {} {}", l.first, l.size);
    for (const auto& v : cover.loop_vertices) line("loop vertex {} {}", v.slot, v.joint_material);
    for (const auto* points : {&cover.fixed_points, &cover.loading_points, &cover.measured_points}) {
      line("points");
      for (const auto& p : *points) line("{} {}", text(p.position), p.element);
    }
  }

  void list(const Analysis& a) {
    line("analysis {} {:a} {} {:a} {:a} {} {}", static_cast<int>(a.dialect), a.velocity_carry_over, a.step_count,
         a.allowed_displacement_ratio, a.time_step, a.automatic_time_step, a.automatic_penalty);
    line("{} {:a} {} {} {} {} {:a} {} {}", text(a.contact_penalty), a.penalty_factor, a.plane_strain,
         static_cast<int>(a.rotation), text(a.gravity), a.open_close_limit, a.contact_damping, text(a.over_relaxation),
         a.save_interval.value_or(-1));
    const OpenCloseConstants& c = a.open_close;
    line("{:a} {:a} {:a} {:a} {:a}", c.closing_ratio, c.opening_ratio, c.allowed_penetration, c.angle_overlap_deg,
         c.normal_to_shear_stiffness);
    for (const auto& m : a.block_materials) list(m);
    for (const auto& j : a.joint_materials)
      line("joint material {:a} {:a} {:a}", j.friction_angle_deg, j.cohesion, j.tensile_strength);
    for (const auto& b : a.bolt_properties) line("bolts {:a} {:a} {:a}", b.stiffness, b.strength, b.pretension);
    for (const auto& curve : a.fixed_point_motions) list("motion", curve);
    for (const auto& curve : a.point_loads) list("load", curve);
    list("body acceleration", a.body_acceleration);
  }

  void list(const MeshPlan& m) {
    line("mesh {} {} {:a} {} {:a} {} {} {} {:a}", static_cast<int>(m.kind), m.half_rows, m.side,
         static_cast<int>(m.shape), m.angle_deg, static_cast<int>(m.placement), text(m.through_x), text(m.through_y),
         m.snap_ratio);
    if (m.error > 0) line("error {:a} {}", m.error, m.most_unknowns);
    if (m.tip_side > 0) line("at tips {:a}", m.tip_side);
    if (m.tip_functions.are_asked()) line("functions at tips {:a}", m.tip_functions.radius);
    for (const auto& meshed : m.materials) line("meshed {}", meshed.material);
    for (const auto& r : m.refined) line("refined {} {:a}", text(r.at), r.side);
  }

  void list(const CoverPlan& plan) {
    line("covers {} contact {}", plan.functions ? static_cast<int>(*plan.functions) : -1,
         static_cast<int>(plan.contact));
    list(plan.mesh);
    for (const auto& t : plan.tractions) {
      line("traction {} | {} | {}", t.x.text, t.y.text, t.pressure.text);
      for (const Point p : t.along) line("along {}", text(p));
    }
    for (const auto& d : plan.displacements) {
      line("displacement {} {} | {} | {}", static_cast<int>(d.held), d.x.text, d.y.text, d.normal.text);
      for (const Point p : d.along) line("along {}", text(p));
    }
    for (const auto& f : plan.forces) line("force {} {}", text(f.at), text(f.force));
    for (const auto& s : plan.springs) line("spring {} {} {:a}", text(s.at), text(s.direction), s.stiffness);
    line("body force {} | {}", plan.body_force.x.text, plan.body_force.y.text);
    const StressPlan& s = plan.initial_stress;
    line("initial stress {} | {} | {} | {}", s.xx.text, s.yy.text, s.xy.text, s.zz ? s.zz->text : "none");
    for (const auto& e : plan.excavations) {
      line("excavation {}", e.step);
      for (const Point p : e.outline) line("outline {}", text(p));
    }
    for (const auto& c : plan.cracks) {
      line("crack {}", c.joint_material);
      for (const Point p : c.along) line("along {}", text(p));
    }
    if (plan.growth)
      line("growth {} {:a} {}", static_cast<int>(plan.growth->criterion), plan.growth->increment,
           plan.growth->has_corrector);
  }

  void list(const Units& units) { line("units {} {} {}", units.length, units.mass, units.time); }
  void list(const RunChoices& choices) {
    line("profile {}", choices.profile);
    for (const auto& [name, value] : choices.settings) line("set {} {}", name, value);
  }
  void list(const Stage& s) {
    line("stage {} {} {:a} {:a} {} {}", s.name, s.steps, s.duration, s.equilibrium.value_or(0), s.removes_forces,
         s.profile);
    if (s.mesh) list(*s.mesh);
    const auto outline = [&](const auto& part) {
      for (const Point p : part.outline) line("outline {}", text(p));
    };
    for (const auto& part : s.excavations) {
      line("excavation {}", part.joint_material);
      outline(part);
    }
    for (const auto& cut : s.cuts)
      line("cut {} {} {}", text(cut.segment.start), text(cut.segment.end), cut.joint_material);
    for (const auto& part : s.block_materials) {
      line("block material {}", part.block_material);
      outline(part);
    }
    for (const auto& change : s.joint_materials) line("joint material {} {}", change.from, change.to);
    for (const auto& b : s.bolts)
      line("bolt {} {} {:a} {:a} {:a} {}", text(b.segment.start), text(b.segment.end), b.stiffness, b.strength,
           b.pretension, b.type);
    for (const auto& removed : s.removed_bolts) line("removed {}", removed.bolt);
    for (const auto& held : s.held) line("held {}", text(held.position));
    for (const auto& part : s.released) {
      line("released");
      outline(part);
    }
    for (const auto& force : s.forces) line("force {} {}", text(force.at), text(force.force));
    for (const auto& [name, value] : s.settings) line("set {} {}", name, value);
  }
  void list(const TimeCurve& motion) { list("motion of the ground", motion); }

  void list(const Frame& frame) {
    line("frame {} {:a}", frame.step, frame.time);
    for (const auto& e : frame.elements) {
      line("element {} {} {} {:a} {:a} {:a} {:a}", e.material, text(e.centroid), text(e.displacement), e.rotation,
           e.velocity.x, e.velocity.y, e.velocity.rotation);
      line("{:a} {:a} {:a} {:a} {:a} {:a}", e.stress.xx, e.stress.yy, e.stress.xy, e.area, e.mass, e.moment_of_inertia);
      for (const auto& loop : e.loops) {
        line("loop");
        for (const auto& p : loop) line("{}", text(p));
      }
    }
    for (const auto& b : frame.bolts) line("bolt {} {} {:a} {}", text(b.first), text(b.second), b.force, b.is_broken);
    for (const auto* points : {&frame.fixed_points, &frame.loading_points, &frame.measured_points}) {
      line("points");
      for (const auto& p : *points) line("{} {} {}", text(p.position), text(p.displacement), p.element);
    }
  }
  void list(const MeasuredTrack& track) {
    line("track {}", track.point);
    for (const auto& r : track.rows)
      line("{} {:a} {:a} {} {:a} {} {:a}", r.step, r.time, r.time_step, text(r.position), r.displacement,
           text(r.velocity), r.speed);
  }

  std::string text_;

 private:
  void list(const StrengthValues& v) {
    line("{:a} {:a} {:a} {:a} {:a}", v.cohesion, v.friction_deg, v.dilation_deg, v.yield_stress,
         v.tensile_strength.value_or(-1));
  }

  void list(const Strength& s) {
    line("strength {} {}", static_cast<int>(s.surface), static_cast<int>(s.matching));
    list(s.values);
    if (!s.change) return;
    list(s.change->values);
    line("{:a} {:a}", s.change->plastic_strain, s.change->fracture_energy);
  }

  void list(const BlockMaterial& m) {
    line("block material {:a} {:a} {:a} {:a} {:a} {:a}", m.density, m.unit_weight, m.youngs_modulus, m.poissons_ratio,
         m.damping, m.horizontal_force);
    line("{:a} {:a} {:a}", m.initial_stress.xx, m.initial_stress.yy, m.initial_stress.xy);
    line("{} {:a} {:a}", m.gives_zz, m.initial_stress.zz, m.stress_gradient.zz);
    if (m.strength) list(*m.strength);
    if (m.toughness)
      line("toughness {:a} {} {} {} {:a}", m.toughness->mode_1, text(m.toughness->mode_2),
           text(m.toughness->tensile_strength), text(m.toughness->cohesion), m.toughness->friction_deg);
    if (m.crack_closure) line("cracks {:a} {:a}", m.crack_closure->initial_modulus, m.crack_closure->closure_strain);
    line("{:a} {:a} {:a}", m.stress_gradient.xx, m.stress_gradient.yy, m.stress_gradient.xy);
    line("{:a} {:a} {:a}", m.initial_velocity.x, m.initial_velocity.y, m.initial_velocity.rotation);
    line("{:a} {:a} {:a}", m.initial_strain[0], m.initial_strain[1], m.initial_strain[2]);
  }

  void list(const char* noun, const TimeCurve& curve) {
    line("{}", noun);
    for (std::size_t i = 0; i < curve.times.size(); ++i) line("{:a} {}", curve.times[i], text(curve.values[i]));
  }

  static std::string text(Point p) { return fmt::format("{:a} {:a}", p.x, p.y); }
  static std::string text(const Segment& s) { return text(s.start) + ' ' + text(s.end); }
  static std::string text(const std::optional<double>& v) { return v ? fmt::format("{:a}", *v) : "-"; }

  template <typename... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    text_ += fmt::format(format, std::forward<Values>(values)...) + '\n';
  }
};

}  // namespace

std::string content_text(const formats::Content& content) {
  Lister lister;
  if (content.drawing) lister.list(*content.drawing);
  if (content.blocks) lister.list(*content.blocks);
  if (content.cover) lister.list(*content.cover);
  if (content.analysis) lister.list(*content.analysis);
  if (content.units) lister.list(*content.units);
  if (content.covers) lister.list(*content.covers);
  if (content.motion) lister.list(*content.motion);
  for (const Frame& frame : content.frames) lister.list(frame);
  for (const MeasuredTrack& track : content.tracks) lister.list(track);
  if (content.choices) lister.list(*content.choices);
  for (const Stage& stage : content.stages) lister.list(stage);
  return lister.text_;
}

}  // namespace keyblock::support
