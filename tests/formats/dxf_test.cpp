// DXF: every entity gets its place, curves keep their tolerance, messages list skipped entities and place faults, and
// written files are read again.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cut/bodies/cut_blocks.hpp"
#include "formats/dxf/curves/dxf_curves.hpp"
#include "geometry/polygon.hpp"
#include "tests/formats/dxf_samples.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dxf_test {
namespace {

std::string line(const std::string& layer, const std::string& more = "") {
  return "0\nLINE\n8\n" + layer + "\n10\n0\n20\n0\n11\n1000\n21\n2000\n" + more;
}

std::string circle(const std::string& more) {
  return "0\nCIRCLE\n8\nJOINT_1\n10\n3\n20\n0\n40\n2\n" + more;
}

/// x, y of a corner and the joint material, from 1, of the side that begins there.
struct Corner {
  int x, y, joint;
};

std::string outline(const std::string& layer, const std::vector<Corner>& corners) {
  std::string text = "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n70\n1\n";
  for (const Corner& c : corners) text += fmt::format("0\nVERTEX\n8\nJOINT_{}\n10\n{}\n20\n{}\n", c.joint, c.x, c.y);
  return text + "0\nSEQEND\n";
}

Reading read_entities(const std::string& entities, const std::string& header = "") {
  return read({"f", dxf_text(entities, header)});
}

std::string sentence(const Reading& reading, const std::string& name) {
  for (const Warning& warning : reading.warnings)
    if (warning.name == name) return to_string(warning);
  return "";
}

void expect_same(const Drawing& a, const Drawing& b) {
  EXPECT_EQ(a.edge_node_ratio, b.edge_node_ratio);
  EXPECT_EQ(a.boundary_count, b.boundary_count);
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    EXPECT_EQ(a.joints[i].segment, b.joints[i].segment);
    EXPECT_EQ(a.joints[i].joint_material, b.joints[i].joint_material);
  }
  ASSERT_EQ(a.material_lines.size(), b.material_lines.size());
  for (std::size_t i = 0; i < a.material_lines.size(); ++i) {
    EXPECT_EQ(a.material_lines[i].segment, b.material_lines[i].segment);
    EXPECT_EQ(a.material_lines[i].block_material, b.material_lines[i].block_material);
  }
  ASSERT_EQ(a.bolts.size(), b.bolts.size());
  for (std::size_t i = 0; i < a.bolts.size(); ++i) {
    EXPECT_EQ(a.bolts[i].segment, b.bolts[i].segment);
    EXPECT_EQ(a.bolts[i].stiffness, b.bolts[i].stiffness);
    EXPECT_EQ(a.bolts[i].strength, b.bolts[i].strength);
    EXPECT_EQ(a.bolts[i].pretension, b.bolts[i].pretension);
    EXPECT_EQ(a.bolts[i].type, b.bolts[i].type);
  }
  ASSERT_EQ(a.fixed_lines.size(), b.fixed_lines.size());
  for (std::size_t i = 0; i < a.fixed_lines.size(); ++i) EXPECT_EQ(a.fixed_lines[i].segment, b.fixed_lines[i].segment);
  const auto same_points = [](const std::vector<MarkedPoint>& p, const std::vector<MarkedPoint>& q) {
    return std::ranges::equal(p, q, {}, &MarkedPoint::position, &MarkedPoint::position);
  };
  EXPECT_TRUE(same_points(a.loading_points, b.loading_points));
  EXPECT_TRUE(same_points(a.measured_points, b.measured_points));
  EXPECT_TRUE(same_points(a.hole_points, b.hole_points));
}

}  // namespace

TEST(Dxf, every_entity_lands_in_its_place) {
  const Reading reading = read({"f", kDxfSample});
  const Drawing& drawing = *reading.content.drawing;
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"dxf_curves_as_chords", "dxf_skipped"}));
  EXPECT_EQ(drawing.edge_node_ratio, 0.01);
  EXPECT_EQ(drawing.boundary_count, 4u);
  EXPECT_EQ(drawing.joints[3].segment, (Segment{{0, 6}, {0, 0}}));
  // 1 line, a semicircle of 16 chords and a straight side, an arc of 16, a circle of 32.
  ASSERT_EQ(drawing.joints.size(), 4u + 1 + 17 + 16 + 32);
  EXPECT_EQ(drawing.joints[4].segment, (Segment{{0, 3}, {8, 3}}));
  EXPECT_EQ(drawing.joints[4].joint_material, 1);
  EXPECT_EQ(drawing.joints[21].segment, (Segment{{6, 3}, {8, 3}}));
  EXPECT_EQ(drawing.joints[21].joint_material, 2);
  EXPECT_EQ(drawing.material_lines.at(0).block_material, 1);
  EXPECT_EQ(drawing.bolts.at(0).strength, 2e3);
  EXPECT_EQ(drawing.fixed_lines.at(0).segment, (Segment{{.5, .5}, {.5, .5}}));
  EXPECT_EQ(drawing.loading_points.at(0).position, (Point{7, 5}));
  EXPECT_EQ(drawing.measured_points.at(0).position, (Point{7, 4}));
  EXPECT_EQ(drawing.hole_points.at(0).position, (Point{2, 1.5}));
  EXPECT_EQ(sentence(reading, "dxf_skipped"), "f:136:1: warning: skipped: 1 × TEXT [dxf_skipped]");
}

TEST(Dxf, chords_leave_their_arc_by_no_more_than_the_stated_share_of_the_radius) {
  for (const double bulge : {0.01, 0.3, 1.0, -1.0, 5.0, -0.2}) {
    const Point start{2, 1}, end{5, 5};
    std::vector<Point> points = bulge_points(start, end, bulge);
    // The circle through the ends and the point at which the arc stands out by bulge times half the chord, to the
    // right.
    const Point middle = 0.5 * (start + end), right = (1.0 / 5) * Point{4, -3};
    const Point apex = middle + 2.5 * bulge * right;
    const double radius = 2.5 * (1 + bulge * bulge) / (2 * std::abs(bulge));
    const Point centre = apex - (bulge > 0 ? radius : -radius) * right;
    points.insert(points.begin(), start);
    points.push_back(end);
    double nearest_apex = 10;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(distance(points[i], centre), radius, 1e-12 * radius);
      nearest_apex = std::min(nearest_apex, distance(points[i], apex));
      if (i == 0) continue;
      const double sagitta = radius - distance(0.5 * (points[i - 1] + points[i]), centre);
      EXPECT_LE(sagitta, kSagittaRatio * radius * (1 + 1e-9)) << bulge;
    }
    EXPECT_LE(nearest_apex, 0.15 * radius) << "the arc runs on the right side of its chord";
  }
  EXPECT_EQ(bulge_points({0, 0}, {1, 0}, 0).size(), 0u);
}

TEST(Dxf, coordinates_are_brought_to_metres_and_the_factor_is_named) {
  const Reading millimetres = read_entities(line("JOINT_1"), "9\n$INSUNITS\n70\n4\n");
  EXPECT_EQ(millimetres.content.drawing->joints.at(0).segment.end, (Point{1, 2}));
  EXPECT_NE(sentence(millimetres, "dxf_scaled_to_metres").find("multiplied by 0.001"), std::string::npos);
  const std::string ends = "10\n0\n20\n0\n11\n39800\n21\n200\n";
  const Reading exact = read_entities("0\nLINE\n8\nJOINT_1\n" + ends, "9\n$INSUNITS\n70\n4\n");
  EXPECT_EQ(exact.content.drawing->joints.at(0).segment.end, (Point{39.8, 0.2})) << "not 39.800000000000004";
  const Reading feet = read_entities(line("JOINT_1"), "9\n$INSUNITS\n70\n2\n");
  EXPECT_NEAR(feet.content.drawing->joints.at(0).segment.end.x, 304.8, 1e-12);
  for (const char* header : {"", "9\n$INSUNITS\n70\n0\n", "9\n$INSUNITS\n70\n6\n"}) {
    const Reading as_is = read_entities(line("JOINT_1"), header);
    EXPECT_EQ(as_is.content.drawing->joints.at(0).segment.end, (Point{1000, 2000}));
    EXPECT_EQ(as_is.warnings, Warnings{});
    EXPECT_EQ(as_is.content.units.has_value(), std::string(header).ends_with("6\n")) << header;
  }
  EXPECT_EQ(millimetres.content.units, (Units{"m", "", ""}));
  EXPECT_EQ(names(read_entities(line("JOINT_1"), "9\n$INSUNITS\n70\n77\n").warnings),
            std::vector<std::string>{"dxf_unit_unknown"});
}

TEST(Dxf, a_drawing_without_unit_beside_a_case_that_has_one_is_told) {
  for (const char* header : {"", "9\n$INSUNITS\n70\n0\n"}) {
    ReadHint hint;
    hint.length = "mm";
    const Reading beside = kDxf.read(Source{"f", dxf_text(line("JOINT_1"), header)}, hint);
    EXPECT_EQ(beside.content.drawing->joints.at(0).segment.end, (Point{1000, 2000}));
    EXPECT_NE(sentence(beside, "dxf_without_unit").find("taken as in mm"), std::string::npos);
  }
}

TEST(Dxf, coordinates_are_brought_to_the_unit_that_is_asked_for) {
  const Source source{"f", dxf_text(line("JOINT_1"), "9\n$INSUNITS\n70\n4\n")};
  const auto end_in = [&](const std::string& length) {
    const Reading reading = kDxf.read(source, {{}, {}, GeometryKind::unknown, length});
    EXPECT_EQ(reading.content.units, (Units{length, "", ""}));
    EXPECT_EQ(names(reading.warnings).size(), length == "mm" ? 0u : 1u);
    return reading.content.drawing->joints.at(0).segment.end;
  };
  EXPECT_EQ(end_in("mm"), (Point{1000, 2000}));
  EXPECT_EQ(end_in("cm"), (Point{100, 200}));
  EXPECT_NEAR(end_in("in").x, 1000 / 25.4, 1e-12);
}

TEST(Dxf, the_declared_unit_is_written_and_none_where_none_is_declared) {
  Content content = read_entities(line("JOINT_1")).content;
  const auto written_with = [&](const char* length) {
    content.units = Units{length, "kg", "s"};
    const std::string text = kDxf.write(content);
    const std::size_t at = text.find("$INSUNITS\n70\n") + 13;
    return text.substr(at, text.find('\n', at) - at);
  };
  // Numbers of the DXF reference of drawing programs.
  EXPECT_EQ(written_with("in"), "1");
  EXPECT_EQ(written_with("ft"), "2");
  EXPECT_EQ(written_with("mm"), "4");
  EXPECT_EQ(written_with("cm"), "5");
  EXPECT_EQ(written_with("m"), "6");
  EXPECT_EQ(written_with("km"), "7");
  EXPECT_EQ(written_with("yd"), "10");
  EXPECT_EQ(written_with("dm"), "14");
  EXPECT_EQ(written_with(""), "0");
  content.units.reset();
  EXPECT_NE(kDxf.write(content).find("$INSUNITS\n70\n0\n"), std::string::npos);
}

TEST(Dxf, layers_without_a_known_word_are_joints_with_the_first_numbers_not_yet_taken) {
  const Reading reading = read_entities(line("faults") + line("JOINT_2") + line("Bedding") + line("faults") +
                                        line("joints steep 7") + line("boundary"));
  std::vector<int> materials;
  for (const JointLine& joint : reading.content.drawing->joints) materials.push_back(joint.joint_material + 1);
  EXPECT_EQ(materials, (std::vector<int>{1, 3, 2, 4, 3, 7}));
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"dxf_layer_as_joints", "dxf_layer_as_joints"}));
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints").find("layer \"faults\""), std::string::npos);
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints").find("joint material 3"), std::string::npos);
}

TEST(Dxf, a_layer_that_is_nearly_a_word_is_told_which) {
  const auto told = [](const char* layer) { return sentence(read_entities(line(layer)), "dxf_layer_as_joints"); };
  for (const char* layer : {"OUTLINE", "Boundry", "bondary 2"})
    EXPECT_NE(told(layer).find("did you mean \"BOUNDARY\"?"), std::string::npos) << told(layer);
  EXPECT_NE(told("JONT_1 bedding").find("did you mean \"JOINT\"?"), std::string::npos) << told("JONT_1 bedding");
  for (const char* layer : {"faults", "Bedding", "0"})
    EXPECT_EQ(told(layer).find("did you mean"), std::string::npos) << told(layer);
}

// The convention of Shi's Windows program (findings of legacy, defect F).
TEST(Dxf, the_number_of_a_layer_stands_at_its_end_or_right_behind_its_word) {
  const Reading reading = read_entities(line("JOINT_3 bedding") + line("joints bedding 4") + line("JOINT5") +
                                        line("JOINT_2 set 6") + line("JOINT bedding"));
  std::vector<int> numbers;
  for (const JointLine& joint : reading.content.drawing->joints) numbers.push_back(joint.joint_material + 1);
  EXPECT_EQ(numbers, (std::vector<int>{3, 4, 5, 6, 1}));
}

TEST(Dxf, texts_f_l_m_h_make_points_and_colours_joint_types_as_in_the_old_windows_program) {
  const auto mark = [](char letter, int x) {
    return fmt::format("0\nMTEXT\n8\n0\n10\n{}\n20\n0.5\n40\n1\n1\n{}\n", x, letter);
  };
  const Reading reading =
      read_entities(line("0", "62\n3\n") + line("0") + line("0", "62\n256\n") + mark('F', 1) + mark('L', 2) +
                    mark('M', 3) + mark('H', 4) + "0\nMTEXT\n8\n0\n10\n0\n20\n0\n40\n1\n1\nHinge\n");
  const auto& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 3U);
  EXPECT_EQ(drawing.joints[0].joint_material, 3);  // type 4: colour + 1
  EXPECT_EQ(drawing.joints[1].joint_material, 0);
  EXPECT_EQ(drawing.joints[2].joint_material, 0);
  ASSERT_EQ(drawing.fixed_lines.size(), 1U);
  EXPECT_EQ(drawing.fixed_lines[0].segment.start, (Point{1, 0.5}));
  EXPECT_EQ(drawing.fixed_lines[0].segment.end, (Point{1, 0.5}));
  ASSERT_EQ(drawing.loading_points.size(), 1U);
  EXPECT_EQ(drawing.loading_points[0].position, (Point{2, 0.5}));
  ASSERT_EQ(drawing.measured_points.size(), 1U);
  EXPECT_EQ(drawing.measured_points[0].position, (Point{3, 0.5}));
  ASSERT_EQ(drawing.hole_points.size(), 1U);
  EXPECT_EQ(drawing.hole_points[0].position, (Point{4, 0.5}));
  EXPECT_NE(sentence(reading, "dxf_old_marks").find("4 texts F, L, M, H"), std::string::npos);
  EXPECT_EQ(sentence(reading, "dxf_layer_as_joints"), "");
}

TEST(Dxf, colours_say_nothing_without_the_old_marks) {
  const Reading reading = read_entities(line("0", "62\n3\n"));
  EXPECT_EQ(reading.content.drawing->joints.at(0).joint_material, 0);
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints"), "");
}

TEST(Dxf, an_edge_node_ratio_that_is_not_said_is_a_named_default) {
  std::string text = dxf_text(line("JOINT_1"));
  text.erase(0, text.find("0\nSECTION"));
  const Reading reading = read({"f", text});
  EXPECT_EQ(reading.content.drawing->edge_node_ratio, kDxfEdgeNodeRatio);
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"default_edge_node_ratio"});
}

TEST(Dxf, what_is_skipped_is_listed_once_a_kind_with_its_number) {
  const Reading reading = read_entities(line("JOINT_1") + "0\nHATCH\n8\nA\n0\nHATCH\n8\nB\n" +
                                        line("JOINT_1", "30\n5\n") + circle("30\n1\n") + line("JOINT_1", "67\n1\n") +
                                        line("MEASURED") + "0\nPOINT\n8\nelsewhere\n10\n0\n20\n0\n");
  std::vector<std::string> skipped;
  for (const Warning& warning : reading.warnings) skipped.push_back(warning.sentence);
  EXPECT_EQ(skipped, (std::vector<std::string>{
                         "skipped: 2 × HATCH", "skipped: 1 × entity in paper space",
                         "skipped: 1 × LINE not in the plane z = 0", "skipped: 1 × CIRCLE not in the plane z = 0",
                         "skipped: 1 × LINE on layer \"MEASURED\"", "skipped: 1 × POINT on layer \"elsewhere\""}));
  EXPECT_EQ(reading.content.drawing->joints.size(), 1u);
  std::string with_blocks = dxf_text(line("JOINT_1"));
  with_blocks.insert(with_blocks.rfind("0\nEOF"),
                     "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nnut\n0\nLINE\n8\n0\n0\nENDBLK\n0\nENDSEC\n");
  EXPECT_EQ(sentence(read({"f", with_blocks}), "dxf_skipped"),
            "f:36:1: warning: skipped: 1 × entity of a block that no INSERT draws [dxf_skipped]");
}

// A block of a unit square on layer 0 with a joint of its own layer, base point in its middle. The majority of shapes
// decides; tilted ones lie in no plane.
TEST(Dxf, the_plane_is_that_of_most_entities) {
  const std::string at = "30\n412.5\n31\n412.5\n";
  const Reading reading = read_entities(line("JOINT_1", at) + line("JOINT_2", at) + line("JOINT_3"));
  ASSERT_EQ(reading.content.drawing->joints.size(), 2U);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("1 × LINE not in the plane z = 412.5"), std::string::npos);
  const Reading below = read_entities(circle("30\n-7\n210\n0\n220\n0\n230\n-1\n") + line("JOINT_1", "30\n7\n31\n7\n"));
  EXPECT_EQ(below.content.drawing->joints.size(), 33U) << "the height of a circle counts along its normal";
}

TEST(Dxf, an_insert_lifts_what_it_draws) {
  const std::string block = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nbar\n10\n0\n20\n0\n30\n2\n" +
                            line("JOINT_1", "30\n5\n31\n5\n") + "0\nENDBLK\n0\nENDSEC\n";
  std::string text =
      dxf_text("0\nINSERT\n8\n0\n2\nbar\n10\n0\n20\n0\n30\n100\n43\n2\n" + line("JOINT_2", "30\n106\n31\n106\n"));
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), block);
  EXPECT_EQ(read({"f", text}).content.drawing->joints.size(), 2U) << "100 + 2 (5 - 2) = 106";
}

TEST(Dxf, an_invisible_entity_is_skipped_and_said) {
  const Reading reading = read_entities(line("JOINT_1") + line("JOINT_1", "60\n1\n"));
  EXPECT_EQ(reading.content.drawing->joints.size(), 1U);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("1 × LINE that is invisible"), std::string::npos);
}

TEST(Dxf, an_insert_in_rows_and_columns_draws_its_block_at_each) {
  const std::string block =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nbar\n10\n0\n20\n0\n0\nLINE\n8\nJOINT_1\n10\n0\n20\n0\n11\n1\n21\n0\n"
      "0\nENDBLK\n0\nENDSEC\n";
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\nbar\n10\n5\n20\n7\n41\n3\n50\n90\n70\n2\n71\n3\n44\n10\n45\n20\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), block);
  const std::vector<JointLine> joints = read({"f", text}).content.drawing->joints;
  ASSERT_EQ(joints.size(), 6U);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 2; ++column) {  // rotated by 90 degrees: columns go up, rows to the left
      const Segment& found = joints[static_cast<std::size_t>(2 * row + column)].segment;
      EXPECT_LT(distance(found.start, {5.0 - 20 * row, 7.0 + 10 * column}), 1e-12);
      EXPECT_LT(distance(found.end, {5.0 - 20 * row, 10.0 + 10 * column}), 1e-12)
          << "three times as long, not three times as far";
    }
  text.replace(text.find("70\n2"), 4, "70\n2000000000");
  EXPECT_THROW(read({"f", text}), InputError);
}

TEST(Dxf, an_insert_draws_its_block_scaled_turned_and_on_its_own_layer) {
  std::string text = dxf_text(
      "0\nINSERT\n8\nBOUNDARY_2\n2\nhouse\n10\n10\n20\n20\n41\n4\n42\n2\n50\n90\n"
      "0\nINSERT\n8\n0\n2\nnone\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"),
              "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nhouse\n10\n0.5\n20\n0.5\n"
              "0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n"
              "0\nLINE\n8\nJOINT_3\n10\n0\n20\n0.5\n11\n1\n21\n0.5\n0\nENDBLK\n0\nENDSEC\n");
  const Reading reading = read({"f", text});
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.boundary_count, 4U);
  ASSERT_EQ(drawing.joints.size(), 5U);
  EXPECT_EQ(drawing.joints[0].joint_material, 1);
  EXPECT_EQ(drawing.joints[4].joint_material, 2);
  // (-0.5, -0.5) by (4, 2), rotated by 90 degrees: (1, -2) from (10, 20).
  EXPECT_NEAR(drawing.joints[0].segment.start.x, 11, 1e-12);
  EXPECT_NEAR(drawing.joints[0].segment.start.y, 18, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.start.x, 10, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.start.y, 18, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.end.y, 22, 1e-12);
  EXPECT_NE(sentence(reading, "dxf_skipped").find("INSERT of a block that is not there"), std::string::npos);
}

TEST(Dxf, a_block_that_holds_itself_is_refused_at_its_insert) {
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\na\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"),
              "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nINSERT\n8\n0\n2\na\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n");
  EXPECT_THROW(read({"f", text}), InputError);
}

// Each of 16 blocks draws the next one ten times.
TEST(Dxf, blocks_that_would_draw_without_end_are_refused) {
  std::string blocks;
  for (int i = 0; i < 12; ++i) {
    blocks += "0\nBLOCK\n2\nb" + std::to_string(i) + "\n";
    for (int k = 0; k < 10; ++k)
      blocks += i == 11 ? line("JOINT_1") : "0\nINSERT\n8\n0\n2\nb" + std::to_string(i + 1) + "\n10\n0\n20\n0\n";
    blocks += "0\nENDBLK\n";
  }
  std::string text = dxf_text("0\nINSERT\n8\n0\n2\nb0\n10\n0\n20\n0\n");
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n");
  EXPECT_THROW(read({"f", text}), InputError);
}

namespace {

/// Text of a drawing program: without the comment of Keyblock.
Reading drawn(const std::string& entities) {
  std::string text = dxf_text(entities);
  return read({"f", text.substr(text.find("0\nSECTION"))});
}

std::string straight(const std::string& layer, Point a, Point b) {
  return fmt::format("0\nLINE\n8\n{}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", layer, a.x, a.y, b.x, b.y);
}

const std::string kSquareOutline = straight("BOUNDARY", {0, 0}, {4, 0}) + straight("BOUNDARY", {4, 4}, {4, 0}) +
                                   straight("BOUNDARY", {4, 4}, {0, 4}) + straight("BOUNDARY", {0, 4}, {0, 0});

}  // namespace

TEST(Dxf, joints_beyond_the_boundary_are_cut_off_and_it_is_said) {
  const Reading reading = drawn(kSquareOutline + straight("JOINT_2", {-3, 1}, {7, 1}) +
                                straight("JOINT_3", {1, 1}, {3, 3}) + straight("JOINT_4", {5, 5}, {9, 5}));
  const Drawing& drawing = *reading.content.drawing;
  ASSERT_EQ(drawing.boundary_count, 4U);
  ASSERT_EQ(drawing.joints.size(), 6U);
  EXPECT_NEAR(drawing.joints[4].segment.start.x, 0, 1e-12);
  EXPECT_NEAR(drawing.joints[4].segment.end.x, 4, 1e-12);
  EXPECT_EQ(drawing.joints[4].joint_material, 1);
  EXPECT_EQ(drawing.joints[5].segment, (Segment{{1, 1}, {3, 3}})) << "to the last digit";
  EXPECT_NE(sentence(reading, "dxf_clipped").find("1 are shorter now or in pieces, 1 lay outside"), std::string::npos);
}

TEST(Dxf, a_loop_with_a_hole_point_is_kept_free_of_joints_and_one_without_is_not) {
  const std::string inner =
      "0\nLWPOLYLINE\n8\nBOUNDARY\n90\n4\n70\n1\n10\n1\n20\n1\n10\n2\n20\n1\n10\n2\n20\n2\n"
      "10\n1\n20\n2\n";
  const std::string joint = straight("JOINT_2", {0, 1.5}, {4, 1.5});
  EXPECT_EQ(drawn(kSquareOutline + inner + joint).content.drawing->joints.size(), 9U);
  const Reading open = drawn(kSquareOutline + inner + joint + "0\nPOINT\n8\nHOLE\n10\n1.5\n20\n1.2\n");
  const Drawing& drawing = *open.content.drawing;
  ASSERT_EQ(drawing.joints.size(), 10U);
  EXPECT_NEAR(drawing.joints[8].segment.end.x, 1, 1e-12);
  EXPECT_NEAR(drawing.joints[9].segment.start.x, 2, 1e-12);
}

TEST(Dxf, a_boundary_that_does_not_close_cuts_nothing_off_and_says_where) {
  const std::string open = straight("BOUNDARY", {0, 0}, {4, 0}) + straight("BOUNDARY", {4, 0}, {4, 4});
  const Reading reading = drawn(open + straight("JOINT_2", {-3, 1}, {7, 1}));
  EXPECT_EQ(reading.content.drawing->joints.back().segment.start.x, -3);
  EXPECT_NE(sentence(reading, "dxf_not_clipped"), "");
}

TEST(Dxf, chords_of_skipped_curves_are_not_counted) {
  const std::string circle = "\n10\n0\n20\n0\n40\n1\n";
  const Reading skipped = read_entities(line("JOINT_1") + "0\nCIRCLE\n8\nMEASURED" + circle);
  EXPECT_EQ(names(skipped.warnings), std::vector<std::string>{"dxf_skipped"});
  const Reading one = read_entities("0\nCIRCLE\n8\nMEASURED" + circle + "0\nCIRCLE\n8\nJOINT" + circle);
  EXPECT_NE(sentence(one, "dxf_curves_as_chords").find("1 arcs, circles and bulges are 32 chords"), std::string::npos);
}

TEST(Dxf, curves_seen_from_below_are_mirrored) {
  const Reading reading = read_entities(circle("210\n0\n220\n0\n230\n-1\n"));
  for (const JointLine& joint : reading.content.drawing->joints)
    EXPECT_NEAR(distance(joint.segment.start, {-3, 0}), 2, 1e-12);
}

TEST(Dxf, line_ends_blanks_and_a_missing_end_change_nothing) {
  const Drawing expected = *read({"f", kDxfSample}).content.drawing;
  std::string crlf;
  for (const char c : kDxfSample) crlf += c == '\n' ? std::string(" \r\n") : std::string(1, c);
  expect_same(*read({"f", crlf}).content.drawing, expected);
  const Reading cut_off = read({"f", kDxfSample.substr(0, kDxfSample.rfind("0\nEOF"))});
  expect_same(*cut_off.content.drawing, expected);
  EXPECT_EQ(names(cut_off.warnings).front(), "dxf_without_end");
}

TEST(Dxf, a_written_drawing_is_read_again_to_the_last_digit) {
  Drawing drawing = *read({"f", kDxfSample}).content.drawing;
  drawing.edge_node_ratio = 1.0 / 3;
  drawing.joints[5].segment.start = {0.1 + 0.2, -1e-17};
  drawing.joints[6].joint_material = -4;
  drawing.bolts[0].type = 2;
  drawing.material_lines.push_back({{{1, 1}, {1, 1}}, 0, {}});
  drawing.fixed_lines.push_back({{{0, 0}, {1e30, 1}}, {}});
  const Reading again = read({"f", kDxf.write({drawing, {}, {}})});
  EXPECT_EQ(again.warnings, Warnings{});
  expect_same(*again.content.drawing, drawing);
}

TEST(Dxf, outlines_on_the_layers_of_blocks_cut_are_these_blocks) {
  const Reading again = read_entities(outline("BLOCK_1", {{0, 0, 1}, {2, 0, 3}, {2, 2, 1}, {0, 2, 1}}) +
                                      outline("BLOCK_2", {{2, 0, 1}, {4, 0, 2}, {4, 3, 1}, {2, 2, 3}}));
  const Blocks cut = cut_blocks(*again.content.drawing).blocks;
  ASSERT_EQ(cut.blocks.size(), 2u);
  for (const BlockPolygon& block : cut.blocks) {
    const bool is_left = block.material == 0;
    EXPECT_EQ(area(points_of(block.outer)), is_left ? 4 : 5);
    std::vector<int> joints;
    for (const BlockVertex& vertex : block.outer) joints.push_back(vertex.joint_material);
    std::ranges::sort(joints);
    EXPECT_EQ(joints, is_left ? (std::vector<int>{0, 0, 0, 2}) : (std::vector<int>{0, 0, 1, 2}));
  }
}

TEST(Dxf, faults_are_found_at_their_line_and_column) {
  const auto fault = [](const std::string& entities) { return error_of(dxf_text(entities)); };
  EXPECT_EQ(fault("0\nLINE\n8\nJOINT_1\n10\n0\n20\nabc\n11\n1\n21\n1\n"),
            "f:20:1: error: expected y of the start (group 20) of LINE, found \"abc\"");
  EXPECT_EQ(fault("0\nLINE\n8\nJOINT_1\n10\n0\n20\n0\n11\n1\n"),
            "f:14:1: error: expected y of the end (group 21) of LINE, found none");
  EXPECT_EQ(fault("0\nLINE\nJOINT_1\n8\n"),
            "f:15:1: error: expected a DXF group code (a whole number from -5 to 1071), found \"JOINT_1\"");
  EXPECT_EQ(fault("0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n  -1\n"),
            "f:22:3: error: expected the radius (group 40, greater than 0) of CIRCLE, found \"-1\"");
  EXPECT_EQ(fault("0\nPOLYLINE\n8\n0\n0\nVERTEX\n10\n0\n20\n0\n0\nLINE\n"),
            "f:24:1: error: expected VERTEX or SEQEND of POLYLINE, found \"LINE\"");
  EXPECT_EQ(fault("0\nPOLYLINE\n8\n0\n0\nVERTEX\n10\n0\n20\n0\n"),
            "f:14:1: error: expected VERTEX or SEQEND behind POLYLINE, found the end of the section");
  EXPECT_EQ(fault("0\nLWPOLYLINE\n8\n0\n10\n0\n10\n1\n"),
            "f:14:1: error: expected y (group 20) of vertex 1 of LWPOLYLINE, found none");
  EXPECT_EQ(fault(line("JOINT_99999999999")),
            "f:14:1: error: expected a number up to 2147483647 at the end of the layer, found \"JOINT_99999999999\"");
  EXPECT_EQ(fault(line("BOLT", "1001\nKEYBLOCK\n1040\n1\n")),
            "f:26:1: error: expected 3 values (group 1040) of the bolt: stiffness, strength, pre-tension, found 1");
  EXPECT_EQ(error_of("0\nSECTION\n2\nENTITIES\n0\n"), "f:6:1: error: expected the value of group 0, found end of file");
  EXPECT_EQ(error_of("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n"),
            "f:9:1: error: expected ENDSEC of the section \"ENTITIES\", found end of file");
  EXPECT_EQ(error_of("0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"),
            "f: error: expected a section ENTITIES, found none");
}

TEST(Dxf, counts_are_held_against_what_is_there_and_never_trusted) {
  const std::string square = "10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n";
  const Reading reading = read_entities("0\nLWPOLYLINE\n8\nJOINT_1\n90\n2000000000\n70\n1\n" + square);
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"dxf_vertex_count"});
  EXPECT_EQ(reading.content.drawing->joints.size(), 3u);
}

TEST(Dxf, vertices_that_repeat_the_one_before_begin_no_side) {
  const Reading reading = read_entities(
      "0\nLWPOLYLINE\n8\nJOINT_1\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n0\n");
  EXPECT_EQ(reading.content.drawing->joints.size(), 3u);
}

TEST(Dxf, binary_files_of_drawing_programs_are_refused_by_name) {
  using namespace std::string_literals;
  EXPECT_NE(error_of("AutoCAD Binary DXF\r\n\x1a\0\0\0SECTION"s).find("a binary DXF file (save it as ASCII DXF)"),
            std::string::npos);
  EXPECT_NE(error_of("AC1032\0\0\0\0\0\x03\x80"s).find("a DWG file (save it as ASCII DXF)"), std::string::npos);
  EXPECT_EQ(drawing_program_binary("AC10"), "");
}

}  // namespace keyblock::formats::dxf_test
