// Computes elastic forces of NMM bodies under large displacement: total Lagrangian, by the law of each element's
// material. Its steps conserve energy and momentum. Theory: docs/theory/02-equations-of-motion.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "material/elastic_law.hpp"
#include "model/continuum.hpp"
#include "system/sparse_system.hpp"

namespace keyblock {

/// x = X + Σ N_a(X) d_a on the undeformed manifold; F = I + Σ d_a ⊗ ∇N_a, E = ½ (FᵀF - I), S by `ElasticPoint`.
///
/// The initial stress of the materials is included; elements whose material has a strength are left out. Entries 2a, 2a
/// + 1 of d belong to function a. Integrals are exact for the St. Venant–Kirchhoff law; E does not change in a rigid
/// motion. Stores copies of the basis and of all other data.
class CoverElasticity {
 public:
  CoverElasticity(const Continuum& continuum, CoverBasis basis);

  const CoverBasis& basis() const { return basis_; }

  /// Returns ∫ of the energy that the law stores.
  double energy(const Eigen::VectorXd& d) const;

  /// Returns the force of a step from d0 to d1 (Simo & Tarnow 1992), with S_θ the stress of a step of the law:
  ///       f = ∫ ∇N · S_θ F_halfᵀ,   F_half = (F0 + F1)/2.
  /// Its work f · (d1 - d0) is ∫ S_θ : (E1 - E0): the change of energy, plus the dissipation (θ - ½) ∫ Δε : D : Δε. It
  /// has no resultant and no moment about the mean positions (x0 + x1)/2, for every θ. With d0 = d1 it is the gradient
  /// of the energy. θ of element e is `theta` + `more`[e], if `more` is not empty: a stress of damping follows the mean
  /// rate of strain.
  Eigen::VectorXd force(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta,
                        std::span<const double> more = {}) const;

  /// Adds `scale` times ∂f/∂d1 to A, made symmetric by F_half instead of F1: ½ ∫ ∇N S_θ ∇N + θ ∫ B(F_half)ᵀ D
  /// B(F_half). D is the stiffness of a step of the law. The omitted part is of first order in F1 - F0: each Newton
  /// iteration gains about log10(2/|F1 - F0|) digits.
  void add_tangent(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta, std::span<const double> more,
                   double scale, SparseSystem& system) const;

  /// Adds `scale` times the second derivative of the energy to A; at d = 0 without initial stress it is the stiffness
  /// of `cover_stiffness`.
  void add_static_tangent(const Eigen::VectorXd& d, double scale, SparseSystem& system) const;

  /// Returns the present position of the point of an element that was at X.
  Point position(const Eigen::VectorXd& d, int element, Point at_start) const;

  /// Returns F at X.
  Eigen::Matrix2d deformation(const Eigen::VectorXd& d, int element, Point at_start) const;

  /// Returns the Cauchy stress, tension positive: F S Fᵀ / det F in the plane and Szz / det F across it. The change of
  /// thickness under plane stress is left out.
  Stress stress(const Eigen::VectorXd& d, int element, Point at_start) const {
    return stress_of(deformation(d, element, at_start), element, at_start);
  }
  /// Returns the Cauchy stress for a deformation F.
  Stress stress_of(const Eigen::Matrix2d& f, int element, Point at_start) const;

 private:
  /// Integration points of an element, two rows of gradients each.
  struct Element {
    Eigen::MatrixXd gradients;  // 2 points × functions
    Eigen::VectorXd weights;
    Eigen::Matrix3Xd initial;  // S0 at each point: xx, yy, xy
    Eigen::Matrix3d modulus;
    ElasticLaw law;

    ElasticPoint at(Eigen::Index point) const {
      return {law, modulus, Eigen::Map<const Eigen::Vector3d>(initial.data() + 3 * point)};
    }
  };

  /// Stress and stiffness of every point of an element, and the memory for its tangent.
  struct Linearised {
    Eigen::Matrix3Xd stress;
    std::vector<Eigen::Matrix3d> stiffness;
    Eigen::MatrixXd b;         // Bᵀ
    Eigen::MatrixXd weighted;  // D B
    Eigen::MatrixXd stressed;  // S ∇N
    Eigen::MatrixXd tangent;
    Eigen::MatrixXd both;
  };

  void add_element_tangent(int element, const Eigen::MatrixX2d& mean, double material, double geometric,
                           Linearised& points, SparseSystem& system) const;
  Stress initial_stress(int element, Point x) const;

  CoverBasis basis_;
  std::vector<Element> elements_;
  std::vector<Stress> initial_;       // per element, at y = 0
  std::vector<Stress> gradient_;      // and its change per y
  std::vector<double> share_across_;  // per element
  std::function<Stress(Point)> more_;
  bool gives_zz_ = false;
};

}  // namespace keyblock
