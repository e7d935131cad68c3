// Omissions of the views: every item they name is one of the case file, and their output does not depend on it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/views.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "formats/case_file/keyblock_case.hpp"
#include "tests/formats/reading.hpp"
#include "tests/support/random_contents.hpp"

namespace keyblock::formats::views_test {
namespace {

using Json = nlohmann::ordered_json;

/// Hands every value that the item means to `visit`; false if the schema has no such item.
template <class Visit>
bool visit_item(Json* value, const Json& layout, const std::string& item, Visit visit) {
  if (item.empty()) {
    if (value) visit(*value);
    return true;
  }
  if (item.starts_with("[]")) {
    if (!layout.contains("items")) return false;
    bool is_known = true;
    if (!value || value->empty()) return visit_item(nullptr, layout["items"], item.substr(2), visit);
    for (Json& part : *value) is_known = visit_item(&part, layout["items"], item.substr(2), visit) && is_known;
    return is_known;
  }
  const std::string name = item.substr(item.starts_with('.') ? 1 : 0);
  const std::string key = name.substr(0, name.find_first_of(".["));
  const std::string rest = name.substr(key.size());
  for (std::size_t i = 0; i < layout.value("prefixItems", Json::array()).size(); ++i)
    if (layout["prefixItems"][i]["x-key"] == key)
      return visit_item(value ? &(*value)[i] : nullptr, layout["prefixItems"][i], rest, visit);
  if (!layout.contains("properties") || !layout["properties"].contains(key)) return false;
  Json* part = value && value->contains(key) ? &(*value)[key] : nullptr;
  return visit_item(part, layout["properties"][key], rest, visit);
}

struct View {
  const Format* format;
  LeftOut (*left_out)(const Content&);
};

const std::vector<View> kViews{{&kVtk, left_out_by_vtk}, {&kCsv, left_out_by_csv}};

}  // namespace

TEST(Views, a_value_that_is_left_out_changes_nothing_and_has_its_place_in_a_case_file) {
  const Json schema = Json::parse(case_schema());
  int changes = 0;
  for (const support::ContentKind& kind : support::content_kinds())
    for (const View& view : kViews)
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Dice dice(seed);
        const Content content = kind.draw(dice);
        std::string text;
        try {
          text = view.format->write(content);
        } catch (const std::invalid_argument&) {
          continue;
        }
        Json other = Json::parse(kKeyblockCase.write(content));
        for (const std::string_view item : view.left_out(content).items) {
          const bool is_known = visit_item(&other, schema, std::string(item), [&](Json& value) {
            if (!value.is_number() || value == 0) return;
            if (value.is_number_integer())
              value = 1;
            else
              value = 0.25;
            ++changes;
          });
          EXPECT_TRUE(is_known) << item;
        }
        EXPECT_EQ(view.format->write(read({"f", other.dump()}).content), text) << kind.format->name << seed;
      }
  EXPECT_GT(changes, 300);
}

TEST(Views, all_frames_make_the_table_and_the_last_one_the_grid) {
  Content content;
  content.frames.resize(3);
  for (Frame& frame : content.frames) frame.elements.emplace_back().loops = {{{0, 0}, {1, 0}, {0, 1}}};
  content.frames.back().time = 0.25;
  EXPECT_EQ(left_out_by_csv(content).frames_shown, 3U);
  EXPECT_EQ(left_out_by_vtk(content).frames_shown, 1U);
  const std::string table = kCsv.write(content);
  EXPECT_EQ(std::ranges::count(table, '\n'), 4);
  EXPECT_NE(kVtk.write(content).find(">0.25<"), std::string::npos);
}

}  // namespace keyblock::formats::views_test
