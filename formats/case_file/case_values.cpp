// Replaces names by numbers in one walk over the file, with the name of the current key.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/case_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/nearest.hpp"
#include "problem/units/measure.hpp"

namespace keyblock::formats {
namespace {

constexpr std::array<std::string_view, 3> kBlockFields{"material", "block_material", "materials"};
constexpr std::array<std::string_view, 1> kJointFields{"joint_material"};
constexpr std::array<std::string_view, 1> kBoltFields{"bolt"};
constexpr std::array<std::string_view, 1> kBoltRows{"removed_bolts"};
constexpr std::size_t kNameOfLine = 8;  // place of the name in a row of a bolt between two points
constexpr std::size_t kNameOfBolt = 9;  // the same between two blocks
// Lists of rows, and the index of the material in a row.
constexpr std::array<std::string_view, 2> kBlockRows{"material_lines", "materials"};
constexpr std::array<std::string_view, 6> kJointRows{"joints", "outer",         "holes",
                                                     "cuts",   "loop_vertices", "joint_materials"};

constexpr std::array<std::string_view, 2> kTexts{kSettings, "layers"};  // their texts are not names of materials

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

class Values {
 public:
  explicit Values(JsonText& text) : text_(text) {
    name_bolts(text.root());
    const std::optional<JsonValue> analysis = text.root().member("analysis");
    if (!analysis || analysis->kind() != JsonKind::object) return;
    rocks_ = names_in(*analysis, "block_materials");
    joints_ = names_in(*analysis, "joint_materials");
  }

  /// `key`: of the value, or of the lists around it.
  void walk(const JsonValue& value, std::string_view key) {
    if (value.kind() == JsonKind::object) {
      for (auto i = value.begin(); i != value.end(); ++i) {
        const std::string_view name = (*i).string();
        ++i;
        if (is_one_of(kTexts, name)) continue;
        if ((*i).kind() == JsonKind::string)
          put(*i, name);
        else
          walk(*i, name);
      }
    } else if (value.kind() == JsonKind::array) {
      for (const JsonValue item : value) {
        if (item.kind() == JsonKind::string)
          put_in_row(item, key);
        else
          walk(item, key);
      }
    }
  }

  MaterialNames names() const { return {rocks_, joints_}; }

 private:
  // Bolts of the geometry come first, then those of the stages, in the order of their numbers.
  void name_bolts(const JsonValue& root) {
    name_bolts_of(root.member("drawing"), kNameOfLine);
    name_bolts_of(root.member("blocks"), kNameOfBolt);
    const std::optional<JsonValue> stages = root.member("stages");
    if (!stages || stages->kind() != JsonKind::array) return;
    for (const JsonValue stage : *stages) name_bolts_of(stage, kNameOfLine);
  }

  void name_bolts_of(const std::optional<JsonValue>& parent, std::size_t place) {
    if (!parent || parent->kind() != JsonKind::object) return;
    const std::optional<JsonValue> bolts = parent->member("bolts");
    if (!bolts || bolts->kind() != JsonKind::array) return;
    for (const JsonValue bolt : *bolts) {
      bolts_.emplace_back();
      if (bolt.kind() != JsonKind::array) continue;
      std::size_t at = 0;
      for (const JsonValue value : bolt) {
        if (at++ != place || value.kind() != JsonKind::string) continue;
        if (std::ranges::find(bolts_, value.string()) != bolts_.end() && !value.string().empty())
          value.fail("another name for each of the bolts");
        bolts_.back() = value.string();
      }
    }
  }

  static std::vector<std::string> names_in(const JsonValue& analysis, std::string_view list) {
    std::vector<std::string> names;
    const std::optional<JsonValue> materials = analysis.member(list);
    if (!materials || materials->kind() != JsonKind::array) return names;
    std::size_t count = 0;
    for (const JsonValue material : *materials) {
      ++count;  // those without a name take no memory until one has a name
      if (material.kind() != JsonKind::object) continue;
      const std::optional<JsonValue> name = material.member("name");
      if (!name || name->kind() != JsonKind::string) continue;
      if (std::ranges::find(names, name->string()) != names.end())
        name->fail(fmt::format("another name for each of {}", list));
      names.resize(count);
      names.back() = name->string();
    }
    return names;
  }

  void put(const JsonValue& value, std::string_view key) {
    if (is_one_of(kBlockFields, key)) return put_number(value, rocks_, "block material");
    if (is_one_of(kJointFields, key)) return put_number(value, joints_, "joint material");
    if (is_one_of(kBoltFields, key)) return put_number(value, bolts_, "bolt");
  }

  /// Numbers, possibly with units, stand next to the material of a row: the reader handles those.
  void put_in_row(const JsonValue& value, std::string_view key) {
    if (is_one_of(kBoltRows, key)) return put_number(value, bolts_, "bolt");
    const bool is_name = std::ranges::find(rocks_, value.string()) != rocks_.end() ||
                         std::ranges::find(joints_, value.string()) != joints_.end();
    if (!is_name && quantity_in(value.string())) return;
    if (is_one_of(kBlockRows, key)) put_number(value, rocks_, "block material");
    if (is_one_of(kJointRows, key)) put_number(value, joints_, "joint material");
  }

  void put_number(const JsonValue& value, const std::vector<std::string>& names, std::string_view kind) {
    const auto found = std::ranges::find(names, value.string());
    if (found == names.end() || value.string().empty()) {
      std::vector<std::string> known = names;
      std::erase(known, std::string());
      value.fail(known.empty() ? fmt::format("a number, because no {} has a name", kind)
                               : fmt::format("the number or the name of a {}, one of {}{}", kind,
                                             fmt::join(known, ", "), nearest_words(value.string(), known)));
    }
    text_.replace(value, static_cast<double>(found - names.begin() + 1));
  }

  JsonText& text_;
  std::vector<std::string> rocks_;
  std::vector<std::string> joints_;
  std::vector<std::string> bolts_;
};

}  // namespace

bool takes_name(std::string_view field) {
  return is_one_of(kBlockFields, field) || is_one_of(kJointFields, field) || is_one_of(kBoltFields, field);
}

MaterialNames resolve_names(JsonText& text) {
  Values values(text);
  values.walk(text.root(), "");
  return values.names();
}

}  // namespace keyblock::formats
