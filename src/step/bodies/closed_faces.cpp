// Finds edges that two elements share in opposite directions and solves the contact problem on them; see
// closed_faces.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/closed_faces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "contact/rows/point_motion.hpp"
#include "contact/solve/frictional_problem.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/segment.hpp"

namespace keyblock {
namespace {

// Number of contact points per piece. Pressures at the corners oscillate, because corners outnumber the freedoms of the
// opening (Ji & Dolbow 2004). Springs at points inside the pieces may be stiff.
constexpr int kPointsOfPiece = 3;
// Stiffness of faces per area, in E/h with h the side of the triangles. Measured in fra-19 (pressure 0.5, friction 0 to
// 0.6): faces overlap by 6e-5 to 2e-4 of their slip; pressures are 0 to 1.4. With 200 E/h the overlap is 3e-4 to 1e-3,
// the pressure 0.3 to 0.8. With 1e4 E/h they are 6e-6 to 2e-5 and 0 to 7, and a third of the points carry none. K is
// the same to 1e-5 of s √(π c).
constexpr double kStiffness = 1e3;
// Residuals relative to the largest force that would close one gap alone: round-off of the solution, and the largest
// accepted.
constexpr double kGoal = 1e-11;
constexpr double kAcceptable = 1e-8;

/// Side of an element on the boundary.
struct Face {
  int element = 0;
  int corner = 0;  ///< at its end, counted through the loops of the element
  int joint_material = 0;
  Segment edge;
};

void add_faces(std::span<const ElementCorner> loop, int element, int first, std::vector<Face>& faces) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i].neighbour >= 0) continue;
    const std::size_t next = (i + 1) % loop.size();
    faces.push_back({element,
                     first + static_cast<int>(next),
                     std::max(0, loop[i].joint_material),
                     {loop[i].position, loop[next].position}});
  }
}

std::vector<Face> faces_of(const Manifold& manifold) {
  std::vector<Face> faces;
  for (std::size_t e = 0; e < manifold.elements.size(); ++e) {
    const ManifoldElement& element = manifold.elements[e];
    add_faces(manifold.loop(element.outer), static_cast<int>(e), 0, faces);
    int first = element.outer.size;
    for (const SlotRange& hole : manifold.holes_of(element)) {
      add_faces(manifold.loop(hole), static_cast<int>(e), first, faces);
      first += hole.size;
    }
  }
  return faces;
}

/// Key of a face by its ends: both sides of a joint repeat the positions bit for bit.
using Ends = std::array<double, 4>;
Ends ends_of(Point start, Point end) {
  return {start.x, start.y, end.x, end.y};
}

PointMotion motion_of(const CoverBasis& basis, int element, Point at) {
  const ElementShape shape = basis.shape(element);
  const Eigen::RowVectorXd n = shape.values(at);
  PointMotion motion{DisplacementOperator(2, 0)};
  for (int a = 0; a < shape.function_count(); ++a)
    motion.of_shared.push_back({shape.functions[static_cast<std::size_t>(a)], n(a)});
  return motion;
}

Eigen::VectorXd motion_along(const ContactRows& rows, const Eigen::VectorXd& d) {
  Eigen::VectorXd motion(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) motion[static_cast<Eigen::Index>(i)] = rows[i].of_shared(d);
  return motion;
}

/// Applies the inverse of a stiffness through its factorisation.
class FactorAnswer : public SharedFlexibility {
 public:
  FactorAnswer(std::shared_ptr<const SparseFactor> factor, Eigen::Index size)
      : factor_(std::move(factor)), size_(size) {}
  Eigen::Index size() const override { return size_; }
  Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const override { return factor_->solve(forces); }

 private:
  std::shared_ptr<const SparseFactor> factor_;
  Eigen::Index size_;
};

}  // namespace

std::vector<FacePoint> face_points(const Continuum& continuum, const CoverBasis& basis) {
  const Manifold& manifold = continuum.manifold;
  std::map<Ends, Face> waiting;
  std::vector<FacePoint> points;
  for (const Face& face : faces_of(manifold)) {
    const auto found = waiting.find(ends_of(face.edge.end, face.edge.start));
    if (found == waiting.end()) {
      waiting.emplace(ends_of(face.edge.start, face.edge.end), face);
      continue;
    }
    const Face other = found->second;
    waiting.erase(found);
    if (face.element == other.element) continue;  // around the end of a crack that has no functions
    const double per_length =
        kStiffness * continuum.material(face.element).youngs_modulus / basis.shape(face.element).frame.size;
    const double size = distance(face.edge.start, face.edge.end);
    const Point normal = ElementSide{other.element, other.edge}.normal();
    for (const GaussPoint& g : gauss_rule(kPointsOfPiece))
      points.push_back({face.element, other.element, other.corner, point_at(face.edge, g.at), normal,
                        other.joint_material, per_length * size * g.weight});
  }
  return points;
}

ContactRows face_rows(const CoverBasis& basis, const std::vector<FacePoint>& points) {
  // All unknowns are shared: the one element that the rows name has none of its own.
  const ElementIndex all{0};
  ContactRows rows;
  for (const FacePoint& point : points) {
    const PointMotion own = motion_of(basis, point.element, point.at);
    const PointMotion other = motion_of(basis, point.other, point.at);
    rows.push_back(row_between(all, own, all, other, point.normal));
    rows.push_back(row_between(all, own, all, other, point.tangent()));
  }
  return rows;
}

FaceForces face_forces(const std::vector<FacePoint>& points, const ContactRows& rows,
                       const std::vector<JointMaterial>& joints, std::shared_ptr<const SparseFactor> stiffness,
                       const Eigen::VectorXd& d) {
  FaceForces found{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()))};
  if (points.empty()) return found;
  Flexibility flexibility;
  flexibility.blocks.push_back({});
  flexibility.shared = std::make_shared<FactorAnswer>(std::move(stiffness), d.size());
  FrictionalProblem problem;
  problem.w = ContactMatrix(rows, flexibility);
  problem.b = motion_along(rows, d);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Eigen::Index k : {0, 1})
      problem.w.add_to_diagonal(static_cast<Eigen::Index>(2 * i) + k, 1 / points[i].stiffness);
    problem.laws.push_back({joints[static_cast<std::size_t>(points[i].joint_material)].friction_tangent()});
  }
  const double largest = problem.b.cwiseQuotient(problem.w.diagonal()).cwiseAbs().maxCoeff();
  problem.goal = kGoal * largest;
  problem.acceptable = kAcceptable * largest;
  FrictionalSolution solution = solve(problem, found.forces);
  return {std::move(solution.forces), solution.converged};
}

std::vector<FaceContact> face_contacts(const std::vector<FacePoint>& points, const ContactRows& rows,
                                       const Eigen::VectorXd& forces, const Eigen::VectorXd& d) {
  const Eigen::VectorXd motion = motion_along(rows, d);
  std::vector<FaceContact> contacts;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(2 * i);
    contacts.push_back({points[i], motion[n], motion[n + 1], forces[n], forces[n + 1]});
  }
  return contacts;
}

}  // namespace keyblock
