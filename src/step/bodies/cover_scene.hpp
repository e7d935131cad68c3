// Bodies on covers as the steps of Dynamics::standard see them: what loads them, how they answer, what they do as a
// whole.
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

namespace keyblock {

/// Connected pieces of the bodies: a crack may part a body in several.
struct ConnectedPieces {
  std::vector<int> of_function;              ///< number of the piece of each function
  std::vector<ElementIndex> first_elements;  ///< the first element of each piece, ascending
};

/// All bodies of a model that hang on covers. Vectors have the entries (dx, dy) of every cover function. It does not
/// change once it is made, so that those who prepare a scene hand theirs on to those who step through it.
class CoverScene : public Groundwork {
 public:
  /// The model has a continuum, whose elements are its last.
  CoverScene(const Model& model, const Settings& settings);
  CoverScene(const CoverScene&) = delete;  // its parts refer to each other

  /// Whether one of this model and these settings would be the same.
  bool is_of(const Model& model, const Settings& settings) const;

  std::shared_ptr<const CoverKinematics> kinematics() const { return kinematics_; }
  const WholeBody& body_at_start(ElementIndex e) const;
  const std::vector<WholeBody>& at_start() const { return at_start_; }
  double size() const { return size_; }  ///< of the largest body
  /// Of a wave of stretching through the largest body, √(E/ρ) over its size, the least of the materials: about that of
  /// the first mode of a stout body.
  double slow_frequency() const { return slow_frequency_; }

  /// The initial velocities of the materials, as rigid motions about the mass centres.
  Eigen::VectorXd start_velocity() const;
  /// By the share of velocity that the material of each body carries from step to step.
  Eigen::VectorXd carried_over(Eigen::VectorXd v) const;
  /// Weight of the materials, and what tractions and supports of the problem exert.
  const Eigen::VectorXd& weight() const { return weight_; }
  /// What the initial stress exerts on the unknowns.
  const Eigen::VectorXd& initial_force() const { return initial_force_; }
  /// Whether supports of the problem itself, not fixed points, hold a body.
  bool has_supports() const;
  /// Whether they hold the piece of an element on covers: what a crack cuts off from a held part of its body is not.
  bool is_supported(ElementIndex e) const { return supported_[static_cast<std::size_t>(e.value - first_.value)]; }
  /// M times a uniform field.
  Eigen::VectorXd inertia_of(Point acceleration) const;

  const ElasticBodies& bodies() const { return bodies_; }
  const Continuum& continuum() const { return bodies_.continuum; }
  const CoverBasis& basis() const { return bodies_.basis(); }
  const CoverYield& yield() const { return bodies_.yield; }
  /// A turning of a body about a point, 1 rad per time, at positions d; nothing of other bodies.
  Eigen::VectorXd turning(int body, const Eigen::VectorXd& d, Point centre) const;
  /// The bodies at d, with the resultants of `forces`.
  std::vector<WholeBody> whole(const Eigen::VectorXd& d, const Eigen::VectorXd& forces) const;
  Eigen::VectorXd momentum(const Eigen::VectorXd& v) const { return bodies_.mass.times(v); }  ///< M v
  static double top_speed(const Eigen::VectorXd& v);
  /// How far unknowns like these move the bodies, without sign: the unknowns themselves, or, where unknowns may depend
  /// on each other and be large for nothing, what they move at the corners of all elements.
  Eigen::VectorXd felt(const Eigen::VectorXd& unknowns) const;
  /// The greatest of a body: the sum over its functions, whatever the directions.
  double largest_load(const Eigen::VectorXd& forces) const;
  double greatest_momentum(const Eigen::VectorXd& v) const { return largest_load(momentum(v)); }
  /// On one function of each piece that hangs together, with the first element of it.
  std::vector<std::pair<ElementIndex, double>> largest_forces(const Eigen::VectorXd& forces) const;

  double kinetic_energy(const Eigen::VectorXd& v) const { return v.dot(momentum(v)) / 2; }
  double strain_energy(const Eigen::VectorXd& d, const YieldStates& points) const { return bodies_.energy(d, points); }
  /// What the force of the rock takes in a step beyond the change of strain energy, to points with the memories
  /// `after`: of plastic flow, and (κ − ½) ∫ ΔE : D : ΔE or what comes with it where rock flows.
  struct StrainLoss {
    double plastic = 0;
    double algorithmic = 0;
  };
  StrainLoss strain_loss(const CoverYield::Way& way, const YieldStates& after) const;
  /// Of damping over a step: a M against `rate`, and b against the mean rate of strain.
  double damping_work(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Eigen::VectorXd& rate,
                      double dt) const;
  /// Of the rock at rest; ∂U/∂d where it does not flow.
  Eigen::VectorXd elastic_force(const Eigen::VectorXd& d, const YieldStates& points) const;
  /// Against v at rest from strain: a M v.
  Eigen::VectorXd damping_force(const Eigen::VectorXd& v) const;

  Stress stress(ElementIndex e, const Eigen::VectorXd& d, const YieldStates& points, Point start) const;
  double rotation(ElementIndex e, const Eigen::VectorXd& d, Point start) const;  ///< of the polar decomposition, rad
  /// Number of the body of an element on covers, from 0.
  int body_of(ElementIndex e) const;
  /// Whether both elements are of one body on covers.
  bool are_one_body(ElementIndex a, ElementIndex b) const;

  std::shared_ptr<const SharedFlexibility> mass_inverse() const { return mass_inverse_; }

 private:
  std::shared_ptr<const Continuum> made_of_;
  CoverDamping damping_;
  ElasticBodies bodies_;
  ElementIndex first_;
  std::shared_ptr<const CoverKinematics> kinematics_;
  std::vector<double> carry_;    ///< of each body
  std::vector<bool> supported_;  ///< of each element, whether supports of the problem hold what it hangs together with
  ConnectedPieces pieces_;
  std::vector<WholeBody> at_start_;
  double size_ = 0;
  double slow_frequency_ = 0;
  Eigen::VectorXd weight_;
  Eigen::VectorXd initial_force_;
  std::shared_ptr<const SharedFlexibility> mass_inverse_;
  Eigen::SparseMatrix<double> at_corners_;  ///< of unknowns that may depend on each other; empty else
};

/// Of a point of the bodies; `velocity` with the turning there, half the curl: length and rad, per time.
struct MotionOfPoint {
  Stress stress;
  double rotation = 0;
  Velocity velocity;
};

/// Of that which lay at `start`, by one look at the functions there: the same as `stress` and `rotation` to the bit.
MotionOfPoint motion_of_point(const CoverScene& scene, ElementIndex e, const Eigen::VectorXd& d,
                              const Eigen::VectorXd& v, const YieldStates& points, Point start);

}  // namespace keyblock
