// Runs a case under friction angles of its first joint material, two at once: sweep CASE…
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <future>
#include <iostream>
#include <keyblock/keyblock.hpp>

namespace kb = keyblock::api;

namespace {

// Each run has a context of its own: two runs of one process do not affect each other.
double way_at(const kb::Case& base, double friction) {
  const kb::Context context(1);
  const kb::Case changed = base.with("/analysis/joint_materials/0/friction_angle_deg", friction);
  kb::Run run(kb::Plan(changed, {}, context), context);
  run.go_on();
  const auto moved = run.frame().displacement();
  return std::hypot(moved(moved.rows() - 1, 0), moved(moved.rows() - 1, 1));
}

}  // namespace

int main(int argc, char** argv) try {
  const kb::Case base = kb::Case::read({argv + 1, argv + argc});
  for (double friction = 10; friction < 30; friction += 10) {
    auto next = std::async(std::launch::async, way_at, base, friction + 5);
    std::cout << friction << " " << way_at(base, friction) << "\n";
    std::cout << friction + 5 << " " << next.get() << "\n";
  }
} catch (const kb::Error& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
