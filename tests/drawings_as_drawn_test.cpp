// Drawings as people draw them: an outline crossed by joints, with a known number of blocks, and with gaps, doubles,
// hidden layers, symbols and wrong units. Each gives that number, or a message with the place.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "cut/bodies/cut_blocks.hpp"
#include "formats/dxf/dxf.hpp"
#include "geometry/polygon.hpp"
#include "tests/formats/dxf_samples.hpp"

namespace keyblock::drawings_as_drawn_test {
namespace {

using formats::Reading;

constexpr int kDrawingsOfAKind = 10;

/// A rectangle crossed by joints, rotated and moved.
class Sheet {
 public:
  explicit Sheet(unsigned seed) : random_(seed) {
    width_ = share(5, 40);
    height_ = share(4, 20);
    angle_ = seed % 3 == 0 ? 0 : share(0, 6.28);
    origin_ = seed % 4 == 0 ? Point{} : Point{share(-500, 500), share(-500, 500)};
    upright_ = static_cast<int>(share(1, 5));
    level_ = static_cast<int>(share(1, 4));
    for (int i = 1; i <= upright_; ++i) x_.push_back(width_ * (i + share(-0.2, 0.2)) / (upright_ + 1));
    for (int i = 1; i <= level_; ++i) y_.push_back(height_ * (i + share(-0.2, 0.2)) / (level_ + 1));
  }

  double share(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t blocks() const { return x_.size() * y_.size() + x_.size() + y_.size() + 1; }
  double width() const { return width_; }
  double height() const { return height_; }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  Point at(double x, double y) const {
    const double c = std::cos(angle_), s = std::sin(angle_);
    return scale * (origin_ + Point{c * x - s * y, s * x + c * y});
  }

  std::string line(const std::string& layer, double x0, double y0, double x1, double y1) const {
    const Point a = at(x0, y0), b = at(x1, y1);
    return fmt::format("0\nLINE\n8\n{}\n10\n{}\n20\n{}\n30\n{}\n11\n{}\n21\n{}\n31\n{}\n", layer, a.x, a.y, elevation,
                       b.x, b.y, elevation);
  }

  std::string outline(double gap = 0, double overshoot = 0) const {
    const double o = overshoot;
    return line("BOUNDARY", -o, 0, width_ + o, 0) + line("BOUNDARY", width_, -o, width_, height_ + o) +
           line("BOUNDARY", width_ + o, height_, -o, height_) + line("BOUNDARY", 0, height_ + o, 0, gap - o);
  }

  /// Joints that end so far outside the outline.
  std::string joints(double beyond) const {
    std::string text;
    for (const double x : x_) text += line("JOINT_1", x, -beyond, x, height_ + beyond);
    for (const double y : y_) text += line("JOINT_2", -beyond, y, width_ + beyond, y);
    return text;
  }

  double elevation = 0;
  double scale = 1;

 private:
  std::mt19937 random_;
  double width_ = 0, height_ = 0, angle_ = 0;
  Point origin_;
  int upright_ = 0, level_ = 0;
  std::vector<double> x_, y_;
};

Reading read(const std::string& entities, const formats::ReadHint& hint = {}, const std::string& header = "",
             const std::string& sections = "") {
  std::string text = formats::dxf_text(entities, header);
  text.erase(0, text.find("0\nSECTION"));  // as drawing programs write it, without the comment of this one
  text.insert(text.find("0\nSECTION\n2\nENTITIES"), sections);
  return formats::kDxf.read({"sheet.dxf", text}, hint);
}

formats::ReadHint joining(double distance) {
  formats::ReadHint hint;
  hint.drawing.join = distance;
  return hint;
}

std::string sentence(const Warnings& warnings, const std::string& name) {
  for (const Warning& warning : warnings)
    if (warning.name == name) return warning.sentence;
  return "";
}

/// Returns the number of blocks, their area over that of the sheet, and all messages.
struct Cut {
  std::size_t blocks = 0;
  double area = 0;
  Warnings warnings;
  std::size_t bolts = 0;
};

Cut cut_of(const Reading& reading) {
  Cut cut;
  cut.warnings = reading.warnings;
  try {
    const CutResult result = cut_blocks(*reading.content.drawing);
    cut.blocks = result.blocks.blocks.size();
    cut.bolts = result.blocks.bolts.size();
    for (const BlockPolygon& block : result.blocks.blocks) cut.area += area(points_of(block.outer));
    cut.warnings = joined(cut.warnings, result.warnings);
  } catch (const InputError& error) {
    cut.warnings.push_back({"refused", error.place(), error.sentence()});
  }
  return cut;
}

void for_sheets(const std::function<void(Sheet&)>& look) {
  for (unsigned seed = 1; seed <= kDrawingsOfAKind; ++seed) {
    SCOPED_TRACE(seed);
    Sheet sheet(seed);
    look(sheet);
  }
}

void expect_all(const Sheet& sheet, const Cut& cut) {
  EXPECT_EQ(cut.blocks, sheet.blocks());
  EXPECT_NEAR(cut.area, sheet.width() * sheet.height() * sheet.scale * sheet.scale, 1e-3 * cut.area);
}

std::string place_of(Point p) {
  return fmt::format("({:.4g}", p.x).substr(0, 4);
}

}  // namespace

TEST(DrawingsAsDrawn, joints_that_run_beyond_the_outline_are_cut_off_at_it) {
  for_sheets([](Sheet& sheet) { expect_all(sheet, cut_of(read(sheet.outline() + sheet.joints(sheet.share(0, 3))))); });
}

TEST(DrawingsAsDrawn, an_outline_drawn_twice_counts_once) {
  for_sheets([](Sheet& sheet) {
    const double w = sheet.width(), h = sheet.height(), middle = sheet.share(0.2, 0.8) * w;
    const std::string again = sheet.line("BOUNDARY", middle, 0, 0, 0) + sheet.line("BOUNDARY", middle, 0, w, 0) +
                              sheet.line("BOUNDARY", w, h, w, 0) + sheet.line("BOUNDARY", w, h, 0, h) +
                              sheet.line("BOUNDARY", 0, 0, 0, h);
    const Cut cut = cut_of(read(sheet.outline() + again + sheet.joints(1)));
    expect_all(sheet, cut);
    EXPECT_EQ(sentence(cut.warnings, "dxf_not_clipped"), "");
  });
}

TEST(DrawingsAsDrawn, joints_drawn_twice_count_once) {
  for_sheets([](Sheet& sheet) {
    std::string again = sheet.joints(2);
    const double x = sheet.x().front();
    again += sheet.line("JOINT_3", x, sheet.height() + 1, x, -1) + sheet.line("JOINT_3", x, 0, x, sheet.height() / 3);
    expect_all(sheet, cut_of(read(sheet.outline() + sheet.joints(1) + again)));
  });
}

TEST(DrawingsAsDrawn, a_gap_of_the_outline_is_told_with_place_and_width_and_joined) {
  for_sheets([](Sheet& sheet) {
    const double gap = sheet.share(1e-4, 4e-3) * sheet.height();
    const std::string drawing = sheet.outline(gap) + sheet.joints(1);
    const Cut open = cut_of(read(drawing));
    const std::string told = sentence(open.warnings, "dxf_not_clipped");
    EXPECT_NE(told.find(fmt::format("{:.2g}", gap).substr(0, 4)), std::string::npos) << told << " of " << gap;
    EXPECT_TRUE(told.find(place_of(sheet.at(0, 0))) != std::string::npos ||
                told.find(place_of(sheet.at(0, gap))) != std::string::npos)
        << told;
    const Cut closed = cut_of(read(drawing, joining(1.5 * gap)));
    expect_all(sheet, closed);
    EXPECT_NE(sentence(closed.warnings, "ends_joined"), "");
  });
}

TEST(DrawingsAsDrawn, an_outline_that_overshoots_its_corners_is_told_and_trimmed) {
  for_sheets([](Sheet& sheet) {
    const double passed = sheet.share(1e-4, 4e-3) * sheet.height();
    const std::string drawing = sheet.outline(0, passed) + sheet.joints(1);
    EXPECT_NE(sentence(cut_of(read(drawing)).warnings, "dxf_not_clipped"), "");
    expect_all(sheet, cut_of(read(drawing, joining(1.5 * passed))));
  });
}

TEST(DrawingsAsDrawn, joints_that_end_just_short_are_told_with_place_and_width_and_joined) {
  for_sheets([](Sheet& sheet) {
    const double gap = sheet.share(1e-5, 2e-3) * sheet.height();
    const std::string drawing = sheet.outline() + sheet.joints(-gap);
    const Cut open = cut_of(read(drawing));
    EXPECT_LT(open.blocks, sheet.blocks());
    const std::string told = sentence(open.warnings, "ends_stop_short");
    const std::string ends = fmt::format("{} ends of lines stop", 2 * (sheet.x().size() + sheet.y().size()));
    EXPECT_NE(told.find(ends), std::string::npos) << told;
    EXPECT_NE(told.find(fmt::format("{:.1g}", gap).substr(0, 3)), std::string::npos) << told << " of " << gap;
    expect_all(sheet, cut_of(read(drawing, joining(1.5 * gap))));
  });
}

TEST(DrawingsAsDrawn, what_lies_on_hidden_layers_is_left_out_and_said) {
  for_sheets([](Sheet& sheet) {
    const bool is_off = sheet.share(0, 1) < 0.5;
    const std::string layers = fmt::format(
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nJoint_9 Alt\n70\n{}\n62\n{}\n0\nENDTAB\n0\nENDSEC\n",
        is_off ? 0 : 1, is_off ? -3 : 3);
    const double w = sheet.width(), h = sheet.height();
    const std::string old = sheet.line("JOINT_9 ALT", -1, 0.1 * h, w + 1, 0.83 * h) +
                            sheet.line("Joint_9 Alt", 0.1 * w, -1, 0.77 * w, h + 1);
    const Cut cut = cut_of(read(sheet.outline() + sheet.joints(1) + old, {}, "", layers));
    expect_all(sheet, cut);
    EXPECT_NE(sentence(cut.warnings, "dxf_hidden_layers").find("2 entities"), std::string::npos);
    formats::ReadHint named;
    named.layers.rows = {{"joint_9 alt", "joint 9"}};
    EXPECT_GT(cut_of(read(sheet.outline() + sheet.joints(1) + old, named, "", layers)).blocks, sheet.blocks());
  });
}

TEST(DrawingsAsDrawn, circles_and_plates_on_a_layer_of_bolts_are_symbols_and_heads_on_the_face_hold) {
  for_sheets([](Sheet& sheet) {
    std::string bolts;
    const int count = 12;
    for (int i = 0; i < count; ++i) {
      const double y = sheet.height() * (i + 0.5) / count;
      const Point head = sheet.at(0, y);
      bolts += sheet.line("BOLT_1", 0, y, 0.9 * sheet.width(), y);
      if (i < 3) bolts += sheet.line("BOLT_1", 0.9 * sheet.width(), y, 0, y);  // drawn twice
      bolts += fmt::format("0\nCIRCLE\n8\nBOLT_1\n10\n{}\n20\n{}\n40\n{}\n", head.x, head.y, 0.01 * sheet.height());
      bolts += fmt::format("0\nLWPOLYLINE\n8\nBOLT_1\n90\n3\n70\n1\n10\n{}\n20\n{}\n10\n{}\n20\n{}\n10\n{}\n20\n{}\n",
                           head.x, head.y, head.x + 0.1, head.y, head.x, head.y + 0.1);
    }
    const Cut cut = cut_of(read(sheet.outline() + sheet.joints(1) + bolts));
    expect_all(sheet, cut);
    EXPECT_EQ(cut.bolts, static_cast<std::size_t>(count));
    EXPECT_EQ(std::ranges::count(cut.warnings, "dxf_skipped", &Warning::name), 3)
        << "a line for each kind of symbol, one for bolts drawn twice";
  });
}

TEST(DrawingsAsDrawn, a_flat_drawing_at_any_elevation_is_taken) {
  for_sheets([](Sheet& sheet) {
    sheet.elevation = sheet.share(-400, 4000);
    const Cut cut = cut_of(read(sheet.outline() + sheet.joints(1)));
    expect_all(sheet, cut);
    EXPECT_EQ(sentence(cut.warnings, "dxf_skipped"), "");
  });
}

TEST(DrawingsAsDrawn, another_unit_than_that_of_the_file_is_taken_where_it_is_asked_for) {
  for_sheets([](Sheet& sheet) {
    sheet.scale = 1000;
    formats::ReadHint hint;
    hint.drawing.unit = "mm";
    const Cut cut = cut_of(read(sheet.outline() + sheet.joints(1000), hint, "9\n$INSUNITS\n70\n6\n"));
    sheet.scale = 1;
    expect_all(sheet, cut);
    EXPECT_NE(sentence(cut.warnings, "dxf_unit_overruled").find("millimetre"), std::string::npos);
  });
}

TEST(DrawingsAsDrawn, joints_drawn_as_an_array_and_as_splines_cut_as_lines_do) {
  for_sheets([](Sheet& sheet) {
    const int rows = 4;
    const Point zero = sheet.at(0, 0), right = sheet.at(1, 0) - zero;
    const std::string block = fmt::format(
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nbed\n10\n0\n20\n0\n0\nLINE\n8\n0\n10\n-1\n20\n0\n11\n{}\n21\n0\n"
        "0\nENDBLK\n0\nENDSEC\n",
        sheet.width() + 1);
    const double spacing = sheet.height() / (rows + 1);
    const Point first = sheet.at(0, spacing);
    std::string joints =
        fmt::format("0\nINSERT\n8\nJOINT_2\n2\nbed\n10\n{}\n20\n{}\n50\n{}\n70\n1\n71\n{}\n45\n{}\n", first.x, first.y,
                    std::atan2(right.y, right.x) * 180 / std::acos(-1.0), rows, spacing);
    for (const double x : sheet.x()) {
      joints += "0\nSPLINE\n8\nJOINT_1\n71\n3\n";
      for (const int knot : {0, 0, 0, 0, 1, 1, 1, 1}) joints += fmt::format("40\n{}\n", knot);
      for (const double y : {-1.0, 0.3 * sheet.height(), 0.6 * sheet.height(), sheet.height() + 1}) {
        const Point p = sheet.at(x, y);
        joints += fmt::format("10\n{}\n20\n{}\n30\n0\n", p.x, p.y);
      }
    }
    const Cut cut = cut_of(read(sheet.outline() + joints, {}, "", block));
    EXPECT_EQ(cut.blocks, (sheet.x().size() + 1) * (rows + 1));
    EXPECT_NEAR(cut.area, sheet.width() * sheet.height(), 1e-3 * cut.area);
    EXPECT_EQ(sentence(cut.warnings, "dxf_skipped"), "");
  });
}

}  // namespace keyblock::drawings_as_drawn_test
