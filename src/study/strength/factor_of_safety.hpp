// Strength reduction: the factor by which strength is divided when a scene no longer stands, in a bracket.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/strength/strength_trial.hpp"

namespace keyblock::study {

/// Displacements have grown if the largest is more than this many times that of the trial of the least factor: the
/// knee. Griffiths & Lane (1999) take both signs together, a search that finds no equilibrium and displacements that
/// rise. The factor of safety is that of equilibrium. The knee alone is a matter of service: bolts stretch, and blocks
/// slide within their joints, long before equilibrium ends.
inline constexpr double kKnee = 5;

struct SearchOptions {
  std::optional<double> from;  ///< where the search begins, > 0; none: `guess`, and below where that falls
  std::optional<double> to;    ///< the largest that is tried; none: 16 times the first
  double within = 0.01;        ///< width of the bracket
  double guess = 1;            ///< where the search begins unless `from` says so
  double up = 1.25;            ///< ratio of one factor to the one before on the way up to the first that falls
  bool seeks_knee = true;      ///< the bracket of the knee is closed too
  std::optional<long long> trial_limit = {};  ///< linear systems after which a trial is undecided; 0: none; none:
                                              ///< `trial_limit`
  std::function<void(double factor)> on_begin = [](double) {};  ///< before each trial
  std::function<void(const StrengthTrial&)> on_trial = [](const StrengthTrial&) {};
  std::function<void(const std::string&)> on_loose = {};  ///< told that a block is left out, and the search begins anew
};

/// Linear systems after which a trial is given up as undecided; nothing: no limit. `asked`: 0 for none. By default it
/// is more than trials take whose contact forces settle, and ten times the longest trial before that was decided:
/// trials near the factor of safety take longer than the first.
std::optional<long long> trial_limit(std::optional<long long> asked, long long longest_before);

/// The largest factor known to stand below the least that falls.
struct Bracket {
  std::optional<double> stands;
  std::optional<double> falls;

  bool is_closed() const { return stands && falls; }
  double width() const { return *falls - *stands; }
  double middle() const { return (*stands + *falls) / 2; }
};

enum class SearchEnd {
  bracketed,  ///< to the width asked for
  falls,      ///< at the least factor that was tried
  stands,     ///< at the largest
  undecided,  ///< statics did not decide where it had to
  stopped     ///< by request
};

/// A word for tables: "bracketed".
std::string name_of(SearchEnd end);

/// Ratio of sides of the coarser mesh by which the error of a mesh is estimated.
inline constexpr double kCoarserTimes = 2;

/// Error of the mesh in the factor of safety of NMM bodies.
struct MeshError {
  std::optional<Bracket> coarse;  ///< on the coarser mesh; none: there is no estimate
  double share = 0;               ///< of the factor, if the error grows with the power 1.5 of the side
  double least = 0;               ///< the same with the power 2
  double most = 0;                ///< and with the power 1
  double uncertainty = 0;         ///< of these shares, from the widths of both brackets
  double extrapolated = 0;        ///< the factor of ever finer meshes
  std::string why_none = {};
  bool is_stopped = false;  ///< the search on the coarser mesh was: the factor was found before
};

struct FactorOfSafety {
  Reduced what = Reduced::joints;
  double within = 0.01;
  SearchEnd end = SearchEnd::bracketed;
  std::vector<StrengthTrial> trials;  ///< in the order they were made
  Bracket bracket;                    ///< of equilibrium near the drawing: the factor of safety
  Bracket service;                    ///< of displacements: above it they are past the knee
  bool has_bolts = false;
  bool is_lower_estimate = false;  ///< rock that is reduced flows with ψ < φ
  std::vector<std::string> notes;  ///< what is to be known of it, in sentences
  std::vector<int> left_out = {};  ///< numbers, from 0, of loose blocks that the scene is taken without

  std::optional<MeshError> mesh_error = {};      ///< none if it was not sought
  std::optional<StrengthState> standing;         ///< of the last that stands
  std::optional<StrengthState> standing_before;  ///< of the one before it
  /// State of the first trial that falls: its last one, or the equilibrium far from the drawing.
  std::optional<FieldFrame> falling;
  /// Its displacement increments count from here: the last equilibrium of that trial, or, of a far one, `standing`.
  std::optional<FieldFrame> before_fall = {};

  /// The trial of this factor. Throws std::out_of_range.
  const StrengthTrial& trial_at(double factor) const;
  /// Returns true if a trial that stands is past the knee.
  bool grows_before_it_falls() const;

  /// Whether a bracket was found, and the case stands at its lower end, which is 1 or more.
  bool is_safe() const { return end == SearchEnd::bracketed && *bracket.stands >= 1; }
};

/// Begins at `from`, or at the guess. A trial stands if it finds an equilibrium in which no body has come farther than
/// in the trial of the least factor by a tenth of its width (`kFarFromDrawing`): farther away another scene is in
/// equilibrium than the one that was drawn. If a trial stands only after a slide of a hundredth of half the scene's
/// extent, smaller factors are tried for a reference. The search goes up by quarters, or down by fifths, to the first
/// that ends differently, and bisects. If the knee lies below, its bracket is closed too. If there is no equilibrium
/// for loose blocks alone (`kLooseArea`, `kLooseInAll`), the search begins anew without them. Throws as the trials.
FactorOfSafety factor_of_safety(const StrengthTrials& trials, const SearchOptions& options);

}  // namespace keyblock::study
