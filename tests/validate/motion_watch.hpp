// Watches falling heaps for impossible motion: kinetic energy beyond the work of weight, a rise, a change of area, or
// blocks passing through their support.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/model.hpp"
#include "result/frame.hpp"
#include "settings/settings.hpp"

namespace keyblock {

/// Follows the frames of a run under gravity from rest, without access to the solver. Masses come from the areas of the
/// first frame, kinetic energy from centroid velocities and rotation rates. Strain rates are left out: their part is
/// positive.
class MotionWatch {
 public:
  MotionWatch(const Model& model, const Settings& settings) : model_(model), settings_(settings) {}

  void see(const Frame& frame);

  /// Largest kinetic energy minus released potential energy, over `energy_scale()`; at most round-off in sound runs.
  double greatest_excess() const { return excess_; }
  /// Largest sum of kinetic, strain and potential energy over its initial value, over `energy_scale()`.
  double greatest_gain() const { return gain_; }
  /// Largest height of the common centre of mass over its first one, over the height of the scene.
  double greatest_rise() const { return rise_; }
  /// Largest relative change of the area of a block.
  double greatest_area_change() const { return area_change_; }
  /// The same, less the change of area by stress: nonzero only for false strain. A small block that carries its
  /// neighbours is strained by more than the weight of the whole slope would strain it.
  double greatest_false_area_change() const { return false_area_change_; }
  /// Largest kinetic over released potential energy, if more than 1e-9 of the energy scale is released.
  double greatest_ratio() const { return ratio_; }
  /// Largest area that blocks share, all pairs together, over the area of the moving blocks. Free fall through the
  /// ground passes every other check.
  double greatest_overlap() const { return overlap_; }
  bool all_finite() const { return all_finite_; }

 private:
  struct Mass {
    double mass = 0;
    double inertia = 0;
    Point start;
    double area = 0;
    double strained_area = 0;  ///< area under its stress over the area without stress
  };

  void begin(const Frame& frame);
  double strained_area(const ElementFrame& element) const;
  double energy_scale() const { return total_mass_ * length(settings_.gravity) * height_; }

  const Model& model_;
  const Settings& settings_;
  std::vector<Mass> masses_;
  double total_mass_ = 0;
  double height_ = 0;  ///< of the moving blocks
  double excess_ = 0;
  double gain_ = 0;
  double start_energy_ = 0;  ///< kinetic and strain
  double rise_ = 0;
  double area_change_ = 0;
  double false_area_change_ = 0;
  double ratio_ = 0;
  double overlap_ = 0;
  bool all_finite_ = true;
};

}  // namespace keyblock
