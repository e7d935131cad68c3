// Declares the common interface of DDA blocks and NMM bodies. Time stepping, energy balance and equilibrium search use
// it without knowing which unknowns a body has.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/rows/contact_row.hpp"
#include "material/yield_law.hpp"
#include "model/state.hpp"
#include "result/ledger.hpp"
#include "result/plastic_state.hpp"
#include "settings/standard_choices.hpp"
#include "step/bodies/integrator.hpp"
#include "step/bodies/whole_body.hpp"

namespace keyblock {

/// Memories of the points of elastoplastic rock; empty without such rock.
struct PointMemories {
  std::vector<YieldState> blocks;  ///< one per element
  std::vector<YieldState> covers;  ///< in the order of CoverYield
};

/// Unknowns, velocities, accelerations and point memories of all bodies of a scene.
struct BodiesMotion {
  UnknownsTable q;
  UnknownsTable v;
  UnknownsTable a;
  PointMemories points = {};
};

/// Largest force on a body, and largest acceleration it gives a free one.
struct Scales {
  double force = 0;
  double acceleration = 0;
  double momentum = 0;
  double size = 0;  ///< of the largest moving body
};

/// Range of masses, and slowest natural frequency of a body.
struct MassRange {
  double lightest = std::numeric_limits<double>::max();
  double heaviest = 0;
  double slowest = std::numeric_limits<double>::max();  ///< ω, 1 / time
  bool all_strain = true;
};

/// Parts of a scene besides the matrices of its bodies.
struct SceneParts {
  const Model& model;
  const Reference& reference;
  const Settings& settings;
};

/// Integration point of a body with its share `area`, at the start and now.
struct FieldPoint {
  Point start;
  double area = 0;
  Point place;
  Point velocity;
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Identity();  ///< of the place by the start
};

class BodyGroups;

/// Mark per element. Bodies are chosen as wholes.
using ChosenElements = std::vector<bool>;

/// Bodies of an earlier scene. `parents`: per later element, the earlier one that it is or was cut from.
struct BodiesBefore {
  SceneParts scene;
  const BodyGroups& groups;
  const BodiesMotion& motion;
  const Table<ElementIndex, ElementIndex>& parents;
};

/// Accepted step from the view of its bodies.
struct BodiesStep {
  const BodiesMotion& start;
  const UnknownsTable& q;       ///< at the end of the smooth motion
  const UnknownsTable& v;       ///< of the smooth motion
  const UnknownsTable& a;       ///< of the smooth motion
  const UnknownsTable& end;     ///< unknowns after removal of overlaps
  const PointMemories& points;  ///< at the end
  const UnknownsTable& loads;   ///< weight included
  const StepRule& rule;
  double dt = 0;
};

/// Step without contact: Δq = increments + A⁻¹ Gᵀ λ, v = known + rule.end_velocity Δq, and the same form for a.
struct FreeStep {
  Flexibility flexibility;
  Flexibility judging;  ///< A⁻¹ with the inertia by which forces are judged; empty if that is the same
  UnknownsTable increments;
  UnknownsTable known_velocity;
  UnknownsTable known_acceleration;
};

/// Step of bodies, linearised about an estimate of the increments.
class EstimatedStep {
 public:
  virtual ~EstimatedStep() = default;
  /// Writes A⁻¹ about an estimate into `step`. Returns false if the factorisation fails.
  virtual bool linearise(const UnknownsTable& estimate, FreeStep& step) = 0;
  /// Writes the increments about an estimate into `step`, with the previous A⁻¹.
  virtual void evaluate(const UnknownsTable& estimate, FreeStep& step) = 0;
  /// Writes velocities, accelerations and point memories for increments that solve the equations.
  virtual void put_end(const UnknownsTable& increments, UnknownsTable& v, UnknownsTable& a,
                       PointMemories& points) const = 0;
};

/// All bodies of a scene with one kind of unknowns. A group reads and writes its own part of a table of unknowns, where
/// elements of other groups have no entries. Functions named add_… expect initialised sums.
class BodyGroup {
 public:
  virtual ~BodyGroup() = default;

  // Properties of the bodies.

  virtual bool has(ElementIndex e) const = 0;
  virtual double size() const = 0;                   ///< of the largest movable body
  virtual double mass_of(ElementIndex e) const = 0;  ///< of the body that holds the element
  virtual bool are_one_body(ElementIndex a, ElementIndex b) const = 0;
  /// Returns true if bodies have supports or fixed parts besides fixed points and contact.
  virtual bool has_supports() const = 0;
  /// Returns true if the body of an element with unknowns has supports besides fixed points.
  virtual bool is_supported(ElementIndex e) const = 0;
  /// Returns true if the equations of a step are linear in the increments.
  virtual bool is_linear() const = 0;
  /// Returns true if some rock is elastoplastic: the equations of a step then have kinks.
  virtual bool may_yield() const = 0;
  /// Returns true if a step resolves an impact: the inertia near the contact takes part and elasticity governs the
  /// rebound. Otherwise bodies jump apart as wholes, by a coefficient of restitution.
  virtual bool resolves_impacts() const = 0;
  /// Returns true if elements may have holes.
  virtual bool takes_holes() const = 0;
  /// Returns true if the first forces and strains can balance with accelerations. Sliding and falling bodies then also
  /// start in balance. Other bodies start suddenly loaded or in static equilibrium.
  virtual bool has_compatible_start() const = 0;
  /// Returns the stress law of large strain; empty if strain stays small.
  virtual std::optional<ElasticLaw> law_of_large_strain(const SceneParts& scene, ElementIndex e) const = 0;
  /// Returns the displacement functions that the bodies share; null if each has unknowns of its own.
  virtual const CoverBasis* shared_basis() const { return nullptr; }
  /// Returns true if two fixed points must support a body.
  virtual bool needs_fixed_points() const = 0;
  /// Adds the masses and frequencies of the bodies. `contact_stiffness`: of springs that may hold bodies; 0 without
  /// springs.
  virtual void add_to(MassRange& range, double contact_stiffness) const = 0;

  // Start and loads.

  virtual void put_start(const SceneParts& scene, BodiesMotion& motion) const = 0;
  /// Multiplies v by the fraction of velocity that each material keeps from step to step.
  virtual void carry_over(const SceneParts& scene, UnknownsTable& v) const = 0;
  /// Writes the weight; on NMM bodies also support loads, and their tractions at q.
  virtual void put_own_loads(const UnknownsTable& q, double time, UnknownsTable& loads) const = 0;
  /// Adds M times a uniform field.
  virtual void add_inertia(Point acceleration, UnknownsTable& loads) const = 0;
  virtual void add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
                      const UnknownsTable& v) const = 0;
  /// Removes the loads from these bodies.
  virtual void unload(const ChosenElements& bodies, UnknownsTable& loads) const = 0;
  /// Copies unknowns and point memories of these bodies from another motion.
  virtual void put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const = 0;

  // Mechanics.

  virtual void put_mass_inverse(Flexibility& flexibility) const = 0;
  virtual void put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const = 0;  ///< M v
  virtual double kinetic_energy(const UnknownsTable& v) const = 0;
  virtual void add_stored(const BodiesMotion& motion, StoredEnergy& stored) const = 0;
  virtual void add_flow(const BodiesStep& step, EnergyFlow& flow) const = 0;
  /// Adds M⁻¹ times loads less elastic and damping forces.
  virtual void add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion, const Flexibility& mass_inverse,
                                UnknownsTable& a) const = 0;
  /// Returns the largest momentum of a body.
  virtual double largest_momentum(const UnknownsTable& v) const = 0;
  /// Returns the largest load on a body, initial stress included.
  virtual double largest_load(const UnknownsTable& loads) const = 0;
  /// Passes the largest force on each loaded body to `seen`, with one of its elements. The forces are M `a`.
  using SeenForce = std::function<void(ElementIndex, double)>;
  virtual void look_at_forces(const UnknownsTable& a, const SeenForce& seen) const = 0;
  /// Passes each body at q to `seen`, with the resultants of `forces`.
  using SeenBody = std::function<void(const WholeBody&)>;
  virtual void look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                              const SeenBody& seen) const = 0;
  virtual double fastest_centre(const UnknownsTable& v) const = 0;
  virtual double fastest_point(const UnknownsTable& v) const = 0;  ///< upper bound
  /// Returns the greatest difference of increments, relative to the size of bodies. Rotation and strain are relative
  /// already.
  virtual double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const = 0;
  /// Returns the error of an accepted step by its rule, relative as above.
  virtual double step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                            double dt) const = 0;

  /// Begins a step without contact. Writes known data into `step`, whose tables have room; keeps a reference to
  /// `start`. Returns null if the step is linear, so that all is known.
  virtual std::unique_ptr<EstimatedStep> begin(const BodiesMotion& start, const UnknownsTable& loads,
                                               const StepRule& rule, double dt, FreeStep& step) const = 0;

  // Fields.

  /// Returns the state of an element in the position `placed`.
  virtual ElementState state_of(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                const Placement& placed) const = 0;
  /// Returns the stress at the point that lay at `start`.
  virtual Stress stress_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion, Point start) const = 0;
  /// Returns the plastic state there, in the axes of the plane; empty for rock that cannot yield.
  virtual std::optional<PlasticState> plastic_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                                 Point start) const = 0;
  /// Adds the plastic areas only.
  virtual void add_plastic(const BodiesMotion& motion, PlasticTotals& totals) const = 0;
  /// Returns ∫ σ · Δεᵖ of a step, with the stress at its end.
  virtual double plastic_work(const BodiesMotion& before, const BodiesMotion& after) const = 0;
  /// Returns the motion of an element's body over a region of the initial shape, at integration points. The points
  /// integrate products of its fields with each other, and with a polynomial of `degree`, to round-off.
  virtual std::vector<FieldPoint> field_over(const SceneParts& scene, ElementIndex e,
                                             std::span<const std::vector<Point>> region, int degree,
                                             const BodiesMotion& motion) const = 0;
  /// Returns the memory of rock at the point that lay at `start`; empty memory if it cannot yield.
  virtual YieldState memory_at(ElementIndex e, const BodiesMotion& motion, Point start) const = 0;
  /// Transfers unknowns, velocities and memories from the earlier bodies.
  virtual void carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const = 0;
};

/// Groups of a scene; every element belongs to one of them.
class BodyGroups {
 public:
  using Group = std::shared_ptr<const BodyGroup>;
  BodyGroups() = default;
  explicit BodyGroups(std::vector<Group> groups) : groups_(std::move(groups)) {}

  auto begin() const { return groups_.begin(); }
  auto end() const { return groups_.end(); }
  const BodyGroup& of(ElementIndex e) const;
  bool are_one_body(ElementIndex a, ElementIndex b) const;

 private:
  std::vector<Group> groups_;
};

}  // namespace keyblock
