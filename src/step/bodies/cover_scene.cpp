// Sums over the functions of each body; see cover_scene.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/cover_scene.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "model/body_load.hpp"
#include "model/shared_covers.hpp"
#include "step/bodies/cover_flexibility.hpp"
#include "step/bodies/linear_static.hpp"
#include "terms/ghost_force.hpp"

namespace keyblock {
namespace {

using Functions = std::vector<std::vector<int>>;

CoverDamping damping_of(const std::vector<int>& body_materials, const Settings& settings) {
  CoverDamping damping;
  for (const int material : body_materials) {
    damping.mass.push_back(settings.mass_damping.of(material));
    damping.stiffness.push_back(settings.stiffness_damping.of(material).value_or(0));
  }
  return damping;
}

std::vector<double> carry_over_of(const std::vector<int>& body_materials, const Settings& settings) {
  std::vector<double> shares;
  for (const int material : body_materials) shares.push_back(settings.velocity_carry_over.of(material));
  return shares;
}

/// Marks the NMM elements in supported pieces; `first` is the first of them in the model.
std::vector<bool> supported_elements(const Model& model, ElementIndex first) {
  const Continuum& continuum = *model.continuum;
  const std::vector<int> pieces = body_numbers(model);
  const auto piece_of = [&](std::size_t element) {
    return static_cast<std::size_t>(pieces[static_cast<std::size_t>(first.value) + element]);
  };
  std::vector<bool> holds(pieces.size());
  const auto put = [&](int element) { holds[piece_of(static_cast<std::size_t>(element))] = true; };
  for (const PrescribedDisplacement& held : continuum.prescribed)
    for (const ElementSide& side : sides_along(continuum.manifold, held.along)) put(side.element);
  for (const PointSpring& spring : continuum.point_springs) put(spring.element);
  std::vector<bool> supported;
  for (std::size_t e = 0; e < continuum.manifold.elements.size(); ++e) supported.push_back(holds[piece_of(e)]);
  return supported;
}

ElementIndex first_on_covers(const Model& model) {
  for (ElementIndex e : indices(model.elements))
    if (model.elements[e].is_on_covers()) return e;
  return model.elements.end_index();
}

double rotation_of(const Eigen::Matrix2d& f) {
  return std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
}

/// Returns the matrix from unknowns to the displacements of all element corners.
Eigen::SparseMatrix<double> values_at_corners(const Continuum& continuum, const CoverBasis& basis) {
  std::vector<Eigen::Triplet<double>> values;
  int row = 0;
  for (int e = 0; e < basis.element_count(); ++e) {
    const ElementShape shape = basis.shape(e);
    for (const auto& loop : continuum.manifold.polygon(continuum.manifold.elements[static_cast<std::size_t>(e)]))
      for (const Point& corner : loop) {
        const Eigen::RowVectorXd n = shape.values(corner);
        for (int a = 0; a < shape.function_count(); ++a)
          for (int i = 0; i < 2; ++i)
            values.emplace_back(row + i, 2 * shape.functions[static_cast<std::size_t>(a)] + i, n(a));
        row += 2;
      }
  }
  Eigen::SparseMatrix<double> matrix(row, 2 * basis.function_count());
  matrix.setFromTriplets(values.begin(), values.end());
  return matrix;
}

ConnectedPieces pieces_of(const CoverBasis& basis, ElementIndex first, const std::vector<int>& numbers) {
  ConnectedPieces found;
  found.of_function.assign(static_cast<std::size_t>(basis.function_count()), 0);
  std::map<int, int> pieces;
  for (int e = 0; e < basis.element_count(); ++e) {
    const auto [piece, is_new] =
        pieces.try_emplace(numbers[static_cast<std::size_t>(first.value + e)], static_cast<int>(pieces.size()));
    if (is_new) found.first_elements.push_back({first.value + e});
    for (const int f : basis.shape(e).functions) found.of_function[static_cast<std::size_t>(f)] = piece->second;
  }
  return found;
}

}  // namespace

CoverScene::CoverScene(const Model& model, const Settings& settings)
    : made_of_(model.continuum),
      damping_(damping_of(made_of_->manifold.body_materials, settings)),
      bodies_(*made_of_, damping_),
      changing_(*made_of_, bodies_.basis()),
      first_(first_on_covers(model)),
      kinematics_(std::make_shared<CoverKinematics>(model, first_, bodies_.basis())),
      carry_(carry_over_of(made_of_->manifold.body_materials, settings)),
      supported_(supported_elements(model, first_)),
      mass_inverse_(mass_flexibility_of(bodies_)) {
  if (definiteness_of(bodies_.continuum.functions) == Definiteness::semidefinite)
    at_corners_ = values_at_corners(bodies_.continuum, bodies_.basis());
  pieces_ = pieces_of(basis(), first_, body_numbers(model));
  weight_ = bodies_.supports.load();
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(bodies_.unknown_count());
  initial_force_ = -bodies_.elasticity.force(still, still, 1);
  if (!yield().is_empty()) initial_force_ -= yield().answer(still, yield().start()).force;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(bodies_.unknown_count());
  at_start_.resize(bodies_.rigid.functions().size());
  at_start_ = whole(none, none);
  for (VertexIndex v : IndexRange<VertexIndex>(model.elements[first_].first_vertex, model.vertices.end_index())) {
    WholeBody& body = at_start_[static_cast<std::size_t>(body_of(model.vertices[v].element))];
    body.size = std::max(body.size, distance(body.centre, model.start_vertices[static_cast<std::size_t>(v.value)]));
    size_ = std::max(size_, body.size);
  }
  slow_frequency_ = std::numeric_limits<double>::infinity();
  for (const int number : bodies_.continuum.manifold.body_materials) {
    const BlockMaterial& material = bodies_.continuum.materials[static_cast<std::size_t>(number)];
    slow_frequency_ = std::min(slow_frequency_, std::sqrt(material.youngs_modulus / material.density) / size_);
  }
}

// Models that do not change the continuum share one object, so that comparing pointers suffices.
bool CoverScene::is_of(const Model& model, const Settings& settings) const {
  if (model.continuum != made_of_ || first_on_covers(model) != first_) return false;
  const std::vector<int>& materials = made_of_->manifold.body_materials;
  return damping_of(materials, settings) == damping_ && carry_over_of(materials, settings) == carry_;
}

Eigen::VectorXd CoverScene::felt(const Eigen::VectorXd& unknowns) const {
  if (at_corners_.rows() == 0) return unknowns.cwiseAbs();
  return (at_corners_ * unknowns).cwiseAbs();
}

int CoverScene::body_of(ElementIndex e) const {
  return bodies_.continuum.manifold.elements[static_cast<std::size_t>(e.value - first_.value)].body;
}

const WholeBody& CoverScene::body_at_start(ElementIndex e) const {
  return at_start_[static_cast<std::size_t>(body_of(e))];
}

Eigen::VectorXd CoverScene::turning(int body, const Eigen::VectorXd& d, Point centre) const {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(bodies_.unknown_count());
  const std::vector<int>& functions = bodies_.rigid.functions()[static_cast<std::size_t>(body)];
  const Eigen::VectorXd own = bodies_.rigid.modes(body, d, centre).col(2);
  for (std::size_t i = 0; i < functions.size(); ++i)
    v.segment<2>(2 * functions[i]) = own.segment<2>(2 * static_cast<Eigen::Index>(i));
  return v;
}

Eigen::VectorXd CoverScene::start_velocity() const {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(bodies_.unknown_count());
  const Functions& functions = bodies_.rigid.functions();
  for (std::size_t b = 0; b < functions.size(); ++b) {
    const int material = bodies_.continuum.manifold.body_materials[b];
    const Velocity& given = bodies_.continuum.materials[static_cast<std::size_t>(material)].initial_velocity;
    const Eigen::MatrixX3d modes =
        bodies_.rigid.modes(static_cast<int>(b), Eigen::VectorXd::Zero(v.size()), at_start_[b].centre);
    const Eigen::VectorXd own = modes * Eigen::Vector3d(given.x, given.y, given.rotation);
    for (std::size_t i = 0; i < functions[b].size(); ++i)
      v.segment<2>(2 * functions[b][i]) = own.segment<2>(static_cast<Eigen::Index>(2 * i));
  }
  return v;
}

Eigen::VectorXd CoverScene::carried_over(Eigen::VectorXd v) const {
  const Functions& functions = bodies_.rigid.functions();
  for (std::size_t b = 0; b < functions.size(); ++b)
    for (const int f : functions[b]) v.segment<2>(2 * f) *= carry_[b];
  return v;
}

Eigen::VectorXd CoverScene::inertia_of(Point acceleration) const {
  const Functions& functions = bodies_.rigid.functions();
  Eigen::VectorXd field = Eigen::VectorXd::Zero(bodies_.unknown_count());
  for (std::size_t b = 0; b < functions.size(); ++b) {
    const Eigen::MatrixX3d modes = bodies_.rigid.modes(static_cast<int>(b), field, {});
    for (std::size_t i = 0; i < functions[b].size(); ++i)
      field.segment<2>(2 * functions[b][i]) =
          modes.block<2, 2>(static_cast<Eigen::Index>(2 * i), 0) * Eigen::Vector2d(acceleration.x, acceleration.y);
  }
  return momentum(field);
}

std::vector<WholeBody> CoverScene::whole(const Eigen::VectorXd& d, const Eigen::VectorXd& forces) const {
  const Functions& functions = bodies_.rigid.functions();
  const std::vector<RigidMotion> motions = bodies_.rigid.motions(d, Eigen::VectorXd::Zero(d.size()));
  std::vector<WholeBody> all;
  for (std::size_t b = 0; b < functions.size(); ++b) {
    const Eigen::VectorXd own = unknowns_of(functions[b], forces);
    WholeBody body{motions[b].mass, motions[b].rotary_inertia, at_start_[b].size, motions[b].centre};
    body.resultant = bodies_.rigid.modes(static_cast<int>(b), d, body.centre).transpose() * own;
    for (Eigen::Index i = 0; i < own.size(); i += 2) body.gross += own.segment<2>(i).norm();
    all.push_back(body);
  }
  return all;
}

double CoverScene::top_speed(const Eigen::VectorXd& v) {
  double top = 0;
  for (Eigen::Index i = 0; i + 1 < v.size(); i += 2) top = std::max(top, v.segment<2>(i).norm());
  return top;
}

double CoverScene::largest_load(const Eigen::VectorXd& forces) const {
  double largest = 0;
  for (const std::vector<int>& functions : bodies_.rigid.functions()) {
    double sum = 0;
    for (const int f : functions) sum += forces.segment<2>(2 * f).norm();
    largest = std::max(largest, sum);
  }
  return largest;
}

std::vector<std::pair<ElementIndex, double>> CoverScene::largest_forces(const Eigen::VectorXd& forces) const {
  std::vector<std::pair<ElementIndex, double>> largest;
  for (const ElementIndex e : pieces_.first_elements) largest.emplace_back(e, 0);
  for (std::size_t f = 0; f < pieces_.of_function.size(); ++f) {
    double& force = largest[static_cast<std::size_t>(pieces_.of_function[f])].second;
    force = std::max(force, forces.segment<2>(2 * static_cast<Eigen::Index>(f)).norm());
  }
  return largest;
}

CoverScene::StrainLoss CoverScene::strain_loss(const CoverYield::Way& way, const YieldStates& after) const {
  const double work = bodies_.force(way).dot(way.d1 - way.d0);
  const double lost = work - (strain_energy(way.d1, after) - strain_energy(way.d0, way.before));
  const double plastic = yield().is_empty() ? 0 : yield().plastic_work(way.d1, way.before, after);
  return {plastic, lost - plastic};
}

double CoverScene::damping_work(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const Eigen::VectorXd& rate,
                                double dt) const {
  const Eigen::VectorXd way = to - from;
  double work = 0;
  if (!bodies_.stiffness_damping.empty()) {
    std::vector<double> shares;
    for (const double b : bodies_.stiffness_damping) shares.push_back(b / dt);
    work = way.dot(bodies_.elasticity.force(from, to, 0, shares) - bodies_.elasticity.force(from, to, 0));
    if (!yield().is_empty()) work += yield().damping_work(from, to, shares);
  }
  return bodies_.has_mass_damping ? work + way.dot(bodies_.mass_damping.times(rate)) : work;
}

Eigen::VectorXd CoverScene::damping_force(const Eigen::VectorXd& v) const {
  if (!bodies_.has_mass_damping) return Eigen::VectorXd::Zero(v.size());
  return bodies_.mass_damping.times(v);
}

Eigen::VectorXd CoverScene::elastic_force(const Eigen::VectorXd& d, const YieldStates& points) const {
  return bodies_.force(d, points);
}

Stress CoverScene::stress(ElementIndex e, const Eigen::VectorXd& d, const YieldStates& points, Point start) const {
  const int element = e.value - first_.value;
  return bodies_.continuum.material(element).is_nonlinear() ? yield().stress(d, points, element, start)
                                                            : bodies_.elasticity.stress(d, element, start);
}

bool CoverScene::has_supports() const {
  return !bodies_.continuum.prescribed.empty() || !bodies_.continuum.point_springs.empty();
}

bool CoverScene::are_one_body(ElementIndex a, ElementIndex b) const {
  return kinematics_->carries(a) && kinematics_->carries(b) && body_of(a) == body_of(b);
}

double CoverScene::rotation(ElementIndex e, const Eigen::VectorXd& d, Point start) const {
  return rotation_of(bodies_.elasticity.deformation(d, e.value - first_.value, start));
}

// The velocity gradient is Ḟ F⁻¹; its skew part is the rotation rate.
MotionOfPoint motion_of_point(const CoverScene& scene, ElementIndex e, const Eigen::VectorXd& d,
                              const Eigen::VectorXd& v, const YieldStates& points, Point start) {
  const int element = scene.kinematics()->manifold_element(e);
  const ElementShape shape = scene.basis().shape(element);
  const Eigen::Matrix2Xd gradients = shape.gradients(start);
  const auto deformation_by = [&](const Eigen::VectorXd& field) -> Eigen::Matrix2d {
    Eigen::MatrixX2d own(shape.function_count(), 2);
    for (int a = 0; a < shape.function_count(); ++a)
      own.row(a) = field.segment<2>(2 * shape.functions[static_cast<std::size_t>(a)]).transpose();
    return Eigen::Matrix2d::Identity() + (gradients * own).transpose();
  };
  const Eigen::Matrix2d f = deformation_by(d);
  const Stress stress = scene.continuum().material(element).is_nonlinear()
                            ? scene.yield().stress(d, points, element, start)
                            : scene.bodies().elasticity.stress_of(f, element, start);
  const Point moved_by = moved({}, scene.kinematics()->shares(e, start), v);
  const Eigen::Matrix2d rate = deformation_by(v) - Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d gradient = rate * f.inverse();
  return {stress, rotation_of(f), {moved_by.x, moved_by.y, (gradient(1, 0) - gradient(0, 1)) / 2}};
}

}  // namespace keyblock
