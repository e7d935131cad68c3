// Conversion from every kind of file to every target: losses are those of conversion_losses.txt, and the rest comes
// back equal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/convert.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "formats/case_file/keyblock_case.hpp"
#include "formats/shi/dda_analysis.hpp"
#include "formats/shi/dda_blocks.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "formats/shi/nmm_analysis.hpp"
#include "geometry/polygon.hpp"
#include "tests/study/conversions.hpp"
#include "tests/support/content_text.hpp"
#include "tests/support/random_contents.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/two_triangles.hpp"

namespace keyblock::study::convert_test {

using formats::Content;

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
