// Draws samples and names, and breaks some.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mixed_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tests/support/text_files.hpp"
#include "tests/support/two_triangles.hpp"
#include "tests/validate/dice.hpp"

namespace keyblock::support {
namespace {

namespace fs = std::filesystem;

/// A case as two files.
struct Sample {
  std::string geometry;
  std::string analysis;
  std::string geometry_ending;
  bool is_manifold = false;
};

// One block and two joint materials, one loading point, for two_triangles.
const std::string kManifoldAnalysis =
    "0.7\n10\n1\n2\n0.01\n0.1\n500\n2 -3\n0.1\n0.5 -1\n10 0.2\n1 2 3\n4 5 6\n7 8 9\n30 1 2\n20 0 0\n1.5\n0 0 0\n";
const std::string kMotion = "0.005 3\n.1\n-.2\n.3\n";

std::vector<Sample> samples() {
  const fs::path root = KEYBLOCK_SOURCE_DIR;
  std::vector<fs::path> geometries{root / "tests/malformed/00_control_orig.geo",
                                   root / "tests/malformed/00_control_xml.geo"};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "legacy_cases"))
    if (entry.path().extension() == ".geo" || entry.path().extension() == ".blk") geometries.push_back(entry.path());
  std::ranges::sort(geometries);
  std::vector<Sample> found{{kTwoTrianglesFile, kManifoldAnalysis, "", true}};
  for (const fs::path& geometry : geometries) {
    const fs::path analysis = fs::path(geometry).replace_extension(".ana");
    if (fs::exists(analysis))
      found.push_back({read_text(geometry), read_text(analysis), geometry.extension().string()});
  }
  return found;
}

std::string broken(const std::string& text, Dice& dice) {
  const auto middle = static_cast<std::size_t>(dice.between(0.3, 0.6) * static_cast<double>(text.size()));
  switch (dice.below(4)) {
    case 0:
      return text.substr(0, middle);
    case 1:
      return {};
    case 2:
      return text.substr(0, middle) + std::string("\x01\x02\x00", 3) + text.substr(middle);
    default:
      return "one two three " + text;
  }
}

/// Writes files and counts them.
struct Writer {
  fs::path root;
  double broken_share;
  Dice dice;
  MixedArchive made;

  bool write(const std::string& path, const std::string& text) {
    const bool is_broken = dice.happens(broken_share);
    fs::create_directories((root / path).parent_path());
    write_text(root / path, is_broken ? broken(text, dice) : text);
    if (is_broken) made.broken.insert(path);
    ++made.files;
    return is_broken;
  }

  void write_pair(const std::string& geometry, const std::string& analysis, const Sample& sample) {
    const bool breaks_geometry = write(geometry, sample.geometry);
    const bool breaks_analysis = write(analysis, sample.analysis);
    if (breaks_geometry) made.partners.insert(analysis);
    if (breaks_analysis) made.partners.insert(geometry);
  }
};

}  // namespace

MixedArchive write_mixed_archive(const fs::path& root, std::size_t count, double broken_share, std::uint64_t seed) {
  const std::vector<Sample> all = samples();
  Writer writer{root, broken_share, Dice(seed), {}};
  for (int i = 0; writer.made.files + 2 <= count; ++i) {
    const Sample& sample = all[static_cast<std::size_t>(writer.dice.below(static_cast<int>(all.size())))];
    const std::string folder = fmt::format("lot{:02}", i / 10);
    const auto geometry_beginning = sample.is_manifold ? "cv" : "dc";
    switch (writer.dice.below(3)) {
      case 0:  // the same name
        writer.write_pair(fmt::format("{}/slope {}{}", folder, i, sample.geometry_ending),
                          fmt::format("{}/slope {}.ana", folder, i), sample);
        break;
      case 1:  // the same number
        writer.write_pair(fmt::format("{}/{}{:03}", folder, geometry_beginning, i),
                          fmt::format("{}/{}{:03}", folder, sample.is_manifold ? "mf" : "df", i), sample);
        break;
      default:  // alone in a folder
        writer.write_pair(fmt::format("{}/case{}/model", folder, i), fmt::format("{}/case{}/input.dat", folder, i),
                          sample);
    }
  }
  while (writer.made.files < count) {
    write_text(root / fmt::format("quake{}.dat", writer.made.files), kMotion);
    ++writer.made.files;
  }
  return writer.made;
}

}  // namespace keyblock::support
