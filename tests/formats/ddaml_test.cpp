// DDAML in all its variants, and the places of its faults.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml.hpp"

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "formats/shi/dda_geometry.hpp"
#include "tests/formats/reading.hpp"

namespace keyblock::formats::ddaml_test {
namespace {

const std::string kGeometry =
    "<Geometry><Edgenodedist distance='0.01'/>"
    "<Jointlist><Joint type='2'> 0 0 1 0 </Joint><Joint type=\"1\">1,0 1,1</Joint></Jointlist>"
    "<Fixedpointlist><Point>.5 .1</Point><Line>0 .2 1 .2</Line></Fixedpointlist></Geometry>";

const std::string kControls =
    "<Analysistype type='dynamic'/><Rotation type='secondorder'/><Gravity flag='no'>free text</Gravity>"
    "<Gravaccel value='9.8'/><Autotimestep flag='yes'/><Autopenalty flag='yes' pfactor='20'/><Planestrain "
    "flag='no'/>"
    "<Numtimesteps timesteps='10'/><Maxtimestep maxtimestep='.001'/><Maxdisplacement maxdisplacement='.01'/>";
const std::string kBlockMaterial =
    "<Blockmaterial><Unitmass>2</Unitmass><Unitweight>20</Unitweight><Youngsmod>1e6</Youngsmod>"
    "<Poissonratio>.5</Poissonratio><Damping>.1</Damping><Istress>1 2 3</Istress><Ivelocity>4 5 6</Ivelocity>"
    "<Istrain>7 8 9</Istrain></Blockmaterial>";
const std::string kJointMaterial =
    "<Jointproperties><Friction>30</Friction><Cohesion>1</Cohesion><Tensile>2</Tensile></Jointproperties>";

std::string document(const std::string& sections) {
  return "<DDA>" + sections + "</DDA>";
}

std::string analysis(const std::string& more) {
  return document("<Analysis>" + kControls + kBlockMaterial + kJointMaterial + more + "</Analysis>");
}

std::string geometry(const std::string& more) {
  return document("<Geometry><Edgenodedist distance='.01'/>" + more + "</Geometry>");
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST(Ddaml, geometry_and_analysis_are_read_from_one_file) {
  const Reading reading =
      read({"f", document(kGeometry + "<Analysis>" + kControls + kBlockMaterial + kJointMaterial + "</Analysis>")});
  EXPECT_EQ(reading.warnings, Warnings{});
  ASSERT_TRUE(reading.content.drawing);
  ASSERT_TRUE(reading.content.analysis);
}

TEST(Ddaml, decimal_commas_in_the_text_of_an_element_are_refused_where_its_numbers_are_too_many) {
  const auto joint = [](const std::string& text) {
    return document("<Geometry><Edgenodedist distance='0.01'/><Jointlist><Joint type='1'>" + text +
                    "</Joint></Jointlist></Geometry>");
  };
  EXPECT_EQ(error_of(joint("1,5 0,25 2 3")).substr(0, 59),
            "f:1:75: error: expected a decimal point, or white space bes");
  EXPECT_EQ(error_of(joint("0,0 1,1")), "");
  EXPECT_EQ(names(read({"f", joint("1 2 3 4 5")}).warnings), (std::vector<std::string>{"surplus_numbers"}));
}

TEST(Ddaml, geometry_lands_in_its_places) {
  const Drawing drawing = *read({"f", document(kGeometry)}).content.drawing;
  EXPECT_EQ(drawing.edge_node_ratio, .01);
  EXPECT_EQ(drawing.boundary_count, 0u);
  ASSERT_EQ(drawing.joints.size(), 2u);
  EXPECT_EQ(drawing.joints[0].joint_material, 1);
  EXPECT_EQ(drawing.joints[1].segment, (Segment{{1, 0}, {1, 1}}));
  ASSERT_EQ(drawing.fixed_lines.size(), 2u);
  EXPECT_EQ(drawing.fixed_lines[0].segment, (Segment{{.5, .1}, {.5, .1}}));
}

TEST(Ddaml, analysis_lands_in_its_places) {
  const Reading reading =
      read({"f", analysis("<Opencloselimit maxopenclose='7'/><Saveinterval step=''/><ContactDamping value='.2'/>"
                          "<Boltproperties>1e6 2e3 50</Boltproperties><AConstants><AngleOverlap value='4'/>"
                          "<MinReflineFactor value='1'/></AConstants>")});
  EXPECT_EQ(reading.warnings, Warnings{});
  const Analysis& a = *reading.content.analysis;
  EXPECT_EQ(a.dialect, AnalysisDialect::ddaml);
  EXPECT_EQ(a.velocity_carry_over, 1);
  EXPECT_EQ(a.rotation, Rotation::exact);
  EXPECT_EQ(a.gravity, 9.8);
  EXPECT_TRUE(a.automatic_time_step);
  EXPECT_TRUE(a.automatic_penalty);
  EXPECT_EQ(a.penalty_factor, 20);
  EXPECT_EQ(a.step_count, 10);
  EXPECT_EQ(a.time_step, .001);
  EXPECT_EQ(a.allowed_displacement_ratio, .01);
  EXPECT_EQ(a.open_close_limit, 7);
  EXPECT_EQ(a.save_interval, 10);
  EXPECT_EQ(a.contact_damping, .2);
  EXPECT_EQ(a.open_close.angle_overlap_deg, 4);
  EXPECT_EQ(a.bolt_properties.at(0).pretension, 50);
  const BlockMaterial& block = a.block_materials.at(0);
  EXPECT_EQ(block.unit_weight, 20);
  EXPECT_EQ(block.damping, .1);
  EXPECT_EQ(block.initial_stress, (Stress{1, 2, 3}));
  EXPECT_EQ(block.initial_velocity, (Velocity{4, 5, 6}));
  EXPECT_EQ(block.initial_strain, (std::array<double, 3>{7, 8, 9}));
  EXPECT_EQ(block.stress_gradient, Stress{});
  EXPECT_EQ(a.joint_materials.at(0).tensile_strength, 2);
}

TEST(Ddaml, prefixes_namespaces_comments_and_prologue_change_nothing) {
  const std::string expected = kDdaGeometry.write(read({"f", document(kGeometry)}).content);
  const std::string prefixed =
      "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!DOCTYPE DDA SYSTEM \"geometry.dtd\" [<!ENTITY x "
      "\"y\">]>\r\n<!-- a --><B:DDA xmlns:B='http://any'>"
      "<!-- b --><B:Geometry><B:Edgenodedist distance='0.01'/><!-- c --><B:Jointlist><!-- d --><B:Joint "
      "type='2'> 0 0 <!-- e --> 1 0 "
      "</B:Joint><?pi?></B:Jointlist><B:Fixedpointlist><B:Point>.5 "
      ".1</B:Point></B:Fixedpointlist><B:Jointlist><B:Joint type='1'>"
      "<![CDATA[1 0]]> 1 1</B:Joint></B:Jointlist><B:Holepointlist/><B:Fixedpointlist><B:Line>0 .2 1 "
      ".2</B:Line></B:Fixedpointlist>"
      "</B:Geometry></B:DDA>";
  const Reading reading = read({"f", prefixed});
  EXPECT_EQ(reading.warnings, Warnings{});
  EXPECT_EQ(kDdaGeometry.write(reading.content), expected);
}

TEST(Ddaml, boundary_lines_come_first_with_joint_material_1) {
  const Drawing drawing =
      *read({"f", geometry("<Jointlist><Joint type='3'>0 0 1 1</Joint></Jointlist><Boundlist><Line>0 0 1 "
                           "0</Line></Boundlist>")})
           .content.drawing;
  EXPECT_EQ(drawing.boundary_count, 1u);
  EXPECT_EQ(drawing.joints.at(0).joint_material, 0);
  EXPECT_EQ(drawing.joints.at(1).joint_material, 2);
}

TEST(Ddaml, material_line_takes_its_material_from_type_or_fifth_number) {
  const Drawing drawing =
      *read({"f", geometry("<Matlinelist><Line type='2'>0 0 1 1</Line><Line>0 0 1 1 3</Line></Matlinelist>")})
           .content.drawing;
  EXPECT_EQ(drawing.material_lines.at(0).block_material, 1);
  EXPECT_EQ(drawing.material_lines.at(1).block_material, 2);
}

TEST(Ddaml, load_records_are_separated_by_semicolons) {
  const std::string loads = "<Loadpointlist><Loadpoint numpoints='2'>\n0 1 2;\n5 3 4; \n</Loadpoint></Loadpointlist>";
  const Reading reading = read({"f", analysis(loads)});
  ASSERT_EQ(reading.content.analysis->point_loads.size(), 1u);
  EXPECT_EQ(reading.content.analysis->point_loads[0].times, (std::vector<double>{0, 5}));
  EXPECT_EQ(reading.content.analysis->point_loads[0].values, (std::vector<Point>{{1, 2}, {3, 4}}));
  EXPECT_NE(error_of(analysis(with(loads, "5 3 4", "0 3 4"))), "");
  EXPECT_NE(error_of(analysis(with(loads, "numpoints='2'", "numpoints='1'"))), "");
  EXPECT_NE(error_of(analysis(with(loads, "numpoints='2'", "numpoints='1000000000'"))), "");
  EXPECT_NE(error_of(analysis(with(loads, " numpoints='2'", ""))), "");
}

TEST(Ddaml, each_default_taken_is_a_warning_of_its_own_name) {
  const Reading reading =
      read({"f", document("<Analysis><Numtimesteps timesteps='10'/><Maxtimestep maxtimestep='.001'/>"
                          "<Maxdisplacement maxdisplacement='.01'/>" +
                          with(kBlockMaterial, "<Damping>.1</Damping>", "") + kJointMaterial + "</Analysis>")});
  EXPECT_EQ(names(reading.warnings),
            (std::vector<std::string>{"default_damping", "default_analysistype", "default_rotation", "default_gravity",
                                      "default_gravaccel", "default_autotimestep", "default_autopenalty",
                                      "default_planestrain"}));
  EXPECT_EQ(reading.content.analysis->gravity, 9.81);
  EXPECT_EQ(reading.content.analysis->penalty_factor, 50);
}

TEST(Ddaml, poissons_ratio_of_one_half_is_an_error_in_plane_strain_wherever_that_is_said) {
  EXPECT_EQ(error_of(analysis("")), "");
  EXPECT_NE(error_of(with(analysis("<Planestrain flag='yes'/>"), "<Planestrain flag='no'/>", "")), "");
}

TEST(Ddaml, pipe_flow_and_unknown_elements_are_skipped_with_a_warning) {
  const Reading reading = read({"f", document(kGeometry + "<Fluids><FluidDensity density='1'/></Fluids><Other/>")});
  EXPECT_EQ(names(reading.warnings), (std::vector<std::string>{"pipe_flow_ignored", "unknown_element"}));
}

TEST(Ddaml, what_stands_again_or_behind_a_value_is_a_warning) {
  const auto read_with = [](const std::string& from, const std::string& to) {
    return read({"f", with(analysis(""), from, to)});
  };
  using Names = std::vector<std::string>;
  const Reading two = read_with("timesteps='10'", "timesteps='10 20'");
  EXPECT_EQ(two.content.analysis->step_count, 10);
  EXPECT_EQ(names(two.warnings), Names{"surplus_numbers"});
  EXPECT_EQ(names(read_with("timesteps='10'", "timesteps='10 x'").warnings), Names{"trailing_text"});
  const Reading again = read_with("<Numtimesteps", "<Numtimesteps timesteps='5'/><Numtimesteps");
  EXPECT_EQ(again.content.analysis->step_count, 10) << "the last";
  EXPECT_EQ(names(again.warnings), Names{"repeated_element"});
  const Reading stress = read_with("<Istress>", "<Istress>7 8 9</Istress><Istress>");
  EXPECT_EQ(stress.content.analysis->block_materials.at(0).initial_stress, (Stress{7, 8, 9})) << "the first";
  EXPECT_EQ(names(stress.warnings), Names{"repeated_element"});
  EXPECT_EQ(
      names(read({"f", with(document(kGeometry), "<Edgenodedist", "<Edgenodedist distance='.3 4'/><Edgenodedist")})
                .warnings),
      (Names{"surplus_numbers", "repeated_element"}));
  EXPECT_EQ(names(read({"f", with(document(kGeometry), "type='2'", "type='2 1'")}).warnings), Names{"surplus_numbers"});
}

TEST(Ddaml, faults_are_found_at_their_line_and_column) {
  EXPECT_EQ(error_of("<DDA>\n<Geometry><Edgenodedist distance='.01'/>\n<Jointlist>\r\n<Joint type='x'>0 0 1 1</Joint>"
                     "</Jointlist></Geometry></DDA>"),
            "f:4:14: error: expected the joint material (attribute type) of Joint 1 of 1, found \"x\"");
  EXPECT_EQ(error_of("<DDA><Geometry><Edgenodedist distance='.01'/>\n<Jointlist><Joint type='1'>0 0\n1 oops</Joint>"
                     "</Jointlist></Geometry></DDA>"),
            "f:3:3: error: expected y of the end of Joint 1 of 1, found \"oops\"");
  EXPECT_EQ(error_of("<DDA>\n<Geometry>\n</Geometri></DDA>").substr(0, 46),
            "f:3:3: error: expected well-formed XML, found ");
  EXPECT_EQ(error_of("<DDA>\n<Geometry>\n"), "f:3:1: error: expected well-formed XML, found end of file");
}

TEST(Ddaml, missing_parts_are_errors_that_name_the_element) {
  EXPECT_EQ(error_of("<DDA/>"), "f:1:2: error: expected a Geometry or an Analysis element, found neither");
  EXPECT_EQ(error_of("<DDA><Geometry/></DDA>"),
            "f:1:7: error: expected an Edgenodedist element in Geometry, found none");
  EXPECT_NE(
      error_of(with(analysis(""), "<Unitmass>2</Unitmass>", "")).find("expected the element Unitmass in Blockmaterial"),
      std::string::npos);
  EXPECT_NE(error_of(with(analysis(""), kJointMaterial, "")).find("expected a joint material"), std::string::npos);
  EXPECT_NE(error_of(document(kGeometry + kGeometry)).find("found a second"), std::string::npos);
}

TEST(Ddaml, a_million_nested_elements_do_no_harm) {
  std::string open, close;
  for (int i = 0; i < 1000000; ++i) {
    open += "<a>";
    close += "</a>";
  }
  EXPECT_NE(error_of(open + close), "");
  EXPECT_NE(error_of(open), "");
  EXPECT_NE(error_of(geometry("<Jointlist><Joint type='1'>" + open + close + "</Joint></Jointlist>")), "");
}

TEST(Ddaml, boundary_lines_may_state_a_joint_material) {
  const Drawing drawing =
      *read({"f", geometry("<Boundlist><Line>0 0 1 0</Line><Line type='3'>1 0 1 1</Line></Boundlist>")})
           .content.drawing;
  ASSERT_EQ(drawing.boundary_count, 2u);
  EXPECT_EQ(drawing.joints[0].joint_material, 0);
  EXPECT_EQ(drawing.joints[1].joint_material, 2);
}

TEST(Ddaml, text_written_of_both_parts_is_read_without_a_warning_and_written_again_the_same) {
  const Content content =
      read({"f", document(kGeometry + "<Analysis>" + kControls + kBlockMaterial + kJointMaterial + "</Analysis>")})
          .content;
  const std::string text = kDdaml.write(content);
  const Reading again = read({"f", text});
  EXPECT_EQ(again.warnings, Warnings{});
  EXPECT_EQ(kDdaml.write(again.content), text);
}

TEST(Ddaml, what_native_files_say_in_other_words_is_turned_into_those_of_ddaml) {
  Content content = read({"f", "0.01 1 0 0 2 0 0 0 0\n0 0 1 0 1\n0 0 1 0 1e6 2e3 50\n0 1 1 1 1e6 2e3 50\n"}).content;
  EXPECT_THROW(kDdaml.write(content), std::invalid_argument);  // properties of bolts stand in the analysis
  content.analysis = read({"f", "1 20 1 1 .006 .01 3e7\n0\n5 160 1e6 .25\n0 0 0\n0 0 0\n0 0 0\n30 0 0\n"},
                          {0, 1, GeometryKind::blocks})
                         .content.analysis;
  const Content read_back = read({"f", kDdaml.write(content)}).content;
  EXPECT_EQ(read_back.analysis->penalty_factor, 30);  // 3e7 over the modulus of 1e6
  EXPECT_EQ(read_back.analysis->gravity, 32);         // 160 over 5
  EXPECT_EQ(read_back.analysis->point_loads.at(0).at(1), (Point{0, 0}));
  ASSERT_EQ(read_back.analysis->bolt_properties.size(), 1u);
  EXPECT_EQ(read_back.analysis->bolt_properties[0].strength, 2e3);
  EXPECT_EQ(read_back.drawing->bolts.at(1).type, 0);
  content.analysis->velocity_carry_over = 0.5;
  EXPECT_THROW(kDdaml.write(content), std::invalid_argument);
}

}  // namespace keyblock::formats::ddaml_test
