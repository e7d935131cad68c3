// Follows the cracks of a case as they grow: crack CASE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

int main(int argc, char** argv) try {
  kb::Run run(kb::Plan(kb::Case::read({argv + 1, argv + argc})));
  while (run.advance()) {
    const kb::Frame now = run.frame();
    const auto tip = now.tip();
    const auto place = now.tip_place();
    const auto factors = now.tip_factors();
    for (std::size_t i = 0; i < tip.rows(); ++i)
      std::cout << now.step() << " crack " << tip(i, 0) << " at " << place(i, 0) << " " << place(i, 1) << ", K_I "
                << factors(i, 0) << ", length " << now.crack_length()(i) << "\n";
  }
  std::cout << run.outcome().reason << "\n";
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
