// The blocks of a scene: each has unknowns of its own, in a frame that turns with it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/block_yield.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

class BlockGroup final : public BodyGroup {
 public:
  /// One body an element; those of other groups have no unknowns and are `of_others`. `yields`: one an element, or
  /// none of any.
  BlockGroup(Bodies bodies, std::vector<bool> of_others, std::vector<std::optional<BlockYield>> yields);

  const Bodies& bodies() const { return bodies_; }

  bool has(ElementIndex e) const override { return !of_others_[static_cast<std::size_t>(e.value)]; }
  double size() const override { return size_; }
  double mass_of(ElementIndex e) const override { return bodies_[e].mass(0, 0); }
  bool are_one_body(ElementIndex a, ElementIndex b) const override { return a == b; }
  bool has_supports() const override;
  bool is_supported(ElementIndex) const override { return false; }
  bool is_linear() const override { return yields_.empty(); }
  bool may_yield() const override { return !yields_.empty(); }
  bool resolves_impacts() const override { return false; }
  bool takes_holes() const override { return true; }
  bool has_compatible_start() const override { return true; }
  std::optional<ElasticLaw> law_of_large_strain(const SceneParts&, ElementIndex) const override { return {}; }
  std::string_view why_unheld() const override { return {}; }
  void add_to(MassRange& range, double contact_stiffness) const override;

  void put_start(const SceneParts& scene, BodiesMotion& motion) const override;
  void carry_over(const SceneParts& scene, UnknownsTable& v) const override;
  void put_weight(UnknownsTable& loads) const override;
  void add_inertia(Point acceleration, UnknownsTable& loads) const override;
  void add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
              const UnknownsTable& v) const override;

  void put_mass_inverse(Flexibility& flexibility) const override;
  void put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const override;
  double kinetic_energy(const UnknownsTable& v) const override;
  void add_stored(const BodiesMotion& motion, StoredEnergy& stored) const override;
  void add_flow(const BodiesStep& step, EnergyFlow& flow) const override;
  void add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion, const Flexibility& mass_inverse,
                        UnknownsTable& a) const override;
  double largest_momentum(const UnknownsTable& v) const override;
  double largest_load(const UnknownsTable& loads) const override;
  void look_at_forces(const UnknownsTable& a, const SeenForce& seen) const override;
  void look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                      const SeenBody& seen) const override;
  double fastest_centre(const UnknownsTable& v) const override;
  double fastest_point(const UnknownsTable& v) const override;
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
  YieldState memory_at(ElementIndex e, const BodiesMotion& motion, Point) const override {
    return yield_of(e) ? motion.points.blocks[static_cast<std::size_t>(e.value)] : YieldState();
  }
  void carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const override;

 private:
  void carry_memory(ElementIndex e, const std::vector<FieldPoint>& field, const BodiesBefore& before,
                    BodiesMotion& carried) const;
  void carry_field(const SceneParts& scene, ElementIndex e, const std::vector<FieldPoint>& field,
                   BodiesMotion& carried) const;

  /// None of a block that stays elastic.
  const BlockYield* yield_of(ElementIndex e) const {
    const auto i = static_cast<std::size_t>(e.value);
    return yields_.empty() || !yields_[i] ? nullptr : &*yields_[i];
  }
  /// V Bᵀ D times inelastic strain at rest, which acts against the elastic force.
  Unknowns inelastic_force(ElementIndex e, const BodiesMotion& motion) const;
  void add_yield_flow(const BodiesStep& step, ElementIndex e, EnergyFlow& flow) const;

  Bodies bodies_;
  std::vector<bool> of_others_;
  std::vector<std::optional<BlockYield>> yields_;
  double size_ = 0;
};

}  // namespace keyblock
