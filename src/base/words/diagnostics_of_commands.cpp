// Rows of warnings by the commands check, convert, element and fit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/words/diagnostics_parts.hpp"

namespace keyblock::diagnostic_rows {
namespace {

using enum DiagnosticLevel;

constexpr auto kCommands = std::to_array<Diagnostic>({
    {"bolts_not_read", note, "Bolts are not read under --bug-compatible",
     "The Berkeley program takes the numbers of bolts for those of fixed lines and points. So does "
     "--bug-compatible.",
     "Nothing, if Berkeley results are wanted; else leave out --bug-compatible."},
    {"boundaries_dropped", note, "Boundary lines are dropped under --bug-compatible",
     "The Berkeley program does not read the lines of Boundlist. Neither does --bug-compatible.",
     "Nothing, if Berkeley results are wanted; else leave out --bug-compatible."},
    {"comments_dropped", note, "Comments are not converted",
     "The source has comments. The written file does not hold them.",
     "Nothing, if they are not needed; else copy them by hand."},
    {"dialect_changes", warning, "The converted case follows other rules of profile legacy",
     "The dialect of the written format changes settings of profile legacy. The message lists them.",
     "Give these settings by --set, to keep the former rules."},
    {"first_material_line_lost", note, "The first material line is lost under --bug-compatible",
     "The Berkeley program does not read the first material line. Neither does --bug-compatible.",
     "Nothing, if Berkeley results are wanted; else leave out --bug-compatible."},
    {"first_steps_fail", error, "The first steps of the run fail",
     "`keyblock check` tries up to 20 steps of the case. One of them failed, as it would in a run.",
     "Correct what the message names."},
    {"gradient_from_velocity", note, "The initial velocity is also the stress gradient",
     "The Berkeley program takes Ivelocity as stress gradient too. So does --bug-compatible.",
     "Nothing, if Berkeley results are wanted; else leave out --bug-compatible."},
    {"not_of_berkeley", note, "The Berkeley program does not read this format",
     "--bug-compatible applies to files that the Berkeley program reads. This file stays as it is.",
     "Nothing, if that is right; else leave out --bug-compatible."},
    {"one_material_a_block", warning, "A block holds elements of several materials",
     "Converted blocks have one material each. Such a block takes that of its first element.",
     "Draw a joint between the materials, or keep the cover file."},
    {"plane_not_read", note, "Plane stress has no effect on a single element",
     "The case is one of plane stress. The path of `keyblock element` decides the stress across the plane.",
     "Nothing, if the path is right; else choose another --path."},
    {"poor_fit", error, "The fitted curve does not follow the data",
     "R² is below 0.9, or neighbouring points lie off the curve by more than 5 % of the greatest value on average. "
     "Errors and intervals of the parameters mean nothing.",
     "Fit the part of the curve that the law describes, or choose another test."},
    {"profile_changes", warning, "The converted case runs under another profile",
     "Without --profile, a run takes another profile for the written files than for those read.",
     "Run the converted case with --profile of the former one."},
    {"several_cases", note, "The files are not one case",
     "Two or more files hold a geometry, or two or more an analysis. Each file was checked alone.",
     "Nothing, if the files belong to several cases; else give those of one case."},
    {"softening", error, "The measured stress falls after its peak",
     "The stress at the end is more than 10 % below the peak. The fitted law has a plateau and does not soften.",
     "Leave out the rows after the peak; give the strength an `after` in the case."},
    {"strain_without_effect", note, "Initial strains are dropped under --bug-compatible",
     "Istrain has no effect in the Berkeley program. --bug-compatible sets it to 0.",
     "Nothing: initial strains have no effect here either."},
    {"velocity_from_gradient", note, "The stress gradient is also the initial velocity",
     "The Berkeley program takes the numbers of the stress gradient as initial velocity. So does --bug-compatible.",
     "Nothing, if Berkeley results are wanted; else leave out --bug-compatible."},
});

}  // namespace

std::span<const Diagnostic> of_commands() {
  return kCommands;
}

}  // namespace keyblock::diagnostic_rows
