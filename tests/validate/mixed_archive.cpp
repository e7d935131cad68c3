// Checks a mixed archive, kills the batch in the middle and resumes it: prints the time on two cores, and if both
// catalogues agree.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mixed_archive.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace {

namespace fs = std::filesystem;
using keyblock::support::read_text;

constexpr double kMostSeconds = 60;

std::vector<std::string> batch(const fs::path& root, const std::string& out, bool is_resumed) {
  std::vector<std::string> words{"batch", root / "in", "--check", "--jobs", "2", "-o", root / out};
  if (is_resumed) words.emplace_back("--resume");
  return words;
}

int lines_in(const fs::path& file) {
  return static_cast<int>(std::ranges::count(read_text(file), '\n'));
}

bool are_same(const fs::path& a, const fs::path& b) {
  return std::ranges::all_of(std::vector{"catalogue.csv", "catalogue.json", "catalogue.html"}, [&](const char* name) {
    const std::string text = read_text(a / name);
    return !text.empty() && text == read_text(b / name);
  });
}

/// Failed jobs that hold no broken file, and broken files whose job did not fail.
std::pair<int, int> misjudged(const fs::path& catalogue, const keyblock::support::MixedArchive& made) {
  std::pair<int, int> counts{0, 0};
  for (const auto& job : nlohmann::json::parse(read_text(catalogue))["jobs"]) {
    int broken = 0;
    bool is_touched = false;
    for (const auto& file : job["files"]) {
      broken += made.broken.contains(file["path"]) ? 1 : 0;
      is_touched = is_touched || broken > 0 || made.partners.contains(file["path"]);
    }
    const bool has_failed = job["outcome"] == "failed";
    if (has_failed && !is_touched) ++counts.first;
    if (!has_failed) counts.second += broken;
  }
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace keyblock::support;
  CLI::App app("A mixed archive, checked by a batch");
  std::size_t count = 1000;
  double broken_share = 0.05;
  std::uint64_t seed = 1;
  std::string folder;
  app.add_option("--count", count, "files")->capture_default_str();
  app.add_option("--broken", broken_share, "share of broken files")->capture_default_str();
  app.add_option("--seed", seed, "of the drawing of samples, names and damages")->capture_default_str();
  app.add_option("-o", folder, "where to write the archive and its catalogues (default: a temporary folder)");
  CLI11_PARSE(app, argc, argv);

  const fs::path root = folder.empty() ? fs::path(fresh_folder("mixed_archive")) : fs::path(folder);
  for (const char* name : {"in", "whole", "killed"}) fs::remove_all(root / name);
  const MixedArchive made = write_mixed_archive(root / "in", count, broken_share, seed);
  const auto start = std::chrono::steady_clock::now();
  const ProgramRun whole = run_keyblock(batch(root, "whole", false));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto [wrongly_failed, missed] = misjudged(root / "whole" / "catalogue.json", made);
  fmt::print("{}{} files, {} broken: {:.2f} s ({:.2f} s of processor time, {:.0f} MB), exit {}\n", whole.messages,
             made.files, made.broken.size(), seconds, whole.cpu_seconds, whole.peak_megabytes, whole.exit_code);
  fmt::print("{} failed without a broken file, {} broken files not told\n", wrongly_failed, missed);

  const int lines = lines_in(root / "whole" / "journal.jsonl");
  const ProgramRun killed = kill_keyblock(batch(root, "killed", false), root / "killed" / "journal.jsonl", lines / 10);
  const int done = lines_in(root / "killed" / "journal.jsonl");
  const ProgramRun resumed = run_keyblock(batch(root, "killed", true));
  const bool same = are_same(root / "whole", root / "killed");
  fmt::print("killed (exit {}) at {} of {} lines, resumed: {} catalogue\n{}", killed.exit_code, done, lines,
             same ? "the same" : "ANOTHER", resumed.messages);
  return same && done < lines && seconds < kMostSeconds && wrongly_failed == 0 && missed == 0 ? 0 : 1;
}
