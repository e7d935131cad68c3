// Draws towers block by block and slopes joint by joint.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/validate/random_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <numbers>

#include "cut/bodies/cut_blocks.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock {
namespace {

constexpr double kGravity = 9.81;
constexpr double kDegree = std::numbers::pi / 180;
constexpr int kSteps = 40;
constexpr std::array<double, 4> kTimeSteps{0.5e-3, 1e-3, 2e-3, 5e-3};

// Common to both kinds: a dynamic run as in a native analysis file, with a constant step.
Analysis drawn_analysis(Dice& dice) {
  Analysis analysis;
  analysis.dialect = AnalysisDialect::berkeley;
  analysis.velocity_carry_over = 1;
  analysis.step_count = kSteps;
  analysis.allowed_displacement_ratio = 0.01;
  analysis.automatic_penalty = true;
  analysis.time_step = kTimeSteps[static_cast<std::size_t>(dice.below(4))];
  analysis.place = {"random", 0, 0};
  return analysis;
}

constexpr double kStiffest = 1e11;
constexpr double kSoftestOfStack = 1e8;
// Under the weight of 30 m of rock this is strained by 5e-4; a corner block that carries its neighbours, by more than a
// thousandth.
constexpr double kSoftestOfSlope = 2e9;

BlockMaterial drawn_rock(Dice& dice, double softest) {
  BlockMaterial rock;
  rock.density = dice.between(1500, 3500);
  rock.unit_weight = rock.density * kGravity;
  rock.youngs_modulus = dice.magnitude_between(softest, kStiffest);
  rock.poissons_ratio = dice.between(0, 0.4);
  return rock;
}

JointMaterial drawn_joint(Dice& dice) {
  return {dice.between(5, 45), 0, 0, {}};
}

Point turned_about_origin(Point p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

// Joint materials of a block: under it, over it, and at its sides.
struct Edges {
  int below = 0;
  int above = 0;
  int sides = 0;
};

BlockPolygon rectangle(Point low, Point high, int material, Edges joints) {
  return {material,
          {{low, joints.sides}, {{high.x, low.y}, joints.below}, {high, joints.sides}, {{low.x, high.y}, joints.above}},
          {}};
}

constexpr double kFloorDepth = 2;
constexpr double kFloorEnd = 3;  // beyond the outermost towers

class StackDrawing {
 public:
  explicit StackDrawing(std::uint64_t seed) : dice_(seed), analysis_(drawn_analysis(dice_)) {
    analysis_.block_materials.push_back(drawn_rock(dice_, kSoftestOfStack));  // the floor
    analysis_.joint_materials.push_back(drawn_joint(dice_));
  }

  Problem draw() {
    const int blocks = 2 + dice_.below(11);
    const int towers = std::min(blocks, 1 + dice_.below(3));
    const double tilt = dice_.happens(0.5) ? -dice_.between(0, 10) * kDegree : 0;
    scene_.blocks.emplace_back();
    double left = 0;
    for (int i = 0; i < towers; ++i) {
      const int count = blocks / towers + (i < blocks % towers ? 1 : 0);
      left = tower(left, count) + (dice_.happens(0.6) ? 0 : dice_.between(0.01, 0.5));
    }
    scene_.blocks[0] = rectangle({-kFloorEnd, -kFloorDepth}, {left + kFloorEnd, 0}, 0, {});
    for (const double x : {-kFloorEnd / 2, left + kFloorEnd / 2})
      scene_.fixed_points.push_back({{x, -kFloorDepth / 2}, 0, {}});
    turn(tilt);
    scene_.place = analysis_.place;
    return {std::move(scene_), std::move(analysis_)};
  }

 private:
  // Every block leans against the line x = left or is off it by a few hundredths of its width; so does its neighbour
  // from the other side. Returns the extent of the tower.
  double tower(double left, int count) {
    const double width = dice_.between(0.5, 2);
    double right = left;
    double y = 0;
    int below = 0;
    for (int i = 0; i < count; ++i) {
      const double w = width * dice_.between(0.8, 1.2);
      const double h = width * dice_.between(0.3, 1);
      const double offset = dice_.happens(0.4) ? 0 : width * dice_.between(0, 0.1);
      const int above = static_cast<int>(analysis_.joint_materials.size());
      analysis_.joint_materials.push_back(drawn_joint(dice_));
      const int rock = static_cast<int>(analysis_.block_materials.size());
      analysis_.block_materials.push_back(drawn_rock(dice_, kSoftestOfStack));
      scene_.blocks.push_back(rectangle({left + offset, y}, {left + offset + w, y + h}, rock, {below, above, 0}));
      right = std::max(right, left + offset + w);
      y += h;
      below = above;
    }
    return right;
  }

  void turn(double angle) {
    if (angle == 0) return;
    for (BlockPolygon& block : scene_.blocks)
      for (BlockVertex& corner : block.outer) corner.position = turned_about_origin(corner.position, angle);
    for (BlockPoint& point : scene_.fixed_points) point.position = turned_about_origin(point.position, angle);
  }

  Dice dice_;
  Analysis analysis_;
  Blocks scene_;
};

struct JointSet {
  double angle = 0;  ///< of the joints against the x axis
  double spacing = 0;
  int material = 0;
};

// Fixed rock and outline of a slope of height H: base below y = 0, back left of x = 0, face from (crest, H) to (toe,
// 0).
class SlopeDrawing {
 public:
  explicit SlopeDrawing(std::uint64_t seed) : dice_(seed), analysis_(drawn_analysis(dice_)) {
    analysis_.block_materials.push_back(drawn_rock(dice_, kSoftestOfSlope));
    for (int i = 0; i < 3; ++i) analysis_.joint_materials.push_back(drawn_joint(dice_));
    foundation_is_one_ = dice_.happens(0.25);
    drawing_.edge_node_ratio = dice_.happens(0.5) ? 0.005 : 1e-6;
  }

  Problem draw() {
    constexpr int kTries = 1000;
    for (int i = 0; i < kTries; ++i) {
      outline();
      const double area = (crest_ + toe_) / 2 * height_;
      for (const JointSet& set : drawn_sets(area / dice_.between(kFewestBlocksOfSlope, kMostBlocksOfSlope)))
        cut_by(set);
      if (has_fitting_count()) return {std::move(drawing_), std::move(analysis_)};
    }
    throw std::logic_error("no slope with a fitting number of blocks");
  }

 private:
  void line(Point start, Point end, int material) { drawing_.joints.push_back({{start, end}, material, {}}); }

  void outline() {
    drawing_.joints.clear();
    drawing_.fixed_lines.clear();
    height_ = dice_.between(5, 30);
    crest_ = height_ * dice_.between(0.3, 1.2);
    toe_ = crest_ + height_ / std::tan(dice_.between(40, 85) * kDegree);
    const double low = -height_ / 5;
    const double end = toe_ + height_ / 2;
    const std::array<Point, 8> corners{
        {{low, low}, {end, low}, {end, 0}, {toe_, 0}, {crest_, height_}, {0, height_}, {low, height_}, {low, low}}};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) line(corners[i], corners[i + 1], 0);
    line({foundation_is_one_ ? 0 : low, 0}, {toe_, 0}, 0);
    line({0, 0}, {0, height_}, 0);
    drawing_.boundary_count = drawing_.joints.size();
    const double half = low / 2;
    for (const Point p : {Point{toe_ / 3, half}, Point{toe_, half}, Point{half, height_ / 3}, Point{half, height_ / 2}})
      drawing_.fixed_lines.push_back({{p, p}, {}});
  }

  // Two sets that cross at 40 to 140 degrees and bound blocks of about the given area.
  std::array<JointSet, 2> drawn_sets(double block_area) {
    const double first = dice_.between(-60, 60) * kDegree;
    const double between = dice_.between(40, 140) * kDegree;
    const double slenderness = dice_.magnitude_between(0.4, 2.5);
    const double spacing = std::sqrt(block_area * std::sin(between));
    return {{{first, spacing * slenderness, 1}, {first + between, spacing / slenderness, 2}}};
  }

  // Lines through the whole slope, at distances that scatter by a fifth of the spacing and at angles that scatter by 3
  // degrees.
  void cut_by(const JointSet& set) {
    const Point middle{toe_ / 2, height_ / 2};
    const double reach = length(middle);
    const double first = -reach + set.spacing * dice_.between(0, 1);
    for (double d = first; d < reach; d += set.spacing) {
      const double angle = set.angle + dice_.between(-3, 3) * kDegree;
      const double offset = d + set.spacing * dice_.between(-0.2, 0.2);
      const Point normal{-std::sin(set.angle), std::cos(set.angle)};
      clipped(middle + offset * normal, {std::cos(angle), std::sin(angle)}, set.material);
    }
  }

  // The stretch of a line inside the slope, prolonged by a thousandth of the height so that it crosses the outline.
  void clipped(Point through, Point direction, int material) {
    const std::array<Point, 4> corners{{{0, 0}, {toe_, 0}, {crest_, height_}, {0, height_}}};
    double low = -2 * (toe_ + height_);
    double high = -low;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point edge = corners[(i + 1) % corners.size()] - corners[i];
      const double inside = cross(edge, through - corners[i]);
      const double rate = cross(edge, direction);
      if (rate > 0) low = std::max(low, -inside / rate);
      if (rate < 0) high = std::min(high, -inside / rate);
    }
    const double beyond = height_ / 1000;
    if (high - low > beyond)
      line(through + (low - beyond) * direction, through + (high + beyond) * direction, material);
  }

  bool has_fitting_count() const {
    const CutResult cut = cut_blocks(drawing_, NodeMerging::in_order_found);
    const int held = foundation_is_one_ ? 1 : 2;
    const int moving = static_cast<int>(cut.blocks.blocks.size()) - held;
    return cut.blocks.fixed_points.size() == drawing_.fixed_lines.size() && moving >= kFewestBlocksOfSlope &&
           moving <= kMostBlocksOfSlope;
  }

  Dice dice_;
  Analysis analysis_;
  Drawing drawing_;
  bool foundation_is_one_ = false;
  double height_ = 0;
  double crest_ = 0;
  double toe_ = 0;
};

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

}  // namespace

RandomScene random_stack(std::uint64_t seed) {
  return {fmt::format("stack {}", seed), StackDrawing(seed).draw()};
}

RandomScene random_slope(std::uint64_t seed) {
  return {fmt::format("slope {}", seed), SlopeDrawing(seed).draw()};
}

RandomScene random_scene(std::uint64_t seed) {
  return seed % 2 == 0 ? random_stack(seed) : random_slope(seed);
}

void write_scene(const RandomScene& scene, const std::filesystem::path& folder) {
  std::string name = scene.name;
  std::ranges::replace(name, ' ', '_');
  formats::Content content;
  content.analysis = scene.problem.analysis;
  write(folder / (name + ".ana"), formats::kDdaAnalysisBerkeley.write(content));
  if (const auto* drawing = std::get_if<Drawing>(&scene.problem.geometry)) {
    content.drawing = *drawing;
    write(folder / (name + ".geo"), formats::kDdaGeometry.write(content));
  } else {
    content.blocks = std::get<Blocks>(scene.problem.geometry);
    write(folder / (name + ".blk"), formats::kDdaBlocks.write(content));
  }
}

}  // namespace keyblock
