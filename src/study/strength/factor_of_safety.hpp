// Strength reduction: the factor by which strength is divided when a scene no longer stands, in a bracket.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/strength/strength_trial.hpp"

namespace keyblock::study {

/// Displacements grow without bound as strength nears the limit: a trial is past the knee where its largest is more
/// than so many times that of the trial of the least factor. Griffiths & Lane (1999) ask for both signs of failure, a
/// search that finds no equilibrium and displacements that rise; the number is ours: on the slopes of
/// legacy_cases/strength_reduction any from 3 to 10 gives a factor within 0.01 of it.
inline constexpr double kKnee = 5;

struct SearchOptions {
  std::optional<double> from;  ///< where the search begins, > 0; none: 1, and below where that falls
  std::optional<double> to;    ///< the largest that is tried; none: 16 times the first
  double within = 0.01;        ///< width of the bracket
  std::function<bool()> wants_stop = [] { return false; };
  std::function<void(double factor)> on_begin = [](double) {};  ///< before each trial
  std::function<void(const StrengthTrial&)> on_trial = [](const StrengthTrial&) {};
  /// Why a trial was stopped that is to be given up as undecided; empty where the search is to stop.
  std::function<std::string()> why_given_up = [] { return std::string(); };
  std::function<void(const std::string&)> on_loose = {};  ///< told that a block is left out, and the search begins anew
};

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

struct FactorOfSafety {
  Reduced what = Reduced::joints;
  double within = 0.01;
  SearchEnd end = SearchEnd::bracketed;
  std::vector<StrengthTrial> trials;  ///< in the order they were made
  Bracket bracket;                    ///< of what stands: in equilibrium, and not past the knee
  Bracket equilibrium;                ///< of equilibrium alone
  bool is_lower_estimate = false;     ///< rock that is reduced flows with ψ < φ
  std::vector<std::string> notes;     ///< what is to be known of it, in sentences
  std::vector<int> left_out = {};     ///< numbers, from 0, of loose blocks that the scene is taken without

  std::optional<StrengthState> standing;         ///< of the last that stands
  std::optional<StrengthState> standing_before;  ///< of the one before it
  /// Of the first that falls: where it had come to, or the far equilibrium past the knee.
  std::optional<FieldFrame> falling;

  /// Whether a bracket was found, and the case stands at its lower end, which is 1 or more.
  bool is_safe() const { return end == SearchEnd::bracketed && *bracket.stands >= 1; }
};

/// Begins at `from`, or 1. Where a trial stands only after a slide of a hundredth of half the scene's extent, smaller
/// factors are tried for what the knee is measured by. The search goes up by quarters, or down by fifths, to the first
/// that ends differently, and bisects. Where the knee and the loss of equilibrium lie apart, the bracket of equilibrium
/// is closed too. Where there is no equilibrium for loose blocks alone (`kLooseArea`, `kLooseInAll`), the search begins
/// anew without them. Throws as the trials.
FactorOfSafety factor_of_safety(const StrengthTrials& trials, const SearchOptions& options);

}  // namespace keyblock::study
