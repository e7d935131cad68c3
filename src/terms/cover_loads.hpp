// Adds forces on elements on covers (on area, along boundary, at points) and springs that support points.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// Adds ∫ Tᵀ b over all elements to f, exact if b is a polynomial of second order.
void add_cover_body_force(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// Subtracts ∫ Bᵀ s over all elements from f, s the initial stress; exact if s is a polynomial of second order.
void add_cover_initial_stress(const Continuum& continuum, const CoverBasis& basis, SparseSystem& system);

/// Adds ∫ Tᵀ t along a part of the boundary to f, exact if t is a polynomial of third order.
void add_traction(const Continuum& continuum, const CoverBasis& basis, const Traction& traction, SparseSystem& system);

/// Pressures on edges that turn and stretch: beyond the force on the undisplaced edge.
class FollowingLoads {
 public:
  FollowingLoads(const Continuum& continuum, const CoverBasis& basis);

  /// Adds ∫ Tᵀ p (N - n) to the loads on the unknowns, two per function: n ds is the undisplaced edge with its outward
  /// normal, N ds that edge displaced by d. Each side of an element stays straight. Throws InputError if a formula is
  /// not finite.
  void add(const Eigen::VectorXd& d, double time, Eigen::VectorXd& loads) const;

 private:
  struct Sample {
    Point at;
    double weight;                 ///< over the length of the side
    Eigen::MatrixXd displacement;  ///< T, 2 × 2n
  };
  struct Side {
    std::function<double(Point x, Point normal, double time)> pressure;
    Point normal;
    double turn = 1;          ///< 1 if the normal points to the right of the edge, -1 to its left
    Eigen::MatrixXd stretch;  ///< T at the end less T at the start
    std::vector<int> functions;
    std::vector<Sample> samples;
  };
  std::vector<Side> sides_;
};

/// Tractions that change over time or with the displacement, with the points of their quadrature.
class ChangingLoads {
 public:
  ChangingLoads(const Continuum& continuum, const CoverBasis& basis);

  /// Adds ∫ Tᵀ t at a time to the loads on the unknowns, two per function, and what following pressures add at d.
  /// Throws InputError if a formula is not finite.
  void add(const Eigen::VectorXd& d, double time, Eigen::VectorXd& loads) const;

 private:
  struct Sample {
    Point at;
    double weight;
    Eigen::MatrixXd displacement;  ///< T, 2 × 2n
  };
  struct Side {
    std::function<Point(Point x, Point normal, double time)> force;
    Point normal;
    std::vector<int> functions;
    std::vector<Sample> samples;
  };
  std::vector<Side> sides_;
  FollowingLoads following_;
};

/// Returns the resultant of all forces that do not depend on displacement or time: on areas, along boundaries, at
/// points.
Resultant sum_of_loads(const Continuum& continuum, int degree);

/// Adds Tᵀ F to f.
void add_point_force(const CoverBasis& basis, const PointForce& load, SparseSystem& system);

/// Adds k Tᵀ n nᵀ T to K.
void add_point_spring(const CoverBasis& basis, const PointSpring& spring, SparseSystem& system);

}  // namespace keyblock
