// Checks the outlines of blocks as cut, and their contacts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/look_ahead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <set>

#include "base/sentences/sentences.hpp"
#include "base/words/plain_number.hpp"
#include "contact/find/connected_sets.hpp"
#include "cut/bodies/slivers.hpp"
#include "geometry/box.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"
#include "model/material_choices.hpp"
#include "problem/lines/outline_graph.hpp"
#include "run/ahead/facing_faces.hpp"
#include "run/ahead/incompressible_rock.hpp"
#include "run/ahead/plausible_units.hpp"
#include "run/ahead/spring_impacts.hpp"
#include "run/ahead/wedged_toes.hpp"
#include "run/growth/bonded_faces.hpp"
#include "step/scene/enforcement.hpp"

namespace keyblock {
namespace {

constexpr double kSlender = 5;           // length over mean width of a block that should be able to bend
constexpr double kBendingArea = 0.5;     // of the median block: bending of a smaller one hardly affects others
constexpr double kHeldAlong = 0.5;       // of the length of a slender block: fixed points as far apart keep it straight
constexpr double kStray = 1e-3;          // of the side of a mean square block: points on an edge are not outside
constexpr double kOverlap = 1e-4;        // of the size of the mean block: faces that coincide
constexpr double kDownward = 0.05;       // sine of the angle at which a face rests on another
constexpr double kStiff = 100;           // springs over inertia, above which many pairs take hundreds of solves
constexpr std::size_t kManyPairs = 500;  // number of pairs in the measured case

std::string at(const Point& p) {
  return fmt::format("{}, {}", plain(p.x), plain(p.y));
}

// Serves files that state the block of each point. `loops`: of the blocks; `near`: nearer points count as on an edge.
Finding points_outside(const Blocks& blocks, const std::vector<std::vector<Point>>& loops, double near) {
  struct Stray {
    const char* noun;
    const BlockPoint* point;
    double off;
  };
  std::vector<Stray> found;
  const auto look = [&](const char* noun, const std::vector<BlockPoint>& points) {
    for (const BlockPoint& point : points) {
      const std::vector<Point>& loop = loops[static_cast<std::size_t>(point.block)];
      if (side(loop, point.position) != Side::outside) continue;
      double off = std::numeric_limits<double>::max();
      for (std::size_t i = 0; i < loop.size(); ++i)
        off = std::min(off, distance(Segment{loop[i], loop[(i + 1) % loop.size()]}, point.position));
      if (off > near) found.push_back({noun, &point, off});
    }
  };
  look("a fixed point", blocks.fixed_points);
  look("a loading point", blocks.loading_points);
  look("a measured point", blocks.measured_points);
  if (found.empty()) return {};
  Facts facts{{{"count", found.size()}, {"distance", found.front().off}},
              {{"lie", found.size() == 1 ? "lies" : "lie"}, {"noun", found.front().noun}}};
  for (const Stray& stray : found) {
    facts.elements.push_back(stray.point->block + 1);
    facts.points.push_back({stray.point->position.x, stray.point->position.y});
  }
  return {"point_outside_its_block", std::move(facts)};
}

// Counts crossings of a level ray with the outline, modulo 2; lines drawn twice count once.
bool is_inside(const std::vector<Segment>& outline, Point p) {
  bool inside = false;
  for (const Segment& line : outline) {
    if ((line.start.y > p.y) == (line.end.y > p.y)) continue;
    const double x = line.start.x + (p.y - line.start.y) / (line.end.y - line.start.y) * (line.end.x - line.start.x);
    if (x > p.x) inside = !inside;
  }
  return inside;
}

bool lies_along(const std::vector<Point>& loop, Point from, Point along, double size, double tolerance) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i] - from;
    const Point b = loop[(i + 1) % loop.size()] - from;
    const double off = std::max(std::abs(a.x * along.y - a.y * along.x), std::abs(b.x * along.y - b.y * along.x));
    if (off > tolerance) continue;
    const auto [low, high] = std::minmax({a.x * along.x + a.y * along.y, b.x * along.x + b.y * along.y});
    if (std::min(high, size) - std::max(low, 0.0) > tolerance) return true;
  }
  return false;
}

// Returns the median area of blocks without fixed points, or of all if each has one. One huge block does not change it.
double middle_area(const std::vector<BlockForm>& shapes, const std::vector<int>& fixed) {
  std::vector<double> loose, all;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    all.push_back(shapes[i].area);
    if (fixed[i] == 0) loose.push_back(shapes[i].area);
  }
  std::vector<double>& areas = loose.empty() ? all : loose;
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>((areas.size() - 1) / 2);
  std::ranges::nth_element(areas, middle);
  return *middle;
}

using Texts = std::vector<std::pair<std::string, std::string>>;

/// Blocks of a scene as cut, and their contacts.
class Blocky {
 public:
  Blocky(const Prepared& prepared)
      : model_(prepared.scene.model),
        settings_(prepared.scene.settings),
        blocks_(prepared.blocks),
        touching_(touching_pairs(model_)),
        fixed_(blocks_.blocks.size(), 0) {
    for (const BlockPolygon& block : blocks_.blocks) {
      loops_.push_back(points_of(block.outer));
      shapes_.push_back(form_of(block));
      mean_ += shapes_.back().area;
    }
    mean_ /= static_cast<double>(shapes_.size());
    held_.resize(blocks_.blocks.size());
    for (const CarriedPoint& point : model_.fixed_points) {
      ++fixed_[point.element.value];
      held_[static_cast<std::size_t>(point.element.value)].add(point.start);
    }
    for (const SupportRow& row : model_.support_rows) has_held_edge_.insert(row.element.value);
  }

  Warnings warnings(const Problem& problem) const {
    Warnings found;
    const auto put = [&](Finding finding) {
      if (!finding.empty()) found.push_back(warning_of(std::move(finding), blocks_.place));
    };
    put(slivers());
    if (const auto* drawing = std::get_if<Drawing>(&problem.geometry)) put(outside(*drawing));
    if (std::holds_alternative<Blocks>(problem.geometry))  // in others the program assigns points to blocks
      put(points_outside(blocks_, loops_, kStray * std::sqrt(mean_)));
    put(flying());
    put(unheld());
    put(unsupported());
    put(cannot_bend());
    put(stiff_springs());
    return found;
  }

  /// Returns the stiffness of springs over the inertia of the mean block if it is too large for the step; otherwise 0.
  double stiffness_of_springs() const {
    if (settings_.dynamics != Dynamics::standard || settings_.standard.motion != MotionRule::dynamic) return 0;
    if (touching_.size() < kManyPairs ||
        with_enforcement_decided(settings_, model_).standard.enforcement.common != Enforcement::penalty)
      return 0;
    double mass = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      mass += shapes_[i].area * model_.material_of(model_.elements[index(i)]).density;
    mass /= static_cast<double>(shapes_.size());
    const double ratio = settings_.contact_penalty * settings_.time_step * settings_.time_step / mass;
    return ratio > kStiff ? ratio : 0;
  }

  std::string softer_springs() const {
    const double ratio = stiffness_of_springs();
    if (ratio == 0) return {};
    return fmt::format("--set contact_penalty={:.2g} or --set time_step={:.2g}",
                       settings_.contact_penalty * kStiff / ratio, settings_.time_step * std::sqrt(kStiff / ratio));
  }

 private:
  /// Returns the finding about some blocks, with the place and the area of the first.
  Finding about(const char* form, const std::vector<std::size_t>& found, const Texts& texts) const {
    const BlockForm& first = shapes_[found.front()];
    const double size = first.area, percent = 100 * size / mean_;
    Facts facts{{{"count", found.size()}, {"blocks", shapes_.size()}, {"area", size}, {"percent_of_mean", percent}},
                texts};
    facts.points = {{first.centroid.x, first.centroid.y}};
    for (const std::size_t block : found) facts.elements.push_back(static_cast<int>(block) + 1);
    return {form, std::move(facts)};
  }

  Finding slivers() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (is_sliver(shapes_[i], mean_)) found.push_back(i);
    if (found.empty()) return {};
    const auto thinnest =
        *std::ranges::min_element(found, {}, [&](std::size_t i) { return shapes_[i].width() / shapes_[i].length; });
    const auto smallest = std::ranges::min_element(found, {}, [&](std::size_t i) { return shapes_[i].area; });
    std::rotate(found.begin(), smallest, smallest + 1);
    const BlockForm& thin = shapes_[thinnest];
    Finding finding = about("slivers", found,
                            {{"are", found.size() == 1 ? "is a sliver," : "are slivers,"},
                             {"rule", slivers_in_words()},
                             {"thinnest_at", at(thin.centroid)}});
    const auto of_thinnest = {std::pair{"thinnest", thinnest + 1.0}, {"width", thin.width()}, {"length", thin.length}};
    finding.facts.numbers.insert(finding.facts.numbers.end(), of_thinnest.begin(), of_thinnest.end());
    finding.facts.points.push_back({thin.centroid.x, thin.centroid.y});
    return finding;
  }

  Finding outside(const Drawing& drawing) const {
    if (drawing.boundary_count < 3) return {};
    const OutlineGraph graph(std::span(drawing.joints).first(drawing.boundary_count));
    if (graph.is_tangled()) return {};
    const std::vector<Segment> outline = graph.pieces();
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const std::array<std::vector<Point>, 1> outer{points_of(blocks_.blocks[i].outer)};
      const std::optional<Point> within = point_inside(outer);
      if (within && !is_inside(outline, *within)) found.push_back(i);
    }
    if (found.empty()) return {};
    return about("block_outside_outline", found, {{"lie", found.size() == 1 ? "lies" : "lie"}});
  }

  bool is_held(std::size_t i) const {
    return fixed_[i] > 0 || has_held_edge_.contains(static_cast<int>(i)) || !model_.elements[index(i)].can_move();
  }
  static ElementIndex index(std::size_t i) { return ElementIndex{static_cast<int>(i)}; }

  // Returns the sets of blocks that contacts and bolts connect.
  ConnectedSets connected() const {
    std::vector<ElementIndex> held;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (is_held(i)) held.push_back(index(i));
    return {model_, touching_, held};
  }

  // In dynamics a block without contact is meant to fall or fly.
  bool flies(std::size_t i) const {
    const auto is_it = [&](ElementIndex e) { return e == index(i); };
    return !is_static(settings_, model_) && settings_.standard.motion == MotionRule::dynamic &&
           std::ranges::none_of(touching_, [&](const ElementPair& p) { return is_it(p.lower) || is_it(p.upper); }) &&
           std::ranges::none_of(model_.bolts,
                                [&](const Bolt& b) { return is_it(b.first.element) || is_it(b.second.element); });
  }

  Finding flying() const {
    const ConnectedSets sets = connected();
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (!sets.is_held(index(i)) && flies(i)) found.push_back(i);
    if (found.empty()) return {};
    return about("free_blocks", found, {{"move", found.size() == 1 ? "moves" : "move"}});
  }

  Finding unheld() const {
    const ConnectedSets sets = connected();
    std::vector<std::size_t> loose;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (!sets.is_held(index(i)) && !flies(i)) loose.push_back(i);
    if (loose.empty()) return {};
    const char* const form = length(settings_.gravity) > 0 ? "unheld_blocks" : "unheld_blocks:weightless";
    return about(form, loose, {{"are", loose.size() == 1 ? "is" : "are"}});
  }

  // Returns true if a face of the upper block looks downward and lies on the lower one.
  bool rests_on(std::size_t upper, std::size_t lower, Point down) const {
    const double tolerance = kOverlap * std::sqrt(mean_);
    const std::vector<Point>& own = loops_[upper];
    const std::vector<Point>& other = loops_[lower];
    bool shares_a_face = false;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Point a = own[i];
      const Point b = own[(i + 1) % own.size()];
      const double size = distance(a, b);
      if (size <= tolerance) continue;
      const Point along = (1 / size) * (b - a);
      const Point outward{along.y, -along.x};
      if (!lies_along(other, a, along, size, tolerance)) continue;
      shares_a_face = true;
      if (outward.x * down.x + outward.y * down.y > kDownward) return true;
    }
    const Point way = shapes_[lower].centroid - shapes_[upper].centroid;
    return !shares_a_face && way.x * down.x + way.y * down.y > 0;  // corner on face
  }

  Finding unsupported() const {
    const double g = length(settings_.gravity);
    if (g == 0) return {};
    const Point down = (1 / g) * settings_.gravity;
    std::vector<std::vector<std::size_t>> bears(shapes_.size());  // blocks that rest on each
    for (const ElementPair& pair : touching_) {
      const auto one = static_cast<std::size_t>(pair.lower.value);
      const auto other = static_cast<std::size_t>(pair.upper.value);
      if (rests_on(one, other, down)) bears[other].push_back(one);
      if (rests_on(other, one, down)) bears[one].push_back(other);
    }
    std::vector<bool> stands(shapes_.size());
    std::vector<std::size_t> to_look_at;
    const auto stand = [&](std::size_t i) {
      if (stands[i]) return;
      stands[i] = true;
      to_look_at.push_back(i);
    };
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (is_held(i)) stand(i);
    for (const Bolt& bolt : model_.bolts)
      for (const ElementIndex e : {bolt.first.element, bolt.second.element}) stand(static_cast<std::size_t>(e.value));
    while (!to_look_at.empty()) {
      const std::size_t lower = to_look_at.back();
      to_look_at.pop_back();
      for (const std::size_t upper : bears[lower]) stand(upper);
    }
    const ConnectedSets sets = connected();  // the others are reported as unheld
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (!stands[i] && sets.is_held(index(i))) found.push_back(i);
    if (found.empty()) return {};
    return about("unsupported_blocks", found,
                 {{"have", found.size() == 1 ? "has" : "have"}, {"them", found.size() == 1 ? "it" : "them"}});
  }

  Finding cannot_bend() const {
    std::vector<std::size_t> found;
    const double least = kBendingArea * middle_area(shapes_, fixed_);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const bool is_held_along = fixed_[i] >= 2 && length(held_[i].size()) >= kHeldAlong * shapes_[i].length;
      if (!is_held_along && shapes_[i].length > kSlender * shapes_[i].width() && shapes_[i].area >= least)
        found.push_back(i);
    }
    if (found.empty()) return {};
    const auto rigid =
        std::ranges::count_if(found, [&](std::size_t i) { return !model_.elements[index(i)].can_move(); });
    const BlockForm& first = shapes_[found.front()];
    Finding finding = about("block_cannot_bend", found, {{"are", found.size() == 1 ? "is" : "are"}});
    finding.facts.numbers.emplace_back("length", first.length);
    finding.facts.numbers.emplace_back("width", first.width());
    if (rigid > 0) finding.facts.numbers.emplace_back("rigid", rigid);
    return finding;
  }

  Finding stiff_springs() const {
    const double ratio = stiffness_of_springs();
    if (ratio == 0) return {};
    return {
        "springs_stiff_for_step",
        {{{"stiffness", settings_.contact_penalty}, {"ratio", ratio}, {"pairs", touching_.size()}, {"limit", kStiff}},
         {{"remedy", softer_springs()}}}};
  }

  const Model& model_;
  const Settings& settings_;
  const Blocks& blocks_;
  std::vector<ElementPair> touching_;
  std::vector<int> fixed_;  ///< number of points per block
  std::set<int> has_held_edge_;
  std::vector<Box> held_;  ///< around the fixed points of each
  std::vector<std::vector<Point>> loops_;
  std::vector<BlockForm> shapes_;
  double mean_ = 0;
};

bool is_of_blocks(const Prepared& prepared) {
  const Model& model = prepared.scene.model;
  return model.nodes.empty() && !model.continuum && !prepared.blocks.blocks.empty() &&
         model.elements.size() == prepared.blocks.blocks.size();
}

}  // namespace

Warnings look_ahead(const Problem& problem, const Prepared& prepared) {
  Warnings found = implausible_units(problem, prepared.scene.settings, prepared.scene.model);
  found = joined(std::move(found), spring_impacts(prepared.scene, problem.analysis->place));
  found = joined(std::move(found), facing_faces(prepared.scene, problem.analysis->place));
  found = joined(std::move(found), incompressible_rock(prepared.scene, problem.analysis->place));
  if (problem.covers) found = joined(std::move(found), bonded_crack_faces(prepared.scene, problem.covers->place));
  if (!is_of_blocks(prepared)) return found;
  found = joined(std::move(found), wedged_toes(prepared.scene, problem.analysis->place));
  return joined(std::move(found), Blocky(prepared).warnings(problem));
}

std::string softer_springs(const Prepared& prepared) {
  return is_of_blocks(prepared) ? Blocky(prepared).softer_springs() : std::string();
}

std::string smallest_block(const Blocks& blocks) {
  if (blocks.blocks.empty()) return {};
  std::vector<BlockForm> shapes;
  double sum = 0;
  for (const BlockPolygon& block : blocks.blocks) {
    shapes.push_back(form_of(block));
    sum += shapes.back().area;
  }
  const auto smallest = std::ranges::min_element(shapes, {}, &BlockForm::area);
  return fmt::format("smallest block: {} at {}, area {}, {:.3g} % of the mean", smallest - shapes.begin() + 1,
                     at(smallest->centroid), plain(smallest->area, 3),
                     100 * smallest->area * static_cast<double>(shapes.size()) / sum);
}

}  // namespace keyblock
