// DXF: every entity gets its place, curves keep their tolerance, and written files are read again.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dxf/dxf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formats/dxf/curves/dxf_curves.hpp"
#include "tests/formats/dxf_samples.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dxf_test {
namespace {

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
  const Reading millimetres = read_entities(dxf_line("JOINT_1"), "9\n$INSUNITS\n70\n4\n");
  EXPECT_EQ(millimetres.content.drawing->joints.at(0).segment.end, (Point{1, 2}));
  EXPECT_NE(sentence(millimetres, "dxf_scaled_to_metres").find("multiplied by 0.001"), std::string::npos);
  const std::string ends = "10\n0\n20\n0\n11\n39800\n21\n200\n";
  const Reading exact = read_entities("0\nLINE\n8\nJOINT_1\n" + ends, "9\n$INSUNITS\n70\n4\n");
  EXPECT_EQ(exact.content.drawing->joints.at(0).segment.end, (Point{39.8, 0.2})) << "not 39.800000000000004";
  const Reading feet = read_entities(dxf_line("JOINT_1"), "9\n$INSUNITS\n70\n2\n");
  EXPECT_NEAR(feet.content.drawing->joints.at(0).segment.end.x, 304.8, 1e-12);
  for (const char* header : {"", "9\n$INSUNITS\n70\n0\n", "9\n$INSUNITS\n70\n6\n"}) {
    const Reading as_is = read_entities(dxf_line("JOINT_1"), header);
    EXPECT_EQ(as_is.content.drawing->joints.at(0).segment.end, (Point{1000, 2000}));
    EXPECT_EQ(as_is.warnings, Warnings{});
    EXPECT_EQ(as_is.content.units.has_value(), std::string(header).ends_with("6\n")) << header;
  }
  EXPECT_EQ(millimetres.content.units, (Units{"m", "", ""}));
  EXPECT_EQ(names(read_entities(dxf_line("JOINT_1"), "9\n$INSUNITS\n70\n77\n").warnings),
            std::vector<std::string>{"dxf_unit_unknown"});
}

TEST(Dxf, a_drawing_without_unit_beside_a_case_that_has_one_is_told) {
  for (const char* header : {"", "9\n$INSUNITS\n70\n0\n"}) {
    ReadHint hint;
    hint.length = "mm";
    const Reading beside = kDxf.read(Source{"f", dxf_text(dxf_line("JOINT_1"), header)}, hint);
    EXPECT_EQ(beside.content.drawing->joints.at(0).segment.end, (Point{1000, 2000}));
    EXPECT_NE(sentence(beside, "dxf_without_unit").find("taken as in mm"), std::string::npos);
  }
}

TEST(Dxf, coordinates_are_brought_to_the_unit_that_is_asked_for) {
  const Source source{"f", dxf_text(dxf_line("JOINT_1"), "9\n$INSUNITS\n70\n4\n")};
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
  Content content = read_entities(dxf_line("JOINT_1")).content;
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
  const Reading reading = read_entities(dxf_line("faults") + dxf_line("JOINT_2") + dxf_line("Bedding") +
                                        dxf_line("faults") + dxf_line("joints steep 7") + dxf_line("boundary"));
  std::vector<int> materials;
  for (const JointLine& joint : reading.content.drawing->joints) materials.push_back(joint.joint_material + 1);
  EXPECT_EQ(materials, (std::vector<int>{1, 3, 2, 4, 3, 7}));
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"dxf_layer_as_joints", "dxf_layer_as_joints"}));
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints").find("layer \"faults\""), std::string::npos);
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints").find("joint material 3"), std::string::npos);
}

TEST(Dxf, a_layer_that_is_nearly_a_word_is_told_which) {
  const auto told = [](const char* layer) { return sentence(read_entities(dxf_line(layer)), "dxf_layer_as_joints"); };
  for (const char* layer : {"OUTLINE", "Boundry", "bondary 2"})
    EXPECT_NE(told(layer).find("did you mean \"BOUNDARY\"?"), std::string::npos) << told(layer);
  EXPECT_NE(told("JONT_1 bedding").find("did you mean \"JOINT\"?"), std::string::npos) << told("JONT_1 bedding");
  for (const char* layer : {"faults", "Bedding", "0"})
    EXPECT_EQ(told(layer).find("did you mean"), std::string::npos) << told(layer);
}

// The convention of Shi's Windows program (findings of legacy, defect F).
TEST(Dxf, the_number_of_a_layer_stands_at_its_end_or_right_behind_its_word) {
  const Reading reading = read_entities(dxf_line("JOINT_3 bedding") + dxf_line("joints bedding 4") +
                                        dxf_line("JOINT5") + dxf_line("JOINT_2 set 6") + dxf_line("JOINT bedding"));
  std::vector<int> numbers;
  for (const JointLine& joint : reading.content.drawing->joints) numbers.push_back(joint.joint_material + 1);
  EXPECT_EQ(numbers, (std::vector<int>{3, 4, 5, 6, 1}));
}

TEST(Dxf, texts_f_l_m_h_make_points_and_colours_joint_types_as_in_the_old_windows_program) {
  const auto mark = [](char letter, int x) {
    return fmt::format("0\nMTEXT\n8\n0\n10\n{}\n20\n0.5\n40\n1\n1\n{}\n", x, letter);
  };
  const Reading reading =
      read_entities(dxf_line("0", "62\n3\n") + dxf_line("0") + dxf_line("0", "62\n256\n") + mark('F', 1) +
                    mark('L', 2) + mark('M', 3) + mark('H', 4) + "0\nMTEXT\n8\n0\n10\n0\n20\n0\n40\n1\n1\nHinge\n");
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
  const Reading reading = read_entities(dxf_line("0", "62\n3\n"));
  EXPECT_EQ(reading.content.drawing->joints.at(0).joint_material, 0);
  EXPECT_NE(sentence(reading, "dxf_layer_as_joints"), "");
}

TEST(Dxf, an_edge_node_ratio_that_is_not_said_is_a_named_default) {
  std::string text = dxf_text(dxf_line("JOINT_1"));
  text.erase(0, text.find("0\nSECTION"));
  const Reading reading = read({"f", text});
  EXPECT_EQ(reading.content.drawing->edge_node_ratio, kDxfEdgeNodeRatio);
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"default_edge_node_ratio"});
}

TEST(Dxf, what_is_skipped_is_listed_once_a_kind_with_its_number) {
  const Reading reading =
      read_entities(dxf_line("JOINT_1") + "0\nHATCH\n8\nA\n0\nHATCH\n8\nB\n" + dxf_line("JOINT_1", "30\n5\n") +
                    dxf_circle("30\n1\n") + dxf_line("JOINT_1", "67\n1\n") + dxf_line("MEASURED") +
                    "0\nPOINT\n8\nelsewhere\n10\n0\n20\n0\n");
  std::vector<std::string> skipped;
  for (const Warning& warning : reading.warnings) skipped.push_back(warning.sentence);
  EXPECT_EQ(skipped, (std::vector<std::string>{
                         "skipped: 2 × HATCH", "skipped: 1 × entity in paper space",
                         "skipped: 1 × LINE not in the plane z = 0", "skipped: 1 × CIRCLE not in the plane z = 0",
                         "skipped: 1 × LINE on layer \"MEASURED\"", "skipped: 1 × POINT on layer \"elsewhere\""}));
  EXPECT_EQ(reading.content.drawing->joints.size(), 1u);
  std::string with_blocks = dxf_text(dxf_line("JOINT_1"));
  with_blocks.insert(with_blocks.rfind("0\nEOF"),
                     "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nnut\n0\nLINE\n8\n0\n0\nENDBLK\n0\nENDSEC\n");
  EXPECT_EQ(sentence(read({"f", with_blocks}), "dxf_skipped"),
            "f:36:1: warning: skipped: 1 × entity of a block that no INSERT draws [dxf_skipped]");
}

TEST(Dxf, chords_of_skipped_curves_are_not_counted) {
  const std::string circle = "\n10\n0\n20\n0\n40\n1\n";
  const Reading skipped = read_entities(dxf_line("JOINT_1") + "0\nCIRCLE\n8\nMEASURED" + circle);
  EXPECT_EQ(names(skipped.warnings), std::vector<std::string>{"dxf_skipped"});
  const Reading one = read_entities("0\nCIRCLE\n8\nMEASURED" + circle + "0\nCIRCLE\n8\nJOINT" + circle);
  EXPECT_NE(sentence(one, "dxf_curves_as_chords").find("1 arcs, circles and bulges are 32 chords"), std::string::npos);
}

TEST(Dxf, curves_seen_from_below_are_mirrored) {
  const Reading reading = read_entities(dxf_circle("210\n0\n220\n0\n230\n-1\n"));
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

}  // namespace keyblock::formats::dxf_test
