// Comma-separated tables: results out, and tables (expected values, traces) in.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout (RFC 4180): a header line, then one line a row; cells with a comma, quote or line break stand in double
// quotes, a quote inside is doubled. Written with `\n` and the shortest numbers that read back the same; read with `\n`
// or `\r\n`, a byte-order mark and empty lines are passed over. Every number is in
// the units of the case; where it declares them, headings name them: "dx1 [mm]", else some have letters: "dx1 [L]"
// (tables/run_tables.hpp says what each column measures).
//   history  step,time [T], then x,y,dx,dy [L] of every point i: xi yi dxi dyi; dx dy since the start;
//            then the force of every bolt, tension positive: bolti [F]; then, where load steps sum it, what every
//            prescribed displacement exerts on the bodies: reactioni_x,reactioni_y [F]; where rock may yield also
//            driveni [L], the mean length of that displacement, where load steps follow it, load_share of the loads
//            where steps follow the path of equilibria (load_control = arc_length), load_factor of all loads where
//            cracks grow, and of all such rock
//            yielded_fraction, the share of its area that has yielded since the start, yielding_fraction, that which
//            ended the step on its surface, and plastic_work [F L], stress times plastic strain summed, per unit
//            thickness (empty where it is not summed: in time without a ledger)
//   points   step,time,point,x,y,dx,dy,sxx,syy,sxy,szz: one line a measured point and instant; points from 1, stress
//            tension positive; where rock may yield then its plastic strain since the start (components of the tensor,
//            xy half of the shear angle), the equivalent one, κ = ∫ √(2/3) ‖dev dεᵖ‖, yield_state at the end of the
//            step (0 elastic, 1 smooth part of the surface, 2 edge, 3 apex, 4 tension), has_yielded since the start
//            (0, 1), mean stress, von Mises stress and Lode angle (material/stress_invariants.hpp); of rock that
//            cannot yield all but these three are empty
//   steps    step,time,dt,oci,contacts,closed,k_blocks,penalty,disp_ratio,max_penetration: one line an accepted step;
//            oci counts the open-close passes, k_blocks the elements and the pairs of elements with a contact (the
//            Berkeley program counts fill-in of its factor too), disp_ratio is the greatest displacement over the
//            allowed
//   blocks   step,time,block,material,cx,cy,rot,dx,dy,sxx,syy,sxy,area,szz: one line a block and frame; block and
//            material from 1, rot in radians, stress tension positive, szz across the plane; where rock may yield the
//            columns that points has of it, at the centroid
//   rounds   step,round,residual: of load steps of rock that may yield the rounds of Newton's method in the last part
//            of each, 0 before the first; residual is what is out of balance over the largest of the forces
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

/// Of the points at these places of the rows, counted from 1 as in whole tables; all of them where none are chosen.
std::string history_csv(const History& history, const Units& units = {}, const std::vector<std::size_t>& chosen = {});
std::string points_csv(const History& history, const Units& units = {});
std::string steps_csv(std::span<const StepReport> steps, const Units& units = {});
std::string rounds_csv(std::span<const StepReport> steps);
std::string blocks_csv(std::span<const Frame> frames, const Units& units = {});

/// One row of cells, the line of the file it began on, and the column at which each cell begins.
struct CsvRow {
  std::vector<std::string> cells;
  int line = 0;
  std::vector<int> columns;
  int end = 0;  ///< the column behind the last cell
};

/// A table as text; every row has as many cells as the header.
struct CsvTable {
  std::string name;  ///< of the file, for messages
  std::vector<std::string> header;
  std::vector<CsvRow> rows;
};

/// Throws InputError where a row has more or fewer cells than the header, or a quote is not closed.
CsvTable read_csv(const Source& source);

/// Index of the column with this heading, or with it and a unit in brackets; InputError if there is none.
std::size_t csv_column(const CsvTable& table, std::string_view heading);

/// The cell as a finite number; InputError if it is none.
double csv_real(const CsvTable& table, const CsvRow& row, std::size_t column);

}  // namespace keyblock::formats
