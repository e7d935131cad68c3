// Computes elasticity, plastic flow and fields of the DDA blocks of a scene, and transfers their state to a later
// scene.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "step/bodies/block_yield.hpp"
#include "step/bodies/step_equations.hpp"
#include "step/groups/block_bodies.hpp"

namespace keyblock {

class BlockGroup final : public BlockBodies {
 public:
  /// Takes one body per element. Elements of other groups have no unknowns and are marked in `of_others`. `yields`: one
  /// per element, or empty if no block is inelastic.
  BlockGroup(Bodies bodies, std::vector<bool> of_others, std::vector<std::optional<BlockYield>> yields)
      : BlockBodies(std::move(bodies), std::move(of_others)), yields_(std::move(yields)), kept_(bodies_.size()) {}

  bool is_linear() const override { return yields_.empty(); }
  bool has_compatible_start() const override { return yields_.empty(); }
  bool may_yield() const override { return !yields_.empty(); }

  void put_start(const SceneParts& scene, BodiesMotion& motion) const override;
  void unload(const ChosenElements& bodies, UnknownsTable& loads) const override;
  void put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const override;

  void add_stored(const BodiesMotion& motion, StoredEnergy& stored) const override;
  void add_flow(const BodiesStep& step, EnergyFlow& flow) const override;
  void add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion, const Flexibility& mass_inverse,
                        UnknownsTable& a) const override;
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
  /// Returns null for a block that stays elastic.
  const BlockYield* yield_of(ElementIndex e) const {
    const auto i = static_cast<std::size_t>(e.value);
    return yields_.empty() || !yields_[i] ? nullptr : &*yields_[i];
  }
  /// Returns V Bᵀ D times the current inelastic strain, a force against the elastic force.
  Unknowns inelastic_force(ElementIndex e, const BodiesMotion& motion) const;
  void add_yield_flow(const BodiesStep& step, ElementIndex e, EnergyFlow& flow) const;

  std::vector<std::optional<BlockYield>> yields_;
  mutable std::vector<KeptInverse> kept_;  ///< one per body, for one step at a time
};

}  // namespace keyblock
