// Kills runs at random moments of a case and profile, resumes them on other threads, and compares them byte by byte
// with the undisturbed run. A row in which no run was resumed fails too. Words on the command line: only the cases
// whose names hold one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/killed_runs.hpp"
#include "tests/support/shared_folder.hpp"

namespace {

constexpr unsigned kSeed = 20;

struct Case {
  std::string name;
  std::vector<std::string> files;
  std::vector<std::string> options;
  int moments = 20;
  std::vector<std::string> profiles = {"legacy", "standard"};
};

Case legacy_case(const std::string& name, const std::string& ending, const std::vector<std::string>& options = {}) {
  const std::string stem = std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/" + name;
  return {name, {stem + ending, stem + ".ana"}, options};
}

Case body_on_covers(const std::string& name, const std::vector<std::string>& options) {
  return {name, {std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/" + name}, options, 20, {"standard"}};
}

/// Excavated in stages under contact.
Case excavation(const std::string& name, const std::string& file) {
  return {name, {std::string(KEYBLOCK_SOURCE_DIR) + "/" + file}, {}, 20, {"standard"}};
}

// Files without a licence, which may lie beside the repository.
Case shared_case(const std::string& name, const std::string& first, const std::string& second,
                 const std::vector<std::string>& options) {
  const auto folder = keyblock::shared_folder();
  return {name, {(folder / first).string(), (folder / second).string()}, options};
}

std::vector<Case> all_cases() {
  const std::string wall = "reference_runs/scaling/brick30.geo";
  const std::string of_wall = "reference_runs/scaling/scale_N30_maxd_0.01.ana";
  const std::string manifold = "legacy_samples/pythonwithnmm/";
  return {legacy_case("stack/five_blocks/five_blocks", ".geo"),
          legacy_case("toppling_column/falls/falls", ".geo"),
          legacy_case("bolt/breaking/breaking", ".geo"),
          legacy_case("cohesive_joint/c40/c40", ".geo"),
          legacy_case("settlement/five_tall_static/five_tall_static", ".blk", {"--set", "enforcement=penalty"}),
          legacy_case("masonry_arch/quake_thin_falls/quake_thin_falls", ".blk"),
          shared_case("wall of 916 bricks", wall, of_wall, {"--set", "steps=12"}),
          shared_case("wall of 916 bricks, sudden", wall, of_wall, {"--set", "steps=12", "--set", "start=sudden"}),
          body_on_covers("sudden_load_on_covers/damped", {"--set", "steps=60"}),
          body_on_covers("sliding_block_on_covers/a30_p20", {"--set", "steps=60"}),
          excavation("tunnel in jointed rock", "docs/tunnel.json"),
          excavation("roof block", "legacy_cases/staged_excavation/roof_block/roof_block.json"),
          excavation("roof block on covers",
                     "legacy_cases/staged_excavation/roof_block_on_covers/roof_block_on_covers.json"),
          shared_case("manifold of old files", manifold + "cv04", manifold + "mf04", {})};
}

bool is_asked_for(const Case& one, const std::vector<std::string>& words) {
  return words.empty() ||
         std::ranges::any_of(words, [&](const std::string& word) { return one.name.find(word) != std::string::npos; });
}

}  // namespace

int main(int argc, char** argv) {
  using keyblock::support::KilledRuns;
  bool all_sound = true;
  fmt::print("{:50} {:10} {:>6} {:>8} {:>6}  {}\n", "case", "profile", "killed", "resumed", "twice", "files");
  for (const Case& one : all_cases()) {
    if (!is_asked_for(one, {argv + 1, argv + argc})) continue;
    if (!std::filesystem::exists(one.files.front())) {
      fmt::print("{:50} skipped: there is no {}\n", one.name, one.files.front());
      continue;
    }
    for (const std::string& profile : one.profiles) {
      std::vector<std::string> arguments = one.files;
      arguments.insert(arguments.end(), {"--profile", profile});
      arguments.insert(arguments.end(), one.options.begin(), one.options.end());
      const KilledRuns runs = keyblock::support::killed_runs(arguments, one.moments, kSeed);
      all_sound = all_sound && runs.differs.empty() && runs.resumed > 0;
      fmt::print("{:50} {:10} {:6} {:8} {:6}  {}\n", one.name, profile, runs.killed, runs.resumed, runs.killed_twice,
                 !runs.differs.empty() ? "DIFFER: " + runs.differs
                 : runs.resumed == 0   ? "NONE RESUMED: nothing is shown"
                                       : "the same bytes");
      std::fflush(stdout);
    }
  }
  return all_sound ? 0 : 1;
}
