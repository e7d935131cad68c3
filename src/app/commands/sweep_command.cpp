// `keyblock sweep`: runs a case over any of its values.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/command.hpp"
#include "app/input/value_sweep_options.hpp"
#include "app/option_checks.hpp"

namespace keyblock {
namespace {

/// Adds the values of the rows and the results of each.
void add_value_options(CLI::App& options, ValueSweepOptions& chosen) {
  options
      .add_option("--over", chosen.over,
                  "run the case over values of a key: /POINTER=20:40:2, /POINTER=0,50 kN, SETTING=A,B, "
                  "joints:/POINTER=normal(35,3); may be repeated; names and * stand for numbers of list items")
      ->type_name("KEY=VALUES")
      ->take_all();
  options
      .add_option("--design", chosen.design_file,
                  "rows of values instead of --over: a JSON list of objects; null leaves a key as it is")
      ->type_name("FILE");
  options
      .add_option("--random", chosen.random,
                  "N rows of a Latin hypercube over lists and over normal(MEAN,DEVIATION), lognormal(MEAN,DEVIATION), "
                  "uniform(LOW,HIGH) and triangular(LOW,MODE,HIGH)")
      ->type_name("N")
      ->check(above_zero());
  options.add_option("--seed", chosen.seed, "seed of --random (default: 1)");
  options.add_flag("--zip", chosen.is_zipped, "take first values of all keys together, then second ones, …");
  options.add_option("--joints", chosen.joints, "statistics of joints (docs/slope.json), drawn anew for each row")
      ->type_name("FILE");
  options.add_option("--out", chosen.out,
                     "results of a row, separated by commas: displacement, speed, state, steps, time, blocks, fos, "
                     "fos_rock, point1.dx, NAME.vx of a history, ledger.kinetic, tip1.k1, /pointer into run.json "
                     "(default: displacement)");
  options.add_option("--history", chosen.histories, "follow a quantity, as `keyblock run --history`; may be repeated")
      ->type_name("[NAME=]WHAT")
      ->take_all();
  options.add_option("--to-within", chosen.within, "final width of the bracket of fos")->check(above_zero());
}

/// Adds the options by which jobs are done: those of `batch` too.
void add_job_options(CLI::App& options, ValueSweepOptions& chosen) {
  options
      .add_option("-o,--output", chosen.folder,
                  "folder for table.csv, columns.csv, times.csv, sweep.svg, sweep.json, journals and jobs")
      ->type_name("FOLDER");
  options.add_option("--jobs", chosen.jobs, "jobs at a time (default: number of cores)")->check(CLI::Range(1, 1024));
  options.add_option("--time-limit", chosen.cpu_seconds, "processor time per process, seconds (default: no limit)")
      ->check(above_zero());
  options.add_option("--memory-limit", chosen.memory_mebibytes, "address space per process, MiB (default: no limit)")
      ->check(above_zero());
  options.add_flag("--resume", chosen.is_resumed, "do the missing jobs of the sweep in FOLDER, from their checkpoints");
  options.add_option("--shard", chosen.shard, "do only jobs of shard K of N, also on another machine")
      ->type_name("K/N");
  options.add_flag("--merge", chosen.is_merged, "run nothing; write the table of all shards in FOLDER");
  options.add_option("--slurm", chosen.slurm, "print an array script of N shards for sbatch, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  options.add_option("--parallel", chosen.parallel, "print a line of N shards for GNU parallel, and run nothing")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
}

}  // namespace

Action configure_sweep(CLI::App& options) {
  const auto chosen = std::make_shared<ValueSweepOptions>();
  add_case_options(options, chosen->given, "one case folder, or the files of a case").files->required();
  add_value_options(options, *chosen);
  add_job_options(options, *chosen);
  options.add_flag("--json", chosen->as_json, "print the table as JSON");
  options.add_flag("--force", chosen->force, "overwrite files");
  return [chosen] { return sweep_values(*chosen); };
}

}  // namespace keyblock
