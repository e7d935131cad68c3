// Declares studies of many runs: factor of safety, stress intensity factors, rows of a random sweep.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <keyblock/keyblock.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock::api {
inline namespace v1 {

/// A trial of a strength reduction.
struct Trial {
  double factor = 1;
  std::string verdict;      ///< "stands", "falls", "undecided"
  std::string why;          ///< in a sentence, if it does not stand or is past the knee; else empty
  double displacement = 0;  ///< the largest of any corner since the start [length]
};

struct Strength {
  std::optional<double> stands, falls;  ///< the bracket of the factor of safety
  std::string profile, why_profile;     ///< of all trials; `standard` for old files that request none
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value, all; of all trials: static
  int unknowns = 0;
  std::string end;  ///< "bracketed", "falls", "stands", "undecided", "stopped"
  std::vector<Trial> trials;
  std::vector<std::string> notes;  ///< sentences about the search, such as where it went on
  std::vector<Warning> warnings;   ///< of reading, preparing and looking ahead
  std::optional<Frame> standing;   ///< equilibrium at `stands`
  /// State at `falls`: the last one of the search, out of balance, or an equilibrium far from the drawing. Empty if the
  /// search knows none. Both frames have the columns of Detail::corners, and no contacts.
  std::optional<Frame> falling;
};

/// Divides the strength of "joints", "rock" or "both" until the case is no longer stable: the search of `keyblock fos`,
/// without its second one on a coarser mesh. If `what` is empty or `within` 0, it is that of the `case.json` of a
/// folder, else "joints" or 0.01. The range of the search and its exemptions are always those of `case.json`. Throws
/// input; choice for another word, or a width below 0; failed if nothing fixes the blocks and gravity, or no
/// load at all, acts on them. A search that is stopped ends with "stopped".
KEYBLOCK_API Strength factor_of_safety(const Case& of, std::string_view what = {}, double within = 0,
                                       const Choices& choices = {}, const Context& context = Context());

/// A crack tip at the end of the loads.
struct Tip {
  double x = 0, y = 0;              ///< undeformed
  double ahead_x = 0, ahead_y = 0;  ///< of length 1, along the crack into the rock
  double k1 = 0, k2 = 0;            ///< stress intensity, force over length^1.5
  double j = 0;                     ///< energy release rate, force over length
  double kink_deg = 0;              ///< where it would go on, from straight ahead to the left
  double k_equivalent = 0;          ///< of the criterion of growth, compared with the toughness, force over length^1.5
  double spread = 0;                ///< of K_I between integration domains, as a share of K
  std::string doubt;                ///< why it cannot be trusted; empty where nothing speaks against it
};

struct Intensity {
  std::vector<Tip> tips;
  std::string profile, why_profile;                           ///< `standard` for old files that request none
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value, all
  int unknowns = 0;
  std::vector<Warning> warnings;
};

/// Stress intensity factors of all tips, as `keyblock sif`. Throws input for a case without cracks, stopped.
KEYBLOCK_API Intensity stress_intensity(const Case& of, const Choices& choices = {},
                                        const Context& context = Context());

/// Rows of a Latin hypercube over "KEY=VALUES", as `keyblock sweep --over --random`: a JSON list of objects. The same
/// seed gives the same rows. Throws choice.
KEYBLOCK_API std::string random_rows(const std::vector<std::string>& keys, std::size_t count, std::uint64_t seed = 1);

}  // namespace v1
}  // namespace keyblock::api
