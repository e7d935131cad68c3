// Draws the common parts of pictures of blocks: marks of points, block edges, legend and scale bar.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "problem/run_choices.hpp"
#include "report/drawing/svg.hpp"

namespace keyblock::report {

/// A bolt that carries or may, one that broke, and one that has no properties and carries nothing.
enum class BoltState { carries, broken, idle };

inline constexpr std::string_view kBoltColour = "#5e3c99";

enum class Mark { fixed_point, loading_point, measured_point };

/// Draws the sign of a point of the scene at a place of the page.
void draw_mark(SvgPage& page, Point at, Mark mark);

/// Draws a bolt between two places of the page, as a full line with plates at its ends, and its name behind the second
/// end. A broken bolt has a gap and a cross in its middle; one that carries nothing is a line of grey dots.
void draw_bolt(SvgPage& page, Point from, Point to, BoltState state, const std::string& name = {});

/// Width of block edges: one page unit for few blocks, finer where they crowd.
double edge_width(Point page_size, std::size_t block_count);

/// Draws the edges of a loop in the colours of their joint materials: `joints[i]` of the edge that arrives at corner i,
/// below 0 none. Runs of one material become one line each: fewer shapes for scenes of many blocks.
void draw_joint_edges(SvgPage& page, const std::vector<Point>& corners, const std::vector<int>& joints, double width);

/// Place of a block. `stays`: it is always shown.
struct PlacedBlock {
  Point middle;
  double area = 0;
  bool stays = false;
};

/// Returns the blocks that a picture leaves out, in their order: those far outside of `drawn`, if they are few of many
/// and a small part of the area. A sliver far below a slope would shrink the slope to a corner of the page.
std::vector<std::size_t> far_small_blocks(const Box& drawn, const std::vector<PlacedBlock>& blocks);

/// Returns the members of a list without those at the places `left_out`, which ascend.
template <class T>
std::vector<T> without(const std::vector<T>& all, const std::vector<std::size_t>& left_out) {
  std::vector<T> kept;
  auto next = left_out.begin();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (next != left_out.end() && *next == i)
      ++next;
    else
      kept.push_back(all[i]);
  return kept;
}

/// Returns "2 small blocks lie outside of the picture".
std::string outside_in_words(std::size_t count);

/// One entry of a legend: a filled square, a line, the sign of a point or of a bolt, or a number.
struct LegendEntry {
  enum class Sign { area, line, dashed_line, dots, mark, bolt, number };
  Sign sign = Sign::area;
  std::string_view colour;
  Mark mark = Mark::fixed_point;
  std::string words;
  BoltState bolt = BoltState::carries;
};

/// Adds an entry for each state of bolts that is there, with their number: "broken bolt (2)".
void add_bolts(std::vector<LegendEntry>& legend, const std::vector<BoltState>& states);

/// Adds "block material 1", or "granite (block material 1)" if it has a name, …: of many numbers the first twelve, and
/// how many more there are. Areas and lines have the colours of their number.
void add_numbered(std::vector<LegendEntry>& legend, const std::set<int>& numbers, LegendEntry::Sign sign,
                  std::string_view word, const std::vector<std::string>& names = {});

/// Returns the height of the entries in rows of `width`.
double legend_height(const std::vector<LegendEntry>& entries, double width);
void draw_legend(SvgPage& page, Point corner, double width, const std::vector<LegendEntry>& entries);

/// Draws a bar of round length, at most a quarter of `width`, with its length in the unit of the case. Its left end is
/// at `left`.
void draw_scale_bar(SvgPage& page, Point left, double width, const PageMap& map, const Units& units);

}  // namespace keyblock::report
