// Reads an old file of any dialect and writes it as a case file: old_file case.json OLD_FILE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  const kb::Case old = kb::Case::read({argv + 2, argv + argc});
  for (const kb::Warning& warning : old.warnings()) std::cout << "odd: " << warning.sentence << "\n";
  for (const std::string& told : old.write(argv[1])) std::cout << told << "\n";
  const kb::Plan plan(old);
  std::cout << plan.blocks() << " blocks, " << plan.steps() << " steps, profile " << plan.profile() << ": "
            << plan.why_profile() << "\n";
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
