// Converts by rsvg-convert of librsvg, which draws SVG as browsers do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/helpers/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <vector>

#include "app/helpers/helper_program.hpp"
#include "base/bytes/file_bytes.hpp"
#include "base/error.hpp"

namespace keyblock {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConverter = "rsvg-convert";
constexpr double kDotsAnInch = 300;  // what journals ask of figures
constexpr double kZoom = 2;          // dots a unit of the picture, for screens

std::string ending_of(const std::string& file) {
  std::string ending = fs::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string converted(const std::string& svg, const std::string& format, bool has_width) {
  const WorkFolder folder("keyblock_picture");
  const fs::path from = folder / "picture.svg", to = folder / "converted";
  write_file(from, svg);
  std::vector<std::string> words{kConverter, "--format", format, "--output", to.string()};
  if (format == "png" && has_width)
    for (const char* option : {"--dpi-x", "--dpi-y"}) {
      words.emplace_back(option);
      words.push_back(fmt::format("{}", kDotsAnInch));
    }
  else if (format == "png") {
    words.emplace_back("--zoom");
    words.push_back(fmt::format("{}", kZoom));
  }
  words.push_back(from.string());
  if (const int code = run_helper(words); code != 0 || !fs::is_regular_file(to))
    throw OutputError(fmt::format("{} failed with exit code {}", kConverter, code));
  return file_bytes(to.string());
}

// Replaces the size in pixels, which the first element names, by one in millimetres; the view box stays.
std::string with_width(std::string svg, double width) {
  const auto value_at = [&](std::string_view name) {
    const std::size_t from = svg.find(name) + name.size();
    return std::pair(from, svg.find('"', from));
  };
  const auto [wide, wide_end] = value_at(" width=\"");
  const double units_wide = std::stod(svg.substr(wide, wide_end - wide));
  svg.replace(wide, wide_end - wide, fmt::format("{:g}mm", width));
  const auto [high, high_end] = value_at(" height=\"");
  const double units_high = std::stod(svg.substr(high, high_end - high));
  svg.replace(high, high_end - high, fmt::format("{:g}mm", width * units_high / units_wide));
  return svg;
}

}  // namespace

void require_picture_name(std::string_view option, const std::string& file) {
  const std::string ending = ending_of(file);
  if (ending.empty() || ending == ".svg") return;
  if (ending != ".pdf" && ending != ".png")
    throw UsageError(fmt::format("{}: expected a name that ends in .svg, .pdf or .png, found {}", option, file));
  if (!is_installed(kConverter))
    throw UsageError(fmt::format(
        "{}: {} needs the program {}, which is not installed (Debian package librsvg2-bin); a name that ends in .svg "
        "needs none",
        option, file, kConverter));
}

void require_no_picture_name(std::string_view option, const std::string& file, std::string_view picture_option) {
  constexpr std::array<std::string_view, 9> kPictures{".svg", ".png", ".jpg", ".jpeg", ".pdf",
                                                      ".eps", ".gif", ".tif", ".tiff"};
  if (std::ranges::find(kPictures, ending_of(file)) == kPictures.end()) return;
  throw UsageError(fmt::format("{}: expected an ending other than that of a picture, found {}; {} writes a picture",
                               option, file, picture_option));
}

void write_picture(const std::string& file, std::string svg, Overwrite overwrite, std::optional<double> width) {
  if (width) svg = with_width(std::move(svg), *width);
  const std::string ending = ending_of(file);
  if (ending == ".pdf" || ending == ".png") svg = converted(svg, ending.substr(1), width.has_value());
  write_output(file, svg, overwrite);
}

}  // namespace keyblock
