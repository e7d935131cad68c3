// Rock that keeps its volume locks on constant and derived functions: the run says so.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ahead/incompressible_rock.hpp"

#include <gtest/gtest.h>

#include "model/continuum.hpp"

namespace keyblock::incompressible_rock_test {
namespace {

Warnings told(double poissons_ratio, CoverFunctions functions, Plane plane) {
  auto continuum = std::make_shared<Continuum>();
  continuum->materials.resize(2);
  continuum->materials[1].poissons_ratio = poissons_ratio;
  continuum->functions = functions;
  Scene scene;
  scene.model.continuum = std::move(continuum);
  scene.settings.plane = plane;
  return incompressible_rock(scene, {});
}

}  // namespace

TEST(IncompressibleRock, is_told_where_functions_lock) {
  for (const CoverFunctions functions : {CoverFunctions::constant, CoverFunctions::derived}) {
    EXPECT_EQ(told(0.49, functions, Plane::strain).size(), 1U);
    EXPECT_TRUE(told(0.48, functions, Plane::strain).empty());
    EXPECT_TRUE(told(0.49, functions, Plane::stress).empty());
  }
  EXPECT_TRUE(told(0.4999, CoverFunctions::linear, Plane::strain).empty());
}

}  // namespace keyblock::incompressible_rock_test
