// Effect of faulty files on the Berkeley program, by the sentences of legacy-formats 2.1, 2.3.1, 2.6, 4 and
// legacy-rules 16.1.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/convert/berkeley_faults.hpp"

#include <gtest/gtest.h>

#include "tests/formats/reading.hpp"

namespace keyblock::study::berkeley_faults_test {
namespace {

formats::FileReading file_of(const std::string& text) {
  formats::FileReading file;
  file.path = "f";
  file.source = {"f", text};
  file.choice = formats::recognise(file.source);
  file.reading = formats::read(file.source);
  return file;
}

std::string error_in(const std::string& text) {
  try {
    as_berkeley_reads(file_of(text));
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::vector<std::string> new_warnings(const formats::FileReading& file) {
  std::vector<std::string> all = formats::names(as_berkeley_reads(file).warnings);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(file.reading->warnings.size()));
  return all;
}

// Density, weight, E, nu; initial stress; slots 8 to 10; slots 11 to 13.
std::string native_analysis(const std::string& carry_over) {
  return carry_over + "\n10\n1\n1\n0.01\n0.1\n2 20 1e6 0.2\n1 2 3\n4 5 6\n7 8 9\n30 0 0\n";
}

const std::string kXml = R"(<?xml version="1.0"?><DDA>
<Geometry><Edgenodedist distance="0.01"/><Boundlist><Line>0 0 1 0</Line></Boundlist>
<Jointlist><Joint type="2">1 0 1 1</Joint></Jointlist><Matlinelist><Line type="2">0 0 1 1</Line></Matlinelist>
<Boltlist><Bolt type="1">0 0 1 1</Bolt></Boltlist></Geometry>
<Analysis><Numtimesteps timesteps="5"/><Maxtimestep maxtimestep="0.1"/><Maxdisplacement maxdisplacement="0.1"/>
<Blockmaterial type="1"><Unitmass>2</Unitmass><Unitweight>20</Unitweight><Youngsmod>1e6</Youngsmod>
<Poissonratio>0.2</Poissonratio>
<Istress>1 2 3</Istress><Ivelocity>1 0 2</Ivelocity><Istrain>7 8 9</Istrain></Blockmaterial>
<Jointproperties type="1"><Friction>30</Friction><Cohesion>0</Cohesion><Tensile>0</Tensile></Jointproperties>
</Analysis></DDA>)";

}  // namespace

// Lines: 3 joints, 2 material lines, 1 bolt of 7 numbers, 2 fixed lines, 1 loading and 1 measured point.
TEST(BerkeleyFaults, native_lines_lose_the_first_material_line_and_read_bolts_as_what_follows) {
  const formats::FileReading file = file_of(
      "0.01\n3 0\n2\n1\n2\n1\n1\n0\n0 0 1 0 1\n1 0 1 1 2\n1 1 0 0 3\n0 0 1 1 1\n0 1 1 0 2\n"
      "1 2 3 4 5 6 7\n11 12 13 14\n15 16 17 18\n21 22\n31 32\n");
  EXPECT_EQ(new_warnings(file), (std::vector<std::string>{"first_material_line_lost", "bolts_not_read"}));
  const Drawing drawing = *as_berkeley_reads(file).content.drawing;
  ASSERT_EQ(drawing.material_lines.size(), 1U);
  EXPECT_EQ(drawing.material_lines[0].block_material, 1);
  EXPECT_TRUE(drawing.bolts.empty());
  ASSERT_EQ(drawing.fixed_lines.size(), 2U);
  EXPECT_EQ(drawing.fixed_lines[0].segment, (Segment{{1, 2}, {3, 4}}));
  EXPECT_EQ(drawing.fixed_lines[1].segment, (Segment{{5, 6}, {7, 11}}));
  EXPECT_EQ(drawing.loading_points.at(0).position, (Point{12, 13}));
  EXPECT_EQ(drawing.measured_points.at(0).position, (Point{14, 15}));
}

TEST(BerkeleyFaults, native_velocity_is_that_of_the_stress_gradient) {
  const formats::FileReading file = file_of(native_analysis("1"));
  EXPECT_EQ(new_warnings(file), (std::vector<std::string>{"velocity_from_gradient"}));
  const BlockMaterial material = as_berkeley_reads(file).content.analysis->block_materials.at(0);
  EXPECT_EQ(material.stress_gradient, (Stress{4, 5, 6}));
  EXPECT_EQ(material.initial_velocity, (Velocity{4, 5, 6}));
}

// The rest of the number makes the following reads fail: steps and counts keep their random values.
TEST(BerkeleyFaults, a_carry_over_with_a_point_is_refused) {
  for (const char* spelled : {"0.7", "1.0"})
    EXPECT_NE(error_in(native_analysis(spelled)).find("expected a velocity carry-over spelled 0 or 1"),
              std::string::npos)
        << spelled;
}

TEST(BerkeleyFaults, xml_loses_boundaries_and_takes_the_velocity_as_gradient_too) {
  const formats::FileReading file = file_of(kXml);
  EXPECT_EQ(new_warnings(file),
            (std::vector<std::string>{"boundaries_dropped", "gradient_from_velocity", "strain_without_effect"}));
  const formats::Content content = as_berkeley_reads(file).content;
  ASSERT_EQ(content.drawing->joints.size(), 1U);
  EXPECT_EQ(content.drawing->joints[0].joint_material, 1);
  EXPECT_EQ(content.drawing->boundary_count, 0U);
  EXPECT_EQ(content.drawing->bolts.size(), 1U) << "bolts are unread in native files only";
  EXPECT_EQ(content.drawing->material_lines.size(), 1U) << "so is the first material line lost";
  const BlockMaterial& material = content.analysis->block_materials.at(0);
  EXPECT_EQ(material.initial_velocity, (Velocity{1, 0, 2}));
  EXPECT_EQ(material.stress_gradient, (Stress{1, 0, 2}));
  EXPECT_EQ(material.initial_strain, (std::array<double, 3>{}));
}

TEST(BerkeleyFaults, files_that_the_program_does_not_read_stay) {
  const formats::FileReading file = file_of("{\"keyblock\": 1, \"motion\": [[0, 1, 0]]}");
  EXPECT_EQ(new_warnings(file), (std::vector<std::string>{"not_of_berkeley"}));
}

}  // namespace keyblock::study::berkeley_faults_test
