// Computes the factor of safety by strength reduction: the factor at which a scene becomes unstable, as a bracket.
// Theory: docs/theory/11-strength-reduction.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/decimals.hpp"
#include "study/strength/strength_trial.hpp"

namespace keyblock::study {

/// Ratio of the largest displacement to that of the trial of the least factor, above which displacements have grown:
/// the knee. Griffiths & Lane (1999) combine both signs: no equilibrium, and rising displacements. The factor of safety
/// is that of equilibrium. The knee alone concerns serviceability: bolts stretch, and blocks slide within their joints,
/// long before equilibrium ends.
inline constexpr double kKnee = 5;

struct SearchOptions {
  std::optional<double> from;                 ///< start of the search, > 0; empty: `guess`, and lower if that falls
  std::optional<double> to;                   ///< largest factor tried; empty: 16 times the first
  double within = 0.01;                       ///< width of the bracket
  double guess = 1;                           ///< start of the search unless `from` is set
  double up = 1.25;                           ///< ratio of successive factors on the way up to the first that falls
  bool seeks_knee = true;                     ///< the bracket of the knee is closed too
  std::optional<long long> trial_limit = {};  ///< linear systems per trial; 0: no limit; empty: default
  std::function<void(double factor)> on_begin = [](double) {};  ///< before each trial
  std::function<void(const StrengthTrial&)> on_trial = [](const StrengthTrial&) {};
  std::function<void(const std::string&)> on_loose = {};  ///< reports a block left out; the search begins again
};

/// Returns the number of linear systems after which a trial is given up as undecided; empty: no limit. `asked`: 0 for
/// no limit. The default is 100,000, more than trials need whose contact forces converge. It rises to ten times the
/// longest decided trial so far, because trials near the factor of safety take longer than the first.
std::optional<long long> trial_limit(std::optional<long long> asked, long long longest_before);

/// Largest factor known to stand below the least that falls.
struct Bracket {
  std::optional<double> stands;
  std::optional<double> falls;

  bool is_closed() const { return stands && falls; }
  double width() const { return *falls - *stands; }
  double middle() const { return short_decimal((*stands + *falls) / 2); }
};

enum class SearchEnd {
  bracketed,  ///< to the requested width
  falls,      ///< at the least factor tried
  stands,     ///< at the largest
  undecided,  ///< statics did not decide a necessary trial
  stopped     ///< by request
};

/// Returns a word for tables: "bracketed".
std::string name_of(SearchEnd end);

/// Ratio of sides of the coarser mesh from which the error of a mesh is estimated.
inline constexpr double kCoarserTimes = 2;

/// Error of the mesh in the factor of safety of NMM bodies.
struct MeshError {
  std::optional<Bracket> coarse;  ///< on the coarser mesh; empty without an estimate
  double share = 0;               ///< of the factor, if the error grows with the power 1.5 of the side
  double least = 0;               ///< the same with the power 2
  double most = 0;                ///< and with the power 1
  double uncertainty = 0;         ///< of these fractions, from the widths of both brackets
  double extrapolated = 0;        ///< limit of the factor for ever finer meshes
  std::string why_none = {};
  bool is_stopped = false;  ///< the search on the coarser mesh was stopped; the factor was found before
};

struct FactorOfSafety {
  Reduced what = Reduced::joints;
  double within = 0.01;
  SearchEnd end = SearchEnd::bracketed;
  std::vector<StrengthTrial> trials;  ///< in the order they were made
  Bracket bracket;                    ///< of equilibrium near the drawing: the factor of safety
  Bracket service;                    ///< of displacements: above it they are past the knee
  bool has_bolts = false;
  bool is_lower_estimate = false;  ///< reduced rock flows with ψ < φ
  std::vector<std::string> notes;  ///< remarks, in sentences
  std::vector<int> left_out = {};  ///< numbers, from 0, of loose blocks removed from the scene

  std::optional<MeshError> mesh_error = {};      ///< empty if not requested
  std::optional<StrengthState> standing;         ///< of the last that stands
  std::optional<StrengthState> standing_before;  ///< of the one before it
  /// State of the first trial that falls: its last one, or the equilibrium far from the drawing.
  std::optional<FieldFrame> falling;
  std::optional<Frame> falling_frame = {};  ///< the same state
  /// Origin of its displacement increments: the last equilibrium of that trial, or `standing` for a far one.
  std::optional<FieldFrame> before_fall = {};

  /// Returns the trial of this factor. Throws std::out_of_range.
  const StrengthTrial& trial_at(double factor) const;
  /// Returns true if a trial that stands is past the knee.
  bool grows_before_it_falls() const;

  /// Returns true if a bracket was found whose lower end is 1 or more.
  bool is_safe() const { return end == SearchEnd::bracketed && *bracket.stands >= 1; }
};

/// Searches from `from`, or from the guess. A trial stands if it finds an equilibrium near that of the least factor.
/// Near means that no body has moved farther by a tenth of its width (`kFarFromDrawing`). Farther away, the equilibrium
/// is that of another scene than the drawn one. A trial may stand only after a slide, if it moved by a hundredth of
/// half the scene's extent, or a block by a tenth of its width. One at a hundredth of its factor is then the reference.
/// The search goes up by quarters, or down by fifths, to the first that ends differently, and bisects. If the knee
/// lies below, its bracket is closed too. If only loose blocks have no equilibrium (`kLooseArea`, `kLooseInAll`), the
/// search begins again without them. Throws as the trials.
FactorOfSafety factor_of_safety(const StrengthTrials& trials, const SearchOptions& options);

}  // namespace keyblock::study
