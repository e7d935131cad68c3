// Finds the joint material from the edge of the contact, and its stiffness from its share of the stretch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/scene/contact_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "contact/rows/gap.hpp"
#include "model/material_choices.hpp"
#include "step/newton/tolerances.hpp"
#include "step/scene/touch_search.hpp"

namespace keyblock {
namespace {

// Above this fraction of its limit a friction force slides: residuals of the contact forces are smaller.
constexpr double kAtLimit = 1 - 1e-6;

// Each of the two ends of a stretch has the contact stiffness, so that the whole stretch has twice that.
double stiffness_share(const Touch& touch) {
  return touch.facing.lower ? 2 * touch.share : 1;
}

Enforcement enforcement_at(const StandardScene& scene, const Touch& touch) {
  return enforcement_of(scene.settings, touch.joint_material);
}

void add_springs(ContactLaw& law, const StandardScene& scene, const Touch& touch) {
  const auto [normal, tangential] = springs_of(scene, touch);
  switch (enforcement_at(scene, touch)) {
    case Enforcement::lagrange:
    case Enforcement::automatic:  // decided before the first step
      break;
    case Enforcement::penalty:
      law.normal_compliance = normal;
      law.tangential_compliance = tangential;
      break;
    case Enforcement::augmented:
      law.normal_weight = normal;
      law.tangential_weight = tangential;
      break;
  }
}

struct BondedPoint {
  Point at;
  double force = 0;
  double length = 0;
};

// All bonds between two edges.
struct BondedFace {
  std::vector<BondedPoint> points;
  std::vector<Facing> bonds;
  double shear = 0;
  double shear_strength = 0;
  double tensile_strength = 0;
  bool is_of_whole_blocks = false;

  bool is_sheared(double tolerance) const { return std::abs(shear) > std::max(0.0, shear_strength) + tolerance; }

  // A block drawn on the verge of toppling stands.
  bool is_torn(double tolerance) const {
    const Point first = points.front().at;
    const Point last =
        std::ranges::max_element(points, {}, [&](const BondedPoint& point) { return distance(first, point.at); })->at;
    if (!(distance(first, last) > 0)) return false;
    const Point along = (1 / distance(first, last)) * (last - first);
    double force = 0;
    double length = 0;
    double middle = 0;
    for (const BondedPoint& point : points) {
      force += point.force;
      length += point.length;
      middle += point.length * dot(point.at - first, along);
    }
    middle /= length;
    double moment = 0;
    for (const BondedPoint& point : points) moment += point.force * (dot(point.at - first, along) - middle);
    moment = std::abs(moment);
    return moment > (0.5 + tolerances::of_gaps::kDrawnTogether) * force * length &&
           6 * moment / length - force > tensile_strength + tolerance;
  }
};

}  // namespace

Springs springs_of(const StandardScene& scene, const Touch& touch) {
  const double share = stiffness_share(touch);
  return {1 / (share * scene.normal_stiffness()), 1 / (share * scene.tangential_stiffness())};
}

Touches without_springs(const StandardScene& scene, Touches touches) {
  std::erase_if(touches, [&](const Touch& touch) { return enforcement_at(scene, touch) == Enforcement::penalty; });
  return touches;
}

ContactMemory memory_of(const ContactLaw& law, double normal, double tangential) {
  return {normal,
          tangential,
          -tangential * law.tangential_compliance,
          law.normal_compliance,
          law.tangential_compliance,
          normal,
          normal * law.normal_compliance};
}

// A spring that swings about the limit of friction is a little longer at times; cut at 1, slopes at rest crept by 1e-8
// of their displacements. Slip is some thousand times longer.
constexpr double kMostStretch = 2;

ContactMemory memory_of(const ContactLaw& law, double normal, double tangential, double slip,
                        const ContactMemory* before) {
  ContactMemory memory = memory_of(law, normal, tangential);
  if (law.tangential_compliance == 0 || !sticks(law, normal, tangential)) return memory;
  const double had = before ? before->stretch : 0;
  const double at_limit = law.tangential_compliance * law.force.limit(normal);  // infinite for a bond
  const double most = std::max(kMostStretch * at_limit, std::abs(had));
  memory.stretch = std::clamp(had + slip, -most, most);
  return memory;
}

bool sticks(const ContactLaw& law, double normal, double tangential) {
  return std::abs(tangential) < kAtLimit * law.force.limit(normal);
}

ContactLaw contact_law(const StandardScene& scene, const Bonds& bonds, const Touch& touch) {
  const JointMaterial& joint = scene.model.joint_material(touch.joint_material);
  ContactLaw law;
  law.force.friction = joint.friction_tangent();
  law.rest_gap = touch.rest_gap;
  add_springs(law, scene, touch);
  const auto bond = touch.facing.lower ? bonds.find(touch.facing) : bonds.end();
  if (bond == bonds.end()) return law;
  law.is_bonded = true;
  law.bonded_length = bond->second.length;
  law.force.cohesion = std::numeric_limits<double>::infinity();
  law.shear_strength = joint.cohesion * bond->second.length;
  law.force.least = -joint.tensile_strength * bond->second.length;
  law.rest_gap = bond->second.gap;
  return law;
}

bool resolves_impact(const StandardScene& scene, const Touch& touch) {
  const auto resolves = [&](VertexIndex vertex) {
    return scene.groups.of(scene.model.vertices[vertex].element).resolves_impacts();
  };
  return resolves(touch.vertex) || resolves(touch.start);
}

std::vector<Facing> overloaded_faces(const StandardScene& scene, const UnknownsTable& q, const Touches& touches,
                                     const std::vector<ContactLaw>& laws, const Eigen::VectorXd& forces,
                                     double tolerance) {
  std::map<std::pair<VertexIndex, VertexIndex>, BondedFace> faces;
  const auto vertices = vertices_at(scene.model, scene.reference, q);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (!laws[i].is_bonded) continue;
    BondedFace& face = faces[{touches[i].facing.lower, touches[i].facing.upper}];
    const auto n = static_cast<Eigen::Index>(2 * i);
    face.points.push_back({point_of(touches[i], vertices), forces[n], laws[i].bonded_length});
    face.bonds.push_back(touches[i].facing);
    face.shear += forces[n + 1];
    face.shear_strength += laws[i].shear_strength + laws[i].force.friction * forces[n];
    face.tensile_strength -= laws[i].force.least;
    face.is_of_whole_blocks = !resolves_impact(scene, touches[i]);
  }
  std::vector<Facing> overloaded;
  for (const auto& [edges, face] : faces)
    if (face.is_sheared(tolerance) || (face.is_of_whole_blocks && face.is_torn(tolerance)))
      overloaded.insert(overloaded.end(), face.bonds.begin(), face.bonds.end());
  return overloaded;
}

bool has_strength(const StandardScene& scene, const Touch& touch) {
  return touch.stretch > 0 && scene.model.joint_material(touch.joint_material).has_strength();
}

Bonds bonds_at(const StandardScene& scene, const Motion& motion, const Scales& scales) {
  const auto vertices = vertices_at(scene.model, scene.reference, motion.q);
  Bonds bonds;
  for (const Touch& touch : meeting_touches(scene, motion, scales, tolerances::of_gaps::kDrawnTogether * scales.size))
    if (has_strength(scene, touch)) bonds[touch.facing] = {gap_of(touch, vertices), touch.stretch * touch.share};
  return bonds;
}

}  // namespace keyblock
