// Tests the size of pictures of 100,000 blocks or elements, and the time that they take.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ctime>
#include <functional>
#include <iostream>
#include <pugixml.hpp>
#include <random>
#include <utility>

#include "report/blocks_picture.hpp"
#include "report/field_picture.hpp"
#include "report/rock/crack_picture.hpp"
#include "report/rock/plastic_picture.hpp"
#include "report/rock/strength_picture.hpp"
#include "report/run_picture.hpp"

namespace keyblock::report::large_pictures_test {
namespace {

constexpr int kSide = 317;  // squares: 100,489 in all
constexpr std::size_t kMostBytes = 2'000'000;
constexpr double kMostSeconds = 2;  // of the processor, which others slow down too; 0.2 on a free machine

enum class Values { per_block, linear };

FieldFrame squares(Values values) {
  std::mt19937 dice(1);
  std::uniform_real_distribution<double> noise(-1, 1);
  FieldFrame field;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const int number = kSide * i + j;
      FieldElement element{values == Values::per_block ? number : 0, number % 3, {}, {}};
      const auto corner = [&](double x, double y) {
        return FieldCorner{{x, y}, {0.2 * y, 0.1 * x}, {std::sin(0.05 * x) + 0.3 * noise(dice), 0, 0}};
      };
      element.middle = corner(i + 0.5, j + 0.5);
      std::vector<FieldCorner>& loop = element.loops.emplace_back();
      for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) {
        loop.push_back(corner(i + p.x, j + p.y));
        if (values == Values::per_block) loop.back().stress = element.middle.stress;
      }
      field.elements.push_back(element);
    }
  return field;
}

Frame frame_of(const FieldFrame& field, double factor) {
  Frame frame;
  for (const FieldElement& element : field.elements) {
    ElementFrame& out = frame.elements.emplace_back();
    out.material = element.material;
    out.loops.emplace_back();
    for (const FieldCorner& corner : element.loops.front())
      out.loops.back().push_back(corner.position + factor * corner.displacement);
    const int number = static_cast<int>(frame.elements.size()) - 1;
    if (number % 10 == 0) frame.fixed_points.push_back({out.loops.back()[0], {}, number});
  }
  return frame;
}

Blocks blocks_of(const FieldFrame& field) {
  Blocks blocks;
  for (const FieldElement& element : field.elements) {
    BlockPolygon& block = blocks.blocks.emplace_back();
    block.material = element.material;
    for (const FieldCorner& corner : element.loops.front()) block.outer.push_back({corner.position, element.material});
  }
  return blocks;
}

void expect_bounded(const std::string& name, const std::function<std::string()>& draw) {
  const std::clock_t processor = std::clock();
  const std::string svg = draw();
  const double seconds = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
  std::cout << fmt::format("{}: {} bytes, {:.3f} s of the processor\n", name, svg.size(), seconds);
  EXPECT_LT(svg.size(), kMostBytes) << name;
  EXPECT_LT(seconds, kMostSeconds) << name;
  EXPECT_TRUE(pugi::xml_document{}.load_string(svg.c_str())) << name;
  EXPECT_NE(svg.find("<image"), std::string::npos) << name;
  EXPECT_NE(svg.find("<text"), std::string::npos) << name;
}

}  // namespace

TEST(LargePictures, fields_are_bounded) {
  for (const Values values : {Values::per_block, Values::linear}) {
    const FieldFrame field = squares(values);
    FieldPicture picture{"t", field, field, {}, FieldShown::xx};
    expect_bounded("field", [&] { return field_picture(picture); });
    picture.shown = FieldShown::crosses;
    expect_bounded("crosses", [&] { return field_picture(picture); });
    expect_bounded("mesh", [&] { return mesh_picture("t", field); });
    const PlasticPicture plastic{"t", field, {}};
    expect_bounded("plastic", [&] { return plastic_picture(plastic); });
  }
}

TEST(LargePictures, blocks_and_runs_are_bounded) {
  const FieldFrame field = squares(Values::per_block);
  RunPicture run;
  run.start = frame_of(field, 0);
  run.end = frame_of(field, 1);
  for (std::size_t i = 0; i < run.end.elements.size(); ++i) run.joints.push_back({0, 1, 2, -1});
  const auto expect_run_bounded = [&](const std::string& name) {
    RunPicture given = run;
    expect_bounded(name, [&] { return run_picture(std::move(given)); });
  };
  expect_run_bounded("run");
  for (int i = 0; i < kSide * kSide; i += 10) run.marked.push_back(i);
  expect_run_bounded("run with marked blocks");
  const Blocks blocks = blocks_of(field);
  expect_bounded("blocks", [&] { return blocks_picture(blocks, {}, Numbers::all); });
  StrengthPicture strength;
  strength.standing = strength.before = field;
  strength.falling = field;
  for (FieldElement& element : strength.falling->elements) element.middle.displacement.x += 1;
  for (FieldElement& element : strength.falling->elements) element.loops[0][0].displacement.x += 1;
  strength.plastic_strains.assign(field.elements.size(), 0);
  expect_bounded("strength", [&] { return strength_picture(strength); });
  const History history;
  const CrackPicture cracks{"t", run.start, history, field};
  expect_bounded("cracks", [&] { return crack_picture(cracks); });
}

// Pixels of random colours cannot be compressed: the image gets a lower resolution.
TEST(LargePictures, noise_is_bounded) {
  std::mt19937 dice(2);
  SvgPage page(900, 700);
  page.layer([&] {
    for (int i = 0; i < 1800; ++i)
      for (int j = 0; j < 1400; ++j)
        page.rectangle({0.5 * i, 0.5 * j}, 0.5, 0.5, {.fill = fmt::format("#{:06x}", dice() & 0xFFFFFF)});
  });
  page.text({1, 1}, "words");
  EXPECT_LT(page.str().size(), kMostImageText + 2000);
}

}  // namespace keyblock::report::large_pictures_test
