// Follows the cracks of a case as they grow: crack CASE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

int main(int argc, char** argv) try {
  kb::Run run(kb::Plan(kb::Case::read({argv + 1, argv + argc})));
  while (run.advance()) {
    const kb::Frame now = run.frame();
    const auto crack = now.integers("tips", "crack");
    const auto place = now.reals("tips", "place");
    const auto mode_1 = now.reals("tips", "K_I");
    const auto length = now.reals("tips", "length");
    for (std::size_t i = 0; i < crack.rows(); ++i)
      std::cout << now.step() << " crack " << crack(i) << " at " << place(i, 0) << " " << place(i, 1) << ", K_I "
                << mode_1(i) << ", length " << length(i) << "\n";
  }
  std::cout << run.outcome().reason << "\n";
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
