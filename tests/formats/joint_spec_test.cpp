// The specification of joint sets: every key gets its place, defaults are as documented, other keys are refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/joint_spec.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "formats/case_file/schema/joint_keys.hpp"

namespace keyblock::formats::joint_spec_test {
namespace {

const std::string kBox = "\"rectangle\": {\"width\": 20, \"height\": 10}";

JointScene scene_of(const std::string& inside) {
  return joint_scene_of(read_json({"f", "{" + inside + "}"}));
}

std::string fault(const std::string& inside) {
  try {
    scene_of(inside);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST(JointSpec, every_key_lands_in_its_place) {
  const JointScene scene = scene_of(
      R"("slope": {"height": 8, "angle": 70, "bench": 2, "benches": 3, "toe": 4, "crest": 5, "base": 6, "x": 1, "y": 2},
         "tunnels": [{"shape": "horseshoe", "width": 3, "height": 4, "x": 5, "y": -2}],
         "sets": [{"dip": 30, "spacing": 1, "trace": 6, "gap": 0.5, "scatter": 0.2, "gap_scatter": 0.4,
                   "distribution": "normal", "spacing_distribution": "exponential", "joint": 4, "seed": 9}],
         "seed": 7, "boundary_joint": 2, "edge_node_ratio": 0.005, "fixed": [[0, 1, 2, 3]], "measured": [[4, 5]])");
  const auto& slope = std::get<SlopeShape>(scene.outline);
  EXPECT_EQ(slope.angle_deg, 70);
  EXPECT_EQ(slope.benches, 3);
  EXPECT_EQ(slope.toe + 10 * slope.crest + 100 * slope.base + 1000 * slope.x + 1e4 * slope.y, 21654);
  ASSERT_EQ(scene.tunnels.size(), 1u);
  EXPECT_EQ(scene.tunnels[0].shape, TunnelShape::horseshoe);
  EXPECT_EQ(scene.tunnels[0].height, 4);
  const JointSet& set = scene.sets.at(0);
  EXPECT_EQ(set.dip_deg, 30);
  EXPECT_EQ(set.dip_scatter, 0.2);
  EXPECT_EQ(set.spacing.distribution, Distribution::exponential);
  EXPECT_EQ(set.trace_length->mean, 6);
  EXPECT_EQ(set.trace_length->distribution, Distribution::normal);
  EXPECT_EQ(set.gap.scatter, 0.4);
  EXPECT_EQ(set.joint_material, 3);
  EXPECT_EQ(set.seed, 9u);
  EXPECT_EQ(scene.boundary_material, 1);
  EXPECT_EQ(scene.edge_node_ratio, 0.005);
  EXPECT_EQ(scene.fixed_lines.at(0).segment, (Segment{{0, 1}, {2, 3}}));
  EXPECT_EQ(scene.measured_points.at(0).position, (Point{4, 5}));
}

TEST(JointSpec, what_is_left_out_is_as_documented) {
  const JointScene scene = scene_of(kBox + R"(, "sets": [{"dip": 0, "spacing": 1}, {"dip": 90, "spacing": 2}])");
  EXPECT_EQ(scene.edge_node_ratio, 0.001);
  EXPECT_EQ(scene.boundary_material, 0);
  EXPECT_FALSE(scene.sets.at(1).trace_length);
  EXPECT_EQ(scene.sets[1].joint_material, 1);
  EXPECT_EQ(scene.sets[1].seed, 1u);
  EXPECT_NE(scene.sets[0].stream, scene.sets[1].stream);
  const auto slope = std::get<SlopeShape>(scene_of(R"("slope": {"height": 10, "angle": 45})").outline);
  EXPECT_EQ(slope.toe, 10);
  EXPECT_EQ(slope.crest, 15);
  EXPECT_EQ(slope.base, 5);
  EXPECT_EQ(slope.benches, 1);
}

TEST(JointSpec, corners_of_an_outline_come_counter_clockwise) {
  const Outline triangle{{0, 0}, {4, 0}, {4, 3}};
  EXPECT_EQ(std::get<Outline>(scene_of(R"("outline": [[0, 0], [4, 0], [4, 3]])").outline), triangle);
  const auto turned = std::get<Outline>(scene_of(R"("outline": [[4, 3], [4, 0], [0, 0]])").outline);
  EXPECT_EQ(turned, triangle);
  EXPECT_EQ(fault(R"("outline": [[0, 0], [1, 1]])"),
            "f:1:2: error: expected an outline of three or more corners, found 2");
  EXPECT_EQ(fault(R"("outline": [[0, 0], [1, 1], [2, 2]])"),
            "f:1:2: error: expected an outline with an area, found none");
}

TEST(JointSpec, an_outline_that_crosses_itself_is_refused_at_its_side_with_the_point) {
  EXPECT_EQ(fault("\"outline\": [[0, 0], [10, 0], [10, 4],\n [0, 9], [0, 6], [10, 6]]"),
            "f:1:31: error: expected an outline whose sides do not cross, found sides 3 and 5 that meet at (6, 6)");
  EXPECT_EQ(fault("\"outline\": [[0, 0],\n [2, 2], [2, 0], [0, 2]]"),
            "f:1:14: error: expected an outline whose sides do not cross, found sides 1 and 3 that meet at (1, 1)");
  EXPECT_EQ(fault(R"("outline": [[0, 0], [4, 0], [2, 0], [6, 0], [6, 3]])"),
            "f:1:14: error: expected an outline whose sides do not cross, found sides 1 and 3 that meet at (2, 0)");
}

TEST(JointSpec, a_face_that_cutting_would_merge_is_refused) {
  EXPECT_EQ(fault(R"("slope": {"height": 1e-300, "angle": 60, "toe": 8, "crest": 18, "base": 4})"),
            "f:1:2: error: expected a slope whose face rises by more than 0.026 (0.001 of its extent), found 1e-300");
  EXPECT_EQ(fault(R"("slope": {"height": 1, "angle": 60, "toe": 8, "crest": 18, "base": 4})"), "");
  EXPECT_NE(fault(R"("slope": {"height": 1, "angle": 60, "benches": 1000})"), "");
}

TEST(JointSpec, the_scatter_of_the_dip_is_in_degrees_or_a_share_of_90) {
  const auto scatter = [](const std::string& keys) {
    return scene_of(kBox + R"(, "sets": [{"dip": 30, "spacing": 1, )" + keys + "}]").sets.at(0).dip_scatter;
  };
  EXPECT_EQ(scatter(R"("scatter": 0.2, "dip_scatter_deg": 9)"), 0.1);
  EXPECT_EQ(scatter(R"("dip_scatter": 0.1)"), 0.1);
  EXPECT_NE(fault(kBox + R"(, "sets": [{"dip": 30, "spacing": 1, "dip_scatter": 0.1, "dip_scatter_deg": 9}])"), "");
  EXPECT_NE(fault(kBox + R"(, "sets": [{"dip": 30, "spacing": 1, "dip_scatter_deg": 91}])"), "");
}

TEST(JointSpec, faults_are_named_at_the_line_of_their_key) {
  EXPECT_EQ(fault(kBox + ",\n \"set\": []"),
            "f:2:2: error: expected one of the keys rectangle, slope, outline, tunnels, sets, seed, boundary_joint, "
            "edge_node_ratio, fixed, measured in the specification, found \"set\"");
  EXPECT_EQ(fault(kBox + ",\n\"sets\": [{\"dip\": 1,\n  \"spacing\": 0}]"),
            "f:3:3: error: expected spacing of joint set 1 (greater than 0), found 0");
  EXPECT_EQ(fault(kBox + ",\n\"sets\": [{\"dip\": 1}]"),
            "f:2:10: error: expected spacing of joint set 1 (greater than 0), found none");
  EXPECT_EQ(
      fault(kBox + ",\n\"sets\": [{\"dip\": 1, \"spacing\": 1, \"distribution\": \"cauchy\"}]"),
      "f:2:35: error: expected distribution of joint set 1 (one of normal, lognormal, exponential), found \"cauchy\"");
  EXPECT_EQ(fault(kBox + ",\n\"sets\": [{\"dip\": 1, \"spacing\": 1, \"gap\": 1}]"),
            "f:2:10: error: expected trace beside gap in joint set 1, found none");
  EXPECT_EQ(fault(kBox + ", \"slope\": {\"height\": 1, \"angle\": 45}"),
            "f:1:1: error: expected one of rectangle, slope and outline, found 2");
  EXPECT_EQ(fault(""), "f:1:1: error: expected one of rectangle, slope and outline, found none");
  EXPECT_EQ(fault(kBox + ",\n\"sets\": [{\"dip\": 1, \"spacing\": 1},\n {\"dip\": 1}]"),
            "f:3:2: error: expected spacing of joint set 2 (greater than 0), found none");
  EXPECT_NE(fault("\"slope\": {\"height\": 1, \"angle\": 91}"), "");
  EXPECT_NE(fault(kBox + ", \"fixed\": [[1, 2, 3]]"), "");
  EXPECT_NE(fault(kBox + ", \"tunnels\": [{\"width\": 1, \"x\": 1, \"y\": 1}]"), "");
  EXPECT_NE(fault(kBox + ", \"seed\": 1.5"), "");
  EXPECT_NE(fault("\"rectangle\": 3"), "");
}

TEST(JointSpec, the_schema_has_a_title_and_a_meaning_of_every_key_and_the_limits_of_the_reader) {
  for (const JointKey& key : joint_keys()) {
    EXPECT_FALSE(key.title.empty() || key.meaning.empty()) << key.key;
    EXPECT_EQ(key.unit.empty(), key.demand == nullptr) << key.key;
  }
  const auto schema = nlohmann::json::parse(joint_schema()).at("properties");
  const auto set = schema.at("sets").at("items").at("properties");
  EXPECT_EQ(set.size(), joint_keys_of("set").size());
  EXPECT_EQ(set.at("dip").at("minimum"), -360);
  EXPECT_EQ(set.at("dip").at("maximum"), 360);
  EXPECT_EQ(set.at("spacing").at("exclusiveMinimum"), 0);
  EXPECT_EQ(set.at("spacing").at("x-unit"), "L");
  EXPECT_EQ(set.at("scatter").at("maximum"), 1);
  EXPECT_EQ(set.at("trace").at("x-default"), "through the whole outline");
  EXPECT_EQ(set.at("gap_distribution").at("enum").size(), 3U);
  EXPECT_EQ(set.at("gap_distribution").at("x-words").size(), 3U);
  EXPECT_EQ(schema.at("sets").at("items").at("required"), nlohmann::json({"dip", "spacing"}));
  const auto lifts = schema.at("slope").at("properties").at("benches");
  EXPECT_EQ(lifts.at("type"), "integer");
  EXPECT_EQ(lifts.at("minimum"), 1);
  EXPECT_EQ(lifts.at("maximum"), 1000);
  EXPECT_EQ(schema.at("tunnels").at("items").at("properties").at("shape").at("enum").size(), 3U);
}

}  // namespace keyblock::formats::joint_spec_test
