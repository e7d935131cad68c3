// Computes the forces and energies of inelastic strain; see block_yield.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/block_yield.hpp"

#include "material/material_stress.hpp"

namespace keyblock {

// In plane stress the modulus is that of the plane, which excludes the strain across the plane.
Unknowns BlockYield::inelastic_force(const Eigen::Vector4d& inelastic) const {
  const Eigen::Vector3d stress = rock.plane == Plane::stress
                                     ? Eigen::Vector3d(modulus * inelastic.head<3>())
                                     : Eigen::Vector3d((rock.law->modulus() * inelastic).head<3>());
  return rock.area * (strain.transpose() * stress);
}

double BlockYield::inelastic_energy(const Unknowns& q, const YieldState& state) const {
  const Eigen::Vector3d now = strain_at(q);
  const Eigen::Vector3d at_start = rock.stress(Eigen::Vector3d::Zero(), YieldState()).head<3>();
  return rock.stored(now, state) - rock.area * now.dot(at_start + modulus * now / 2);
}

UnknownBlock BlockYield::lost_stiffness(const Response& response) const {
  return of_unknowns(modulus - response.tangent.topLeftCorner<3, 3>());
}

UnknownBlock BlockYield::of_unknowns(const Eigen::Matrix3d& stiffness) const {
  if (!rock.law->has_symmetric_tangent()) return rock.area * (strain.transpose() * stiffness * strain);
  return rock.area / 2 * (strain.transpose() * (stiffness + stiffness.transpose()) * strain);
}

std::optional<BlockYield> block_yield(const Model& model, const Reference& reference, const Settings& settings,
                                      ElementIndex e) {
  const Element& element = model.elements[e];
  const BlockMaterial& material = model.material_of(element);
  if (!material.is_nonlinear() || element.is_on_covers() || element.basis->unknown_count() <= kRigidUnknowns)
    return std::nullopt;
  const YieldLaw law = yield_law(material);
  const Stress start = start_stress(material, material.stress_gradient, reference.centroids[e].y, settings.plane);
  return BlockYield{{std::make_shared<const YieldLaw>(law), settings.plane, reference.moments[e].area,
                     law.elastic_strain({start.xx, start.yy, start.xy, start.zz})},
                    element.basis->strain(),
                    modulus_of(material, settings.plane)};
}

// A rule whose strain follows the end velocity sees the end's elastic strain in steady flow.
InelasticShare inelastic_share(const Body& body, const StepRule& rule, double dt) {
  const bool follows_rate = rule.strain.velocity != 0;
  const bool is_damped = rule.strain_rate.increment != 0;
  return {follows_rate ? 1 : rule.strain.increment, is_damped ? body.stiffness_damping / dt : 0};
}

}  // namespace keyblock
