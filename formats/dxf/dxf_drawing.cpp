// Assigns every shape of a DXF file the part in the drawing that its layer names.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "formats/dxf/curves/dxf_curves.hpp"
#include "formats/dxf/curves/dxf_spline.hpp"
#include "formats/dxf/dxf_layer_table.hpp"
#include "formats/dxf/dxf_layers.hpp"
#include "formats/text/tokens.hpp"
#include "geometry/polygon.hpp"

namespace keyblock::formats {
namespace {

constexpr int kMostNamed = 1000;   // materials: no legend lists more
constexpr int kMostColours = 256;  // the AutoCAD colour index; the last is that of the layer
constexpr int kByLayer = 256;

/// Names each material after its first layer; joints come before outlines, which share their numbers.
MaterialNames names_of_layers(const std::map<std::string_view, DxfLayer>& layers) {
  MaterialNames all;
  const auto put = [&](std::vector<std::string>& names, DxfRole role) {
    for (const auto& [name, layer] : layers) {
      if (layer.role != role || layer.index < 0 || layer.index >= kMostNamed) continue;
      const auto at = static_cast<std::size_t>(layer.index);
      if (names.size() <= at) names.resize(at + 1);
      if (names[at].empty()) names[at] = name;
    }
  };
  put(all.rocks, DxfRole::material);
  put(all.joints, DxfRole::joint);
  put(all.joints, DxfRole::boundary);
  return all;
}

/// Counts curves and their chords.
class ChordCount {
 public:
  void add(const DxfShape& shape) {
    if (shape.curves == 0) return;
    if (curves_ == 0) first_ = shape.place;
    has_others_ = has_others_ || shape.type == "ELLIPSE" || shape.type == "SPLINE";
    curves_ += shape.curves;
    chords_ += shape.chords;
  }

  /// Returns at most one warning.
  Warnings warnings() const {
    if (curves_ == 0) return {};
    Facts facts{{{"curves", curves_}, {"chords", chords_}, {"share_of_radius", kSagittaRatio}},
                {{"kinds", has_others_ ? "curves" : "arcs, circles and bulges"}}};
    if (has_others_) facts.numbers.emplace_back("share_of_spline", kSplineRatio);
    return {warning_of({"dxf_curves_as_chords", std::move(facts)}, first_)};
  }

 private:
  std::size_t curves_ = 0;
  std::size_t chords_ = 0;
  bool has_others_ = false;  ///< ellipses or splines
  Place first_;
};

class DrawingMaker {
 public:
  DrawingMaker(DxfShapes shapes, double scale, const LayerTable& table)
      : shapes_(std::move(shapes)), scale_(scale), table_(table), parts_(table) {}

  DxfDrawing make() {
    for (DxfShape& shape : shapes_.shapes) to_metres(shape);
    name_layers();
    result_.names = names_of_layers(layers_);
    for (const DxfShape& shape : shapes_.shapes) add(shape);
    Drawing& drawing = result_.drawing;
    drawing.boundary_count = boundaries_.size();
    make_room(boundaries_, drawing.joints.size());
    boundaries_.insert(boundaries_.end(), drawing.joints.begin(), drawing.joints.end());
    drawing.joints = std::move(boundaries_);
    drop_repeated_bolts();
    result_.warnings = joined(std::move(shapes_.warnings), result_.warnings);
    result_.warnings = joined(std::move(result_.warnings), shapes_.hidden.warnings());
    result_.warnings = joined(std::move(result_.warnings), chords_.warnings());
    result_.warnings = joined(std::move(result_.warnings), shapes_.skipped.warnings());
    return std::move(result_);
  }

 private:
  struct UnknownLayer {
    std::string_view name;
    Place first;
    std::size_t entities = 0;
  };

  // 39800 mm times 0.001 is 39.800000000000004 m: where the unit is a whole part of the metre, division is exact.
  double to_metres(double length) const {
    const double part = std::round(1 / scale_);
    return part > 1 && 1 / part == scale_ ? length / part : scale_ * length;
  }

  void to_metres(DxfShape& shape) const {
    for (Point& p : shape.points) {
      p = {to_metres(p.x), to_metres(p.y)};
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        throw InputError(shape.place,
                         fmt::format("expected {} within the range of numbers, found it beyond", shape.type));
    }
  }

  /// Looks up the table, then the name of the layer, then the row for all other layers.
  std::optional<DxfLayer> part_of(std::string_view layer) {
    if (const auto named = parts_.named(layer)) return named;
    if (const auto own = layer_of(layer)) return own;
    return parts_.other();
  }

  /// Assigns parts to layers by table and names. Layers without a known word get the first unused joint materials.
  /// Drawings of the old Windows program are an exception: their colour gives the joint material.
  void name_layers() {
    find_marks();
    std::set<int> taken;
    std::vector<UnknownLayer> unknown;
    std::map<std::string_view, std::size_t> positions;
    for (const DxfShape& shape : shapes_.shapes) {
      if (layers_.contains(shape.layer)) continue;
      if (const auto layer = part_of(shape.layer)) {
        if (layer->number_is_too_long)
          throw InputError(shape.place,
                           fmt::format("expected a number up to 2147483647 at the end of the layer, found {}",
                                       in_quotes(shape.layer)));
        if (layer->role == DxfRole::joint || layer->role == DxfRole::boundary) taken.insert(layer->index);
        layers_[shape.layer] = *layer;
      } else if (!shape.is_point && !has_marks_) {
        const auto [at, is_new] = positions.try_emplace(shape.layer, unknown.size());
        if (is_new) unknown.push_back({shape.layer, shape.place, 0});
        ++unknown[at->second].entities;
      }
    }
    warn_of_unused_rows();
    int index = 0;
    for (const UnknownLayer& layer : unknown) {
      while (taken.contains(index)) ++index;
      layers_[layer.name] = {DxfRole::joint, index, false};
      Facts facts{{{"count", layer.entities}, {"joint_material", index + 1}},
                  {{"quoted", in_quotes(layer.name)}, {"hint", hint_for_layer(layer.name)}}};
      facts.names = {{"layer", std::string(layer.name)}};
      result_.warnings.push_back(warning_of({"dxf_layer_as_joints", std::move(facts)}, layer.first));
      ++index;
    }
  }

  void warn_of_unused_rows() {
    for (const std::string_view layer : shapes_.unread_layers) parts_.named(layer);
    std::vector<std::string> quoted;
    Facts facts;
    for (const std::size_t row : parts_.unused()) {
      quoted.push_back(in_quotes(table_.rows[row].first));
      facts.names.emplace_back("layer", table_.rows[row].first);
    }
    if (quoted.empty()) return;
    facts.numbers = {{"count", quoted.size()}};
    facts.texts = {{"layers", fmt::format("{}", fmt::join(quoted, ", "))}};
    const std::size_t first = parts_.unused().front();
    result_.warnings.push_back(warning_of({"dxf_layer_not_there", std::move(facts)},
                                          first < table_.places.size() ? table_.places[first] : Place{}));
  }

  /// Detects the convention of the old Windows program by its marks on layers without a known name.
  void find_marks() {
    const auto is_mark = [&](const DxfShape& shape) { return shape.mark != 0 && !part_of(shape.layer); };
    const auto first = std::ranges::find_if(shapes_.shapes, is_mark);
    has_marks_ = first != shapes_.shapes.end();
    if (!has_marks_) return;
    const Facts facts{{{"count", std::ranges::count_if(shapes_.shapes, is_mark)}}};
    result_.warnings.push_back(warning_of({"dxf_old_marks", facts}, first->place));
  }

  void add_by_old_marks(const DxfShape& shape) {
    if (!shape.is_point) {
      if (shape.colour < 0 || shape.colour > kMostColours)
        throw InputError(shape.place, fmt::format("expected a colour from 0 to {} (group 62), found {}", kMostColours,
                                                  shape.colour));
      const int colour = shape.colour == kByLayer ? 0 : shape.colour;
      return add_sides(shape, {DxfRole::joint, colour, false});
    }
    constexpr std::array<std::pair<char, DxfRole>, 4> kRoles{
        {{'F', DxfRole::fixed}, {'L', DxfRole::load}, {'M', DxfRole::measured}, {'H', DxfRole::hole}}};
    for (const auto& [mark, role] : kRoles)
      if (shape.mark == mark) return add_point(shape, {role, 0, false});
    skip(shape);
  }

  /// A bolt drawn twice, in either direction, counts once.
  void drop_repeated_bolts() {
    const auto ends = [](const BoltLine& bolt) {
      const auto [a, b] = bolt.segment;
      return std::minmax({std::pair{a.x, a.y}, std::pair{b.x, b.y}});
    };
    std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> seen;
    std::erase_if(result_.drawing.bolts, [&](const BoltLine& bolt) {
      if (seen.insert(ends(bolt)).second) return false;
      shapes_.skipped.add("a bolt drawn twice", bolt.place);
      return true;
    });
  }

  void skip(const DxfShape& shape) {
    shapes_.skipped.add(fmt::format("{} on layer {}", shape.type, in_quotes(shape.layer)), shape.place);
  }

  /// Bolts are straight: a circle, an arc or a closed outline among them is a symbol of a plate or a head.
  static bool is_symbol(const DxfShape& shape) { return shape.curves > 0 || shape.is_closed; }

  void skip_symbol(const DxfShape& shape) {
    shapes_.skipped.add(fmt::format("{} on layer {}, a symbol of a bolt", shape.type, in_quotes(shape.layer)),
                        shape.place);
  }

  void add(const DxfShape& shape) {
    const auto found = layers_.find(shape.layer);
    if (found == layers_.end()) return has_marks_ ? add_by_old_marks(shape) : skip(shape);
    if (found->second.role == DxfRole::ignored) return;
    if (shape.is_point) return add_point(shape, found->second);
    if (found->second.role == DxfRole::bolt && is_symbol(shape)) return skip_symbol(shape);
    const bool is_block = found->second.role == DxfRole::block;
    if (holds_points_only(found->second.role) || (is_block && !shape.is_closed)) return skip(shape);
    if (!is_block) return add_sides(shape, found->second);
    chords_.add(shape);
    add_block(shape, found->second);
  }

  void add_sides(const DxfShape& shape, const DxfLayer& layer) {
    chords_.add(shape);
    const std::size_t sides = shape.points.size() - (shape.is_closed ? 0 : 1);
    if (layer.role == DxfRole::boundary) make_room(boundaries_, sides);
    if (layer.role == DxfRole::joint) make_room(result_.drawing.joints, sides);
    for (std::size_t i = 0; i < sides; ++i) add_line(shape, side(shape, i), layer);
  }

  /// Reserves space for `more` and an eighth: doubling would temporarily hold three times the list.
  template <typename List>
  static void make_room(List& list, std::size_t more) {
    if (list.size() + more > list.capacity())
      list.reserve(std::max((list.size() + more) * 9 / 8 + 16, list.size() * 3 / 2));
  }

  static Segment side(const DxfShape& shape, std::size_t i) {
    return {shape.points[i], shape.points[i + 1 == shape.points.size() ? 0 : i + 1]};
  }

  void add_line(const DxfShape& shape, const Segment& segment, const DxfLayer& layer) {
    Drawing& drawing = result_.drawing;
    switch (layer.role) {
      case DxfRole::boundary:
        boundaries_.push_back({segment, layer.index, shape.place});
        break;
      case DxfRole::material:
        drawing.material_lines.push_back({segment, layer.index, shape.place});
        break;
      case DxfRole::fixed:
        drawing.fixed_lines.push_back({segment, shape.place});
        break;
      case DxfRole::bolt: {
        const std::array<double, 3> values = shape.bolt.value_or(std::array<double, 3>{});
        drawing.bolts.push_back({segment, values[0], values[1], values[2], layer.index, shape.place});
        break;
      }
      default:
        drawing.joints.push_back({segment, layer.index, shape.place});
    }
  }

  void add_point(const DxfShape& shape, const DxfLayer& layer) {
    Drawing& drawing = result_.drawing;
    const Point p = shape.points.front();
    if (layer.role == DxfRole::load)
      drawing.loading_points.push_back({p, shape.place});
    else if (layer.role == DxfRole::measured)
      drawing.measured_points.push_back({p, shape.place});
    else if (layer.role == DxfRole::hole)
      drawing.hole_points.push_back({p, shape.place});
    else if (layer.role == DxfRole::fixed || layer.role == DxfRole::material)
      add_line(shape, {p, p}, layer);
    else
      skip(shape);
  }

  /// Makes each side a joint of the material that the layer of its VERTEX names, otherwise of the first. A point inside
  /// gives the block material. A clockwise loop inside the previous one is a hole of it.
  void add_block(const DxfShape& shape, const DxfLayer& layer) {
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const auto own = i < shape.side_layers.size() ? part_of(shape.side_layers[i]) : std::nullopt;
      const bool names_joint = own && own->role == DxfRole::joint && !own->number_is_too_long;
      result_.drawing.joints.push_back({side(shape, i), names_joint ? own->index : 0, shape.place});
    }
    const bool is_hole =
        !outline_.empty() && area(shape.points) < 0 && keyblock::side(outline_, shape.points.front()) == Side::inside;
    if (is_hole) return;
    outline_ = shape.points;
    if (const auto inside = point_inside({&shape.points, 1}))
      result_.drawing.material_lines.push_back({{*inside, *inside}, layer.index, shape.place});
  }

  DxfShapes shapes_;
  double scale_;
  const LayerTable& table_;
  LayerParts parts_;
  std::map<std::string_view, DxfLayer> layers_;
  std::vector<JointLine> boundaries_;
  std::vector<Point> outline_;  ///< of the last block
  ChordCount chords_;           ///< of shapes that are not skipped
  bool has_marks_ = false;      ///< of the old Windows program
  DxfDrawing result_;
};

}  // namespace

DxfDrawing drawing_of(DxfShapes shapes, double scale, const LayerTable& layers) {
  return DrawingMaker(std::move(shapes), scale, layers).make();
}

}  // namespace keyblock::formats
