// Token equations and marks of the files that are recognised only; layouts in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/recognised_only.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "formats/demands.hpp"
#include "formats/tokens.hpp"

namespace keyblock::formats {
namespace {

using Fit = Recognition::Fit;

bool are_counts(std::span<const double> numbers) {
  for (const double number : numbers)
    if (!is_whole(number) || number < 0) return false;
  return true;
}

Recognition recognise_cover(const Source& source) {
  const Tokens tokens = tokenise(source);
  const std::span<const double> n = tokens.numbers;
  if (n.size() < 8 || !are_counts(n.first(8)) || n[0] < 1 || n[5] < 3) return {};
  const double total = 8 + 3 * (n[1] + n[2] + n[3]) + 6 * n[0] + 2 * (n[4] + n[5] + n[6] + n[7]);
  if (total != static_cast<double>(n.size())) return {};
  return {Fit::exact,
          fmt::format("8-number head with {} elements and {} covers gives the file's {} numbers", n[0], n[5], total)};
}

/// E and nu of each material stand where they would if `loads` loading points come before.
bool materials_follow(std::span<const double> n, std::int64_t loads) {
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(n[2]); ++i) {
    const auto material = n.subspan(7 + 2 * loads + 14 * i);
    if (!(material[3] > 0) || !kPoissonPlaneStress.holds(material[4])) return false;
  }
  return true;
}

Recognition recognise_nmm_analysis(const Source& source) {
  const Tokens tokens = tokenise(source);
  const std::span<const double> n = tokens.numbers;
  if (n.size() < 7 || !kShare.holds(n[0]) || !are_counts(n.subspan(1, 3)) || n[2] < 1) return {};
  const double loads = (static_cast<double>(n.size()) - 11 - 14 * n[2] - 3 * n[3]) / 2;
  if (!is_whole(loads) || loads < 0 || !materials_follow(n, static_cast<std::int64_t>(loads))) return {};
  return {Fit::exact,
          fmt::format("7-number head, {} loading points and {} materials of 14 numbers give the file's {} numbers",
                      loads, n[2], n.size())};
}

Recognition recognise_extended(const Source& source) {
  if (!without_bom(source.text).starts_with("#!0xDDA")) return {};
  return {Fit::exact, "it begins with #!0xDDA"};
}

Recognition recognise_disk(const Source& source) {
  const Tokens tokens = tokenise(source);
  const std::span<const double> n = tokens.numbers;
  const auto is_fraction = [](double v) { return v > 0 && v < 1; };
  if (n.size() < 3 || !(n[0] == 0 || n[0] == 1 || n[0] == 2) || !is_fraction(n[1]) || !is_fraction(n[2])) return {};
  return {Fit::exact, "it begins with a kind of 0, 1 or 2 and two integration weights between 0 and 1"};
}

}  // namespace

constinit const Format kNmmCover{"nmm-cover", "NMM cover file (cv)", recognise_cover, nullptr, nullptr};
constinit const Format kNmmAnalysis{"nmm-analysis", "NMM analysis file (mf)", recognise_nmm_analysis, nullptr, nullptr};
constinit const Format kDdaExtended{"dda-extended", "extended DDA file, version 1.5", recognise_extended, nullptr,
                                    nullptr};
constinit const Format kDiskDda{"disk-dda", "parameter file of the disk DDA program", recognise_disk, nullptr, nullptr};

}  // namespace keyblock::formats
