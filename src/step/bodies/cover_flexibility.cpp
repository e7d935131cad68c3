// Gathers and scatters columns by the functions of each body; see cover_flexibility.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/bodies/cover_flexibility.hpp"

#include <algorithm>
#include <vector>

#include "step/bodies/linear_static.hpp"

namespace keyblock {
namespace {

using FunctionsOfBodies = std::vector<std::vector<int>>;

// Solves for the rows of each body, in the columns with nonzero entries there.
template <class Solve>
Eigen::MatrixXd by_body(const FunctionsOfBodies& functions, const Eigen::MatrixXd& forces, Solve solve) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
  for (std::size_t body = 0; body < functions.size(); ++body) {
    const std::vector<int>& own = functions[body];
    std::vector<Eigen::Index> columns;
    for (Eigen::Index c = 0; c < forces.cols(); ++c)
      if (std::ranges::any_of(own, [&](int f) { return forces(2 * f, c) != 0 || forces(2 * f + 1, c) != 0; }))
        columns.push_back(c);
    if (columns.empty()) continue;
    Eigen::MatrixXd part(static_cast<Eigen::Index>(2 * own.size()), static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index c = 0; c < part.cols(); ++c)
      for (Eigen::Index i = 0; i < part.rows() / 2; ++i)
        part.col(c).segment<2>(2 * i) =
            forces.col(columns[static_cast<std::size_t>(c)]).segment<2>(2 * own[static_cast<std::size_t>(i)]);
    const Eigen::MatrixXd answer = solve(static_cast<int>(body), part);
    for (Eigen::Index c = 0; c < part.cols(); ++c)
      for (Eigen::Index i = 0; i < part.rows() / 2; ++i)
        result.col(columns[static_cast<std::size_t>(c)]).segment<2>(2 * own[static_cast<std::size_t>(i)]) =
            answer.col(c).segment<2>(2 * i);
  }
  return result;
}

class StepAnswer : public SharedFlexibility {
 public:
  StepAnswer(const CoverEquations& equations, const FunctionsOfBodies& functions)
      : equations_(equations), functions_(functions) {}
  Eigen::Index size() const override { return equations_.residual().size(); }
  bool is_symmetric() const override { return equations_.is_symmetric(); }
  Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const override {
    return by_body(functions_, forces,
                   [&](int body, const Eigen::MatrixXd& part) { return equations_.solve(body, part); });
  }

 private:
  const CoverEquations& equations_;
  const FunctionsOfBodies& functions_;
};

/// Returns the mass of one body in one direction: x and y have equal masses and no coupling.
Eigen::SparseMatrix<double> mass_in_x(const SparseSystem& mass, const std::vector<int>& functions) {
  const Eigen::SparseMatrix<double>& all = mass.lower();
  std::vector<int> place(static_cast<std::size_t>(all.cols() / 2));
  for (std::size_t i = 0; i < functions.size(); ++i)
    place[static_cast<std::size_t>(functions[i])] = static_cast<int>(i);
  const auto size = static_cast<Eigen::Index>(functions.size());
  Eigen::SparseMatrix<double> own(size, size);
  Eigen::Index count = 0;
  for (const int f : functions) count += (all.outerIndexPtr()[2 * f + 1] - all.outerIndexPtr()[2 * f]) / 2;
  own.resizeNonZeros(count);
  int* outer = own.outerIndexPtr();
  int at = *outer = 0;
  for (const int f : functions) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(all, 2 * f); entry; ++entry) {
      if (entry.row() % 2 != 0) continue;
      own.innerIndexPtr()[at] = place[static_cast<std::size_t>(entry.row() / 2)];
      own.valuePtr()[at++] = entry.value();
    }
    *++outer = at;
  }
  return own;
}

std::vector<SparseFactor> mass_factors(const ElasticBodies& bodies) {
  const auto factors = [&](Definiteness definiteness) {
    std::vector<SparseFactor> made;
    for (const std::vector<int>& functions : bodies.rigid.functions()) {
      const Eigen::SparseMatrix<double> own = mass_in_x(bodies.mass, functions);
      made.emplace_back(own, definiteness).factorise(own);
    }
    return made;
  };
  try {
    return factors(definiteness_of(bodies.continuum.functions));
  } catch (const NotPositiveDefinite&) {  // covers that lie only on thin pieces have nearly equal functions
    return factors(Definiteness::semidefinite);
  }
}

class MassAnswer : public SharedFlexibility {
 public:
  explicit MassAnswer(const ElasticBodies& bodies)
      : functions_(bodies.rigid.functions()), factors_(mass_factors(bodies)), size_(bodies.unknown_count()) {}
  Eigen::Index size() const override { return size_; }
  Eigen::MatrixXd times(const Eigen::MatrixXd& forces) const override {
    return by_body(functions_, forces, [&](int body, const Eigen::MatrixXd& part) { return solved(body, part); });
  }

 private:
  // A column of alternating x and y, read as two rows, gives two right-hand sides of the one-direction mass.
  Eigen::MatrixXd solved(int body, const Eigen::MatrixXd& part) const {
    const Eigen::Index size = part.rows() / 2;
    Eigen::MatrixXd right(size, 2 * part.cols());
    for (Eigen::Index c = 0; c < part.cols(); ++c)
      right.middleCols(2 * c, 2) = part.col(c).reshaped(2, size).transpose();
    const Eigen::MatrixXd left = factors_[static_cast<std::size_t>(body)].solve(right);
    Eigen::MatrixXd answer(part.rows(), part.cols());
    for (Eigen::Index c = 0; c < part.cols(); ++c)
      answer.col(c).reshaped(2, size) = left.middleCols(2 * c, 2).transpose();
    return answer;
  }

  const FunctionsOfBodies& functions_;
  std::vector<SparseFactor> factors_;
  Eigen::Index size_;
};

}  // namespace

std::shared_ptr<const SharedFlexibility> mass_flexibility_of(const ElasticBodies& bodies) {
  return std::make_shared<MassAnswer>(bodies);
}

std::shared_ptr<const SharedFlexibility> flexibility_of(const CoverEquations& equations) {
  return std::make_shared<StepAnswer>(equations, equations.bodies().rigid.functions());
}

}  // namespace keyblock
