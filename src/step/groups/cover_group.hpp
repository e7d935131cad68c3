// Implements the group of NMM bodies of a scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/cover_equations.hpp"
#include "step/bodies/cover_scene.hpp"
#include "step/groups/body_group.hpp"
#include "step/groups/carry_covers.hpp"

namespace keyblock {

class CoverGroup final : public BodyGroup {
 public:
  explicit CoverGroup(std::shared_ptr<const CoverScene> bodies)
      : bodies_(std::move(bodies)), elements_(boxed_elements(*bodies_)) {}

  const CoverScene& bodies() const { return *bodies_; }
  /// Returns the equations of the current step. They are made with the first step; a group makes one step at a time.
  CoverEquations& equations() const;

  bool has(ElementIndex e) const override { return bodies_->kinematics()->carries(e); }
  double size() const override { return bodies_->size(); }
  double mass_of(ElementIndex e) const override { return bodies_->body_at_start(e).mass; }
  bool are_one_body(ElementIndex a, ElementIndex b) const override { return bodies_->are_one_body(a, b); }
  bool has_supports() const override { return bodies_->has_supports(); }
  bool is_supported(ElementIndex e) const override { return bodies_->is_supported(e); }
  bool is_linear() const override { return false; }
  bool may_yield() const override { return !bodies_->yield().is_empty(); }
  bool resolves_impacts() const override { return true; }
  bool takes_holes() const override { return false; }
  bool has_compatible_start() const override { return false; }
  std::optional<ElasticLaw> law_of_large_strain(const SceneParts& scene, ElementIndex e) const override;
  const CoverBasis* shared_basis() const override { return &bodies_->basis(); }
  bool needs_fixed_points() const override { return true; }
  void add_to(MassRange& range, double contact_stiffness) const override;

  void put_start(const SceneParts& scene, BodiesMotion& motion) const override;
  void carry_over(const SceneParts& scene, UnknownsTable& v) const override;
  void put_own_loads(const UnknownsTable& q, double time, UnknownsTable& loads) const override {
    loads.shared = bodies_->weight();
    bodies_->changing().add(q.shared, time, loads.shared);
  }
  void add_inertia(Point acceleration, UnknownsTable& loads) const override;
  void add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
              const UnknownsTable& v) const override;
  void unload(const ChosenElements& bodies, UnknownsTable& loads) const override;
  void put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const override;

  void put_mass_inverse(Flexibility& flexibility) const override { flexibility.shared = bodies_->mass_inverse(); }
  void put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const override;
  double kinetic_energy(const UnknownsTable& v) const override { return bodies_->kinetic_energy(v.shared); }
  void add_stored(const BodiesMotion& motion, StoredEnergy& stored) const override;
  void add_flow(const BodiesStep& step, EnergyFlow& flow) const override;
  void add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion, const Flexibility& mass_inverse,
                        UnknownsTable& a) const override;
  double largest_momentum(const UnknownsTable& v) const override { return bodies_->greatest_momentum(v.shared); }
  double largest_load(const UnknownsTable& loads) const override;
  void look_at_forces(const UnknownsTable& a, const SeenForce& seen) const override;
  void look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                      const SeenBody& seen) const override;
  double fastest_centre(const UnknownsTable& v) const override { return CoverScene::top_speed(v.shared); }
  double fastest_point(const UnknownsTable& v) const override { return CoverScene::top_speed(v.shared); }
  double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const override;
  double step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                    double dt) const override;
  std::unique_ptr<EstimatedStep> begin(const BodiesMotion& start, const UnknownsTable& loads, const StepRule& rule,
                                       double dt, FreeStep& step) const override;

  ElementState state_of(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                        const Placement& placed) const override;
  Stress stress_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion, Point start) const override;
  std::optional<PlasticState> plastic_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                         Point start) const override;
  void add_plastic(const BodiesMotion& motion, PlasticTotals& totals) const override;
  double plastic_work(const BodiesMotion& before, const BodiesMotion& after) const override;
  std::vector<FieldPoint> field_over(const SceneParts& scene, ElementIndex e,
                                     std::span<const std::vector<Point>> region, int degree,
                                     const BodiesMotion& motion) const override;
  YieldState memory_at(ElementIndex e, const BodiesMotion& motion, Point start) const override {
    return bodies_->yield().memory(motion.points.covers, bodies_->kinematics()->manifold_element(e), start);
  }
  void carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const override;

 private:
  std::shared_ptr<const CoverScene> bodies_;
  std::vector<BoxedElements> elements_;  ///< per body
  mutable std::unique_ptr<CoverEquations> equations_;
};

}  // namespace keyblock
