// Writes random contents, reads and writes them again, for every format that is written; prints a table of failures.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tests/support/random_contents.hpp"

int main(int argc, char** argv) {
  using namespace keyblock;
  using namespace keyblock::support;
  CLI::App app("Round trips of generated contents through every format that is written");
  int count = 10000;
  app.add_option("--count", count, "contents a format")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  bool all_came_back = true;
  for (const ContentKind& kind : content_kinds()) {
    int faults = 0;
    std::string first;
    for (int seed = 0; seed < count; ++seed) {
      Dice dice(static_cast<std::uint64_t>(seed));
      const std::string fault = round_trip_fault(kind, kind.draw(dice));
      if (fault.empty()) continue;
      if (++faults == 1) first = fmt::format("seed {}: {}", seed, fault);
    }
    fmt::print("{:24} {:6} of {} came back unchanged\n", kind.format->name, count - faults, count);
    if (faults > 0) fmt::print("  {}\n", first);
    all_came_back = all_came_back && faults == 0;
  }
  return all_came_back ? 0 : 1;
}
