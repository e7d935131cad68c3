// Sums over the elements and faces of a domain; see tip_integrals.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/tip_integrals.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/polygon.hpp"
#include "geometry/quadrature.hpp"
#include "material/material_stress.hpp"

namespace keyblock {
namespace {

// Quadrature of elements and edges in a domain: near-tip fields are no polynomials. Six points per side; eight change K
// by 1e-5.
constexpr int kAreaDegree = 10;
constexpr int kFacePoints = 8;
// Step of the difference quotient for the divergence of an initial stress given by a formula, per size of an element.
constexpr double kDifference = 1e-4;

// Sides from a tip within which contact closes its faces, and within which contact forces define a direction.
constexpr double kSidesOfTip = 2;
constexpr double kSidesOfFaces = 6;
constexpr double kOnFace = 0.1;   // sine of the angle from the face of a crack within which a force acts on it
constexpr double kExplained = 3;  // K_I over pressure times the root of the side: up to 0.9 in fra-19

/// Field of the integrals at one point, in the axes of the tip.
struct LocalField {
  Eigen::Matrix2d gradient;  // ∂u_i/∂x_j
  Eigen::Vector3d stress;    // σxx, σyy, σxy: change since the start
};

Eigen::Vector3d strain_of(const Eigen::Matrix2d& g) {
  return {g(0, 0), g(1, 1), g(0, 1) + g(1, 0)};
}

Eigen::Matrix2d matrix_of(const Eigen::Vector3d& stress) {
  return (Eigen::Matrix2d() << stress(0), stress(2), stress(2), stress(1)).finished();
}

class TipSums {
 public:
  TipSums(const CoverSolution& solution, const CrackTip& tip, const CrackDomain& domain)
      : solution_(solution), tip_(tip), domain_(domain), rock_(rock_at(solution.continuum, tip)) {
    axes_ << tip.ahead.x, tip.ahead.y, -tip.ahead.y, tip.ahead.x;
    tip_element_ = element_of(manifold(), tip);
    modulus_ = solution.continuum.modulus(std::max(tip_element_, 0));
    if (solution.is_large && tip_element_ >= 0) take_out_turning();
  }

  TipFactors result() {
    for (const int e : domain_.elements()) {
      add_area(e);
      if (has_initial_stress(e)) add_initial_stress_on_faces(e);
    }
    for (const Traction& part : solution_.continuum.tractions) add_traction(part);
    for (const FaceForce& f : solution_.face_forces)
      if (std::ranges::binary_search(domain_.elements(), f.element)) add_force(f.element, f.at, f.force);
    const double half = rock_.effective_modulus() / 2;
    return closed_if_pressed({{half * interaction_[0], half * interaction_[1]}, j_});
  }

 private:
  const Manifold& manifold() const { return solution_.continuum.manifold; }

  Eigen::Matrix2d gradient_at(int e, Point x) const {
    const ElementShape shape = solution_.basis.shape(e);
    const Eigen::Matrix2Xd dn = shape.gradients(x);
    Eigen::Matrix2d g = Eigen::Matrix2d::Zero();
    for (int a = 0; a < shape.function_count(); ++a)
      g += solution_.d.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]) * dn.col(a).transpose();
    return g;
  }

  /// Removes the rotation of the polar decomposition of the deformation of the tip element.
  void take_out_turning() {
    const Point middle =
        centroid(manifold().polygon(manifold().elements[static_cast<std::size_t>(tip_element_)]).front());
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(Eigen::Matrix2d::Identity() + gradient_at(tip_element_, middle),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    turn_back_ = (svd.matrixU() * svd.matrixV().transpose()).transpose();
  }

  Eigen::Matrix2d in_axes(const Eigen::Matrix2d& m) const { return axes_ * m * axes_.transpose(); }
  Eigen::Vector2d in_axes(Point v) const { return axes_ * Eigen::Vector2d(v.x, v.y); }

  LocalField field(int e, Point x) const {
    Eigen::Matrix2d g = gradient_at(e, x);
    if (solution_.is_large) g = turn_back_ * (Eigen::Matrix2d::Identity() + g) - Eigen::Matrix2d::Identity();
    LocalField local;
    local.gradient = in_axes(g);
    local.stress = modulus_ * strain_of(local.gradient);
    return local;
  }

  /// Returns the field of one mode with the factor 1; behind the tip θ is that of the face's side.
  LocalField near_tip(std::size_t mode, Point x, double side_of_face) const {
    const Eigen::Vector2d local = in_axes(x - tip_.at);
    const double theta = side_of_face == 0 ? std::atan2(local.y(), local.x()) : side_of_face * std::numbers::pi;
    const StressIntensity unit{mode == 0 ? 1.0 : 0.0, mode == 0 ? 0.0 : 1.0};
    const double r = local.norm();
    return {near_tip_gradient(rock_, unit, r, theta), near_tip_stress(unit, r, theta)};
  }

  void add_area(int e) {
    for (const AreaPoint& p : area_rule(manifold(), e, solution_.basis.shape(e), kAreaDegree)) {
      const double q = domain_.weight(e, p.at);
      if (q == 0) continue;
      const Eigen::Vector2d dq = in_axes(domain_.gradient(e, p.at));
      const Eigen::Vector2d b = turned(body_force(e, p.at) - inertia(e, p.at));
      if (dq.isZero(0) && b.isZero(0)) continue;
      const LocalField own = field(e, p.at);
      const double energy = 0.5 * own.stress.dot(strain_of(own.gradient));
      const Eigen::Vector2d flow = matrix_of(own.stress) * own.gradient.col(0);
      j_ += p.weight * (flow.dot(dq) - energy * dq.x() - b.dot(own.gradient.col(0)) * q);
      for (std::size_t mode = 0; mode < 2; ++mode) {
        const LocalField other = near_tip(mode, p.at, 0);
        const Eigen::Vector2d mixed =
            matrix_of(own.stress) * other.gradient.col(0) + matrix_of(other.stress) * own.gradient.col(0);
        const double mutual = other.stress.dot(strain_of(own.gradient));
        interaction_[mode] += p.weight * (mixed.dot(dq) - mutual * dq.x() - b.dot(other.gradient.col(0)) * q);
      }
    }
  }

  /// Contact force on the left face of this crack near the tip.
  struct FacePressure {
    Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< in the axes of the tip
    double reach = 0;                                 ///< greatest distance of the forces from the tip
    bool is_at_tip = false;
  };

  FacePressure face_pressure(double side) const {
    FacePressure pressure;
    for (const FaceForce& f : solution_.face_forces) {
      const Eigen::Vector2d local = in_axes(f.at - tip_.at);
      const double r = local.norm();
      const bool is_behind = local.x() < 0 && std::abs(local.y()) <= kOnFace * r && r <= kSidesOfFaces * side;
      if (!is_behind || f.other < 0 || side_of(f.element) < 0 || side_of(f.other) > 0) continue;
      const Eigen::Vector2d force = turned(f.force);
      pressure.force += force;
      pressure.reach = std::max(pressure.reach, r);
      pressure.is_at_tip = pressure.is_at_tip || (r <= kSidesOfTip * side && force.y() > 0);
    }
    return pressure;
  }

  /// Applies the rule for closed faces given in the header.
  TipFactors closed_if_pressed(TipFactors found) const {
    if (tip_element_ < 0 || solution_.face_forces.empty()) return found;
    const double side = solution_.basis.shape(tip_element_).frame.size;
    const FacePressure pressure = face_pressure(side);
    const bool overlaps = found.k.mode_1 < 0;
    if (!(pressure.is_at_tip || overlaps) || !(pressure.force.y() > 0)) return found;
    const double explained = kExplained * pressure.force.y() / pressure.reach * std::sqrt(side);
    if (found.k.mode_1 > explained) return found;
    found.k.mode_2 -= pressure.force.x() / pressure.force.y() * found.k.mode_1;
    found.k.mode_1 = 0;
    found.is_closed = true;
    return found;
  }

  Eigen::Vector2d turned(Point force) const {
    if (force == Point{}) return Eigen::Vector2d::Zero();
    return axes_ * (turn_back_ * Eigen::Vector2d(force.x, force.y));
  }

  /// Returns the body force, including the divergence of the initial stress.
  Point body_force(int e, Point x) const {
    const Continuum& continuum = solution_.continuum;
    Point b = continuum.force_at(e, x);
    if (!continuum.initial_stress) {
      const Stress& per_y = continuum.material(e).stress_gradient;
      return b + Point{per_y.xy, per_y.yy};
    }
    const double h = kDifference * domain_.reach();
    const auto stress = [&](double dx, double dy) { return continuum.initial_stress_at(e, x + Point{dx, dy}); };
    const Stress right = stress(h, 0), left = stress(-h, 0), up = stress(0, h), down = stress(0, -h);
    return b + (1 / (2 * h)) * Point{right.xx - left.xx + up.xy - down.xy, right.xy - left.xy + up.yy - down.yy};
  }

  /// Returns ρ ü.
  Point inertia(int e, Point x) const {
    if (solution_.acceleration == nullptr) return {};
    const ElementShape shape = solution_.basis.shape(e);
    const Eigen::RowVectorXd n = shape.values(x);
    Eigen::Vector2d a = Eigen::Vector2d::Zero();
    for (int i = 0; i < shape.function_count(); ++i)
      a += n(i) * solution_.acceleration->segment<2>(2 * shape.functions[static_cast<std::size_t>(i)]);
    return solution_.continuum.material(e).density * Point{a.x(), a.y()};
  }

  bool has_initial_stress(int e) const {
    return solution_.continuum.initial_stress || solution_.continuum.material(e).is_stressed();
  }

  double side_of(int e) const {
    const Point middle = centroid(manifold().polygon(manifold().elements[static_cast<std::size_t>(e)]).front());
    return cross(tip_.ahead, middle - tip_.at) >= 0 ? 1 : -1;
  }

  void add_force(int e, Point at, Point force) {
    const double q = domain_.weight(e, at);
    if (q == 0 || at == tip_.at) return;
    const Eigen::Vector2d t = turned(force);
    j_ -= q * t.dot(field(e, at).gradient.col(0));
    for (std::size_t mode = 0; mode < 2; ++mode)
      interaction_[mode] -= q * t.dot(near_tip(mode, at, side_of(e)).gradient.col(0));
  }

  /// Adds points along an edge of a face, closer near the tip: by the root of the distance, as near-tip gradients vary.
  template <class Force>
  void add_edge(const ElementSide& edge, const Force& force) {
    const double from = std::sqrt(distance(edge.edge.start, tip_.at)), to = std::sqrt(distance(edge.edge.end, tip_.at));
    const Point along = edge.edge.end - edge.edge.start;
    const double size = length(along);
    for (const GaussPoint& g : gauss_rule(kFacePoints)) {
      const double root = from + g.at * (to - from);
      const double station = std::abs(root * root - from * from) / size;
      const Point at = edge.edge.start + station * along;
      const double weight = g.weight * std::abs(to - from) * 2 * root;
      add_force(edge.element, at, weight * force(at, edge.normal()));
    }
  }

  void add_traction(const Traction& part) {
    for (const ElementSide& side : sides_along(manifold(), part.along))
      if (std::ranges::binary_search(domain_.elements(), side.element)) add_edge(side, part.force);
  }

  void add_initial_stress_on_faces(int e) {
    const auto loops = [&] {
      const ManifoldElement& element = manifold().elements[static_cast<std::size_t>(e)];
      return manifold().loop(element.outer);
    }();
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (loops[i].neighbour >= 0) continue;
      const ElementSide edge{e, {loops[i].position, loops[(i + 1) % loops.size()].position}};
      add_edge(edge, [&](Point at, Point n) {
        const Stress s = solution_.continuum.initial_stress_at(e, at);
        return -1.0 * Point{s.xx * n.x + s.xy * n.y, s.xy * n.x + s.yy * n.y};
      });
    }
  }

  const CoverSolution& solution_;
  CrackTip tip_;
  const CrackDomain& domain_;
  PlaneElasticity rock_;
  Eigen::Matrix2d axes_;  // rows: ahead, left
  Eigen::Matrix2d turn_back_ = Eigen::Matrix2d::Identity();
  Eigen::Matrix3d modulus_;
  int tip_element_ = -1;
  std::array<double, 2> interaction_{};
  double j_ = 0;
};

}  // namespace

int element_of(const Manifold& manifold, const CrackTip& tip) {
  for (std::size_t e = 0; e < manifold.elements.size(); ++e)
    if (side(manifold.polygon(manifold.elements[e]).front(), tip.at) != Side::outside) return static_cast<int>(e);
  return -1;
}

PlaneElasticity rock_at(const Continuum& continuum, const CrackTip& tip) {
  const BlockMaterial& material = continuum.material(std::max(0, element_of(continuum.manifold, tip)));
  return {material.youngs_modulus, material.poissons_ratio, continuum.plane == Plane::strain};
}

TipFactors factors_at(const CoverSolution& solution, const CrackTip& tip, const CrackDomain& domain) {
  return TipSums(solution, tip, domain).result();
}

}  // namespace keyblock
