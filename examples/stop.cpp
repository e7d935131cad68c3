// Stops a run when its second block has moved a given distance: stop DISTANCE CASE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  const double way = std::strtod(argv[1], nullptr);
  kb::Run run(kb::Plan(kb::Case::read({argv + 2, argv + argc})));
  run.go_on([&](const kb::Run& now) {
    const auto moved = now.frame().displacement();
    return std::hypot(moved(1, 0), moved(1, 1)) >= way;
  });
  std::cout << "step " << run.last().number << ", time " << run.last().time << "\n";
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
