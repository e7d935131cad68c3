// Holds the blocks that a DXF file defines and an INSERT draws.
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
  Point base;                                         ///< point that an INSERT moves to its place
  std::span<const DxfRecord> records;                 ///< between BLOCK and ENDBLK
  std::shared_ptr<const DxfShapes> shapes = nullptr;  ///< after an INSERT has drawn them
  bool is_open = false;                               ///< its records are being read
  double base_height = 0;                             ///< z of the base point
};

class DxfDefinitions {
 public:
  /// Reads the section BLOCKS; null: no definitions. Throws InputError if a base point is not a number.
  DxfDefinitions(const DxfDocument& document, const DxfSection* blocks);

  /// Returns null if no definition has that name.
  DxfDefinition* find(std::string_view name);

  /// Largest number of points that all INSERT together may draw, and largest depth of nested definitions.
  static constexpr std::size_t kMostPoints = 500'000;
  static constexpr int kDeepest = 16;

  std::size_t points = 0;  ///< drawn so far
  int depth = 0;           ///< of the definition that is being read

  /// Returns the entities of definitions that no INSERT drew.
  DxfSkipped unused(const DxfDocument& document) const;

 private:
  std::map<std::string_view, DxfDefinition> definitions_;
};

}  // namespace keyblock::formats
