// DXF: faults are named with their place, and counts of a file are never trusted.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/dxf/dxf.hpp"
#include "tests/formats/dxf_samples.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::dxf_faults_test {

TEST(DxfFaults, faults_are_found_at_their_line_and_column) {
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
  EXPECT_EQ(fault(dxf_line("JOINT_99999999999")),
            "f:14:1: error: expected a number up to 2147483647 at the end of the layer, found \"JOINT_99999999999\"");
  EXPECT_EQ(fault(dxf_line("BOLT", "1001\nKEYBLOCK\n1040\n1\n")),
            "f:26:1: error: expected 3 values (group 1040) of the bolt: stiffness, strength, pre-tension, found 1");
  EXPECT_EQ(error_of("0\nSECTION\n2\nENTITIES\n0\n"), "f:6:1: error: expected the value of group 0, found end of file");
  EXPECT_EQ(error_of("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n"),
            "f:9:1: error: expected ENDSEC of the section \"ENTITIES\", found end of file");
  EXPECT_EQ(error_of("0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"),
            "f: error: expected a section ENTITIES, found none");
}

TEST(DxfFaults, counts_are_held_against_what_is_there_and_never_trusted) {
  const std::string square = "10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n";
  const Reading reading = read_entities("0\nLWPOLYLINE\n8\nJOINT_1\n90\n2000000000\n70\n1\n" + square);
  EXPECT_EQ(names(reading.warnings), std::vector<std::string>{"dxf_vertex_count"});
  EXPECT_EQ(reading.content.drawing->joints.size(), 3u);
}

TEST(DxfFaults, vertices_that_repeat_the_one_before_begin_no_side) {
  const Reading reading = read_entities(
      "0\nLWPOLYLINE\n8\nJOINT_1\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n0\n");
  EXPECT_EQ(reading.content.drawing->joints.size(), 3u);
}

TEST(DxfFaults, binary_files_of_drawing_programs_are_refused_by_name) {
  using namespace std::string_literals;
  EXPECT_NE(error_of("AutoCAD Binary DXF\r\n\x1a\0\0\0SECTION"s).find("a binary DXF file (save it as ASCII DXF)"),
            std::string::npos);
  EXPECT_NE(error_of("AC1032\0\0\0\0\0\x03\x80"s).find("a DWG file (save it as ASCII DXF)"), std::string::npos);
  EXPECT_EQ(drawing_program_binary("AC10"), "");
}

}  // namespace keyblock::formats::dxf_faults_test
