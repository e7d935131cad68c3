// The blocks that a DXF file defines and an INSERT draws.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "formats/dxf/dxf_groups.hpp"
#include "formats/dxf/dxf_skipped.hpp"
#include "geometry/point.hpp"

namespace keyblock::formats {

struct DxfShapes;

struct DxfDefinition {
  Point base;                                         ///< what an INSERT puts at its place
  std::span<const DxfRecord> records;                 ///< between BLOCK and ENDBLK
  std::shared_ptr<const DxfShapes> shapes = nullptr;  ///< once an INSERT asked for them
  bool is_open = false;                               ///< its records are being read
  double base_height = 0;                             ///< z of the base point
};

class DxfDefinitions {
 public:
  /// Of the section BLOCKS; null: none. Throws InputError where a base point is no number.
  DxfDefinitions(const DxfDocument& document, const DxfSection* blocks);

  /// Null where there is none of that name.
  DxfDefinition* find(std::string_view name);

  /// Points that all INSERT together may draw, and depth to which definitions may hold one another.
  static constexpr std::size_t kMostPoints = 500'000;
  static constexpr int kDeepest = 16;

  std::size_t points = 0;  ///< drawn so far
  int depth = 0;           ///< of the definition that is being read

  /// Entities of definitions that no INSERT drew.
  DxfSkipped unused(const DxfDocument& document) const;

 private:
  std::map<std::string_view, DxfDefinition> definitions_;
};

}  // namespace keyblock::formats
