// Holds one instant of a run as the page of a run takes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"

namespace keyblock::report {

/// Bodies before any displacement.
struct PageShape {
  std::vector<std::uint32_t> key;        ///< of each body, the same in all shapes of a run
  std::vector<std::uint32_t> number;     ///< shown to the reader
  std::vector<std::uint32_t> material;   ///< index from 0
  std::vector<std::uint32_t> kind;       ///< see `kElementOnCovers`, `kFixedBody`
  std::vector<std::uint32_t> loop_body;  ///< row of the body of each outline and hole
  std::vector<std::uint32_t> loop_size;
  std::vector<Point> places;  ///< corners, loop after loop

  std::size_t bodies() const { return key.size(); }
};

inline constexpr std::uint32_t kElementOnCovers = 1;
inline constexpr std::uint32_t kFixedBody = 256;

enum class PageRowsOf { body, vertex };

/// Meaning of the numbers of bodies or vertices.
struct PageField {
  std::string name;
  std::string label;
  std::string unit;
  PageRowsOf on = PageRowsOf::body;
  std::vector<std::string> components = {};  ///< names of the numbers of a row; empty: one
  std::vector<std::string> states = {};      ///< words for 0, 1, 2, …; empty: a real number
  int bits = 10;                             ///< of fraction, of a real number

  std::size_t parts() const { return components.empty() ? 1 : components.size(); }
};

struct PageValues {
  PageField field;
  std::vector<double> numbers;  ///< row after row
};

/// Column of a table in time.
struct PageColumn {
  std::string name;
  std::string unit;
  std::size_t parts = 1;
  bool is_whole = false;                 ///< not negative, without fraction
  bool is_place = false;                 ///< x, y, x, y, …: the page counts them from its origin
  std::vector<std::string> states = {};  ///< words for 0, 1, 2, …
  std::vector<double> numbers = {};      ///< row after row
};

/// Contacts, bolts, cracks, points or tips.
struct PageRows {
  std::string name;
  std::size_t count = 0;
  std::vector<PageColumn> columns;
};

struct PageFrame {
  int step = 0;
  double time = 0;
  std::optional<double> load_factor = {};  ///< of a static run that has one
  std::string stage = {};
  bool is_static = false;
  PageShape shape = {};
  std::vector<Point> moves = {};  ///< displacement of each corner
  std::vector<PageValues> values = {};
  std::vector<PageRows> parts = {};  ///< those recorded at this instant
};

}  // namespace keyblock::report
