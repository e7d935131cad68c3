// Token equations and marks of the files that are recognised only; layouts in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/recognised_only.hpp"

#include <span>

#include "formats/text/tokens.hpp"

namespace keyblock::formats {
namespace {

Recognition recognise_extended(const Source& source) {
  if (!without_bom(source.text).starts_with("#!0xDDA")) return {};
  return {Recognition::Fit::exact, "it begins with #!0xDDA"};
}

Recognition recognise_disk(const Tokens& tokens) {
  const std::span<const double> n = tokens.numbers;
  const auto is_fraction = [](double v) { return v > 0 && v < 1; };
  if (n.size() < 3 || !(n[0] == 0 || n[0] == 1 || n[0] == 2) || !is_fraction(n[1]) || !is_fraction(n[2])) return {};
  return {Recognition::Fit::exact, "it begins with a kind of 0, 1 or 2 and two integration weights between 0 and 1"};
}

}  // namespace

constinit const Format kDdaExtended{"dda-extended", "extended DDA file, version 1.5", recognise_extended, nullptr,
                                    nullptr};
constinit const Format kDiskDda{"disk-dda",    "parameter file of the disk DDA program", nullptr, nullptr, nullptr,
                                recognise_disk};

}  // namespace keyblock::formats
