// Scales, calls CHOLMOD and refines; see sparse_factor.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/cholmod/sparse_factor.hpp"

#include <dlfcn.h>
#include <pthread.h>

#include <Eigen/CholmodSupport>
#include <cmath>
#include <mutex>
#include <optional>

#include "base/loop.hpp"

namespace keyblock {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kPerturbation = 1e-11;  // on a diagonal of ones: 1 to 2 refinements, against 3 with 1e-8
constexpr int kMostRefinements = 6;
constexpr double kSmallEnough = 1e-15;
constexpr double kNotYet = 1e-12;  // refinement alone leaves less, except for nearly dependent functions at tips
constexpr int kMostIterations = 40;
// Ratio of smallest to largest pivot: round-off makes some 1e-16 of a zero pivot. A million unknowns of a plane body
// give 1e-7.
constexpr double kSingular = 1e-13;

class Factor : public Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> {
 public:
  double pivot_ratio() { return cholmod_rcond(m_cholmodFactor, &cholmod()); }
};

// CHOLMOD requests four OpenMP threads at every front, regardless of OMP_NUM_THREADS; for a one-thread program they
// take a seventh more processor time. This limits them to those of our loops for its lifetime: a caller of the library
// may have parallel regions of its own. The functions exist if CHOLMOD was built with OpenMP.
class ThreadsOfLoops {
 public:
  ThreadsOfLoops() {
    static const auto levels = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
    if (!levels || !set_levels()) return;
    before_ = levels();
    set_levels()(loop_threads() == 1 ? 0 : 1);
  }
  ThreadsOfLoops(const ThreadsOfLoops&) = delete;
  ThreadsOfLoops& operator=(const ThreadsOfLoops&) = delete;
  ~ThreadsOfLoops() {
    if (before_) set_levels()(*before_);
  }

 private:
  using Set = void (*)(int);
  static Set set_levels() {
    static const auto function = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
    return function;
  }
  std::optional<int> before_;
};

// One thread of the process at a time: two that factorised or solved at once, each with a factorisation of its own,
// changed each other's last digits. The BLAS of Debian behind CHOLMOD is a single one for programs of one thread.
// CHOLMOD itself counts and reports in data of the factorisation, also while it solves.
// A process may be copied while another of its threads factorises, as Python's multiprocessing does. The copy has no
// such thread, so the mutex is taken before and given back on both sides.
std::mutex& guard() {
  static std::mutex mutex;
  static const int registered = pthread_atfork([] { mutex.lock(); }, [] { mutex.unlock(); }, [] { mutex.unlock(); });
  static_cast<void>(registered);
  return mutex;
}

}  // namespace

struct SparseFactor::Cholmod {
  Definiteness definiteness;
  Factor factor;
  Sparse scaled;
  Eigen::VectorXd scale;  // 1/√a_ii

  void set_scaled(const Sparse& lower) {
    for (int j = 0; j < lower.cols(); ++j) {
      const double diagonal = lower.valuePtr()[lower.outerIndexPtr()[j]];
      if (!(diagonal > 0)) throw NotPositiveDefinite("the matrix has a diagonal entry that is not positive");
      scale(j) = 1 / std::sqrt(diagonal);
    }
    double* value = scaled.valuePtr();
    const double* given = lower.valuePtr();
    for (int j = 0; j < lower.cols(); ++j) {
      for (int k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k)
        value[k] = scale(lower.innerIndexPtr()[k]) * given[k] * scale(j);
    }
  }
};

SparseFactor::SparseFactor(const Sparse& lower, Definiteness definiteness) : cholmod_(std::make_unique<Cholmod>()) {
  cholmod_->definiteness = definiteness;
  cholmod_->scaled = lower;
  cholmod_->scale.resize(lower.cols());
  cholmod_->factor.cholmod().print = 0;
  if (definiteness == Definiteness::semidefinite) cholmod_->factor.setShift(kPerturbation);
  cholmod_->factor.analyzePattern(lower);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

void SparseFactor::factorise(const Sparse& lower) {
  cholmod_->set_scaled(lower);
  Factor& factor = cholmod_->factor;
  const std::scoped_lock lock(guard());
  const ThreadsOfLoops threads;
  factor.factorize(cholmod_->scaled);
  if (factor.info() != Eigen::Success)
    throw NotPositiveDefinite(
        "the matrix is not positive definite: a body is not supported, or a penalty is too small");
  if (cholmod_->definiteness == Definiteness::definite && factor.pivot_ratio() < kSingular)
    throw NotPositiveDefinite("the matrix is singular: a body is not supported");
}

Eigen::MatrixXd SparseFactor::solve(const Eigen::MatrixXd& right) const {
  const auto scaling = cholmod_->scale.asDiagonal();
  if (cholmod_->definiteness == Definiteness::definite) {
    const std::scoped_lock lock(guard());
    const Eigen::MatrixXd scaled = scaling * right;
    return scaling * cholmod_->factor.solve(scaled).eval();
  }
  Eigen::MatrixXd x(right.rows(), right.cols());
  for (Eigen::Index j = 0; j < right.cols(); ++j) x.col(j) = solve_refined(right.col(j)).x;
  return x;
}

namespace {

/// Improves y by conjugate gradients on the residual, preconditioned by the factorisation of the shifted matrix. Each
/// direction that the shift dominates, and that refinement does not find, takes one iteration (Hestenes & Stiefel
/// 1952).
int iterate(const Factor& factor, const Sparse& matrix, double aim, Eigen::VectorXd& y, Eigen::VectorXd& residual) {
  Eigen::VectorXd best = y, least = residual;
  Eigen::VectorXd z = factor.solve(residual), direction = z;
  double product = residual.dot(z);
  int made = 0;
  while (made < kMostIterations && least.norm() > aim && product > 0) {
    const Eigen::VectorXd image = matrix.selfadjointView<Eigen::Lower>() * direction;
    const double bend = direction.dot(image);
    if (!(bend > 0)) break;
    y += product / bend * direction;
    residual -= product / bend * image;
    ++made;
    if (residual.norm() < least.norm()) {
      best = y;
      least = residual;
    }
    z = factor.solve(residual);
    const double next = residual.dot(z);
    direction = z + next / product * direction;
    product = next;
  }
  y = std::move(best);
  residual = std::move(least);
  return made;
}

}  // namespace

SparseFactor::Refined SparseFactor::solve_refined(const Eigen::VectorXd& right) const {
  const std::scoped_lock lock(guard());
  const auto scaling = cholmod_->scale.asDiagonal();
  const Eigen::VectorXd load = scaling * right;
  const auto residual_of = [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return load - cholmod_->scaled.selfadjointView<Eigen::Lower>() * y;
  };
  Refined refined{cholmod_->factor.solve(load), 0};
  Eigen::VectorXd residual = residual_of(refined.x);
  const double size = load.norm() > 0 ? load.norm() : 1;
  while (refined.refinements < kMostRefinements && residual.norm() > kSmallEnough * size) {
    const Eigen::VectorXd better = refined.x + cholmod_->factor.solve(residual);
    const Eigen::VectorXd left = residual_of(better);
    if (!(left.norm() < 0.5 * residual.norm())) break;
    refined.x = better;
    residual = left;
    ++refined.refinements;
  }
  if (cholmod_->definiteness == Definiteness::semidefinite && residual.norm() > kNotYet * size)
    refined.refinements += iterate(cholmod_->factor, cholmod_->scaled, kSmallEnough * size, refined.x, residual);
  refined.x = (scaling * refined.x).eval();
  return refined;
}

double SparseFactor::entries() const {
  return cholmod_->factor.cholmod().lnz;
}

}  // namespace keyblock
