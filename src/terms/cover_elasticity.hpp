// Elasticity of bodies on covers under large displacement: total Lagrangian, by the law of each element's material,
// energy and momentum kept by its steps.
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

/// x = X + Σ N_a(X) d_a on the undeformed manifold; F = I + Σ d_a ⊗ ∇N_a, E = ½ (FᵀF - I), S as `ElasticPoint` says
/// of it, from the initial stress of the materials; elements whose material has a strength are left out. Entries 2a,
/// 2a + 1 of d belong to function a. Integrals are exact
/// for the law of St. Venant and Kirchhoff; E does not change in a rigid motion. Keeps the basis and what else it needs
/// by value.
class CoverElasticity {
 public:
  CoverElasticity(const Continuum& continuum, CoverBasis basis);

  const CoverBasis& basis() const { return basis_; }

  /// ∫ of what the law stores.
  double energy(const Eigen::VectorXd& d) const;

  /// The force of a step from d0 to d1 (Simo & Tarnow 1992), with S_θ the stress of a step of the law:
  ///     f = ∫ ∇N · S_θ F_halfᵀ,   F_half = (F0 + F1)/2.
  /// Its work f · (d1 - d0) is ∫ S_θ : (E1 - E0): the change of energy, and (θ - ½) ∫ Δε : D : Δε which is lost. It has
  /// no resultant and no moment about the mean positions (x0 + x1)/2, whatever θ. With d0 = d1 it is the gradient of
  /// the energy. θ of element e is `theta` + `more`[e], where any are given: a stress of damping follows the mean rate
  /// of strain.
  Eigen::VectorXd force(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta,
                        std::span<const double> more = {}) const;

  /// A += `scale` times ∂f/∂d1, made symmetric by F_half in place of F1: ½ ∫ ∇N S_θ ∇N + θ ∫ B(F_half)ᵀ D B(F_half), D
  /// the stiffness of a step of the law.
  /// What is left out is of first order in F1 - F0: Newton's method gains about log10(2/|F1 - F0|) digits a round.
  void add_tangent(const Eigen::VectorXd& d0, const Eigen::VectorXd& d1, double theta, std::span<const double> more,
                   double scale, SparseSystem& system) const;

  /// A += `scale` times the second derivative of the energy; at d = 0 without initial stress the stiffness of
  /// `cover_stiffness`.
  void add_static_tangent(const Eigen::VectorXd& d, double scale, SparseSystem& system) const;

  /// Where the point of an element lies that was at X.
  Point position(const Eigen::VectorXd& d, int element, Point at_start) const;

  /// F at X.
  Eigen::Matrix2d deformation(const Eigen::VectorXd& d, int element, Point at_start) const;

  /// Cauchy stress F S Fᵀ / det F in the axes of the plane and Szz / det F across it, tension positive; the change of
  /// thickness under plane stress is left out.
  Stress stress(const Eigen::VectorXd& d, int element, Point at_start) const {
    return stress_of(deformation(d, element, at_start), element, at_start);
  }
  /// The same of a deformation F.
  Stress stress_of(const Eigen::Matrix2d& f, int element, Point at_start) const;

 private:
  /// An element's points of integration, two rows of gradients each.
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

  /// Stress and stiffness of every point of an element, and the memory that its tangent is made in.
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
  std::vector<Stress> initial_;       // of each element at y = 0
  std::vector<Stress> gradient_;      // and its change per y
  std::vector<double> share_across_;  // of each element
  std::function<Stress(Point)> more_;
  bool gives_zz_ = false;
};

}  // namespace keyblock
