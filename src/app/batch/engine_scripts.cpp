// Quotes the words of the command for the shell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/engine_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/bytes/source_facts.hpp"

namespace keyblock {
namespace {

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string joined_words(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const std::string& word : words) all.push_back(quoted(word));
  return fmt::format("{}", fmt::join(all, " "));
}

constexpr std::string_view kSlurm = R"(#!/bin/bash
# {1} shards of one table. Submit this file: sbatch FILE. Then write the table:
#   {0} --merge
#SBATCH --job-name=keyblock
#SBATCH --array=1-{1}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@60
{0} --jobs 1 --resume --shard "$SLURM_ARRAY_TASK_ID/{1}" &
child=$!
trap 'kill -TERM "$child" 2> /dev/null' TERM
wait "$child"
code=$?
while kill -0 "$child" 2> /dev/null; do
  wait "$child"
  code=$?
done
case $code in
  0 | 1) exit 0 ;;  # a job that failed is a row of the table
  5 | 130 | 143)    # goes on from its checkpoints, unless the task was cancelled or is back in the queue already
    scontrol --oneliner show job "$SLURM_JOB_ID" | grep -q ' JobState=RUNNING ' &&
      scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
    ;;
esac
exit "$code"
)";

}  // namespace

std::vector<std::string> own_command() {
  std::vector<std::string> words = words_of_command();
  if (!words.empty() && words.front().find('/') != std::string::npos)
    words.front() = std::filesystem::absolute(words.front()).lexically_normal().string();
  constexpr std::array<std::string_view, 4> kOfScripts{"--slurm", "--parallel", "--jobs", "--shard"};
  constexpr std::array<std::string_view, 3> kFlags{"--merge", "--resume", "--force"};
  for (auto word = words.begin(); word != words.end();) {
    const auto begins = [&](std::string_view option) { return word->starts_with(std::string(option) + "="); };
    if (std::ranges::find(kOfScripts, *word) != kOfScripts.end() && word + 1 != words.end())
      word = words.erase(word, word + 2);
    else if (std::ranges::any_of(kOfScripts, begins) || std::ranges::find(kFlags, *word) != kFlags.end())
      word = words.erase(word);
    else
      ++word;
  }
  return words;
}

std::string slurm_script(const std::vector<std::string>& command, int shards) {
  return fmt::format(kSlurm, joined_words(command), shards);
}

// A shard that was killed comes again, and does its missing jobs. Parallel reads whole commands: in a command of its
// own it would replace braces of file names.
std::string parallel_line(const std::vector<std::string>& command, int shards) {
  const std::string words = joined_words(command);
  return fmt::format(
      "for shard in $(seq {1}); do printf '%s\\n' {2}\"$shard/{1}\"; done | parallel --retries 3 ; {0} --merge\n",
      words, shards, quoted(words + " --jobs 1 --resume --shard "));
}

}  // namespace keyblock
