// Draws contents, and compares the returned ones with them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "formats/berkeley/ddaml.hpp"
#include "formats/case_file/keyblock_case.hpp"
#include "formats/dxf/dxf.hpp"
#include "formats/registry.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "formats/shi/nmm_cover.hpp"
#include "formats/text/numbers.hpp"
#include "tests/support/content_text.hpp"
#include "tests/support/random_analyses.hpp"
#include "tests/support/random_geometries.hpp"
#include "tests/support/random_values.hpp"

namespace keyblock::support {
namespace {

using namespace drawn;
using formats::Content;
using formats::GeometryKind;
using formats::ReadHint;

Content ddaml(Dice& dice) {
  Content content;
  const int parts = dice.below(3);
  if (parts != 1) {
    content.drawing = drawing(dice);
    content.drawing->bolts =
        some(dice, 3, [](Dice& one) { return BoltLine{any_segment(one), 0, 0, 0, one.below(4), {}}; });
  }
  if (parts != 0) content.analysis = ddaml_controls(dice);
  return content;
}

/// A number, or an expression in the variables of a boundary.
Formula formula(Dice& dice, bool on_boundary) {
  if (dice.happens(0.6)) return {formats::format_real(any_real(dice)), {}};
  return {on_boundary && dice.happens(0.5) ? "nx * x^2 - sin(ny)" : "x < 0 ? -y : 2*_pi*x", {}};
}

MeshPlan mesh(Dice& dice) {
  MeshPlan plan;
  plan.materials = some(dice, 3, [](Dice& one) { return MeshedMaterial{one.below(5)}; });
  plan.kind = dice.happens(0.3) ? MeshKind::unstructured : MeshKind::regular;
  if (plan.kind == MeshKind::regular && dice.happens(0.5))
    plan.half_rows = 1 + dice.below(1000);
  else
    plan.side = positive_real(dice);
  plan.shape = dice.happens(0.5) ? MeshShape::old : MeshShape::equilateral;
  const bool is_regular = plan.kind == MeshKind::regular;
  const double angle_deg = dice.between(-180, 180);
  if (is_regular) plan.angle_deg = angle_deg;
  plan.placement = dice.happens(0.5) ? MeshPlacement::aligned : MeshPlacement::free;
  if (dice.happens(0.5)) plan.through_x = coordinate(dice);
  if (dice.happens(0.5)) plan.through_y = coordinate(dice);
  plan.refined = some(dice, 3, [](Dice& one) {
    const Point at = any_point(one);
    return RefinedPoint{at, positive_real(one)};
  });
  if (dice.happens(0.5)) plan.tip_side = positive_real(dice);
  if (dice.happens(0.3)) {
    plan.error = dice.between(1e-9, 0.99);
    plan.most_unknowns = 1 + dice.below(1000000);
  }
  if (dice.happens(0.2)) {
    plan.tip_functions.kind = TipFunctions::williams;
    if (dice.happens(0.5)) plan.tip_functions.radius = positive_real(dice);
  }
  return plan;
}

CoverPlan covers(Dice& dice) {
  CoverPlan plan;
  if (dice.happens(0.8)) plan.functions = static_cast<CoverFunctions>(dice.below(4));
  plan.contact = dice.happens(0.3) ? CoverContact::ignored : CoverContact::felt;
  plan.mesh = mesh(dice);
  plan.tractions = some(dice, 3, [](Dice& one) {
    TractionPlan part{polygon(one), {}, {}, {}, {}};
    part.x = formula(one, true);
    part.y = formula(one, true);
    part.pressure = formula(one, true);
    return part;
  });
  plan.displacements = some(dice, 3, [](Dice& one) {
    DisplacementPlan part;
    part.along = polygon(one);
    part.held = static_cast<Held>(one.below(4));
    if (part.held == Held::normal) part.normal = formula(one, true);
    if (part.held == Held::both || part.held == Held::x) part.x = formula(one, true);
    if (part.held == Held::both || part.held == Held::y) part.y = formula(one, true);
    return part;
  });
  plan.forces = some(dice, 2, [](Dice& one) {
    const Point at = any_point(one);
    return ForcePlan{at, any_point(one), {}};
  });
  plan.springs = some(dice, 2, [](Dice& one) {
    const Point at = any_point(one);
    return SpringPlan{at, {1, coordinate(one)}, positive_real(one), {}};
  });
  plan.body_force = {formula(dice, false), formula(dice, false)};
  plan.initial_stress = {formula(dice, false), formula(dice, false), formula(dice, false)};
  if (dice.happens(0.5)) plan.initial_stress.zz = formula(dice, false);
  plan.excavations = some(dice, 2, [](Dice& one) {
    const int step = 1 + one.below(9);
    return ExcavationPlan{step, polygon(one), {}, 0};
  });
  plan.cracks = some(dice, 2, [](Dice& one) { return CrackPlan{polygon(one), {}, 0}; });
  if (dice.happens(0.3))
    plan.growth = GrowthPlan{static_cast<GrowthCriterion>(dice.below(3)),
                             static_cast<GrowthLoads>(dice.below(3)),
                             positive_real(dice),
                             dice.happens(0.5),
                             {}};
  return plan;
}

Strength strength(Dice& dice) {
  const auto values = [&] {
    StrengthValues v{.cohesion = positive_real(dice), .yield_stress = positive_real(dice)};
    if (dice.happens(0.5)) v.tensile_strength = positive_real(dice);
    return v;
  };
  Strength s;
  s.surface = static_cast<YieldSurface>(dice.below(4));
  s.matching = static_cast<ConeMatching>(dice.below(3));
  s.values = values();
  const bool has_angles = s.surface == YieldSurface::mohr_coulomb || s.surface == YieldSurface::drucker_prager;
  if (has_angles) s.values.friction_deg = dice.between(0, 60);
  if (has_angles && dice.happens(0.5)) s.values.dilation_deg = dice.between(0, s.values.friction_deg);
  if (!dice.happens(0.4)) return s;
  s.change = StrengthChange{.values = s.values, .plastic_strain = dice.between(0.01, 1)};
  s.change->values.cohesion = positive_real(dice);
  return s;
}

Stage stage(Dice& dice) {
  Stage s;
  s.name = "stage \"" + std::to_string(dice.below(9)) + "\"";
  s.steps = 1 + dice.below(9);
  s.duration = dice.happens(0.5) ? positive_real(dice) : 0;
  if (dice.happens(0.5)) s.equilibrium = positive_real(dice);
  s.excavations = some(dice, 2, [](Dice& one) { return StageExcavation{polygon(one), one.below(4), {}}; });
  s.cuts = some(dice, 2, [](Dice& one) {
    const Point from = any_point(one);
    return JointLine{{from, any_point(one)}, one.below(4), {}};
  });
  s.block_materials = some(dice, 2, [](Dice& one) { return StageMaterial{polygon(one), one.below(4), {}}; });
  s.joint_materials = some(dice, 2, [](Dice& one) {
    const int from = one.below(4);
    return StageJointMaterial{from, one.below(4), {}};
  });
  s.bolts = some(dice, 2, [](Dice& one) {
    const Point from = any_point(one);
    return BoltLine{{from, any_point(one)}, positive_real(one), 1, 2, one.below(3), {}};
  });
  s.removed_bolts = some(dice, 2, [](Dice& one) { return StageBolt{one.below(4), {}}; });
  s.held = some(dice, 2, [](Dice& one) { return MarkedPoint{any_point(one), {}}; });
  s.released = some(dice, 2, [](Dice& one) { return StageRelease{polygon(one), {}}; });
  s.forces = some(dice, 2, [](Dice& one) {
    const Point at = any_point(one);
    return StageForce{at, any_point(one), {}};
  });
  s.removes_forces = dice.happens(0.5);
  if (dice.happens(0.3)) {
    s.mesh = mesh(dice);
    s.mesh->error = 0;  // refused in a stage
    s.mesh->most_unknowns = MeshPlan().most_unknowns;
  }
  if (dice.happens(0.3)) s.profile = "draft";
  if (dice.happens(0.3)) s.settings = {{"gravity.x", "1"}, {"odd \"name\"", "5"}};
  return s;
}

PointFrame point_frame(Dice& dice) {
  const Point position = any_point(dice);
  return {position, any_point(dice), dice.below(4) - 1};
}

Frame frame(Dice& dice) {
  Frame drawn;
  drawn.step = dice.below(1000);
  drawn.time = positive_real(dice);
  const int count = 1 + dice.below(3);
  for (int i = 0; i < count; ++i) {
    ElementFrame& element = drawn.elements.emplace_back();
    element.loops.push_back(polygon(dice));
    if (dice.happens(0.3)) element.loops.push_back(polygon(dice));
    element.material = dice.below(3);
    element.centroid = any_point(dice);
    element.displacement = any_point(dice);
    for (double* value :
         {&element.rotation, &element.velocity.x, &element.velocity.y, &element.velocity.rotation, &element.stress.xx,
          &element.stress.yy, &element.stress.xy, &element.area, &element.mass, &element.moment_of_inertia})
      *value = any_real(dice);
  }
  drawn.bolts = some(dice, 2, [](Dice& one) {
    const Point first = any_point(one), second = any_point(one);
    return BoltFrame{first, second, any_real(one), one.happens(0.5)};
  });
  drawn.fixed_points = some(dice, 2, point_frame);
  drawn.loading_points = some(dice, 2, point_frame);
  drawn.measured_points = some(dice, 2, point_frame);
  return drawn;
}

MeasuredTrack track(Dice& dice) {
  MeasuredTrack drawn{dice.below(9), {}};
  const int count = dice.below(4);
  for (int i = 0; i < count; ++i) {
    MeasuredRow& row = drawn.rows.emplace_back();
    row.step = i;
    for (double* value : {&row.time, &row.time_step, &row.position.x, &row.position.y, &row.displacement,
                          &row.velocity.x, &row.velocity.y, &row.speed})
      *value = any_real(dice);
  }
  return drawn;
}

HistoryPlan history(Dice& dice) {
  HistoryPlan plan;
  if (dice.happens(0.5)) plan.name = "crest, \"upper\"";
  const int kind = dice.below(5);
  if (kind == 0) plan.point = any_point(dice);
  if (kind == 1) plan.block = dice.below(9);
  if (kind == 2) plan.contact = BlockPair{dice.below(9), dice.below(9)};
  if (kind == 3) plan.joint = dice.below(9);
  if (kind == 4) {
    const Point start = any_point(dice);
    plan.line = Segment{start, start + Point{1 + dice.between(0, 9), dice.between(-9, 9)}};
  }
  return plan;
}

OutputPlan outputs(Dice& dice) {
  return {some(dice, 4, history), static_cast<ContactTables>(dice.below(4)), 1 + dice.below(9)};
}

/// All that the program knows, including items without a place in old formats.
Content anything(Dice& dice) {
  constexpr std::array<Content (*)(Dice&), 3> kGeometries{native_drawing, blocks, cover};
  constexpr std::array<Content (*)(Dice&), 4> kAnalyses{berkeley_analysis, shi_analysis, manifold_analysis,
                                                        [](Dice& one) {
                                                          return Content{{}, {}, ddaml_controls(one)};
                                                        }};
  Content content;
  if (dice.happens(0.8)) content = kGeometries[static_cast<std::size_t>(dice.below(3))](dice);
  if (content.blocks && dice.happens(0.5)) {
    BlockLoop hole;
    for (const Point& point : polygon(dice)) hole.push_back({point, dice.below(6)});
    content.blocks->blocks.front().holes = {hole};
  }
  if (dice.happens(0.8)) {
    content.analysis = kAnalyses[static_cast<std::size_t>(dice.below(4))](dice).analysis;
    content.analysis->body_acceleration = curve_or_none(dice);
  }
  if (dice.happens(0.3)) content.covers = covers(dice);
  if (dice.happens(0.5)) content.units = dice.happens(0.5) ? Units{"m", "t", "ms"} : Units{"in", "lbf·s²/in", "s"};
  if (dice.happens(0.3)) content.motion = curve(dice);
  if (dice.happens(0.2)) content.frames = some(dice, 3, frame);
  if (dice.happens(0.2)) content.tracks = some(dice, 3, track);
  if (dice.happens(0.5)) content.choices = RunChoices{"standard", {{"motion", "static"}, {"odd \"name\"", "5"}}};
  if (dice.happens(0.3)) content.outputs = outputs(dice);
  if (dice.happens(0.3)) content.layers = {{{"any \"name\", 1", "joint 2"}, {"*", "ignored"}}};
  if (dice.happens(0.3)) content.stages = some(dice, 3, stage);
  if (content.analysis && dice.happens(0.3))
    for (BlockMaterial& material : content.analysis->block_materials) {
      material.gives_zz = true;
      material.initial_stress.zz = any_real(dice);
      material.stress_gradient.zz = any_real(dice);
    }
  if (content.analysis && dice.happens(0.3))
    for (BlockMaterial& material : content.analysis->block_materials)
      if (material.poissons_ratio < 0.5) material.strength = std::make_shared<const Strength>(strength(dice));
  if (content.analysis && dice.happens(0.3))
    for (BlockMaterial& material : content.analysis->block_materials)
      if (material.poissons_ratio < 0.5 && dice.happens(0.5))
        material.crack_closure = CrackClosure{dice.between(0.1, 0.9) * material.youngs_modulus, positive_real(dice)};
  if (content.analysis && dice.happens(0.3))
    for (BlockMaterial& material : content.analysis->block_materials)
      material.toughness =
          Toughness{positive_real(dice), positive_real(dice), {}, positive_real(dice), dice.between(0, 80)};
  if (!formats::fits_a_case(content)) content.units = Units{"ft", "slug", "s"};
  return content;
}

ReadHint no_hint(const Content&) {
  return {};
}

ReadHint points_of_blocks(const Content& content) {
  return {static_cast<int>(content.analysis->fixed_point_motions.size()),
          static_cast<int>(content.analysis->point_loads.size()), GeometryKind::blocks};
}

ReadHint points_of_cover(const Content& content) {
  return {std::nullopt, static_cast<int>(content.analysis->point_loads.size()), GeometryKind::cover};
}

/// The surroundings of the first character that differs.
std::string first_difference(const std::string& drawn, const std::string& read) {
  const auto [a, b] = std::mismatch(drawn.begin(), drawn.end(), read.begin(), read.end());
  const auto at = static_cast<std::size_t>(a - drawn.begin());
  const std::size_t from = at < 40 ? 0 : at - 40;
  return fmt::format("drawn …{}…, read …{}…", drawn.substr(from, 120), read.substr(std::min(from, read.size()), 120));
}

}  // namespace

std::vector<ContentKind> content_kinds() {
  return {{&formats::kDdaGeometry, native_drawing, no_hint},
          {&formats::kDdaBlocks, blocks, no_hint},
          {&formats::kDdaBlocksOfThree, blocks, no_hint},
          {&formats::kDdaAnalysisBerkeley, berkeley_analysis, no_hint},
          {&formats::kDdaAnalysisShi, shi_analysis, points_of_blocks},
          {&formats::kDdaml, ddaml, no_hint},
          {&formats::kDxf, native_drawing, no_hint},
          {&formats::kNmmCover, cover, no_hint},
          {&formats::kKeyblockCase, anything, no_hint},
          {&formats::kNmmAnalysis, manifold_analysis, points_of_cover}};
}

std::string round_trip_fault(const ContentKind& kind, const Content& content) {
  const std::string text = kind.format->write(content);
  try {
    const formats::Choice choice = formats::recognise({"drawn", text}, kind.hint(content).geometry);
    const bool is_own = choice.format == kind.format || choice.format->read == kind.format->read;
    if (!is_own)
      return fmt::format("recognised as {} ({})\n{}", choice.format->name, choice.recognition.evidence, text);
    const formats::Reading reading = kind.format->read({"drawn", text}, kind.hint(content));
    const std::string drawn = content_text(content), read = content_text(reading.content);
    if (drawn != read) return first_difference(drawn, read);
    if (kind.format->write(reading.content) != text) return "the second text differs from the first";
    return {};
  } catch (const InputError& error) {
    return fmt::format("{}\n{}", error.what(), text);
  }
}

}  // namespace keyblock::support
