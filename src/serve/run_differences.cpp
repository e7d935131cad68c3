// Walks through both records at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/run_differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <string>
#include <string_view>

namespace keyblock::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> kLeftOut{"seconds", "made_by", "outputs", "output_sha256",
                                                   "steps",   "inputs",  "unit_of", "supports"};

class Differences {
 public:
  explicit Differences(bool is_of_records) : is_of_records_(is_of_records) {}

  void compare(const Json& a, const Json& b, const std::string& path) {
    if (found_.size() >= kMostDifferences || a == b) return;
    if (a.is_object() && b.is_object()) return compare_members(a, b, path);
    if (a.is_array() && b.is_array() && a.size() == b.size()) {
      for (std::size_t i = 0; i < a.size(); ++i) compare(a[i], b[i], path + "[" + std::to_string(i + 1) + "]");
      return;
    }
    add(a, b, path);
  }

  Json found() && { return std::move(found_); }

 private:
  void compare_members(const Json& a, const Json& b, const std::string& path) {
    const auto inner = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    const auto is_left_out = [&](const std::string& key) {
      return is_of_records_ && path.empty() && std::ranges::find(kLeftOut, key) != kLeftOut.end();
    };
    for (const auto& [key, value] : a.items())
      if (!is_left_out(key)) compare(value, b.value(key, Json()), inner(key));
    for (const auto& [key, value] : b.items())
      if (!is_left_out(key) && !a.contains(key)) compare(Json(), value, inner(key));
  }

  void add(const Json& a, const Json& b, const std::string& path) {
    Json difference{{"path", path}, {"first", a}, {"second", b}};
    if (a.is_number() && b.is_number()) {
      const double x = a, y = b;
      const double scale = std::max(std::abs(x), std::abs(y));
      if (scale > 0) difference["relative"] = std::abs(x - y) / scale;
    }
    found_.push_back(std::move(difference));
  }

  bool is_of_records_;
  Json found_ = Json::array();
};

// The table of units has one entry for all items of a list: "reactions[].slope".
std::string without_numbers(const std::string& path) {
  static const std::regex kIndex("\\[[0-9]+\\]");
  return std::regex_replace(path, kIndex, "[]");
}

std::string unit_at(const Json& record, const std::string& path) {
  const Json units = record.value("unit_of", Json());
  const Json unit = units.is_object() ? units.value(path, Json()) : Json();
  return unit.is_string() ? unit.get<std::string>() : std::string();
}

}  // namespace

Json run_differences(const Json& first, const Json& second) {
  Differences differences(true);
  differences.compare(first, second, "");
  Json found = std::move(differences).found();
  for (Json& difference : found) {
    const std::string path = without_numbers(difference["path"]);
    const std::string one = unit_at(first, path), other = unit_at(second, path);
    if (!one.empty() || !other.empty()) difference["units"] = {one, other};
  }
  return found;
}

Json value_differences(const Json& first, const Json& second) {
  Differences differences(false);
  differences.compare(first, second, "");
  return std::move(differences).found();
}

}  // namespace keyblock::serve
