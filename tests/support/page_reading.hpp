// Reads the page of a run back, as its script does.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace keyblock::support {

/// Geometry of an epoch.
struct ReadShape {
  std::vector<std::uint32_t> key, number, material, kind, loop_body, loop_size;
  std::vector<float> centroid, place;  ///< x, y, x, y, …
};

class ReadPage {
 public:
  /// Precondition: the text is a page with a head.
  explicit ReadPage(std::string text);

  const nlohmann::json& head() const { return head_; }
  const std::string& text() const { return text_; }

  ReadShape shape(std::size_t epoch) const;

  /// Returns the number of a row in a frame; throws std::out_of_range if the frame has no such field.
  float value(const std::string& field, std::size_t part, std::size_t frame, std::size_t row) const;

  /// Returns the columns of a table in time at a frame, by name, row after row; whole numbers as reals.
  std::map<std::string, std::vector<double>> rows(const std::string& what, std::size_t frame) const;

 private:
  std::string bytes(const std::string& id) const;
  const nlohmann::json& chunk(const std::string& what, std::size_t frame) const;

  std::string text_;
  nlohmann::json head_;
};

}  // namespace keyblock::support
