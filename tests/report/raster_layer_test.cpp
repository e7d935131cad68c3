// Tests layers of pages: many shapes become an image with the same areas, few remain shapes in their sequence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <pugixml.hpp>
#include <random>
#include <ranges>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"
#include "report/drawing/png.hpp"
#include "report/drawing/raster.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report::raster_layer_test {
namespace {

using Loops = std::vector<std::vector<Point>>;

std::vector<Point> square(Point corner, double side) {
  return {corner, corner + Point{side, 0}, corner + Point{side, side}, corner + Point{0, side}};
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

/// The data of a chunk; its check sum is compared.
std::string chunk(const std::string& png, const std::string& kind) {
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t size = number_at(png, at);
    const std::string whole = png.substr(at + 4, 4 + size);
    const auto* bytes = reinterpret_cast<const Bytef*>(whole.data());
    EXPECT_EQ(number_at(png, at + 8 + size), crc32(0, bytes, static_cast<uInt>(whole.size()))) << whole.substr(0, 4);
    if (whole.starts_with(kind)) return whole.substr(4);
    at += 12 + size;
  }
  ADD_FAILURE() << "no chunk " << kind;
  return {};
}

Image decoded(const std::string& png) {
  EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
  const std::string head = chunk(png, "IHDR"), colours = chunk(png, "PLTE"), opacities = chunk(png, "tRNS");
  EXPECT_EQ(head.substr(8), std::string("\x08\x03\0\0\0", 5));
  Image image{static_cast<int>(number_at(head, 0)), static_cast<int>(number_at(head, 4)), {}};
  std::string rows(static_cast<std::size_t>(image.height) * static_cast<std::size_t>(image.width + 1), '\0');
  const std::string packed = chunk(png, "IDAT");
  uLongf size = rows.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()),
            Z_OK);
  EXPECT_EQ(size, rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto index = static_cast<unsigned char>(rows[i]);
    if (i % static_cast<std::size_t>(image.width + 1) == 0) {
      EXPECT_EQ(index, 0) << "no filter";
      continue;
    }
    std::uint32_t colour = static_cast<unsigned char>(opacities.at(index));
    for (std::size_t k = 0; k < 3; ++k) colour = colour << 8 | static_cast<unsigned char>(colours.at(3 * index + k));
    image.pixels.push_back(colour);
  }
  return image;
}

/// The only image of a page, and its place.
PlacedImage image_in(const std::string& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(svg.c_str()));
  const pugi::xml_node node = document.child("svg").child("image");
  const std::string head = "data:image/png;base64,", data = node.attribute("href").value();
  EXPECT_TRUE(data.starts_with(head));
  return {decoded(from_base64(data.substr(head.size()))),
          {node.attribute("x").as_double(), node.attribute("y").as_double()},
          {node.attribute("width").as_double(), node.attribute("height").as_double()}};
}

std::uint32_t pixel_at(const PlacedImage& placed, Point at) {
  const Point p = at - placed.corner;
  const double scale = placed.image.width / placed.size.x;
  return placed.image.pixels.at(static_cast<std::size_t>(scale * p.y) * static_cast<std::size_t>(placed.image.width) +
                                static_cast<std::size_t>(scale * p.x));
}

double filled_area(const PlacedImage& placed) {
  const auto filled = std::ranges::count_if(placed.image.pixels, [](std::uint32_t pixel) { return pixel != 0; });
  return static_cast<double>(filled) / static_cast<double>(placed.image.pixels.size()) * placed.size.x * placed.size.y;
}

/// A page with one raster of `shapes`. Shapes without an area fill the layer first.
std::string page_of(const std::vector<Loops>& shapes, const Style& style) {
  SvgPage page(300, 200);
  page.layer([&] {
    for (std::size_t i = 0; i < kMostShapeText / 20; ++i) page.polygon({{{1, 1}, {1, 1}, {1, 1}}}, style);
    for (const Loops& loops : shapes) page.polygon(loops, style);
  });
  return page.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST(Png, an_image_comes_back_with_each_pixel) {
  Image image{7, 5, {}};
  std::mt19937 dice(3);
  for (int i = 0; i < 35; ++i) image.pixels.push_back(i % 3 == 0 ? 0 : 0xFF000000 | (dice() & 0xFFFFFF));
  image.pixels[4] = 0x80123456;  // half transparent
  const Image back = decoded(png_of(image));
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST(Png, of_more_colours_than_a_palette_has_similar_ones_become_one) {
  Image image{100, 100, {}};
  for (std::uint32_t i = 0; i < 10'000; ++i)
    image.pixels.push_back(0xFF000000 | (i % 100) << 16 | i / 100);  // a corner of all colours
  const Image back = decoded(png_of(image));
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (const int shift : {24, 16, 8, 0})
      EXPECT_NEAR(image.pixels[i] >> shift & 0xFF, back.pixels[i] >> shift & 0xFF, 7);
}

TEST(Png, base64_is_padded_to_groups_of_four) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(RasterLayer, its_area_is_that_of_the_polygons) {
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> radius(0.2, 0.75), offset(0, 0.5);
  for (const double size : {40.0, 9.0, 2.0}) {
    std::vector<Loops> shapes;
    double sum = 0;
    for (Point middle{size, size}; middle.y < 200 - size; middle.x += 2 * size) {
      if (middle.x > 300 - size) middle = {size, middle.y + 2 * size};
      const Point apart = middle + Point{offset(dice), offset(dice)};  // of a pixel
      std::vector<Point> loop;
      for (int i = 0; i < 7; ++i) {
        const double angle = 2 * M_PI * i / 7;
        loop.push_back(apart + size * radius(dice) * Point{std::cos(angle), std::sin(angle)});
      }
      if (middle.y > 200 - size) break;
      sum += std::abs(area(loop));
      shapes.push_back({loop});
    }
    EXPECT_NEAR(filled_area(image_in(page_of(shapes, {.fill = "#112233"}))), sum, 0.01 * sum) << size;
  }
}

TEST(RasterLayer, a_hole_stays_open) {
  const Loops frame{square({50, 40}, 100), square({80, 70}, 40), square({90, 80}, 20)};
  const PlacedImage placed = image_in(page_of({frame}, {.fill = "#e3d9c6"}));
  EXPECT_EQ(placed.corner, (Point{50, 40}));
  EXPECT_EQ(placed.size, (Point{100, 100}));
  EXPECT_EQ(pixel_at(placed, {60, 50}), 0xFFE3D9C6);
  EXPECT_EQ(pixel_at(placed, {85, 75}), 0U) << "the hole";
  EXPECT_EQ(pixel_at(placed, {100, 90}), 0xFFE3D9C6) << "an island in it";
}

TEST(RasterLayer, edges_thinner_than_a_pixel_are_pale_and_fade_out_round_small_shapes) {
  const auto edge_of = [](double side, double width) {
    Raster raster(100, 100);
    raster.draw({square({20, 20}, side)}, true, {.fill = 0xFFFFFFFF, .stroke = 0xFF000000, .width = width});
    return pixel_at(raster.image(), {20.1, 20 + side / 2});
  };
  EXPECT_EQ(edge_of(20, 0.5), 0xFF000000) << "one pixel";
  EXPECT_EQ(edge_of(20, 0.25), 0xFF7F7F7F) << "half a pixel";
  EXPECT_EQ(edge_of(3, 0.25), 0xFFBFBFBF) << "around six pixels";
  EXPECT_EQ(edge_of(2, 0.25), 0xFFFFFFFF);
  EXPECT_EQ(edge_of(2, 0.5), 0xFF000000);
}

TEST(RasterLayer, lines_have_their_width_and_their_dashes) {
  Raster raster(100, 100);
  raster.draw({{{10, 50}, {90, 50}}}, false, {.stroke = 0xFF0000FF, .width = 4, .dash = 10, .gap = 5});
  const PlacedImage placed = raster.image();
  EXPECT_NEAR(filled_area(placed), 4 * (5 * 10 + 5), 1e-9);
  EXPECT_NE(pixel_at(placed, {19, 51}), 0U);
  EXPECT_EQ(pixel_at(placed, {21, 51}), 0U);
  Raster slanted(100, 100);
  slanted.draw({{{10, 10}, {50, 90}}}, false, {.stroke = 0xFF0000FF, .width = 0.5});
  EXPECT_EQ(filled_area(slanted.image()), 160 * 0.25) << "a pixel in each row";
}

TEST(RasterLayer, shapes_remain_shapes_up_to_the_limit) {
  SvgPage page(300, 200);
  page.layer([&] {
    for (int part = 0; part < 21; ++part)
      page.layer([&] {  // part of the outer one
        for (int i = 0; i < 100; ++i) page.polygon({square({1, 1}, 5)}, {.fill = "#112233"});
      });
    page.text({5, 5}, "a name");
  });
  EXPECT_EQ(count(page.str(), "<path"), 2100U);
  EXPECT_EQ(count(page.str(), "<image"), 0U);
  EXPECT_EQ(count(page.str(), "a name"), 1U);
  const std::string many = page_of({}, {.fill = "#112233"});
  EXPECT_EQ(count(many, "<path"), 0U);
  SvgPage apart(300, 200);
  for (std::size_t i = 0; i < kMostShapeText / 20; ++i) apart.polygon({square({1, 1}, 5)}, {.fill = "#112233"});
  EXPECT_EQ(count(apart.str(), "<path"), kMostShapeText / 20) << "outside of layers all are shapes";
}

// A reader sees the later shape over the earlier one.
TEST(SvgPage, shapes_of_one_style_share_it_and_keep_their_sequence) {
  SvgPage page(10, 10);
  const Style red{.fill = "#ff0000"}, blue{.fill = "#0000ff", .stroke = "#000000"};
  const std::vector<std::pair<double, const Style*>> drawn{{1, &red},  {2, &red}, {3, &red}, {4, &blue},
                                                           {5, &blue}, {6, &red}, {7, &blue}};
  for (const auto& [side, style] : drawn) page.polygon({square({0, 0}, side)}, *style);
  page.text({1, 1}, "one");
  page.text({2, 2}, "two");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(page.str().c_str()));
  std::string seen;
  for (const pugi::xml_node node :
       document.child("svg").select_nodes("descendant::path") | std::views::transform(&pugi::xpath_node::node)) {
    const bool is_shared = std::string(node.parent().name()) == "g";
    const std::string fill = (is_shared ? node.parent() : node).attribute("fill").value();
    EXPECT_EQ(node.attribute("fill").empty(), is_shared);
    const std::string corners = node.attribute("d").value();
    seen += corners.substr(5, 1) + (fill == "#ff0000" ? "r" : "b") + (is_shared ? "* " : " ");
  }
  EXPECT_EQ(seen, "1r* 2r* 3r* 4b* 5b* 6r 7b ");
  EXPECT_EQ(document.select_nodes("//g").size(), 3U) << "two of shapes, one of words";
}

}  // namespace keyblock::report::raster_layer_test
