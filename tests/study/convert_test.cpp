// From every kind of case to every target: what is lost is named, and the rest comes back equal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "formats/dda_geometry.hpp"
#include "formats/keyblock_case.hpp"
#include "tests/support/random_contents.hpp"

namespace keyblock::study {
namespace {

using formats::Content;
using Json = nlohmann::ordered_json;

formats::FileReading file_of(const formats::Format& format, const Content& content) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", format.write(content)};
  file.choice = formats::recognise(file.source);
  file.reading = formats::Reading{content, {}};
  return file;
}

Conversion converted(const Content& content, const Target& target) {
  return convert({file_of(formats::kKeyblockCase, content)}, target, Faults::none);
}

Content read_back(const Conversion& conversion) {
  Content back;
  for (const ConvertedFile& file : conversion.files) {
    const Content read = file.format->read({"f", file.text}, conversion.hint).content;
    if (read.drawing) back.drawing = read.drawing;
    if (read.blocks) back.blocks = read.blocks;
    if (read.cover) back.cover = read.cover;
    if (read.analysis) back.analysis = read.analysis;
    if (read.units) back.units = read.units;
    if (read.choices) back.choices = read.choices;
    if (read.motion) back.motion = read.motion;
  }
  return back;
}

// The names of the columns of rows, so that an item of a loss can be found in a file.
const Json kSchema = Json::parse(formats::case_schema());

// Takes the item out of every place that its name means.
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
        if (layout["prefixItems"][i]["title"] == key) remove_item(value[i], layout["prefixItems"][i], rest);
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
  for (const Loss& loss : losses) remove_item(json, kSchema, loss.item);
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

std::vector<std::string> items(const std::vector<Loss>& losses) {
  std::vector<std::string> names;
  for (const Loss& loss : losses) names.push_back(loss.item);
  return names;
}

}  // namespace

// The geometry of such a pair is held by the target; derived ones are tested below.
TEST(Convert, what_is_not_named_as_lost_comes_back_equal_between_all_formats) {
  int pairs = 0;
  for (const testing::ContentKind& kind : testing::content_kinds())
    for (const Target& target : targets())
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Dice dice(seed);
        if (!target.parts.front().format->read) continue;  // a view
        const Content content = kind.draw(dice);
        Conversion conversion;
        try {
          conversion = converted(content, target);
        } catch (const InputError&) {
          continue;  // nothing of it fits, or lines drawn at random close no block
        }
        const std::vector<std::string> lost = items(conversion.losses);
        const bool is_derived =
            !conversion.losses.empty() && conversion.losses.front().sentence.find(" → ") == std::string::npos;
        if (is_derived) continue;
        ++pairs;
        EXPECT_EQ(rest_of(content, conversion.losses), rest_of(read_back(conversion), conversion.losses))
            << kind.format->name << " to " << target.name << ", seed " << seed << ": "
            << fmt::format("{}", fmt::join(lost, ", "));
      }
  EXPECT_GT(pairs, 600);
}

TEST(Convert, each_format_into_itself_loses_nothing) {
  for (const testing::ContentKind& kind : testing::content_kinds())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Dice dice(seed);
      const Content content = kind.draw(dice);
      const Target* target = find_target(kind.format->name);
      ASSERT_NE(target, nullptr) << kind.format->name;
      EXPECT_EQ(items(converted(content, *target).losses), std::vector<std::string>{}) << kind.format->name << seed;
    }
}

TEST(Convert, everything_fits_the_case_file) {
  for (const testing::ContentKind& kind : testing::content_kinds()) {
    Dice dice(7);
    EXPECT_EQ(items(converted(kind.draw(dice), *find_target("keyblock-case")).losses), std::vector<std::string>{});
  }
}

TEST(Convert, a_file_whose_content_stays_comes_out_with_the_same_bytes) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", "0.01  # a comment\n4 4 0 0 0 0 0 0\n0 0 4 0. 1\n4 0 4 1 1\n4 1 0 1 1 0 1 0 0 1\n"};
  file.choice = formats::recognise(file.source);
  file.reading = formats::read(file.source);
  const Conversion same = convert({file}, *find_target("dda-geometry"), Faults::none);
  EXPECT_EQ(same.files.at(0).text, file.source.text);
}

// A square of two halves as lines: cut into blocks, and the blocks as lines again.
TEST(Convert, lines_become_blocks_and_blocks_become_lines) {
  Content content;
  Drawing& drawing = content.drawing.emplace();
  drawing.edge_node_ratio = 0.001;
  for (const Segment& line : {Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {2, 1}}, Segment{{2, 1}, {0, 1}},
                              Segment{{0, 1}, {0, 0}}, Segment{{1, -0.5}, {1, 1.5}}})
    drawing.joints.push_back({line, 0, {}});
  drawing.material_lines = {{{{1.2, 0.5}, {1.4, 0.5}}, 1, {}}};
  drawing.fixed_lines = {{{{0.5, 0.5}, {0.5, 0.5}}, {}}};
  const Conversion cut = converted(content, *find_target("dda-blocks"));
  EXPECT_EQ(cut.losses, (std::vector<Loss>{{"drawing", 1, "cut into 2 blocks"}}));
  const Content blocks = cut.files.at(0).format->read({"f", cut.files[0].text}, {}).content;
  const Conversion lines = converted(blocks, *find_target("dda-geometry"));
  EXPECT_EQ(lines.losses, (std::vector<Loss>{{"blocks", 1, "2 blocks as the 7 lines of their edges"}}));
  const Content again = formats::kDdaGeometry.read({"f", lines.files.at(0).text}, {}).content;
  const Conversion recut = converted(again, *find_target("dda-blocks"));
  const Content same = recut.files.at(0).format->read({"f", recut.files[0].text}, {}).content;
  ASSERT_EQ(same.blocks->blocks.size(), 2U);
  std::vector<int> materials{same.blocks->blocks[0].material, same.blocks->blocks[1].material};
  std::ranges::sort(materials);
  EXPECT_EQ(materials, (std::vector<int>{0, 1}));
  EXPECT_EQ(same.blocks->fixed_points.size(), 1U);
}

TEST(Convert, what_an_old_format_cannot_hold_is_named) {
  Content content;
  content.drawing.emplace().edge_node_ratio = 0.01;
  content.drawing->joints = {{{{0, 0}, {1, 0}}, 0, {}}};
  Analysis& analysis = content.analysis.emplace();
  analysis.step_count = 10;
  analysis.time_step = 0.01;
  analysis.allowed_displacement_ratio = 0.1;
  analysis.automatic_time_step = analysis.automatic_penalty = true;
  analysis.plane_strain = true;
  BlockMaterial rock;
  rock.density = 1;
  rock.youngs_modulus = 1;
  rock.initial_strain = {1, 0, 0};
  analysis.block_materials = {rock};
  analysis.joint_materials = {JointMaterial{}};
  content.choices = RunChoices{"standard", {}};
  const Conversion conversion = converted(content, *find_target("berkeley"));
  EXPECT_EQ(items(conversion.losses),
            (std::vector<std::string>{"analysis.plane_strain", "analysis.block_materials[].initial_strain.xx", "run"}));
}

TEST(Convert, faults_of_the_berkeley_program_are_taken_on_request) {
  Content content;
  Drawing& drawing = content.drawing.emplace();
  drawing.edge_node_ratio = 0.01;
  drawing.joints = {{{{0, 0}, {1, 0}}, 0, {}}};
  drawing.material_lines = {{{{0, 0}, {1, 0}}, 1, {}}, {{{0, 1}, {1, 1}}, 2, {}}};
  const Conversion faulty =
      convert({file_of(formats::kKeyblockCase, content)}, *find_target("dda-geometry"), Faults::berkeley);
  EXPECT_EQ(faulty.warnings.at(0).name, "first_material_line_lost");
  const Content read = formats::kDdaGeometry.read({"f", faulty.files.at(0).text}, {}).content;
  ASSERT_EQ(read.drawing->material_lines.size(), 1U);
  EXPECT_EQ(read.drawing->material_lines[0].block_material, 2);
}

TEST(Convert, blocks_are_shown_as_polygons_and_as_a_table) {
  Content content;
  content.blocks.emplace().blocks = {{1, {{{0, 0}, 2}, {{1, 0}, 0}, {{0, 1}, 0}}, {}}};
  content.blocks->fixed_points = {{{0.25, 0.5}, 0, {}}};
  EXPECT_EQ(converted(content, *find_target("csv")).files.at(0).text,
            "kind,part,loop,x,y,material\nblock,1,1,0,0,3\nblock,1,1,1,0,1\nblock,1,1,0,1,1\nfixed,1,1,0.25,0.5,1\n");
  const std::string grid = converted(content, *find_target("vtk")).files.at(0).text;
  EXPECT_NE(grid.find("NumberOfPoints=\"3\" NumberOfCells=\"1\""), std::string::npos);
}

TEST(Convert, what_does_not_fit_between_geometry_and_analysis_is_said) {
  Content content;
  content.drawing.emplace().joints = {{{{0, 0}, {1, 0}}, 2, {}}};
  content.drawing->edge_node_ratio = 0.01;
  Analysis& analysis = content.analysis.emplace();
  analysis.block_materials.resize(1);
  analysis.joint_materials.resize(1);
  analysis.point_loads.resize(1);
  const Conversion conversion = converted(content, *find_target("dda-geometry"));
  std::vector<std::string> names;
  for (const Warning& warning : conversion.warnings) names.push_back(warning.name);
  EXPECT_EQ(names, (std::vector<std::string>{"joint_material_clamped", "surplus_load_curves"}));
}

}  // namespace keyblock::study
