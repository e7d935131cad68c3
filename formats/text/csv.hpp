// Writes results as comma-separated tables, and reads tables (expected values, traces).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout (RFC 4180): a header line, then one line per row. Cells with a comma, quote or line break are in double
// quotes; a quote inside is doubled. Tables are written with `\n` and the shortest numbers that read back the same.
// They are read with `\n` or `\r\n`; a byte-order mark and empty lines are skipped. Every number is in the units of the
// case. If it declares them, headings name them: "dx1 [mm]"; otherwise some have letters: "dx1 [L]"
// (tables/run_tables.hpp has the quantity of each column).
//   history  step,time [T], then x,y,dx,dy [L] of every point i: xi yi dxi dyi; dx dy since the start;
//            then the force of every bolt, tension positive: bolti [F]. If load steps sum it, then the force of every
//            prescribed displacement on the bodies: reactioni_x,reactioni_y [F]. Elastoplastic rock adds more columns.
//            driveni [L] is the mean length of the prescribed displacement, if load steps follow it. load_share is the
//            load fraction, if steps follow the path of equilibria (load_control = arc_length). load_factor is that of
//            all loads, if cracks grow. yielded_fraction is the fraction of the area of such rock that has yielded
//            since the start; yielding_fraction is the fraction that ended the step on its yield surface. plastic_work
//            [F L] is stress times plastic strain, summed, per unit thickness (empty if it is not summed: in dynamics
//            without an energy balance)
//   points   step,time,point,x,y,dx,dy,sxx,syy,sxy,szz: one line per measured point and instant; points from 1, stress
//            tension positive. Elastoplastic rock adds plastic strain since the start (components of the tensor, xy
//            half of the shear angle), the equivalent one, κ = ∫ √(2/3) ‖dev dεᵖ‖, and yield_state at the end of the
//            step (0 elastic, 1 smooth part of the surface, 2 edge, 3 apex, 4 tension). Then follow has_yielded since
//            the start (0, 1), mean stress, von Mises stress and Lode angle (material/stress_invariants.hpp). Elastic
//            rock has only the last three
//   steps    step,time,dt,oci,contacts,closed,k_blocks,penalty,disp_ratio,max_penetration: one line per accepted step.
//            oci counts the open–close iterations. k_blocks counts the elements and the pairs of elements with a
//            contact (the Berkeley program counts fill-in of its factorisation too). disp_ratio is the greatest
//            displacement over the allowed one
//   blocks   step,time,block,material,cx,cy,rot,dx,dy,sxx,syy,sxy,area,szz: one line per block and frame; block and
//            material from 1, rot in radians, stress tension positive, szz out of the plane. Elastoplastic rock adds
//            the same columns as in points, at the centroid
//   rounds   step,round,residual: Newton iterations in the last part of each load step of elastoplastic rock, 0 before
//            the first; residual is the imbalance over the largest of the forces
// steps and blocks begin with the columns of legacy_cases/reference_traces, which have no szz.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "problem/run_choices.hpp"
#include "result/frame.hpp"
#include "result/history.hpp"
#include "result/step_report.hpp"

namespace keyblock::formats {

/// Writes the points with these indices in the rows, numbered from 1 as in whole tables; all of them if none are
/// chosen.
std::string history_csv(const History& history, const Units& units = {}, const std::vector<std::size_t>& chosen = {});
std::string points_csv(const History& history, const Units& units = {});
std::string steps_csv(std::span<const StepReport> steps, const Units& units = {});
std::string rounds_csv(std::span<const StepReport> steps);
std::string blocks_csv(std::span<const Frame> frames, const Units& units = {});

/// Row of cells, the line of the file at which it begins, and the column at which each cell begins.
struct CsvRow {
  std::vector<std::string> cells;
  int line = 0;
  std::vector<int> columns;
  int end = 0;  ///< column after the last cell
};

/// Table as text; every row has as many cells as the header.
struct CsvTable {
  std::string name;  ///< of the file, for messages
  std::vector<std::string> header;
  std::vector<CsvRow> rows;
};

/// Throws InputError if a row has more or fewer cells than the header, or a quote is not closed.
CsvTable read_csv(const Source& source);

/// Heading "dx1 [m]" of a column in parts.
struct CsvHeading {
  std::string name;
  std::string unit;  ///< empty: none
};

CsvHeading csv_heading(std::string_view text);

/// Returns the index of the column with this heading, or with it and a unit in brackets. Throws InputError if it is
/// missing.
std::size_t csv_column(const CsvTable& table, std::string_view heading);

/// Returns the cell as a finite number. Throws InputError if it is not one.
double csv_real(const CsvTable& table, const CsvRow& row, std::size_t column);

}  // namespace keyblock::formats
