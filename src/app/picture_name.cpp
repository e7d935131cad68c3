// Compares endings only, regardless of case.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/error.hpp"

namespace keyblock {
namespace {

std::string ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

void require_picture_name(std::string_view option, const std::string& file) {
  const std::string ending = ending_of(file);
  if (ending.empty() || ending == ".svg") return;
  const std::string svg = std::filesystem::path(file).replace_extension(".svg").string();
  const bool is_known = ending == ".png" || ending == ".pdf" || ending == ".eps";
  throw UsageError(
      fmt::format("{}: pictures are SVG: expected a name that ends in .svg, found {}; {}", option, file,
                  is_known ? fmt::format("write {}, then rsvg-convert -f {} {} -o {}", svg, ending.substr(1), svg, file)
                           : fmt::format("write {} and convert it", svg)));
}

void require_no_picture_name(std::string_view option, const std::string& file, std::string_view picture_option) {
  constexpr std::array<std::string_view, 9> kPictures{".svg", ".png", ".jpg", ".jpeg", ".pdf",
                                                      ".eps", ".gif", ".tif", ".tiff"};
  if (std::ranges::find(kPictures, ending_of(file)) == kPictures.end()) return;
  throw UsageError(
      fmt::format("{}: what is written there is no picture: expected another ending, found {}; {} writes "
                  "a picture",
                  option, file, picture_option));
}

}  // namespace keyblock
