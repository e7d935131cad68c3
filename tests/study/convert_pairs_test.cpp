// Conversions between any two formats: what the target cannot hold is lost and named, the rest comes back equal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "study/convert/derived_geometry.hpp"
#include "tests/study/conversions.hpp"
#include "tests/support/random_contents.hpp"

namespace keyblock::study::convert_pairs_test {
namespace {

using formats::Content;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kSeeds = 40;
constexpr std::uint64_t kSeedsOfCases = 100;  // whose parts are drawn from all the others

// The names of the columns of rows, so that an item of a loss can be found in a file.
const Json kSchema = Json::parse(formats::case_schema());

// Removes the item from every place that its name means.
void remove_item(Json& value, const Json& layout, const std::string& item) {
  if (item.empty()) {
    value = nullptr;
  } else if (item.starts_with("[]")) {
    if (!value.is_array()) return;
    for (Json& part : value) remove_item(part, layout.value("items", Json::object()), item.substr(2));
  } else {
    const std::string name = item.substr(item.starts_with('.') ? 1 : 0);
    const std::string key = name.substr(0, name.find_first_of(".["));
    const std::string rest = name.substr(key.size());
    if (value.is_array() && layout.contains("prefixItems")) {
      for (std::size_t i = 0; i < value.size(); ++i)
        if (layout["prefixItems"][i]["x-key"] == key) remove_item(value[i], layout["prefixItems"][i], rest);
    } else if (value.is_object() && value.contains(key)) {
      if (rest.empty())
        value.erase(key);
      else
        remove_item(value[key], layout["properties"][key], rest);
    }
  }
}

std::string rest_of(const Content& content, const std::vector<Loss>& losses) {
  Json json = Json::parse(formats::kKeyblockCase.write(content));
  for (const Loss& loss : losses)
    if (loss.sentence.find(" → ") != std::string::npos) remove_item(json, kSchema, loss.item);
  json.erase("layers");  // of a drawing that has been read by them
  if (!json.contains("analysis")) return json.dump();
  json["analysis"].erase("dialect");
  for (const char* name : {"fixed_point_motions", "point_loads"}) {  // a point without a curve may have an empty one
    if (!json["analysis"].contains(name)) continue;
    Json& curves = json["analysis"][name];
    while (!curves.empty() && curves.back().empty()) curves.erase(curves.size() - 1);
    if (curves.empty()) json["analysis"].erase(name);
  }
  return json.dump();
}

struct ExpectedLosses {
  std::map<std::string, bool> items;  ///< whether the random contents may be too few to show it
  bool is_refused = false;
};

/// The rows of conversion_losses.txt by their pair.
std::map<std::string, ExpectedLosses> expected_losses() {
  std::map<std::string, ExpectedLosses> table;
  std::ifstream file(KEYBLOCK_SOURCE_DIR "/tests/study/conversion_losses.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t colon = line.find(": ");
    ExpectedLosses& row = table[line.substr(0, colon)];
    std::istringstream words(line.substr(colon + 2));
    for (std::string word; words >> word;) {
      if (word == "refused") row.is_refused = true;
      if (word == "refused" || word == "-") continue;
      const bool is_rare = word.starts_with('?');
      row.items.emplace(word.substr(is_rare ? 1 : 0), is_rare);
    }
  }
  return table;
}

formats::FileReading written_and_read(const support::ContentKind& kind, const Content& content) {
  formats::FileReading file = file_of(*kind.format, content);
  file.reading = kind.format->read(file.source, kind.hint(content));
  return file;
}

bool is_derivation(const Conversion& conversion) {
  return !conversion.losses.empty() && conversion.losses.front().sentence.find(" → ") == std::string::npos;
}

/// The content with the geometry that the conversion derived from it.
Content with_derived_geometry(Content content, const Conversion& conversion) {
  if (!is_derivation(conversion)) return content;
  const bool is_lines = read_back(conversion).drawing.has_value();
  const Content derived = (is_lines ? as_lines(content) : as_blocks(content)).value().content;
  content.drawing = derived.drawing;
  content.blocks = derived.blocks;
  content.cover.reset();
  return content;
}

/// The content as a plain analysis file holds it: each material has its weight, and there is no gravity.
Content with_weights(Content content, const Target& target) {
  const auto is_plain = [](const Target::Part& part) {
    return part.format == &formats::kDdaAnalysisShi || part.format == &formats::kDdaAnalysisBerkeley ||
           part.format == &formats::kNmmAnalysis;
  };
  if (!content.analysis || !content.analysis->gravity || std::ranges::none_of(target.parts, is_plain)) return content;
  for (BlockMaterial& rock : content.analysis->block_materials)
    rock.unit_weight = rock.density * *content.analysis->gravity;
  content.analysis->gravity.reset();
  return content;
}

}  // namespace

TEST(ConvertPairs, what_is_lost_between_any_two_formats_is_what_the_target_cannot_hold_and_the_rest_comes_back_equal) {
  std::map<std::string, ExpectedLosses> table = expected_losses();
  int compared = 0, derived = 0;
  for (const support::ContentKind& kind : support::content_kinds())
    for (const Target& target : targets()) {
      const std::string pair = fmt::format("{} > {}", kind.format->name, target.name);
      ASSERT_TRUE(table.contains(pair)) << pair;
      const ExpectedLosses expected = table.extract(pair).mapped();
      std::set<std::string> lost;
      bool is_refused = true;
      const std::uint64_t seeds = kind.format == &formats::kKeyblockCase ? kSeedsOfCases : kSeeds;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        Dice dice(seed);
        const formats::FileReading file = written_and_read(kind, kind.draw(dice));
        Conversion conversion;
        try {
          conversion = convert({file}, target, Faults::none);
        } catch (const InputError&) {
          continue;  // nothing of it fits, or lines drawn at random close no block
        }
        is_refused = false;
        for (const Loss& loss : conversion.losses) lost.insert(loss.item);
        if (target.parts.front().left_out != nullptr) continue;
        ++compared;
        derived += is_derivation(conversion) ? 1 : 0;
        const Content whole = with_weights(with_derived_geometry(file.reading->content, conversion), target);
        EXPECT_EQ(rest_of(whole, conversion.losses), rest_of(read_back(conversion), conversion.losses))
            << pair << ", seed " << seed;
      }
      EXPECT_EQ(is_refused, expected.is_refused) << pair;
      for (const std::string& item : lost) EXPECT_TRUE(expected.items.contains(item)) << pair << ": " << item;
      for (const auto& [item, is_rare] : expected.items)
        EXPECT_TRUE(is_rare || lost.contains(item)) << pair << ": " << item << " is never lost";
    }
  EXPECT_TRUE(table.empty()) << table.begin()->first << " is no pair";
  EXPECT_GT(compared, 1500);
  EXPECT_GT(derived, 150) << "drawings, blocks and covers";
}

TEST(ConvertPairs, each_format_into_itself_loses_nothing) {
  for (const support::ContentKind& kind : support::content_kinds())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Dice dice(seed);
      const Content content = kind.draw(dice);
      const Target* target = find_target(kind.format->name);
      ASSERT_NE(target, nullptr) << kind.format->name;
      EXPECT_EQ(items(converted(content, *target).losses), std::vector<std::string>{}) << kind.format->name << seed;
    }
}

TEST(ConvertPairs, everything_fits_the_case_file) {
  for (const support::ContentKind& kind : support::content_kinds()) {
    Dice dice(7);
    EXPECT_EQ(items(converted(kind.draw(dice), *find_target("keyblock-case")).losses), std::vector<std::string>{});
  }
}

}  // namespace keyblock::study::convert_pairs_test
