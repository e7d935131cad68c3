// Holds the smallest useful cover, a unit square of two triangles that share a joint, as a file and as its contents.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problem/cover.hpp"

namespace keyblock::support {

/// A diagonal cuts the square (joint material 2, counted from 1), so that each half has its own three covers of the
/// same two mathematical triangles. The upper half comes first among the slots, the lower half first among the
/// elements: no reader may rely on an order of slots.
inline Cover two_triangles() {
  Cover cover;
  cover.elements = {{{4, 3}, 0, {0, 2, 4}}, {{0, 3}, -1, {1, 5, 3}}};
  cover.vertices = {{0, 0}, {1, 1}, {0, 1}, {0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 0}};
  cover.nodes = {{0, 0}, {0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, 1}};
  cover.loops = {{0, 3}, {4, 3}};
  cover.loop_vertices = {{4, 0}, {5, 0}, {6, 1}, {4, 0}, {0, 1}, {1, 0}, {2, 0}, {0, 1}};
  cover.fixed_points = {{{0.25, 0}, 0, {}}};
  cover.loading_points = {{{0.5, 1}, 1, {}}};
  cover.measured_points = {{{0.75, 0.5}, 0, {}}, {{0.25, 0.75}, 1, {}}};
  return cover;
}

/// The same as a file.
inline const std::string kTwoTrianglesFile =
    "2 1 1 2\n8 6 2 8\n"
    "0.25 0 1.000000\n0.5 1 2.000000\n0.75 0.5 1.000000\n0.25 0.75 2.000000\n"
    "5 7 1\n1 3 0\n"
    "0 0\n1 1\n0 1\n0 0\n0 0\n1 0\n1 1\n0 0\n"
    "0 0\n0 0\n1 0\n0 1\n1 1\n1 1\n"
    "1 3 5\n2 6 4\n"
    "1 3\n5 7\n"
    "5 1\n6 1\n7 2\n5 1\n1 2\n2 1\n3 1\n1 2\n";

}  // namespace keyblock::support
