// Files for viewers are well-formed, have correct counts, and keep times and coordinates to the last digit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/views/vtk.hpp"

#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>
#include <sstream>

namespace keyblock::formats::vtk_test {
namespace {

Frame square_with_hole_and_triangle() {
  Frame frame;
  frame.time = 0.1;
  ElementFrame square;
  square.loops = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}};
  ElementFrame triangle;
  triangle.loops = {{{4, 0}, {1.0 / 3.0 + 4, 0}, {4, 1}}};
  triangle.material = 1;
  triangle.stress = {0, -12262.5, 0};
  frame.elements = {square, triangle};
  return frame;
}

std::vector<double> numbers(const pugi::xml_node& array) {
  std::istringstream text(array.text().get());
  std::vector<double> values;
  for (double value = 0; text >> value;) values.push_back(value);
  return values;
}

/// Parses a frame; `piece` holds counts and arrays.
struct Parsed {
  pugi::xml_document document;
  pugi::xml_node piece;

  explicit Parsed(const Frame& frame, const FieldFrame& field = {}, const std::vector<BlockMaterial>& materials = {}) {
    EXPECT_TRUE(
        document.load_string(vtu(with_derived(columns_of(frame, {}, field), materials), {}, VtkCoding::text).c_str()));
    piece = document.child("VTKFile").child("UnstructuredGrid").child("Piece");
  }
  std::vector<double> array(const char* part, const char* name) const {
    return numbers(piece.child(part).find_child_by_attribute("DataArray", "Name", name));
  }
};

double chain_area(const std::vector<double>& coordinates, std::size_t first, std::size_t last) {
  double twice = 0;
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t j = i + 1 == last ? first : i + 1;
    twice += coordinates[3 * i] * coordinates[3 * j + 1] - coordinates[3 * j] * coordinates[3 * i + 1];
  }
  return twice / 2;
}

}  // namespace

TEST(Vtk, a_hole_is_reached_by_a_bridge_and_the_area_is_that_of_the_block) {
  const Parsed parsed(square_with_hole_and_triangle());
  EXPECT_EQ(parsed.piece.attribute("NumberOfPoints").as_int(), 13);
  EXPECT_EQ(parsed.array("Cells", "offsets"), (std::vector<double>{10, 13}));
  EXPECT_DOUBLE_EQ(chain_area(parsed.array("Points", "Points"), 0, 10), 15);
}

TEST(Vtk, every_block_is_a_polygon_with_its_number_material_and_stress) {
  const Parsed parsed(square_with_hole_and_triangle());
  EXPECT_EQ(parsed.piece.attribute("NumberOfCells").as_int(), 2);
  EXPECT_EQ(parsed.array("Cells", "types"), (std::vector<double>{7, 7}));
  EXPECT_EQ(parsed.array("CellData", "block"), (std::vector<double>{1, 2}));
  EXPECT_EQ(parsed.array("CellData", "material"), (std::vector<double>{1, 2}));
  EXPECT_EQ(parsed.array("CellData", "stress_yy"), (std::vector<double>{0, -12262.5}));
}

TEST(Vtk, coordinates_keep_their_last_digit) {
  const Parsed parsed(square_with_hole_and_triangle());
  EXPECT_EQ(parsed.array("Points", "Points").at(33), 1.0 / 3.0 + 4);
}

TEST(Vtk, a_frame_without_blocks_is_an_empty_grid) {
  const Parsed parsed(Frame{});
  EXPECT_EQ(parsed.piece.attribute("NumberOfCells").as_int(-1), 0);
}

TEST(Vtk, the_list_of_files_gives_real_times_and_safe_names) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(pvd({{0.1, 0, "a&b.vtu"}, {1, 0, "c.vtu"}}).c_str()));
  const pugi::xml_node first = document.child("VTKFile").child("Collection").first_child();
  EXPECT_STREQ(first.attribute("timestep").value(), "0.1");
  EXPECT_STREQ(first.attribute("file").value(), "a&b.vtu");
  EXPECT_STREQ(first.next_sibling().attribute("timestep").value(), "1");
}

TEST(Vtk, the_list_of_files_names_parts_and_reads_back_with_and_without_names) {
  const std::vector<PvdEntry> entries{
      {0.1, 0, "c.vtu", "blocks"}, {0.1, 4, "joints_c.vtp", "a \"b\""}, {1, 0, "d.vtu", ""}};
  const std::string text = pvd(entries);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  EXPECT_STREQ(document.child("VTKFile").child("Collection").last_child().previous_sibling().attribute("name").value(),
               "a \"b\"");
  const std::vector<PvdEntry> back = read_pvd(text);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[0].name, "blocks");
  EXPECT_EQ(back[1].file, "joints_c.vtp");
  EXPECT_EQ(back[1].part, 4);
  EXPECT_EQ(back[2].name, "");
  EXPECT_EQ(back[2].file, "d.vtu");
}

TEST(Vtk, a_list_of_files_with_a_long_value_or_a_cut_end_reads_what_it_has) {
  const std::string first = "<DataSet timestep=\"0.5\" part=\"0\" file=\"a.vtu\"/>";
  const std::string second = "<DataSet timestep=\"1" + std::string(200'000, '0') + "\" part=\"0\" file=\"b.vtu\"/>";
  const std::vector<PvdEntry> back = read_pvd("<VTKFile><Collection>" + first + second + "<DataSet timestep=");
  ASSERT_GE(back.size(), 2U);
  EXPECT_EQ(back[0].file, "a.vtu");
  EXPECT_EQ(back[0].time, 0.5);
}

TEST(Vtk, a_field_has_displacement_and_stress_at_every_corner) {
  FieldFrame field{2, 0.5, {}};
  const auto corner = [](double x, double y) { return FieldCorner{{x, y}, {x / 100, y / 10}, {x, y, x + y}}; };
  field.elements.push_back({0, 1, {{corner(0, 0), corner(2, 0), corner(0, 2)}}, corner(1, 1)});
  field.elements.push_back({1,
                            0,
                            {{corner(0, 0), corner(9, 0), corner(9, 9), corner(0, 9)},
                             {corner(1, 1), corner(1, 2), corner(2, 2), corner(2, 1)}},
                            corner(4, 4)});
  Frame frame{2, 0.5, {}, {}, {}, {}, {}};
  for (const FieldElement& element : field.elements) {
    ElementFrame& made = frame.elements.emplace_back();
    made.material = element.material;
    made.stress = element.middle.stress;
    for (const auto& loop : element.loops) {
      made.loops.emplace_back();
      for (const FieldCorner& c : loop) made.loops.back().push_back(c.position + c.displacement);
    }
  }
  const Parsed parsed(frame, field);
  EXPECT_EQ(parsed.piece.attribute("NumberOfCells").as_int(), 2);
  EXPECT_EQ(parsed.piece.attribute("NumberOfPoints").as_int(), 3 + 4 + 4 + 2);  // the way to the hole and back
  const std::vector<double> places = numbers(parsed.piece.child("Points").child("DataArray"));
  const std::vector<double> stress = parsed.array("PointData", "stress_xy");
  const std::vector<double> moved = parsed.array("PointData", "displacement");
  ASSERT_EQ(places.size(), 39U);
  ASSERT_EQ(stress.size(), 13U);
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const Point start{places[3 * i] - moved[3 * i], places[3 * i + 1] - moved[3 * i + 1]};
    EXPECT_NEAR(stress[i], start.x + start.y, 1e-14);
    EXPECT_NEAR(moved[3 * i + 1], start.y / 10, 1e-15);
  }
  EXPECT_EQ(parsed.array("CellData", "body"), (std::vector<double>{1, 2}));
  EXPECT_EQ(parsed.array("CellData", "material"), (std::vector<double>{2, 1}));
  EXPECT_EQ(parsed.array("CellData", "stress_xx"), (std::vector<double>{1, 4}));
}

// σ = λ tr ε + 2 μ ε, with Lamé's constants, of a strain that is given.
TEST(Vtk, elastic_strain_is_the_one_whose_stress_is_told) {
  BlockMaterial soft, hard;
  soft.youngs_modulus = 1e9, soft.poissons_ratio = 0.3;
  hard.youngs_modulus = 4e10, hard.poissons_ratio = 0.15;
  const auto stress_of = [](const BlockMaterial& rock, double xx, double yy, double xy, double zz) {
    const double mu = rock.youngs_modulus / (2 * (1 + rock.poissons_ratio));
    const double lambda = 2 * mu * rock.poissons_ratio / (1 - 2 * rock.poissons_ratio);
    const double trace = lambda * (xx + yy + zz);
    return Stress{trace + 2 * mu * xx, trace + 2 * mu * yy, 2 * mu * xy, trace + 2 * mu * zz};
  };
  Frame frame = square_with_hole_and_triangle();
  frame.elements[0].stress = stress_of(soft, 1e-3, -2e-3, 5e-4, 3e-4);
  frame.elements[1].stress = stress_of(hard, -1e-3, 4e-3, -7e-4, 0);
  FieldFrame field;
  for (const ElementFrame& element : frame.elements) {
    FieldElement& made = field.elements.emplace_back();
    made.material = element.material;
    for (const auto& loop : element.loops) {
      made.loops.emplace_back();
      for (const Point p : loop) made.loops.back().push_back({p, {}, element.stress});
    }
  }
  EXPECT_TRUE(Parsed(frame, field).array("CellData", "elastic_strain_xx").empty());
  const Parsed parsed(frame, field, {soft, hard});
  const std::map<std::string, std::pair<double, double>> wanted{{"elastic_strain_xx", {1e-3, -1e-3}},
                                                                {"elastic_strain_yy", {-2e-3, 4e-3}},
                                                                {"elastic_strain_xy", {5e-4, -7e-4}},
                                                                {"elastic_strain_zz", {3e-4, 0}}};
  for (const auto& [name, strain] : wanted) {
    const std::vector<double> cells = parsed.array("CellData", name.c_str());
    ASSERT_EQ(cells.size(), 2U) << name;
    EXPECT_NEAR(cells[0], strain.first, 1e-17) << name;
    EXPECT_NEAR(cells[1], strain.second, 1e-17) << name;
    const std::vector<double> corners = parsed.array("PointData", name.c_str());
    ASSERT_EQ(corners.size(), 13U) << name;
    EXPECT_EQ(corners.front(), cells[0]) << name;
    EXPECT_EQ(corners.back(), cells[1]) << name;
  }
}

TEST(Vtk, what_rock_that_yields_remembers_is_told_of_cells_where_some_may) {
  Frame frame = square_with_hole_and_triangle();
  EXPECT_TRUE(Parsed(frame).array("CellData", "yield_state").empty());
  frame.plastic = PlasticTotals{};
  frame.elements[1].plastic = PlasticState{0.25, -0.125, 1.0 / 3, -0.125, 0.5, YieldRegion::apex, true};
  const Parsed parsed(frame);
  EXPECT_EQ(parsed.array("CellData", "plastic_strain_xx"), (std::vector<double>{0, 0.25}));
  EXPECT_EQ(parsed.array("CellData", "plastic_strain_xy"), (std::vector<double>{0, 1.0 / 3}));
  EXPECT_EQ(parsed.array("CellData", "equivalent_plastic_strain"), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(parsed.array("CellData", "yield_state"), (std::vector<double>{0, 3}));
  EXPECT_EQ(parsed.array("CellData", "has_yielded"), (std::vector<double>{0, 1}));
  EXPECT_EQ(parsed.array("CellData", "mean_stress"), (std::vector<double>{0, -12262.5 / 3}));
}

}  // namespace keyblock::formats::vtk_test
