// Holds the NMM bodies of a scene for the steps of Dynamics::standard: loads, mechanics and resultants of each body.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "model/cover_kinematics.hpp"
#include "model/scene/scene.hpp"
#include "settings/settings.hpp"
#include "step/bodies/elastic_bodies.hpp"
#include "step/bodies/whole_body.hpp"
#include "terms/cover_loads.hpp"

namespace keyblock {

/// Connected pieces of the bodies: a crack may divide a body into several.
struct ConnectedPieces {
  std::vector<int> of_function;              ///< piece number per function
  std::vector<ElementIndex> first_elements;  ///< first element per piece, ascending
};

/// All NMM bodies of a model. Vectors have entries (dx, dy) per cover function. The object never changes once made, so
/// that scene preparation can pass it on to the stepper.
class CoverScene : public Groundwork {
 public:
  /// Takes a model with a continuum, whose elements are the last of the model.
  CoverScene(const Model& model, const Settings& settings);
  CoverScene(const CoverScene&) = delete;  // its parts refer to each other

  /// Returns true if this model and these settings would give the same object.
  bool is_of(const Model& model, const Settings& settings) const;

  std::shared_ptr<const CoverKinematics> kinematics() const { return kinematics_; }
  const WholeBody& body_at_start(ElementIndex e) const;
  const std::vector<WholeBody>& at_start() const { return at_start_; }
  double size() const { return size_; }  ///< of the largest body
  /// Returns the smallest √(E/ρ) over the size of the largest body: about the frequency of its first mode.
  double slow_frequency() const { return slow_frequency_; }

  /// Returns those of the materials as rigid motions about the mass centres.
  Eigen::VectorXd start_velocity() const;
  Eigen::VectorXd carried_over(Eigen::VectorXd v) const;  ///< v times the fraction that each body keeps per step
  /// Returns the weight, with constant tractions and support loads.
  const Eigen::VectorXd& weight() const { return weight_; }
  const ChangingLoads& changing() const { return changing_; }
  const Eigen::VectorXd& initial_force() const { return initial_force_; }
  /// Returns true if supports of the problem, apart from fixed points, hold a body.
  bool has_supports() const;
  /// Returns true if such supports hold the piece of an NMM element.
  bool is_supported(ElementIndex e) const { return supported_[static_cast<std::size_t>(e.value - first_.value)]; }
  /// Returns M times a uniform field.
  Eigen::VectorXd inertia_of(Point acceleration) const;

  const ElasticBodies& bodies() const { return bodies_; }
  const Continuum& continuum() const { return bodies_.continuum; }
  const CoverBasis& basis() const { return bodies_.basis(); }
  const CoverYield& yield() const { return bodies_.yield; }
  /// Returns the rotation of a body about a point at 1 rad per time, at positions d; zero for other bodies.
  Eigen::VectorXd turning(int body, const Eigen::VectorXd& d, Point centre) const;
  /// Returns the bodies at d, with the resultants of `forces`.
  std::vector<WholeBody> whole(const Eigen::VectorXd& d, const Eigen::VectorXd& forces) const;
  Eigen::VectorXd momentum(const Eigen::VectorXd& v) const { return bodies_.mass.times(v); }  ///< M v
  static double top_speed(const Eigen::VectorXd& v);
  /// Returns the size of the motion that unknowns cause: themselves, or the displacements of all corners if unknowns
  /// may depend on each other, and be large without motion.
  Eigen::VectorXd felt(const Eigen::VectorXd& unknowns) const;
  /// Returns the greatest force on a body: the sum of magnitudes over its functions, regardless of direction.
  double largest_load(const Eigen::VectorXd& forces) const;
  double greatest_momentum(const Eigen::VectorXd& v) const { return largest_load(momentum(v)); }
  /// Returns, per connected piece, its first element and the largest force on one function.
  std::vector<std::pair<ElementIndex, double>> largest_forces(const Eigen::VectorXd& forces) const;

  double kinetic_energy(const Eigen::VectorXd& v) const { return v.dot(momentum(v)) / 2; }
  double strain_energy(const Eigen::VectorXd& d, const YieldStates& points) const { return bodies_.energy(d, points); }
  /// Work of the rock's force in a step beyond the change of strain energy, to points with the memories `after`.
  /// `algorithmic`: (κ − ½) ∫ ΔE : D : ΔE, or its counterpart where rock flows.
  struct StrainLoss {
    double plastic = 0;
    double algorithmic = 0;
  };
  StrainLoss strain_loss(const CoverYield::Way& way, const YieldStates& after) const;
  /// Returns the work of damping over a step: a M against `rate`, and b against the mean strain rate.
  double damping_work(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Eigen::VectorXd& rate,
                      double dt) const;
  /// Returns the static force of the rock; ∂U/∂d if it does not flow.
  Eigen::VectorXd elastic_force(const Eigen::VectorXd& d, const YieldStates& points) const;
  /// Returns the damping force a M v at velocity v, without strain rate.
  Eigen::VectorXd damping_force(const Eigen::VectorXd& v) const;

  Stress stress(ElementIndex e, const Eigen::VectorXd& d, const YieldStates& points, Point start) const;
  double rotation(ElementIndex e, const Eigen::VectorXd& d, Point start) const;  ///< of the polar decomposition, rad
  /// Returns the body number of an NMM element, from 0.
  int body_of(ElementIndex e) const;
  /// Returns true if both elements belong to one NMM body.
  bool are_one_body(ElementIndex a, ElementIndex b) const;

  std::shared_ptr<const SharedFlexibility> mass_inverse() const { return mass_inverse_; }

 private:
  std::shared_ptr<const Continuum> made_of_;
  CoverDamping damping_;
  ElasticBodies bodies_;
  ChangingLoads changing_;
  ElementIndex first_;
  std::shared_ptr<const CoverKinematics> kinematics_;
  std::vector<double> carry_;    ///< per body
  std::vector<bool> supported_;  ///< per element: true if supports of the problem hold its connected piece
  ConnectedPieces pieces_;
  std::vector<WholeBody> at_start_;
  double size_ = 0;
  double slow_frequency_ = 0;
  Eigen::VectorXd weight_;
  Eigen::VectorXd initial_force_;
  std::shared_ptr<const SharedFlexibility> mass_inverse_;
  Eigen::SparseMatrix<double> at_corners_;  ///< of unknowns that may depend on each other; otherwise empty
};

/// Motion of a point of the bodies. `velocity` includes the rotation rate, half the curl: length and rad, per time.
struct MotionOfPoint {
  Stress stress;
  double rotation = 0;
  Velocity velocity;
};

/// Returns the motion of the point that lay at `start`, with one evaluation of the functions there. Bitwise the same as
/// `stress` and `rotation`.
MotionOfPoint motion_of_point(const CoverScene& scene, ElementIndex e, const Eigen::VectorXd& d,
                              const Eigen::VectorXd& v, const YieldStates& points, Point start);

}  // namespace keyblock
