// Walks through both records at once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "serve/run_differences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "job/record/run_measures.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> kLeftOut{"seconds", "made_by", "outputs", "output_sha256",
                                                   "steps",   "inputs",  "unit_of", "supports"};

// Numbers of two systems of units are equal to six digits: round-off of other numbers grows in a run.
constexpr double kEqualInOtherUnits = 1e-6;

// The table of units has one entry for all items of a list: "reactions[].slope".
std::string without_numbers(const std::string& path) {
  std::string without;
  bool is_index = false;
  for (const char c : path) {
    is_index = is_index && std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!is_index) without += c;
    is_index = is_index || c == '[';
  }
  return without;
}

std::string unit_at(const Json& units, const std::string& path) {
  const Json unit = units.is_object() ? units.value(without_numbers(path), Json()) : Json();
  return unit.is_string() ? unit.get<std::string>() : std::string();
}

struct Units {
  std::string first, second;

  bool are_named() const { return !first.empty() || !second.empty(); }
  bool differ() const { return first != second; }
};

/// Walks through two values. `units_of_first` and `units_of_second` name the units of their members, or are null.
class Differences {
 public:
  Differences(bool is_of_records, Json units_of_first, Json units_of_second)
      : is_of_records_(is_of_records),
        units_of_first_(std::move(units_of_first)),
        units_of_second_(std::move(units_of_second)) {}

  void compare(const Json& a, const Json& b, const std::string& path) {
    if (found_.size() >= kMostDifferences) return;
    if (a.is_object() && b.is_object()) return compare_members(a, b, path);
    if (a.is_array() && b.is_array() && a.size() == b.size()) {
      for (std::size_t i = 0; i < a.size(); ++i) compare(a[i], b[i], path + "[" + std::to_string(i + 1) + "]");
      return;
    }
    const Units units{unit_at(units_of_first_, path), unit_at(units_of_second_, path)};
    if (a == b && !(a.is_number() && units.differ())) return;
    add(a, b, path, units);
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

  void add(const Json& a, const Json& b, const std::string& path, const Units& units) {
    Json difference{{"path", path}, {"first", a}, {"second", b}};
    if (a.is_number() && b.is_number()) {
      const std::optional<Unit> one = unit_named(units.first), other = unit_named(units.second);
      const bool is_converted = units.differ() && one && other && one->dimension == other->dimension;
      const double x = a.get<double>() * (is_converted ? one->factor : 1);
      const double y = b.get<double>() * (is_converted ? other->factor : 1);
      const double scale = std::max(std::abs(x), std::abs(y));
      const double relative = scale > 0 ? std::abs(x - y) / scale : 0;
      if (is_converted && relative <= kEqualInOtherUnits) return;
      if (scale > 0) difference["relative"] = relative;
    }
    if (units.are_named()) difference["units"] = {units.first, units.second};
    if (std::string title = is_of_records_ ? title_in_record(path) : std::string(); !title.empty())
      difference["title"] = std::move(title);
    found_.push_back(std::move(difference));
  }

  bool is_of_records_;
  Json units_of_first_, units_of_second_;
  Json found_ = Json::array();
};

}  // namespace

Json run_differences(const Json& first, const Json& second) {
  Differences differences(true, first.value("unit_of", Json()), second.value("unit_of", Json()));
  differences.compare(first, second, "");
  return std::move(differences).found();
}

Json value_differences(const Json& first, const Json& second) {
  Differences differences(false, {}, {});
  differences.compare(first, second, "");
  return std::move(differences).found();
}

}  // namespace keyblock::serve
