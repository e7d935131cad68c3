// Conversion from every kind of file to every target: losses are those of conversion_losses.txt, and the rest comes
// back equal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/convert.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "geometry/polygon.hpp"
#include "study/convert/derived_geometry.hpp"
#include "tests/support/content_text.hpp"
#include "tests/support/random_contents.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::study::convert_test {
namespace {

using formats::Content;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kSeeds = 40;
constexpr std::uint64_t kSeedsOfCases = 100;  // whose parts are drawn from all the others

formats::FileReading file_of(const formats::Format& format, const std::string& text, const Content& content) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", text};
  file.choice = formats::Choice{&format, {}};
  file.reading = formats::Reading{content, {}};
  return file;
}

formats::FileReading file_of(const formats::Format& format, const Content& content) {
  return file_of(format, format.write(content), content);
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
    if (read.covers) back.covers = read.covers;
    if (read.analysis) back.analysis = read.analysis;
    if (read.units) back.units = read.units;
    if (read.choices) back.choices = read.choices;
    if (read.outputs) back.outputs = read.outputs;
    if (!read.stages.empty()) back.stages = read.stages;
    if (read.motion) back.motion = read.motion;
    if (!read.frames.empty()) back.frames = read.frames;
    if (!read.tracks.empty()) back.tracks = read.tracks;
  }
  return back;
}

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

std::vector<std::string> items(const std::vector<Loss>& losses) {
  std::vector<std::string> names;
  for (const Loss& loss : losses) names.push_back(loss.item);
  return names;
}

}  // namespace

TEST(Convert, what_is_lost_between_any_two_formats_is_what_the_target_cannot_hold_and_the_rest_comes_back_equal) {
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

TEST(Convert, each_format_into_itself_loses_nothing) {
  for (const support::ContentKind& kind : support::content_kinds())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Dice dice(seed);
      const Content content = kind.draw(dice);
      const Target* target = find_target(kind.format->name);
      ASSERT_NE(target, nullptr) << kind.format->name;
      EXPECT_EQ(items(converted(content, *target).losses), std::vector<std::string>{}) << kind.format->name << seed;
    }
}

TEST(Convert, everything_fits_the_case_file) {
  for (const support::ContentKind& kind : support::content_kinds()) {
    Dice dice(7);
    EXPECT_EQ(items(converted(kind.draw(dice), *find_target("keyblock-case")).losses), std::vector<std::string>{});
  }
}

// One triangle with a bolt to itself, which moves by 0.5, and two measured points, one of them without a row.
TEST(Convert, replays_and_measured_points_fit_the_case_file) {
  const formats::Source replay{"f",
                               "1 1 1 7 1 0 1\n0 0 0  1 1 3\n"
                               "0 0 0  0 0 0  0 1 0  0 0 1  0 0 0  0 0 0  0 0 0  0 0 0\n0 0 1 0 0 0 0 0 0\n"
                               "0 0 0 0  0 0.1 0.1 1  0 0.2 0.2 1\n"
                               "0 0 0  0 0.5 0  0 1.5 0  0 0.5 1  0 0 0  0 0 0  0 0 0  0 0 0\n0.5 0 1 0 0 0 0 0 0\n"
                               "0 0 0 0  0 0.6 0.1 1  0 0.7 0.2 1\n"};
  const formats::Source measured{"f", "measpoint1=[\n1 0.5 0.5 2 3 0.1 1 -1 1.5\n];\nmeaspoint2=[];\n"};
  for (const formats::Source& source : {replay, measured}) {
    formats::FileReading file;
    file.path = "f";
    file.source = source;
    file.choice = formats::recognise(source);
    file.reading = formats::read(source);
    const Content& content = file.reading->content;
    ASSERT_EQ(content.frames.size() + content.tracks.size(), 2U);
    const Conversion conversion = convert({file}, *find_target("keyblock-case"), Faults::none);
    EXPECT_EQ(conversion.losses, std::vector<Loss>{});
    EXPECT_EQ(support::content_text(read_back(conversion)), support::content_text(content));
  }
  EXPECT_NEAR(formats::read(replay).content.frames.at(1).elements.at(0).displacement.x, 0.5, 1e-15);
}

TEST(Convert, a_format_without_results_says_that_they_are_lost) {
  Dice dice(3);
  Content content = support::content_kinds().front().draw(dice);
  content.tracks.resize(1);
  content.frames.resize(3);
  for (Frame& frame : content.frames) frame.elements.emplace_back().loops = {{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(converted(content, *find_target("dda-geometry")).losses,
            (std::vector<Loss>{{"frames", 1, "3 items → nothing"}, {"tracks", 1, "1 item → nothing"}}));
}

TEST(Convert, comments_are_kept_with_the_bytes_or_named) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", "0.01  # a comment\n4 4 0 0 0 0 0 0\n0 0 4 0. 1\n4 0 4 1 1\n4 1 0 1 1 0 1 0 0 1\n"};
  file.choice = formats::recognise(file.source);
  file.reading = formats::read(file.source);
  const auto told = [&](std::string_view target) {
    return std::ranges::count(convert({file}, *find_target(target), Faults::none).warnings, "comments_dropped",
                              &Warning::name);
  };
  EXPECT_EQ(told("dda-geometry"), 0);
  EXPECT_EQ(told("keyblock-case"), 1);
}

TEST(Convert, a_case_in_millimetres_becomes_a_drawing_in_millimetres) {
  Dice dice(1);
  Content content = support::content_kinds().front().draw(dice);
  ASSERT_TRUE(content.drawing);
  content.units = Units{"mm", "t", "s"};
  const Conversion conversion = converted(content, *find_target("dxf"));
  EXPECT_NE(conversion.files.at(0).text.find("$INSUNITS\n70\n4\n"), std::string::npos);
  std::vector<std::string> lost = items(conversion.losses);
  std::erase_if(
      lost, [](const std::string& item) { return !item.starts_with("drawing.joints") && !item.starts_with("units"); });
  EXPECT_EQ(lost, (std::vector<std::string>{"units.mass", "units.time"}));
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

// One reader takes points of 3 numbers and of 4; each target writes its own.
TEST(Convert, bytes_stay_only_where_points_have_the_size_of_the_target) {
  Content content;
  content.blocks.emplace().blocks = {{0, {{{0, 0}, 0}, {{1, 0}, 0}, {{0, 1}, 0}}, {}}};
  content.blocks->measured_points = {{{0.25, 0.25}, 0, {}}};
  const auto commented = [&](const formats::Format& format) {
    formats::FileReading file = file_of(format, "# mine\n" + format.write(content), content);
    file.choice = formats::recognise(file.source);
    return file;
  };
  for (const formats::Format* from : {&formats::kDdaBlocks, &formats::kDdaBlocksOfThree})
    for (const formats::Format* to : {&formats::kDdaBlocks, &formats::kDdaBlocksOfThree}) {
      const std::string kept = from == to ? "# mine\n" : "";
      EXPECT_EQ(convert({commented(*from)}, *find_target(to->name), Faults::none).files.at(0).text,
                kept + to->write(content))
          << from->name << " to " << to->name;
    }
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

// One loading point with two curves: the second loads nothing, and no file beside that geometry has room for it. As
// lines, each edge once: only the kind of the geometry is lost.
TEST(Convert, blocks_become_the_lines_of_a_dxf_drawing) {
  Content content;
  content.blocks.emplace().blocks = {{0, {{{0, 0}, 0}, {{2, 0}, 0}, {{2, 2}, 2}, {{0, 2}, 0}}, {}},
                                     {1, {{{2, 0}, 0}, {{4, 0}, 1}, {{4, 3}, 0}, {{2, 2}, 0}}, {}}};
  content.blocks->blocks[1].outer[0].joint_material = 2;  // both sides of the contact
  content.blocks->fixed_points = {{{1, 0.1}, 0, {}}};
  content.blocks->bolts = {{{{1, 1}, {3, 1}}, 0, 1, 5, 6, 7}};
  const Conversion drawn = converted(content, *find_target("dxf"));
  EXPECT_EQ(drawn.losses, (std::vector<Loss>{{"blocks", 1, "2 blocks as the 7 lines of their edges"}}));
  const Content cut = read_back(converted(read_back(drawn), *find_target("dda-blocks")));
  ASSERT_EQ(cut.blocks->blocks.size(), 2U);
  for (const BlockPolygon& block : cut.blocks->blocks) {
    const bool is_left = block.material == 0;
    EXPECT_EQ(area(points_of(block.outer)), is_left ? 4 : 5);
    std::vector<int> joints;
    for (const BlockVertex& vertex : block.outer) joints.push_back(vertex.joint_material);
    std::ranges::sort(joints);
    EXPECT_EQ(joints, is_left ? (std::vector<int>{0, 0, 0, 2}) : (std::vector<int>{0, 0, 1, 2}));
  }
  EXPECT_EQ(cut.blocks->fixed_points.size(), 1U);
  EXPECT_EQ(cut.blocks->bolts.at(0).pretension, 7);
}

TEST(Convert, a_curve_without_its_point_is_a_loss) {
  const auto two_loads = [](Content content) {
    content.analysis = Analysis{};
    content.analysis->step_count = 10;
    content.analysis->time_step = content.analysis->allowed_displacement_ratio = 0.01;
    content.analysis->contact_penalty = 1e8;
    content.analysis->over_relaxation = 1.5;
    content.analysis->automatic_time_step = content.analysis->automatic_penalty = true;
    content.analysis->block_materials.emplace_back().density = 1;
    content.analysis->block_materials.back().youngs_modulus = 1;
    content.analysis->joint_materials.emplace_back();
    content.analysis->point_loads = {{{0}, {{1, 2}}, {}}, {{0}, {{3, 4}}, {}}};
    return content;
  };
  Content cover, lines;
  cover.cover = support::two_triangles();
  lines.drawing.emplace().edge_node_ratio = 0.001;
  for (const Segment& line : {Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {1, 2}}, Segment{{1, 2}, {0, 0}}})
    lines.drawing->joints.push_back({line, 0, {}});
  lines.drawing->loading_points = {{{1, 0.5}, {}}};
  for (const auto& [content, target] : {std::pair{two_loads(cover), "manifold"}, std::pair{two_loads(lines), "shi"}}) {
    const Conversion conversion = converted(content, *find_target(target));
    EXPECT_TRUE(std::ranges::count(conversion.losses, Loss{"analysis.point_loads", 1, "2 items → 1 item"}) == 1)
        << target << ": " << fmt::format("{}", fmt::join(items(conversion.losses), ", "));
    EXPECT_EQ(read_back(conversion).analysis->point_loads.at(0).at(0), (Point{1, 2})) << target;
  }
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

// Shi's program runs with material 1 of 1; the case names it, so that it runs too, and the change is a loss.
TEST(Convert, material_numbers_out_of_range_become_the_nearest_in_a_case_file) {
  Content content;
  Blocks& blocks = content.blocks.emplace();
  blocks.blocks.push_back({-1, {{{0, 0}, 2}, {{1, 0}, 0}, {{0, 1}, 0}}, {}});
  content.analysis = support::plain_analysis(1e-3, 1);
  const auto from = [&](const formats::Format& format) {
    return convert({file_of(format, "", content)}, *find_target("keyblock-case"), Faults::none);
  };
  const Conversion conversion = from(formats::kDdaBlocks);
  const Content back = read_back(conversion);
  EXPECT_EQ(back.blocks->blocks[0].material, 0);
  EXPECT_EQ(back.blocks->blocks[0].outer[0].joint_material, 0);
  std::vector<std::string> lost;
  for (const Loss& loss : conversion.losses) lost.push_back(loss.item + ": " + loss.sentence);
  EXPECT_EQ(lost, (std::vector<std::string>{"blocks.blocks[].material: 0 → 1",
                                            "blocks.blocks[].outer[].joint_material: 3 → 1"}));
  EXPECT_TRUE(from(formats::kKeyblockCase).losses.empty()) << "the reader of case files reports them";
}

TEST(Convert, faults_of_the_berkeley_program_are_taken_on_request) {
  Content content;
  Drawing& drawing = content.drawing.emplace();
  drawing.edge_node_ratio = 0.01;
  drawing.joints = {{{{0, 0}, {1, 0}}, 0, {}}};
  drawing.material_lines = {{{{0, 0}, {1, 0}}, 1, {}}, {{{0, 1}, {1, 1}}, 2, {}}};
  const std::vector<formats::FileReading> files{file_of(formats::kDdaGeometry, content)};
  const Content faulty = read_back(convert(files, *find_target("dda-geometry"), Faults::berkeley));
  ASSERT_EQ(faulty.drawing->material_lines.size(), 1U);
  EXPECT_EQ(faulty.drawing->material_lines[0].block_material, 2);
  EXPECT_EQ(read_back(convert(files, *find_target("dda-geometry"), Faults::none)).drawing->material_lines.size(), 2U);
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

TEST(Convert, what_a_view_does_not_show_is_lost) {
  Content content;
  content.blocks.emplace().blocks = {{1, {{{0, 0}, 2}, {{1, 0}, 0}, {{0, 1}, 0}}, {}}};
  content.blocks->fixed_points = {{{0.25, 0.5}, 0, {}}};
  content.units = Units{"m", "t", "s"};
  EXPECT_EQ(converted(content, *find_target("csv")).losses,
            (std::vector<Loss>{{"units", 1, "{length, mass, time} → not shown"},
                               {"blocks.blocks[].material", 1, "2 → not shown"},
                               {"blocks.fixed_points[].block", 1, "1 → not shown"}}));
  EXPECT_EQ(converted(content, *find_target("vtk")).losses,
            (std::vector<Loss>{{"units", 1, "{length, mass, time} → not shown"},
                               {"blocks.blocks[].outer[].joint_material", 3, "3 → not shown"},
                               {"blocks.fixed_points", 1, "1 item → not shown"}}));
  content.frames.resize(3);
  for (Frame& frame : content.frames) frame.bolts.resize(1);
  content.tracks.resize(1);
  const std::vector<Loss> of_grid = converted(content, *find_target("vtk")).losses;
  for (const Loss& loss :
       {Loss{"blocks", 1, "{blocks, fixed_points} → not shown"}, Loss{"frames", 1, "3 items → the last 1"},
        Loss{"tracks", 1, "1 item → not shown"}, Loss{"frames[].bolts", 3, "1 item → not shown"}})
    EXPECT_EQ(std::ranges::count(of_grid, loss), 1) << loss.item;
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

TEST(Convert, plain_files_hold_the_weight_that_gravity_gives) {
  Content content;
  content.analysis.emplace();
  content.analysis->gravity = 10;
  content.analysis->step_count = 1;
  content.analysis->time_step = content.analysis->allowed_displacement_ratio = 0.01;
  content.analysis->block_materials = {BlockMaterial{}};
  content.analysis->block_materials[0].density = 2500;
  content.analysis->block_materials[0].youngs_modulus = 1e9;
  content.analysis->joint_materials = {JointMaterial{}};
  for (const char* target : {"dda-analysis-shi", "dda-analysis-berkeley", "nmm-analysis"}) {
    const Conversion conversion = converted(content, *find_target(target));
    EXPECT_EQ(read_back(conversion).analysis->block_materials[0].unit_weight, 25000) << target;
    for (const Loss& loss : conversion.losses) EXPECT_NE(loss.item, "analysis.gravity") << target;
  }
}

}  // namespace keyblock::study::convert_test
