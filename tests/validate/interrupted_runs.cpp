// 20 random moments a case and profile: the run is killed there, resumed, and compared byte by byte to the run that was not;
// a row in which no run was resumed fails too.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "tests/support/killed_runs.hpp"

namespace {

constexpr int kMoments = 20;
constexpr unsigned kSeed = 20;

struct Case {
  const char* name;  // below legacy_cases, without the endings
  const char* geometry;
  std::vector<std::string> options;
};

}  // namespace

int main() {
  using keyblock::support::KilledRuns;
  const std::vector<Case> cases{
      {"stack/five_blocks/five_blocks", ".geo", {}},
      {"toppling_column/falls/falls", ".geo", {}},
      {"bolt/breaking/breaking", ".geo", {}},
      {"cohesive_joint/c40/c40", ".geo", {}},
      {"settlement/five_tall_static/five_tall_static", ".blk", {"--set", "enforcement=penalty"}},
      {"masonry_arch/quake_thin_falls/quake_thin_falls", ".blk", {}}};
  bool all_sound = true;
  fmt::print("{:50} {:10} {:>6} {:>8} {:>6}  {}\n", "case", "profile", "killed", "resumed", "twice", "files");
  for (const Case& one : cases) {
    const std::string stem = std::string(KEYBLOCK_SOURCE_DIR) + "/legacy_cases/" + one.name;
    for (const char* profile : {"legacy", "standard"}) {
      std::vector<std::string> arguments{stem + one.geometry, stem + ".ana", "--profile", profile};
      arguments.insert(arguments.end(), one.options.begin(), one.options.end());
      const KilledRuns runs = keyblock::support::killed_runs(arguments, kMoments, kSeed);
      all_sound = all_sound && runs.differs.empty() && runs.resumed > 0;
      fmt::print("{:50} {:10} {:6} {:8} {:6}  {}\n", one.name, profile, runs.killed, runs.resumed, runs.killed_twice,
                 !runs.differs.empty() ? "DIFFER: " + runs.differs
                 : runs.resumed == 0   ? "NONE RESUMED: nothing is shown"
                                       : "the same bytes");
    }
  }
  return all_sound ? 0 : 1;
}
