// Draws lengths from the distributions of GSL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/joints/random_value.hpp"

#include <gsl/gsl_randist.h>

#include <cmath>

namespace keyblock {
namespace {

/// Maps neighbouring numbers far apart: the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t spread(std::uint64_t number) {
  std::uint64_t z = number + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

double positive_normal(double mean, double deviation, const gsl_rng* generator) {
  for (;;) {
    const double value = mean + gsl_ran_gaussian(generator, deviation);
    if (value > 0) return value;
  }
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : generator_(gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free) {
  gsl_rng_set(generator_.get(), spread(spread(seed) + stream) >> 32);  // it takes 32 bits
}

double draw(const RandomLength& length, const RandomStream& stream) {
  if (length.mean == 0) return 0;
  if (length.distribution == Distribution::exponential) return gsl_ran_exponential(stream.get(), length.mean);
  if (length.scatter == 0) return length.mean;
  if (length.distribution == Distribution::normal)
    return positive_normal(length.mean, length.scatter * length.mean, stream.get());
  // A lognormal variable of mean m and coefficient of variation c: sigma² = ln(1 + c²), zeta = ln m - sigma² / 2.
  const double variance = std::log1p(length.scatter * length.scatter);
  return gsl_ran_lognormal(stream.get(), std::log(length.mean) - variance / 2, std::sqrt(variance));
}

}  // namespace keyblock
