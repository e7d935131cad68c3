// Holds the DDA blocks of a scene as masses. Each block has unknowns of its own, in a frame that rotates with it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "step/bodies/standard_body.hpp"
#include "step/groups/body_group.hpp"

namespace keyblock {

/// Raises scales to those of a DDA block under its load.
void add_block(Scales& scales, const Body& body, const Unknowns& load, const Unknowns& v);

/// Returns the load of a DDA block, or the force of its initial stress if that is larger.
double largest_load(const Body& body, const Unknowns& load);

/// Properties, loads, momenta, speeds and step differences of DDA blocks.
class BlockBodies : public BodyGroup {
 public:
  /// Takes one body per element. Elements of other groups have no unknowns and are marked in `of_others`.
  BlockBodies(Bodies bodies, std::vector<bool> of_others);

  const Bodies& bodies() const { return bodies_; }

  bool has(ElementIndex e) const override { return !of_others_[static_cast<std::size_t>(e.value)]; }
  double size() const override { return size_; }
  double mass_of(ElementIndex e) const override { return bodies_[e].mass(0, 0); }
  bool are_one_body(ElementIndex a, ElementIndex b) const override { return a == b; }
  bool has_supports() const override;
  bool is_supported(ElementIndex) const override { return false; }
  bool resolves_impacts() const override { return false; }
  bool takes_holes() const override { return true; }
  bool has_compatible_start() const override { return true; }
  std::optional<ElasticLaw> law_of_large_strain(const SceneParts&, ElementIndex) const override { return {}; }
  bool needs_fixed_points() const override { return false; }
  void add_to(MassRange& range, double contact_stiffness) const override;

  void carry_over(const SceneParts& scene, UnknownsTable& v) const override;
  void put_own_loads(const UnknownsTable& q, double time, UnknownsTable& loads) const override;
  void add_inertia(Point acceleration, UnknownsTable& loads) const override;
  void add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
              const UnknownsTable& v) const override;

  void put_mass_inverse(Flexibility& flexibility) const override;
  void put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const override;
  double kinetic_energy(const UnknownsTable& v) const override;
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

 protected:
  Bodies bodies_;

 private:
  std::vector<bool> of_others_;
  double size_ = 0;
};

}  // namespace keyblock
