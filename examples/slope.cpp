// Runs a case and prints the blocks that moved by more than a thousandth of a length unit: slope CASE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

int main(int argc, char** argv) try {
  kb::Run run(kb::Plan(kb::Case::read({argv + 1, argv + argc})));
  const kb::Outcome& outcome = run.go_on();
  for (const std::string& sentence : outcome.sentences) std::cout << sentence << "\n";
  for (const kb::Warning& doubt : outcome.doubts) std::cout << "doubt: " << doubt.sentence << "\n";
  const kb::Frame end = run.frame();
  const auto number = end.number();
  const auto moved = end.displacement();
  for (std::size_t i = 0; i < moved.rows(); ++i) {
    const double way = std::hypot(moved(i, 0), moved(i, 1));
    if (way > 1e-3) std::cout << "block " << number(i) << " moved " << way << "\n";
  }
  return outcome.end == kb::End::finished ? 0 : 1;
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
