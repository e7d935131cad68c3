// Treats one sliver after another, then moves points and bolts; see treat_slivers.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut/bodies/treat_slivers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/sentences/sentences.hpp"
#include "base/words/plain_number.hpp"
#include "base/words/quoted_name.hpp"
#include "cut/bodies/slivers.hpp"
#include "cut/bodies/unite_blocks.hpp"
#include "geometry/box.hpp"

namespace keyblock {
namespace {

// Distance at which corners of neighbours are the same: as large as files round them, but far below the width of a
// sliver.
constexpr double kSameCorner = 1e-4;         // per size of the mean block
constexpr double kSameCornerOfWidth = 0.02;  // per width of the sliver
constexpr std::size_t kMostNamed = 3;        // slivers named by place in a warning

struct Piece {
  DrawnBlock block;
  BlockForm form;
  Box box;
  std::vector<std::size_t> members;  ///< numbers as cut
  bool is_gone = false;
  bool is_alone = false;  ///< shares a side with no block
};

Box box_about(const BlockPolygon& block, double margin) {
  Box box;
  for (const BlockVertex& vertex : block.outer)
    for (const Point corner : {Point{-margin, -margin}, Point{margin, margin}}) box.add(vertex.position + corner);
  return box;
}

bool do_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

std::size_t corners_of(const BlockPolygon& block) {
  std::size_t corners = block.outer.size();
  for (const BlockLoop& hole : block.holes) corners += hole.size();
  return corners;
}

std::string place_and_area(const BlockForm& form) {
  return fmt::format("{}, {} (area {})", plain(form.centroid.x), plain(form.centroid.y), plain(form.area, 3));
}

class Treatment {
 public:
  explicit Treatment(CutResult cut) : cut_(std::move(cut)), number_(cut_.blocks.blocks.size()) {
    std::size_t line = 0;
    for (BlockPolygon& block : cut_.blocks.blocks) {
      DrawnBlock drawn{std::move(block), {}};
      for (std::size_t i = 0; i < corners_of(drawn.polygon) && !cut_.joint_lines.empty(); ++i)
        drawn.lines.push_back(cut_.joint_lines[line++]);
      number_[pieces_.size()] = pieces_.size();
      was_sliver_.push_back(0);
      areas_.push_back(0);
      pieces_.push_back({std::move(drawn), {}, {}, {pieces_.size()}});
      measure(pieces_.back());
      areas_.back() = pieces_.back().form.area;
      total_ += areas_.back();
    }
    left_ = pieces_.size();
    area_left_ = total_;
  }

  CutResult glued() && {
    for (std::optional<std::size_t> sliver; (sliver = smallest_sliver());) glue(*sliver);
    std::size_t alone = 0;
    for (const Piece& piece : pieces_)
      alone += piece.is_alone && !piece.is_gone && is_sliver(piece.form, mean()) ? 1 : 0;
    tell("slivers_glued", alone);
    hand_over();
    warn_of_bolts();
    return std::move(cut_);
  }

  CutResult left_out() && {
    for (std::optional<std::size_t> sliver; (sliver = smallest_sliver());) {
      Piece& piece = pieces_[*sliver];
      require_nothing_on(*sliver);
      note(piece);
      piece.is_gone = true;
      area_left_ -= piece.form.area;
      if (--left_ == 0)
        throw InputError(cut_.blocks.place,
                         fmt::format("expected a block that is no sliver under slivers=leave_out, found all {} {}",
                                     pieces_.size(), slivers_in_words()));
    }
    tell("slivers_left_out", 0);
    hand_over();
    return std::move(cut_);
  }

 private:
  double mean() const { return area_left_ / static_cast<double>(left_); }

  static void measure(Piece& piece) {
    piece.form = form_of(piece.block.polygon);
    piece.box = box_about(piece.block.polygon, piece.form.width());
  }

  std::optional<std::size_t> smallest_sliver() const {
    std::optional<std::size_t> smallest;
    const double mean_area = mean();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      if (piece.is_gone || piece.is_alone || !is_sliver(piece.form, mean_area)) continue;
      if (!smallest || piece.form.area < pieces_[*smallest].form.area) smallest = i;
    }
    return smallest;
  }

  void note(const Piece& piece) {
    found_.push_back(piece.form);
    for (const std::size_t member : piece.members) was_sliver_[member] = 1;
  }

  void glue(std::size_t sliver) {
    Piece& own = pieces_[sliver];
    const double tolerance = std::min(kSameCorner * std::sqrt(mean()), kSameCornerOfWidth * own.form.width());
    std::optional<UnitedBlocks> best;
    std::size_t neighbour = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (i == sliver || pieces_[i].is_gone || !do_meet(own.box, pieces_[i].box)) continue;
      const bool is_larger = pieces_[i].form.area >= own.form.area;
      std::optional<UnitedBlocks> one =
          is_larger ? united(pieces_[i].block, own.block, tolerance) : united(own.block, pieces_[i].block, tolerance);
      if (one && (!best || one->shared > best->shared)) best = std::move(one), neighbour = i;
    }
    if (!best) {
      own.is_alone = true;
      return;
    }
    note(own);
    Piece& other = pieces_[neighbour];
    Piece& larger = other.form.area >= own.form.area ? other : own;
    Piece& smaller = &larger == &other ? own : other;
    larger.block = std::move(best->block);
    larger.members.insert(larger.members.end(), smaller.members.begin(), smaller.members.end());
    smaller.members.clear();
    smaller.is_gone = true;
    larger.is_alone = false;
    --left_;
    measure(larger);
  }

  void warn_without_effect(std::size_t alone) {
    Facts facts{{}, {{"rule", slivers_in_words()}}};
    facts.names = {{"setting", "slivers"}};
    if (alone > 0) facts.numbers = {{"slivers", alone}};
    const char* const form = alone > 0 ? "setting_without_effect:no_side" : "setting_without_effect:no_sliver";
    cut_.warnings.push_back(warning_of({form, std::move(facts)}, cut_.blocks.place));
  }

  /// `alone`: number of slivers that share no side with another block and stay.
  void tell(const char* form, std::size_t alone) {
    if (found_.empty()) return warn_without_effect(alone);
    double area = 0;
    for (std::size_t i = 0; i < areas_.size(); ++i) area += was_sliver_[i] ? areas_[i] : 0;
    std::vector<std::string> named;
    for (std::size_t i = 0; i < std::min(found_.size(), kMostNamed); ++i) named.push_back(place_and_area(found_[i]));
    const std::string more =
        found_.size() > kMostNamed ? fmt::format(" and {} more", found_.size() - kMostNamed) : std::string();
    const bool is_one = found_.size() == 1;
    Facts facts{{{"count", found_.size()}, {"blocks", pieces_.size()}, {"percent_of_area", 100 * area / total_}},
                {{"are", is_one ? "is a sliver," : "are slivers,"},
                 {"rule", slivers_in_words()},
                 {"treated", is_one ? "is" : "are"},
                 {"places", fmt::format("{}{}", fmt::join(named, "; "), more)}}};
    if (alone > 0) {
      facts.numbers.emplace_back("alone", alone);
      facts.texts.emplace_back("stay", alone == 1 ? "1 more shares no side with another and stays"
                                                  : fmt::format("{} more share no side with another and stay", alone));
    }
    for (const BlockForm& block : found_) facts.points.push_back({block.centroid.x, block.centroid.y});
    cut_.warnings.push_back(warning_of({form, std::move(facts)}, cut_.blocks.place));
  }

  void hand_over() {
    Blocks& blocks = cut_.blocks;
    blocks.blocks.clear();
    cut_.joint_lines.clear();
    for (Piece& piece : pieces_) {
      if (piece.is_gone) continue;
      for (const std::size_t member : piece.members) number_[member] = blocks.blocks.size();
      cut_.joint_lines.insert(cut_.joint_lines.end(), piece.block.lines.begin(), piece.block.lines.end());
      blocks.blocks.push_back(std::move(piece.block.polygon));
    }
    const auto renumber = [&](int& block) { block = static_cast<int>(number_[static_cast<std::size_t>(block)]); };
    for (std::vector<BlockPoint>* points : {&blocks.fixed_points, &blocks.loading_points, &blocks.measured_points})
      for (BlockPoint& point : *points) renumber(point.block);
    for (BlockBolt& bolt : blocks.bolts) {
      const bool was_between = bolt.first_block != bolt.second_block;
      renumber(bolt.first_block);
      renumber(bolt.second_block);
      if (was_between && bolt.first_block == bolt.second_block) idle_bolts_.push_back(bolt);
    }
  }

  static Facts facts_of_idle(const BlockBolt& bolt) {
    Facts facts{{}, {{"named", quoted_name(bolt.name.value_or({}))}}, {bolt.first_block + 1}};
    facts.points = {{bolt.segment.start.x, bolt.segment.start.y}, {bolt.segment.end.x, bolt.segment.end.y}};
    if (bolt.name) facts.names = {{"bolt", *bolt.name}};
    return facts;
  }

  void warn_of_bolts() {
    for (const BlockBolt& bolt : idle_bolts_)
      cut_.warnings.push_back(warning_of({"bolt_in_one_block:glued", facts_of_idle(bolt)}, bolt.place));
  }

  void require_nothing_on(std::size_t sliver) const {
    const Blocks& blocks = cut_.blocks;
    const auto refuse = [&](const char* what, Point at, const Place& place) {
      throw InputError(place.line > 0 ? place : blocks.place,
                       fmt::format("expected {} in a block that is no sliver under slivers=leave_out, found it at {}, "
                                   "{} in the one at {}; slivers=glue keeps it",
                                   what, plain(at.x), plain(at.y), place_and_area(pieces_[sliver].form)));
    };
    const auto look = [&](const std::vector<BlockPoint>& points, const char* what) {
      for (const BlockPoint& point : points)
        if (point.block == static_cast<int>(sliver)) refuse(what, point.position, point.place);
    };
    look(blocks.fixed_points, "a fixed point");
    look(blocks.loading_points, "a loading point");
    look(blocks.measured_points, "a measured point");
    for (const BlockBolt& bolt : blocks.bolts) {
      if (bolt.first_block == static_cast<int>(sliver)) refuse("the end of a bolt", bolt.segment.start, bolt.place);
      if (bolt.second_block == static_cast<int>(sliver)) refuse("the end of a bolt", bolt.segment.end, bolt.place);
    }
  }

  CutResult cut_;
  std::vector<Piece> pieces_;        ///< in the order as cut; the larger of two becomes their union
  std::vector<double> areas_;        ///< as cut
  std::vector<char> was_sliver_;     ///< per block as cut: it is a sliver, or part of one
  std::vector<std::size_t> number_;  ///< per block as cut: number of the final block it belongs to
  std::vector<BlockForm> found_;     ///< slivers in the order of their removal
  std::vector<BlockBolt> idle_bolts_;
  double total_ = 0;  ///< area of all blocks, as cut
  double area_left_ = 0;
  std::size_t left_ = 0;  ///< number of blocks
};

}  // namespace

CutResult with_slivers_treated(CutResult cut, Slivers slivers) {
  if (slivers == Slivers::kept || cut.blocks.blocks.empty()) return cut;
  Treatment treatment(std::move(cut));
  return slivers == Slivers::glued ? std::move(treatment).glued() : std::move(treatment).left_out();
}

}  // namespace keyblock
