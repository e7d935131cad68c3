// Multiplies the mean stress of two blocks by their common face; see stressed_start.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/rest/stressed_start.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/rows/gap.hpp"
#include "material/material_stress.hpp"
#include "step/scene/contact_laws.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

Point traction(const StandardScene& scene, VertexIndex of, Point at, Point normal) {
  const BlockMaterial& material = scene.model.material_of(scene.model.elements[scene.model.vertices[of].element]);
  const Stress stress = start_stress(material, material.stress_gradient, at.y, scene.settings.plane);
  return {stress.xx * normal.x + stress.xy * normal.y, stress.xy * normal.x + stress.yy * normal.y};
}

}  // namespace

ClosedContacts stressed_contacts(const StandardScene& scene, const Motion& motion) {
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  std::vector<ClosedContact> closed;
  for (const Touch& touch : resting_touches(scene, motion, scales_at(scene, motion, 0))) {
    const ContactLaw law = contact_law(scene, motion.bonds, touch);
    if (law.normal_compliance > 0 || touch.stretch == 0) continue;
    const Point normal = normal_of(touch, vertices);
    const Point at = point_of(touch, vertices);
    const Point force = -touch.share * touch.stretch / 2 *
                        (traction(scene, touch.vertex, at, normal) + traction(scene, touch.start, at, normal));
    const double pressure = std::max(law.force.least, dot(force, normal));
    const double limit = law.force.limit(pressure);
    if (pressure == 0 && limit == 0) continue;
    const double shear = std::clamp(cross(normal, force), -limit, limit);
    closed.push_back({touch, memory_of(law, pressure, shear)});
  }
  return ClosedContacts(std::move(closed));
}

}  // namespace keyblock
