// Declares the commands of the program: name, sentence, and a function that adds the options.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/exit_code.hpp"

namespace keyblock {

/// Work of a command after its options are read. Throws InputError for bad input (printed by main, exit code 3).
using Action = std::function<ExitCode()>;

/// Row of the table in main.cpp. `configure` adds options to the subcommand and returns the work.
struct Command {
  const char* name;
  const char* sentence;
  Action (*configure)(CLI::App& options);
  const char* examples;  ///< lines for its help
};

/// Adds `--threads`, which takes effect when it is read.
void add_thread_option(CLI::App& options);  // thread_option.cpp

/// Checks a folder of cases: one verdict per line, or catalogue.json. Returns the exit code of the worst case.
ExitCode check_folder(const std::string& folder, const std::string& profile,
                      bool as_json);  // batch/check_folder.cpp

Action configure_new(CLI::App& options);       ///< new_command.cpp
Action configure_check(CLI::App& options);     ///< check_command.cpp
Action configure_cut(CLI::App& options);       ///< cut_command.cpp
Action configure_joints(CLI::App& options);    ///< joints_command.cpp
Action configure_run(CLI::App& options);       ///< run_command.cpp
Action configure_plot(CLI::App& options);      ///< plot_command.cpp
Action configure_report(CLI::App& options);    ///< handout/report_command.cpp
Action configure_view(CLI::App& options);      ///< view_command.cpp
Action configure_serve(CLI::App& options);     ///< serve_command.cpp
Action configure_fos(CLI::App& options);       ///< fos_command.cpp
Action configure_compare(CLI::App& options);   ///< compare_command.cpp
Action configure_tradeoff(CLI::App& options);  ///< tradeoff_command.cpp
Action configure_sweep(CLI::App& options);     ///< sweep_command.cpp
Action configure_batch(CLI::App& options);     ///< batch_command.cpp
Action configure_convert(CLI::App& options);   ///< convert_command.cpp
Action configure_element(CLI::App& options);   ///< rock/element_command.cpp
Action configure_fit(CLI::App& options);       ///< rock/fit_command.cpp
Action configure_sif(CLI::App& options);       ///< sif_command.cpp
Action configure_formats(CLI::App& options);   ///< formats_command.cpp
Action configure_explain(CLI::App& options);   ///< explain_command.cpp
Action configure_shell(CLI::App& options);     ///< shell/shell_command.cpp
Action configure_version(CLI::App& options);   ///< version.cpp

}  // namespace keyblock
