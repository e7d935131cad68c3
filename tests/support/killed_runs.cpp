// Sends SIGKILL at a random moment; the last checkpoint, if any, is left to chance.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/killed_runs.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/support/program.hpp"
#include "tests/support/text_files.hpp"

namespace keyblock::support {

namespace fs = std::filesystem;

namespace {

// Between two checkpoints: a few steps of a small scene.
const std::vector<std::string> kOften{"--checkpoint-every", "0.01"};

// If none of the moments fell between the first checkpoint and the end: a busy machine.
constexpr int kMoreMoments = 20;

// Each part of a run has another number of them.
const std::vector<std::string> kThreads{"1", "2", "4", "7"};

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The checkpoint is there before the first frame, and goes when the record of the whole run is there.
bool has_lost_checkpoint(const std::string& folder) {
  return fs::exists(folder + "/frames") && !fs::exists(folder + "/run.json") && !fs::exists(folder + "/checkpoint.h5");
}

std::string first_difference(const std::map<std::string, std::string>& whole,
                             const std::map<std::string, std::string>& resumed) {
  for (const auto& [name, bytes] : whole)
    if (!resumed.contains(name) || resumed.at(name) != bytes) return name;
  for (const auto& [name, bytes] : resumed)
    if (!whole.contains(name)) return name;
  return {};
}

}  // namespace

std::map<std::string, std::string> contents(const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) all[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  if (const auto record = all.find("run.json"); record != all.end()) {
    auto json = nlohmann::ordered_json::parse(record->second);
    for (const char* key : {"seconds", "made_by"}) json.erase(key);
    record->second = json.dump();
  }
  return all;
}

KilledRuns killed_runs(const std::vector<std::string>& arguments, int moments, unsigned seed) {
  const std::string whole = fresh_folder("whole");
  const std::string folder = fresh_folder("killed");
  const std::vector<std::string> command = joined(joined({"run"}, arguments), kOften);
  int expected = 0;
  double length = 1e9;
  for (int i = 0; i < 2; ++i) {  // the quicker: a delayed run would put moments behind the end
    const auto started = std::chrono::steady_clock::now();
    expected = run_keyblock(joined(command, {"-o", whole + "/out", "--force"})).exit_code;
    length = std::min(length, std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
  }
  std::mt19937 dice(seed);
  const auto moment = [&] { return length * static_cast<double>(dice()) / 4294967296.0; };
  const auto on_threads = [&](const std::vector<std::string>& words) {
    return joined(words, {"--threads", kThreads.at(dice() % kThreads.size())});
  };
  KilledRuns result;
  const auto goes_on = [&](int i) { return i < moments || (result.resumed == 0 && i < moments + kMoreMoments); };
  for (int i = 0; goes_on(i) && result.differs.empty(); ++i) {
    fs::remove_all(folder + "/out");
    const std::vector<std::string> begin = joined(command, {"-o", folder + "/out", "--force"});
    const std::vector<std::string> resume = joined({"run", "--resume", folder + "/out"}, kOften);
    ProgramRun run = kill_keyblock(on_threads(begin), moment());
    if (run.exit_code == 128 + SIGKILL) {
      ++result.killed;
      if (has_lost_checkpoint(folder + "/out")) {
        result.differs = "checkpoint.h5, which is lost";
        return result;
      }
      const bool can_resume = fs::exists(folder + "/out/checkpoint.h5");
      if (can_resume) ++result.resumed;
      const std::vector<std::string>& again = can_resume ? resume : begin;
      const bool twice = i % 3 == 2;
      run = twice ? kill_keyblock(on_threads(again), moment()) : run_keyblock(on_threads(again));
      if (run.exit_code == 128 + SIGKILL) {
        ++result.killed_twice;
        run = run_keyblock(on_threads(fs::exists(folder + "/out/checkpoint.h5") ? resume : begin));
      }
    }
    result.differs = run.exit_code == expected ? first_difference(contents(whole + "/out"), contents(folder + "/out"))
                                               : run.messages;
  }
  return result;
}

}  // namespace keyblock::support
