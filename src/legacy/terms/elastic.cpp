// Adds the elastic stiffness of every element through its strain operator.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "legacy/terms/elastic.hpp"

#include "base/loop.hpp"
#include "material/elastic.hpp"

namespace keyblock {
namespace {

Eigen::Matrix3d stiffness_modulus(const BlockMaterial& material, const Settings& settings) {
  if (settings.plane == Plane::stress) return plane_stress_modulus(material);
  const double nu = material.poissons_ratio;
  const double factor = settings.quirks.plane_strain_factor ? (1 + nu) / (1 - nu) : 1;
  return factor * plane_strain_modulus(material);
}

// `N`: number of unknowns, or Eigen::Dynamic.
template <int N>
UnknownBlock stiffness_of(const Basis& basis, double area, const Eigen::Matrix3d& modulus) {
  const Eigen::Matrix<double, 3, N, Eigen::ColMajor, 3, N == Eigen::Dynamic ? kMostUnknowns : N> strain =
      basis.strain();
  return area * (strain.transpose() * modulus * strain);
}

}  // namespace

UnknownBlock stiffness_matrix(const Basis& basis, double area, const BlockMaterial& material,
                              const Settings& settings) {
  const Eigen::Matrix3d modulus = stiffness_modulus(material, settings);
  if (basis.unknown_count() == 6) return stiffness_of<6>(basis, area, modulus);
  return stiffness_of<Eigen::Dynamic>(basis, area, modulus);
}

void add_elastic(const StepContext& context, System& system) {
  const Model& model = context.model;
  for_each_index(model.elements, [&](ElementIndex e) {
    const Element& element = model.elements[e];
    const double area = context.state.elements[e].moments.area;
    system.matrix.add(e.value, e.value,
                      stiffness_matrix(*element.basis, area, model.material_of(element), context.settings));
  });
}

}  // namespace keyblock
