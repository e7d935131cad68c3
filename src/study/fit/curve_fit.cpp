// Searches breaks on a grid, then fits all unknowns at once; see curve_fit.hpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/fit/curve_fit.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.hpp"

namespace keyblock::study {
namespace {

constexpr std::size_t kFewestCurvePoints = 8;
// Least number of points on either side of a break.
constexpr std::size_t kFewestOfPart = 2;
// Greatest number of breaks of each kind tried; curves with more points skip some.
constexpr std::size_t kMostBreaksTried = 60;
constexpr int kMostFitRounds = 200;
// Residual, relative to the greatest stress, that counts as zero in the comparison of kinds of curves.
constexpr double kExactFit = 1e-9;
constexpr double kSettledFit = 1e-12;

struct CurveKind {
  bool has_closure = false;
  bool has_plateau = false;

  /// Returns the number of unknowns: E2, E1 and ε_c of a closure, strength of a plateau.
  int count() const { return 1 + (has_closure ? 2 : 0) + (has_plateau ? 1 : 0); }
};

/// Unknowns over their scales, so that all are near 1.
struct CurveUnknown {
  CurveKind kind;
  double modulus = 1, strain = 1, stress = 1;  // scales

  BilinearCurve curve(const gsl_vector* x) const {
    BilinearCurve c;
    std::size_t at = 0;
    c.initial_modulus = c.youngs_modulus = modulus * gsl_vector_get(x, at++);
    c.strength = std::numeric_limits<double>::infinity();
    if (kind.has_closure) c.initial_modulus = modulus * gsl_vector_get(x, at++);
    if (kind.has_closure) c.closure_strain = strain * gsl_vector_get(x, at++);
    if (kind.has_plateau) c.strength = stress * gsl_vector_get(x, at++);
    return c;
  }
  Eigen::VectorXd vector(const BilinearCurve& c) const {
    Eigen::VectorXd x(kind.count());
    Eigen::Index at = 0;
    x(at++) = c.youngs_modulus / modulus;
    if (kind.has_closure) x(at++) = c.initial_modulus / modulus;
    if (kind.has_closure) x(at++) = c.closure_strain / strain;
    if (kind.has_plateau) x(at++) = c.strength / stress;
    return x;
  }
};

/// Turns off the error handler of GSL, which would end the program.
class QuietGsl {
 public:
  QuietGsl() : before_(gsl_set_error_handler_off()) {}
  ~QuietGsl() { gsl_set_error_handler(before_); }
  QuietGsl(const QuietGsl&) = delete;
  QuietGsl& operator=(const QuietGsl&) = delete;

 private:
  gsl_error_handler_t* before_;
};

struct CurveData {
  const std::vector<double>& strain;
  const std::vector<double>& stress;
  CurveUnknown unknown;
};

int curve_residuals(const gsl_vector* x, void* data, gsl_vector* f) {
  const auto& p = *static_cast<const CurveData*>(data);
  const BilinearCurve curve = p.unknown.curve(x);
  for (std::size_t i = 0; i < p.strain.size(); ++i)
    gsl_vector_set(f, i, (curve.stress(p.strain[i]) - p.stress[i]) / p.unknown.stress);
  return GSL_SUCCESS;
}

int curve_slopes(const gsl_vector* x, void* data, gsl_matrix* j) {
  const auto& p = *static_cast<const CurveData*>(data);
  const CurveUnknown& u = p.unknown;
  const BilinearCurve c = u.curve(x);
  for (std::size_t i = 0; i < p.strain.size(); ++i) {
    const double strain = p.strain[i];
    const bool yields = u.kind.has_plateau && c.stress(strain) >= c.strength;
    const bool is_open = strain < c.closure_strain;
    std::size_t at = 0;
    const double by_modulus = u.modulus / u.stress;
    const double by_intact = is_open ? 0 : strain - c.closure_strain;
    gsl_matrix_set(j, i, at++, yields ? 0 : by_modulus * by_intact);
    if (u.kind.has_closure) {
      gsl_matrix_set(j, i, at++, yields ? 0 : by_modulus * std::min(strain, c.closure_strain));
      const double by_strain = is_open ? 0 : c.initial_modulus - c.youngs_modulus;
      gsl_matrix_set(j, i, at++, yields ? 0 : by_strain * u.strain / u.stress);
    }
    if (u.kind.has_plateau) gsl_matrix_set(j, i, at++, yields ? 1 : 0);
  }
  return GSL_SUCCESS;
}

double squares(const MeasuredPairs& m, const BilinearCurve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    const double r = m.y[i] - curve.stress(m.x[i]);
    sum += r * r;
  }
  return sum;
}

/// Returns the least-squares moduli between breaks at `closed` and `yielded`.
BilinearCurve with_breaks(const MeasuredPairs& m, CurveKind kind, double closed, double yielded) {
  const auto rows = static_cast<Eigen::Index>(m.x.size());
  Eigen::MatrixXd a(rows, kind.has_closure ? 2 : 1);
  Eigen::VectorXd b(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double strain = std::min(m.x[static_cast<std::size_t>(i)], yielded);
    a(i, 0) = std::max(strain - closed, 0.0);
    if (kind.has_closure) a(i, 1) = std::min(strain, closed);
    b(i) = m.y[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
  BilinearCurve c{kind.has_closure ? x(1) : x(0), x(0), closed, std::numeric_limits<double>::infinity()};
  if (kind.has_plateau) c.strength = c.initial_modulus * closed + c.youngs_modulus * (yielded - closed);
  return c;
}

struct FittedCurve {
  CurveKind kind;
  BilinearCurve curve;
  double squares = std::numeric_limits<double>::infinity();
  Eigen::VectorXd errors;  // of the unknowns
};

bool is_usable(const BilinearCurve& c, CurveKind kind, const MeasuredPairs& m) {
  if (!(c.initial_modulus > 0 && c.youngs_modulus > 0)) return false;
  if (kind.has_closure && !(c.closure_strain > m.x[kFewestOfPart - 1] && c.closure_strain < m.x.back() &&
                            c.initial_modulus < c.youngs_modulus))
    return false;
  if (!kind.has_plateau) return true;
  const auto on_plateau = std::ranges::count_if(m.x, [&](double strain) { return c.stress(strain) >= c.strength; });
  return on_plateau >= static_cast<std::ptrdiff_t>(kFewestOfPart) && c.strength > c.initial_modulus * c.closure_strain;
}

std::optional<BilinearCurve> start_of(const MeasuredPairs& m, CurveKind kind) {
  const std::size_t count = m.x.size(), stride = std::max<std::size_t>(1, count / kMostBreaksTried);
  std::vector<double> breaks;
  for (std::size_t i = kFewestOfPart - 1; i + kFewestOfPart < count; i += stride)
    breaks.push_back((m.x[i] + m.x[i + 1]) / 2);
  const std::vector<double> none{0}, never{std::numeric_limits<double>::infinity()};
  std::optional<BilinearCurve> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double closed : kind.has_closure ? breaks : none)
    for (const double yielded : kind.has_plateau ? breaks : never) {
      if (yielded <= closed) continue;
      const BilinearCurve curve = with_breaks(m, kind, closed, yielded);
      if (!is_usable(curve, kind, m)) continue;
      const double sum = squares(m, curve);
      if (sum < least) {
        least = sum;
        best = curve;
      }
    }
  return best;
}

std::optional<FittedCurve> fitted(const MeasuredPairs& m, CurveKind kind) {
  const std::optional<BilinearCurve> start = start_of(m, kind);
  if (!start) return std::nullopt;
  const double top = *std::ranges::max_element(m.y);
  CurveData problem{m.x, m.y, {kind, start->youngs_modulus, m.x.back(), top}};
  const auto count = static_cast<std::size_t>(kind.count());
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, m.x.size(), count),
      gsl_multifit_nlinear_free);
  gsl_multifit_nlinear_fdf functions{};
  functions.f = curve_residuals;
  functions.df = curve_slopes;
  functions.n = m.x.size();
  functions.p = count;
  functions.params = &problem;
  Eigen::VectorXd x = problem.unknown.vector(*start);
  const gsl_vector_view first = gsl_vector_view_array(x.data(), count);
  const QuietGsl quiet;
  gsl_multifit_nlinear_init(&first.vector, &functions, work.get());
  int why = 0;
  gsl_multifit_nlinear_driver(kMostFitRounds, kSettledFit, kSettledFit, kSettledFit, nullptr, nullptr, &why,
                              work.get());
  BilinearCurve end = problem.unknown.curve(gsl_multifit_nlinear_position(work.get()));
  // Breaks may mislead the iteration; the start is then the better curve, and errors are those there.
  if (!is_usable(end, kind, m) || squares(m, end) > squares(m, *start)) {
    end = *start;
    gsl_multifit_nlinear_init(&first.vector, &functions, work.get());
  }
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> covariance(count, count);
  gsl_matrix_view view = gsl_matrix_view_array(covariance.data(), count, count);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, &view.matrix);
  FittedCurve f{kind, end, squares(m, end), {}};
  const double variance = f.squares / static_cast<double>(m.x.size() - count);
  f.errors = (covariance.diagonal().array() * variance).sqrt().matrix() / top;
  Eigen::Index at = 0;
  f.errors(at++) *= problem.unknown.modulus;
  if (kind.has_closure) f.errors(at++) *= problem.unknown.modulus;
  if (kind.has_closure) f.errors(at++) *= problem.unknown.strain;
  if (kind.has_plateau) f.errors(at++) *= top;
  return f;
}

/// Returns Schwarz's criterion of least squares, n ln(Σ r²/n) + k ln n. The place of a break counts three times: the
/// best of many places reduces Σ r² by more than one unknown does (Ninomiya 2015).
double criterion(const FittedCurve& f, const MeasuredPairs& m) {
  const auto n = static_cast<double>(m.x.size());
  const double k = f.kind.count() + (f.kind.has_closure ? 2 : 0);
  const double exact = kExactFit * *std::ranges::max_element(m.y);
  return n * std::log(std::max(f.squares / n, exact * exact)) + k * std::log(n);
}

bool turn(MeasuredPairs& m, CompressionSign sign) {
  double strain = 0, stress = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    if (std::abs(m.x[i]) > std::abs(strain)) strain = m.x[i];
    if (std::abs(m.y[i]) > std::abs(stress)) stress = m.y[i];
  }
  if (strain * stress < 0)
    throw InputError({m.file, 0, 0}, "expected strain and stress of one sign, found opposite ones");
  const bool is_turned = sign == CompressionSign::negative || (sign == CompressionSign::found && strain < 0);
  if (is_turned)
    for (std::vector<double>* values : {&m.x, &m.y})
      for (double& value : *values) value = -value;
  if ((is_turned ? -strain : strain) < 0)
    throw InputError({m.file, 0, 0}, "expected compression with the sign given, found the other");
  return is_turned;
}

void require_loading(const MeasuredPairs& m) {
  if (m.x.size() < kFewestCurvePoints)
    throw InputError({m.file, 0, 0},
                     fmt::format("expected at least {} points, found {}", kFewestCurvePoints, m.x.size()));
  for (std::size_t i = 1; i < m.x.size(); ++i)
    if (!(m.x[i] > m.x[i - 1]))
      throw InputError({m.file, m.lines[i], 1},
                       fmt::format("expected compression that increases from row to row (one loading, without "
                                   "unloading), found {} after {}",
                                   m.x[i], m.x[i - 1]));
}

}  // namespace

double BilinearCurve::stress(double strain) const {
  const double open = std::min(strain, closure_strain), closed = std::max(strain - closure_strain, 0.0);
  return std::min(initial_modulus * open + youngs_modulus * closed, strength);
}

CurveFit fit_curve(MeasuredPairs m, CompressionSign sign) {
  CurveFit fit;
  fit.is_turned = turn(m, sign);
  require_loading(m);
  if (std::ranges::count(m.y, m.y.front()) == static_cast<std::ptrdiff_t>(m.y.size()))
    throw InputError({m.file, m.lines.front(), 1},
                     fmt::format("expected stress that rises with strain, found {} in all rows", m.y.front()));
  std::optional<FittedCurve> best;
  for (const CurveKind kind :
       {CurveKind{false, false}, CurveKind{false, true}, CurveKind{true, false}, CurveKind{true, true}}) {
    const std::optional<FittedCurve> other = fitted(m, kind);
    if (other && (!best || criterion(*other, m) < criterion(*best, m))) best = other;
  }
  if (!best) throw InputError({m.file, 0, 0}, "expected stress that rises with strain, found none that does");
  const int freedom = static_cast<int>(m.x.size()) - best->kind.count();
  Eigen::Index at = 0;
  fit.youngs_modulus = found(best->curve.youngs_modulus, best->errors(at++), freedom);
  if (best->kind.has_closure) {
    fit.initial_modulus = found(best->curve.initial_modulus, best->errors(at++), freedom);
    fit.closure_strain = found(best->curve.closure_strain, best->errors(at++), freedom);
  }
  if (best->kind.has_plateau) fit.strength = found(best->curve.strength, best->errors(at++), freedom);
  std::vector<double> curve;
  for (const double strain : m.x) curve.push_back(best->curve.stress(strain));
  fit.agreement = agreement(m.y, std::move(curve));
  return fit;
}

}  // namespace keyblock::study
