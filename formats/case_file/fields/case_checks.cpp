// Checks references, outlines and choices of a case file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/fields/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "formats/text/demands.hpp"
#include "material/crack_closure.hpp"
#include "material/strength.hpp"
#include "problem/units/unit_conversion.hpp"
#include "problem/units/unit_names.hpp"

namespace keyblock::formats {
namespace {

constexpr std::size_t kFewestCorners = 3;

[[noreturn]] void fail(const Place& place, std::string_view expected, long long found) {
  throw InputError(place, fmt::format("expected {}, found {}", expected, found));
}

// Throws unless the number, from 0, is that of one of `count` items.
void require_one_of(int index, std::size_t count, std::string_view noun, const Place& place) {
  if (index < 0 || static_cast<std::size_t>(index) >= count)
    fail(place, fmt::format("the number of a {}, 1 to {}", noun, count), static_cast<long long>(index) + 1);
}

// The first slot is repeated after the last one.
void require_slots(const SlotRange& range, std::size_t count, std::string_view noun, const Place& place) {
  require_one_of(range.first, count, noun, place);
  if (range.size < static_cast<int>(kFewestCorners) ||
      static_cast<std::size_t>(range.first) + static_cast<std::size_t>(range.size) >= count)
    fail(place, fmt::format("a range of {}s that ends before number {}", noun, count),
         static_cast<long long>(range.first) + range.size + 1);
}

// Compiles the formula only to report errors at its place.
void check_part(const Formula& formula, std::span<const std::string_view> variables) {
  if (!is_number(formula)) Compiled(formula, variables);
}

constexpr std::array<std::string_view, 5> kInTime{"x", "y", "nx", "ny", "t"};
constexpr auto kOnBoundary = std::span(kInTime).first<4>();
constexpr auto kInBody = std::span(kInTime).first<2>();

void require_points(const std::vector<Point>& points, std::size_t fewest, std::string_view noun, const Place& place) {
  if (points.size() < fewest)
    fail(place, fmt::format("{} points at least {}", fewest, noun), static_cast<long long>(points.size()));
}

constexpr double kHalfTurn = 180;
// Relative to the mesh's scale: nodes that are moved further invert whole triangles.
constexpr double kMostSnapping = 0.1;

void check_part(const MeshPlan& mesh, const Place& covers) {
  const Place& place = mesh.place.line > 0 ? mesh.place : covers;
  const bool may_be_of_a_file = mesh.tip_side > 0 || mesh.error > 0 || !mesh.refined.empty();
  if ((mesh.half_rows > 0) == (mesh.side > 0) && (mesh.side > 0 || !may_be_of_a_file))
    throw InputError(place, fmt::format("expected a mesh with one of half_rows and side, found {}",
                                        mesh.side > 0 ? "both" : "none above 0"));
  if (mesh.kind == MeshKind::unstructured && mesh.half_rows > 0)
    throw InputError(place, "expected the side of an unstructured mesh, found half_rows");
  if (mesh.kind == MeshKind::unstructured && mesh.angle_deg != 0)
    throw InputError(place, fmt::format("expected no angle of an unstructured mesh, found {}", mesh.angle_deg));
  if (!(std::abs(mesh.angle_deg) <= kHalfTurn))
    throw InputError(place, fmt::format("expected an angle from -180 to 180, found {}", mesh.angle_deg));
  if (mesh.tip_functions.radius > 0 && !mesh.tip_functions.are_asked())
    throw InputError(place, fmt::format("expected tip_functions that reach as far as a tip_radius, found none for {}",
                                        mesh.tip_functions.radius));
  if (!(mesh.snap_ratio <= kMostSnapping))
    throw InputError(place,
                     fmt::format("expected a snap_ratio of at most {}, found {}", kMostSnapping, mesh.snap_ratio));
}

void check_part(const std::vector<FactorAt>& over_time, const Place& place) {
  const auto is_later = [](const FactorAt& a, const FactorAt& b) { return a.time >= b.time; };
  const auto found = std::ranges::adjacent_find(over_time, is_later);
  if (found != over_time.end())
    throw InputError(place, fmt::format("expected times of over_time that increase, found {} after {}",
                                        std::next(found)->time, found->time));
}

void check_part(const DisplacementPlan& part) {
  require_points(part.along, 2, "along a boundary", part.place);
  check_part(part.over_time, part.place);
  for (const Formula* formula : {&part.x, &part.y, &part.normal}) check_part(*formula, kOnBoundary);
  const auto refuse = [&](const char* name, const Formula& formula, const char* why) {
    if (formula != Formula{})
      throw InputError(formula.place, fmt::format("expected no {} if {}, found {}", name, why, formula.text));
  };
  if (part.held == Held::normal || part.held == Held::y) refuse("x", part.x, "held is y or normal");
  if (part.held == Held::normal || part.held == Held::x) refuse("y", part.y, "held is x or normal");
  if (part.held != Held::normal) refuse("normal", part.normal, "held is not normal");
}

void check_part(const TractionPlan& part, std::span<const std::string_view> variables) {
  require_points(part.along, 2, "along a boundary", part.place);
  check_part(part.over_time, part.place);
  for (const Formula* formula : {&part.x, &part.y, &part.pressure}) check_part(*formula, variables);
}

template <class Loads>
void check_stages_in(const Loads& loads, int count) {
  const auto look = [&](const auto& part) {
    const auto [first, last] = part.stages;
    for (const auto& stage : {first, last})
      if (stage && *stage >= count)
        fail(part.place,
             count == 0 ? std::string("stages for a load with first_stage or last_stage")
                        : fmt::format("a stage of a load from 1 to {}", count),
             *stage + 1LL);
    if (first && last && *first > *last) fail(part.place, fmt::format("a last_stage from {}", *first + 1), *last + 1LL);
  };
  std::ranges::for_each(loads.tractions, look);
  std::ranges::for_each(loads.displacements, look);
}

}  // namespace

void require_sound(const Units& units, const Place& place) {
  const auto require = [&](std::string_view name, const std::string& unit, std::span<const std::string_view> known) {
    if (!unit.empty() && std::ranges::find(known, unit) == known.end())
      throw InputError(
          place, fmt::format("expected {} of units: one of {}, found \"{}\"", name, fmt::join(known, ", "), unit));
  };
  require("length", units.length, kLengthUnits);
  // A mass that follows from a force may be a product.
  const std::optional<Unit> mass = unit_named(units.mass);
  const bool is_product = mass && mass->dimension == Dimension{1, 0, 0} && units.mass.find("·") != std::string::npos;
  if (!is_product) require("mass", units.mass, kMassUnits);
  require("time", units.time, kTimeUnits);
}

void require_sound(const Drawing& drawing) {
  if (drawing.boundary_count > drawing.joints.size())
    fail(drawing.place, fmt::format("a boundary_count of at most {}, the number of joints", drawing.joints.size()),
         static_cast<long long>(drawing.boundary_count));
}

void require_sound(const Blocks& blocks) {
  const std::size_t count = blocks.blocks.size();
  for (std::size_t i = 0; i < count; ++i) {
    const BlockPolygon& block = blocks.blocks[i];
    const auto require_corners = [&](const BlockLoop& loop) {
      if (loop.size() < kFewestCorners)
        fail(block.place, fmt::format("{} corners at least in each loop of block {}", kFewestCorners, i + 1),
             static_cast<long long>(loop.size()));
    };
    require_corners(block.outer);
    for (const BlockLoop& hole : block.holes) require_corners(hole);
  }
  for (const auto* points : {&blocks.fixed_points, &blocks.loading_points, &blocks.measured_points})
    for (const BlockPoint& point : *points) require_one_of(point.block, count, "block", point.place);
  for (const BlockBolt& bolt : blocks.bolts)
    for (const int block : {bolt.first_block, bolt.second_block}) require_one_of(block, count, "block", bolt.place);
}

void require_sound(const Cover& cover) {
  for (const CoverElement& element : cover.elements) {
    require_slots(element.vertices, cover.vertices.size(), "vertex slot", element.place);
    for (const int node : element.covers) require_one_of(node, cover.nodes.size(), "physical cover", element.place);
  }
  for (const SlotRange& loop : cover.loops) require_slots(loop, cover.loop_vertices.size(), "loop vertex", cover.place);
  for (const LoopVertex& vertex : cover.loop_vertices)
    require_one_of(vertex.slot, cover.vertices.size(), "vertex slot", cover.place);
  for (const auto* points : {&cover.fixed_points, &cover.loading_points, &cover.measured_points})
    for (const CoverPoint& point : *points)
      require_one_of(point.element, cover.elements.size(), "element", point.place);
}

void require_sound(const LoadList& loads) {
  for (const TractionPlan& part : loads.tractions) check_part(part, kInTime);
  for (const DisplacementPlan& part : loads.displacements) check_part(part);
}

void require_sound(const CoverPlan& covers) {
  check_part(covers.mesh, covers.place);
  const auto require_constant = [](const auto& part) {
    if (!part.over_time.empty())
      throw InputError(part.place, "expected over_time in `loads`, for blocks, found it in `covers`");
  };
  for (const TractionPlan& part : covers.tractions) check_part(part, kOnBoundary);
  for (const DisplacementPlan& part : covers.displacements) check_part(part);
  std::ranges::for_each(covers.tractions, require_constant);
  std::ranges::for_each(covers.displacements, require_constant);
  for (const SpringPlan& spring : covers.springs)
    if (spring.direction == Point{}) throw InputError(spring.place, "expected a direction of the spring, found (0, 0)");
  for (const Formula* formula : {&covers.body_force.x, &covers.body_force.y, &covers.initial_stress.xx,
                                 &covers.initial_stress.yy, &covers.initial_stress.xy})
    check_part(*formula, kInBody);
  if (covers.initial_stress.zz) check_part(*covers.initial_stress.zz, kInBody);
  for (const ExcavationPlan& excavation : covers.excavations)
    require_points(excavation.outline, kFewestCorners, "around an excavation", excavation.place);
  for (const CrackPlan& crack : covers.cracks) require_points(crack.along, 2, "along a crack", crack.place);
}

void require_sound(const std::vector<Stage>& stages) {
  for (const Stage& stage : stages) {
    if (stage.steps == 0 && stage.duration == 0)
      throw InputError(stage.place, "expected steps or a duration of each stage, found neither");
    if (stage.mesh) check_part(*stage.mesh, stage.place);
    if (stage.mesh && stage.mesh->error > 0)
      throw InputError(stage.mesh->place.line > 0 ? stage.mesh->place : stage.place,
                       "expected a mesh of a stage without error, found one; only covers.mesh can be refined by error");
    for (const StageExcavation& part : stage.excavations)
      require_points(part.outline, kFewestCorners, "around an excavation", part.place);
    for (const StageMaterial& part : stage.block_materials)
      require_points(part.outline, kFewestCorners, "around a change of material", part.place);
    for (const StageRelease& part : stage.released)
      require_points(part.outline, kFewestCorners, "around released points", part.place);
  }
}

void check_joints_of_cracks(const CoverPlan& covers, const Analysis& analysis) {
  const auto count = static_cast<int>(analysis.joint_materials.size());
  for (const CrackPlan& crack : covers.cracks)
    if (crack.joint_material >= count)
      throw InputError(crack.place, fmt::format("expected a joint_material of a crack from 1 to {}, found {}", count,
                                                crack.joint_material + 1));
}

void require_sound(const Analysis& analysis) {
  if (analysis.block_materials.empty()) throw InputError(analysis.place, "expected block_materials, found none");
  if (analysis.joint_materials.empty()) throw InputError(analysis.place, "expected joint_materials, found none");
  for (const BlockMaterial& material : analysis.block_materials) {
    if (material.toughness && material.toughness->cohesion && !material.toughness->mode_2)
      throw InputError(material.place, "expected a mode_2 of toughness, which its cohesion needs, found none");
    if (!material.is_nonlinear()) continue;
    if (material.strength)
      if (const std::string why = why_unusable(*material.strength); !why.empty()) throw InputError(material.place, why);
    if (material.crack_closure)
      if (const std::string why = why_unusable(*material.crack_closure, material.youngs_modulus); !why.empty())
        throw InputError(material.place, why);
    if (!kPoissonPlaneStrain.holds(material.poissons_ratio))
      throw InputError(
          material.place,
          fmt::format("expected poissons_ratio {} of a material with a {}, found {}", kPoissonPlaneStrain.wording,
                      material.strength ? "strength" : "crack_closure", material.poissons_ratio));
  }
  if (!analysis.plane_strain) return;
  for (const BlockMaterial& material : analysis.block_materials)
    if (!kPoissonPlaneStrain.holds(material.poissons_ratio))
      throw InputError(material.place, fmt::format("expected poissons_ratio {}, found {}", kPoissonPlaneStrain.wording,
                                                   material.poissons_ratio));
}

void check_stages_of(const CoverPlan& covers, int count) {
  check_stages_in(covers, count);
}

void check_stages_of(const LoadList& loads, int count) {
  check_stages_in(loads, count);
}

void require_sound(const OutputPlan& outputs) {
  for (const HistoryPlan& history : outputs.histories) {
    const int given = int(history.point.has_value()) + int(history.block.has_value()) +
                      int(history.contact.has_value()) + int(history.joint.has_value()) +
                      int(history.line.has_value()) + int(history.bolt.has_value());
    if (given != 1) fail(history.place, "one of point, block, contact, joint, line and bolt in a history", given);
    if (history.line && history.line->start == history.line->end)
      throw InputError(history.place, "expected a line with a length, found one point");
  }
}

void require_sound(const std::vector<Frame>& frames, const JsonValue& from) {
  auto frame_from = from.begin();
  for (const Frame& frame : frames) {
    auto element_from = (*frame_from).member("elements")->begin();
    for (const ElementFrame& element : frame.elements) {
      for (const std::vector<Point>& loop : element.loops)
        if (loop.size() < kFewestCorners)
          fail((*element_from).place(), fmt::format("{} corners at least in each loop of an element", kFewestCorners),
               static_cast<long long>(loop.size()));
      ++element_from;
    }
    ++frame_from;
  }
}

}  // namespace keyblock::formats
