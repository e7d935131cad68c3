// Walks both case files side by side; rows of lists are counted under one name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/losses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "formats/case_file/keyblock_case.hpp"

namespace keyblock::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShown = 40;     // characters of a value
constexpr std::size_t kShownKeys = 6;  // of an object

std::string counted_items(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "item" : "items");
}

std::string keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  const std::size_t shown = std::min(keys.size(), kShownKeys);
  return fmt::format("{{{}{}}}", fmt::join(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     keys.size() > shown ? fmt::format(" and {} more", keys.size() - shown) : "");
}

std::string shown(const Json& value) {
  if (value.is_array()) return counted_items(value.size());
  if (value.is_object()) return keys_of(value);
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > kShown ? text.substr(0, kShown) + "…" : text;
}

class Walk {
 public:
  explicit Walk(std::span<const std::string_view> left_out = {}) : left_out_(left_out) {}

  void compare(const std::string& item, const Json& layout, const Json& a, const Json& b) {
    if (std::ranges::find(left_out_, item) != left_out_.end()) return note(item, shown(a) + " → not shown");
    if (a == b && (left_out_.empty() || a.is_primitive())) return;
    if (a.is_object() && b.is_object()) return compare_keys(item, layout, a, b);
    const bool same_length = a.is_array() && b.is_array() && a.size() == b.size();
    if (!same_length) return note(item, shown(a) + " → " + shown(b));
    const bool is_row = layout.contains("prefixItems");
    const Json& items = layout.contains("items") ? layout["items"] : empty_;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Json& part = is_row ? layout["prefixItems"][i] : items;
      compare(is_row ? item + '.' + part.value("x-key", "") : item + "[]", part, a[i], b[i]);
    }
  }

  std::vector<Loss> found() { return std::move(found_); }

 private:
  void compare_keys(const std::string& item, const Json& layout, const Json& a, const Json& b) {
    const auto child = [&](const std::string& key) { return item.empty() ? key : item + '.' + key; };
    const auto part = [&](const std::string& key) -> const Json& {
      return layout.contains("properties") && layout["properties"].contains(key) ? layout["properties"][key] : empty_;
    };
    for (const auto& [key, value] : a.items()) {
      if (key == "dialect") continue;
      if (b.contains(key))
        compare(child(key), part(key), value, b[key]);
      else
        note(child(key), shown(value) + " → nothing");
    }
    for (const auto& [key, value] : b.items())
      if (!a.contains(key)) note(child(key), "nothing → " + shown(value), true);
  }

  void note(const std::string& item, const std::string& sentence, bool is_added = false) {
    const auto [at, is_new] = index_.try_emplace(item, found_.size());
    if (is_new) found_.push_back({item, 0, sentence, is_added});
    ++found_[at->second].times;
  }

  const Json empty_ = Json::object();
  std::span<const std::string_view> left_out_;
  std::vector<Loss> found_;
  std::map<std::string, std::size_t> index_;
};

const Json& layout_of_cases() {
  static const Json layout = Json::parse(formats::case_schema());
  return layout;
}

Json case_of(const formats::Content& content) {
  return formats::fits_a_case(content) ? Json::parse(formats::kKeyblockCase.write(content)) : Json::object();
}

}  // namespace

std::vector<Loss> losses(const formats::Content& original, const formats::Content& converted) {
  Walk walk;
  Json before = case_of(original), after = case_of(converted);
  before.erase("keyblock");
  after.erase("keyblock");
  walk.compare("", layout_of_cases(), before, after);
  return walk.found();
}

std::vector<Loss> losses(const formats::Content& original, const formats::LeftOut& left_out) {
  Walk walk(left_out.items);
  Json all = case_of(original);
  all.erase("keyblock");
  walk.compare("", layout_of_cases(), all, all);
  std::vector<Loss> found = walk.found();
  const std::size_t count = original.frames.size();
  if (count > left_out.frames_shown)
    found.push_back({"frames", 1, fmt::format("{} → the last {}", counted_items(count), left_out.frames_shown)});
  return found;
}

}  // namespace keyblock::study
