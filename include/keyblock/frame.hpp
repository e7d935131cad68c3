// Declares one instant of a run as columns of numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <keyblock/values.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock::api {
inline namespace v1 {

/// A table of numbers, row after row without gaps. Copies share it.
template <class T>
class Column {
 public:
  Column(std::shared_ptr<const std::vector<T>> values, std::size_t width) : values_(std::move(values)), width_(width) {}
  std::size_t rows() const { return values_->size() / width_; }
  std::size_t width() const { return width_; }
  /// Throws choice beyond the last row or column.
  const T& operator()(std::size_t row, std::size_t column = 0) const {
    if (row >= rows() || column >= width_)
      throw Error("expected a row and a column of the table, found one beyond", ErrorCode::choice);
    return (*values_)[row * width_ + column];
  }
  std::span<const T> values() const { return *values_; }

 private:
  std::shared_ptr<const std::vector<T>> values_;
  std::size_t width_;
};

/// One instant as columns, made once; all that is handed out shares them. `unit` has the units. Signs are those of the
/// tables: tension positive in stress, pressure positive in contacts. n blocks (or NMM elements), c contacts,
/// p measured points, t crack tips. `names` lists all columns; most have a function of their own too.
class KEYBLOCK_API Frame {
 public:
  int step() const;            ///< 0 before the first
  double time() const;         ///< [time]
  double load_factor() const;  ///< by which crack growth multiplies the loads
  /// 0, and one more each time that blocks come, go, split or change their undeformed outline: a stage excavates, a
  /// crack grows. Frames of one epoch of a run have the same blocks, loops and corners in the same rows.
  int epoch() const;

  /// "blocks", "loops", "corners", "contacts", "bolts", "cracks", "points", "tips".
  static std::vector<std::string> parts();
  /// Columns of a part; those of any frame if it has no rows. Throws choice for another part.
  std::vector<std::string> names(std::string_view part) const;
  std::size_t rows(std::string_view part) const;                        ///< throws choice for another part
  bool is_integer(std::string_view part, std::string_view name) const;  ///< throws as `reals`
  /// Names of the numbers of a row, such as "x" and "y"; none for a single number. Throws choice for a column that
  /// no frame has.
  std::vector<std::string> components(std::string_view part, std::string_view name) const;
  /// Unit of a column, such as "N/m"; empty for a plain number, and if the case does not declare the units. Throws
  /// choice for one that no frame has.
  std::string unit(std::string_view part, std::string_view name) const;
  /// Throw choice for a column that is not there, or holds the other kind of numbers. A part without rows has
  /// empty columns of the same widths.
  Column<double> reals(std::string_view part, std::string_view name) const;
  Column<int> integers(std::string_view part, std::string_view name) const;

  Column<int> number() const { return integers("blocks", "block"); }  ///< n, for the whole run
  Column<int> material() const { return integers("blocks", "material"); }
  Column<double> centroid() const { return reals("blocks", "centroid"); }            ///< n × 2
  Column<double> displacement() const { return reals("blocks", "displacement"); }    ///< n × 2, of centroids
  Column<double> rotation() const { return reals("blocks", "rotation"); }            ///< n, rad, to the left
  Column<double> velocity() const { return reals("blocks", "velocity"); }            ///< n × 2
  Column<double> rotation_rate() const { return reals("blocks", "rotation_rate"); }  ///< n, rad over time
  Column<double> stress() const { return reals("blocks", "stress"); }    ///< n × 4: xx, yy, xy, zz, tension positive
  Column<double> area() const { return reals("blocks", "area"); }        ///< n
  Column<double> vertices() const { return reals("corners", "place"); }  ///< all corners × 2, loop after loop
  Column<int> loop_block() const { return integers("loops", "row"); }    ///< row of the block of each loop
  Column<int> loop_corners() const { return integers("loops", "corners"); }              ///< how many each loop has
  Column<double> point() const { return reals("points", "place"); }                      ///< p × 2
  Column<double> point_displacement() const { return reals("points", "displacement"); }  ///< p × 2
  Column<int> contact_block() const { return integers("contacts", "block"); }            ///< c, number of the block
  Column<int> contact_other() const { return integers("contacts", "other"); }            ///< c, of the other one
  Column<int> contact_state() const { return integers("contacts", "state"); }    ///< c: 0 open, 1 sticks, 2 slides
  Column<double> contact_point() const { return reals("contacts", "place"); }    ///< c × 2
  Column<double> contact_normal() const { return reals("contacts", "normal"); }  ///< c × 2, unit, out of the other
  Column<double> contact_pressure() const { return reals("contacts", "normal_force"); }  ///< c, force over thickness
  Column<double> contact_shear() const { return reals("contacts", "shear_force"); }      ///< c, force over thickness
  Column<double> contact_gap() const { return reals("contacts", "gap"); }  ///< c, positive where faces are apart

  struct Data;
  explicit Frame(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace v1
}  // namespace keyblock::api
