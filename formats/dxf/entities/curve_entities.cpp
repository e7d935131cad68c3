// Reads the groups of curves; curves/ computes their chords.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/entities/curve_entities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formats/dxf/curves/dxf_curves.hpp"
#include "formats/dxf/curves/dxf_spline.hpp"

namespace keyblock::formats {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kFull = 1e-4;       // rad: an ellipse that lacks less is full, as files with few digits write it
constexpr double kSamePoint = 1e-9;  // over the size of a spline: its ends coincide
enum SplineFlag { kClosedSpline = 1 };

void add_chords(DxfShape& shape, std::size_t chords) {
  ++shape.curves;
  shape.chords += static_cast<std::uint32_t>(chords);
}

void close_chain(DxfShape& shape) {
  shape.points.pop_back();
  shape.is_closed = true;
}

/// Reads the points of a SPLINE from its groups.
class SplineReader {
 public:
  SplineReader(const DxfDocument& document, const DxfRecord& record) : document_(document), record_(record) {}

  /// Reads every point, and the lowest and highest z into `shape`.
  void read(DxfShape& shape) {
    for (const DxfGroup& group : record_.groups) {
      if (group.code >= 1000) break;
      if (group.code == 10 || group.code == 11) open(group);
      if (group.code == 20 || group.code == 21) put_y(group);
      if (group.code == 30 || group.code == 31) put_z(group, shape);
      if (group.code == 40) curve_.knots.push_back(document_.real(group, "a knot", "SPLINE"));
      if (group.code == 41) curve_.weights.push_back(document_.real(group, "a weight", "SPLINE"));
      if (group.code == 71) curve_.degree = document_.integer(group, "the degree", "SPLINE");
    }
    if (waiting_ != nullptr) complain();
  }

  /// Returns the control points, otherwise the fit points; empty if neither makes a curve.
  std::vector<Point> points(bool is_closed) {
    if (is_sound(curve_)) return spline_points(curve_);
    const auto end = std::ranges::unique(fit_).begin();
    fit_.erase(end, fit_.end());
    if (is_closed && !fit_.empty() && fit_.front() != fit_.back()) fit_.push_back(fit_.front());
    if (fit_.size() < 2) return {};
    return spline_points(spline_through(fit_));
  }

 private:
  void open(const DxfGroup& group) {
    if (waiting_ != nullptr) complain();
    waiting_ = group.code == 10 ? &curve_.controls : &fit_;
    waiting_->push_back({document_.real(group, "x of a point", "SPLINE"), 0});
  }

  void put_y(const DxfGroup& group) {
    if (waiting_ == nullptr) return;
    waiting_->back().y = document_.real(group, "y of a point", "SPLINE");
    waiting_ = nullptr;
  }

  void put_z(const DxfGroup& group, DxfShape& shape) {
    const double z = document_.real(group, "z of a point", "SPLINE");
    shape.low = has_height_ ? std::min(shape.low, z) : z;
    shape.high = has_height_ ? std::max(shape.high, z) : z;
    has_height_ = true;
  }

  [[noreturn]] void complain() const {
    throw InputError(document_.place(record_.head),
                     fmt::format("expected y (group {}) of point {} of SPLINE, found none", waiting_ == &fit_ ? 21 : 20,
                                 waiting_->size()));
  }

  const DxfDocument& document_;
  const DxfRecord& record_;
  Nurbs curve_;
  std::vector<Point> fit_;
  std::vector<Point>* waiting_ = nullptr;  ///< list whose last point lacks its y
  bool has_height_ = false;
};

}  // namespace

DxfShape circle_of(const DxfRecordValues& values, const DxfRecord& record) {
  const Point centre = values.point(record, 10, "x of the centre", "y of the centre");
  DxfShape shape = values.shape_of(record, arc_points(centre, values.radius(record), 0, kFullTurn), {30});
  close_chain(shape);
  add_chords(shape, shape.points.size());
  return shape;
}

DxfShape arc_of(const DxfRecordValues& values, const DxfRecord& record) {
  const Point centre = values.point(record, 10, "x of the centre", "y of the centre");
  const double start = values.real(record, 50, "the start angle");
  const double turn = std::fmod(values.real(record, 51, "the end angle") - start, 360);
  const double sweep = turn > 0 ? turn : turn + 360;
  const double degree = std::numbers::pi / 180;
  DxfShape shape = values.shape_of(
      record, arc_points(centre, values.radius(record), degree * std::fmod(start, 360), degree * sweep), {30});
  add_chords(shape, shape.points.size() - 1);
  return shape;
}

DxfShape ellipse_of(const DxfDocument& document, const DxfRecordValues& values, const DxfRecord& record) {
  const Point centre = values.point(record, 10, "x of the centre", "y of the centre");
  const Point major = values.point(record, 11, "x of the major axis", "y of the major axis");
  const double ratio = values.real(record, 40, "the ratio of the axes");
  if (length(major) == 0 || ratio == 0)
    throw InputError(document.place(record.head), "expected an ELLIPSE with two axes, found one without a length");
  const double start = std::fmod(values.real_or(0, record, 41, "the start"), kFullTurn);
  const double all = values.real_or(kFullTurn, record, 42, "the end") - values.real_or(0, record, 41, "the start");
  const double turn = std::fmod(all, kFullTurn);
  const bool is_whole = std::abs(all) >= kFullTurn - kFull || turn == 0;
  const int side = values.side_seen(record) < 0 ? -1 : 1;
  const Point minor = (side * std::abs(ratio)) * Point{-major.y, major.x};
  const double sweep = is_whole ? kFullTurn : turn > 0 ? turn : turn + kFullTurn;
  DxfShape shape = values.shape_of(record, ellipse_points(centre, major, minor, start, sweep), {30});
  if (is_whole) close_chain(shape);
  add_chords(shape, shape.points.size() - (is_whole ? 0 : 1));
  const double tilt = values.real_or(0, record, 31, "z of the major axis");
  shape.low -= std::abs(tilt);
  shape.high += std::abs(tilt);
  return shape;
}

DxfShape spline_of(const DxfDocument& document, const DxfRecordValues& values, const DxfRecord& record) {
  DxfShape shape = values.shape_of(record, {}, {});
  SplineReader reader(document, record);
  reader.read(shape);
  const bool is_closed = (values.flags(record) & kClosedSpline) != 0;
  shape.points = reader.points(is_closed);
  shape.points.erase(std::ranges::unique(shape.points).begin(), shape.points.end());
  if (shape.points.size() < 2) {
    shape.points.clear();
    return shape;
  }
  add_chords(shape, shape.points.size() - 1);
  double size = 0;
  for (const Point p : shape.points) size = std::max(size, distance(p, shape.points.front()));
  const bool meets_itself = distance(shape.points.front(), shape.points.back()) <= kSamePoint * size;
  if (meets_itself && shape.points.size() > 3)
    close_chain(shape);
  else
    shape.is_closed = is_closed;
  return shape;
}

}  // namespace keyblock::formats
