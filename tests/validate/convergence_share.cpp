// Prints the number of steps of random stacks and slopes that converge without cutting, under both profiles, and fails
// if profile `standard` misses a requirement.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/validate/shares.hpp"

namespace keyblock {
namespace {

struct Options {
  std::uint64_t first = 0;
  int count = 1000;
  int steps = 0;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::string folder;
  bool writes_scenes = false;
};

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

int measure(const Options& options) {
  if (options.writes_scenes) {
    for (int i = 0; i < options.count; ++i)
      write_scene(random_scene(options.first + static_cast<std::uint64_t>(i)), options.folder);
    return 0;
  }
  const std::vector<SceneRun> runs = run_scenes(options.first, options.count, options.threads, options.steps);
  const std::vector<Share> shares = shares_of(runs);
  double seconds = 0;
  for (const Share& share : shares) seconds += share.kind == "all" ? share.seconds : 0;
  fmt::print("{}\n{}\n{}\n{:.0f} s of processor time\n", shares_csv(shares), reasons_csv(runs), ended_csv(runs),
             seconds);
  if (!options.folder.empty()) {
    write(std::filesystem::path(options.folder) / "shares.csv", shares_csv(shares));
    write(std::filesystem::path(options.folder) / "ended.csv", ended_csv(runs));
    write(std::filesystem::path(options.folder) / "runs.csv", runs_csv(runs));
  }
  const std::vector<std::string> misses = misses_of_standard(shares);
  for (const std::string& miss : misses) fmt::print("misses: {}\n", miss);
  return misses.empty() ? 0 : 1;
}

}  // namespace
}  // namespace keyblock

int main(int count, char** words) {
  keyblock::Options options;
  CLI::App app{"share of steps that converge without cutting: stacks have even seeds, slopes the others"};
  app.add_option("--first", options.first, "first seed")->capture_default_str();
  app.add_option("--count", options.count, "number of seeds")->capture_default_str();
  app.add_option("--steps", options.steps, "of each run; 0: as drawn")->capture_default_str();
  app.add_option("--threads", options.threads)->capture_default_str();
  app.add_option("--write", options.folder, "existing folder for shares.csv, ended.csv and runs.csv");
  app.add_flag("--scenes", options.writes_scenes, "write the scenes as legacy files there, and run nothing");
  CLI11_PARSE(app, count, words);
  return keyblock::measure(options);
}
