// Bodies of one kind behind one interface: what steps, ledgers and searches ask of them, whatever their unknowns are.
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

/// What points of rock that may yield remember; empty where nothing may.
struct PointMemories {
  std::vector<YieldState> blocks;  ///< one an element
  std::vector<YieldState> covers;  ///< in the order of CoverYield
};

/// Unknowns of all bodies of a scene, their velocities and accelerations, and what their points remember.
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

/// Masses, and how slowly the slowest mode of a body swings.
struct MassRange {
  double lightest = std::numeric_limits<double>::max();
  double heaviest = 0;
  double slowest = std::numeric_limits<double>::max();  ///< ω, 1 / time
  bool all_strain = true;
};

/// What a scene is made of besides its bodies' own matrices.
struct SceneParts {
  const Model& model;
  const Reference& reference;
  const Settings& settings;
};

/// A point of a body, of which there is `area` about it, at the start and now.
struct FieldPoint {
  Point start;
  double area = 0;
  Point place;
  Point velocity;
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Identity();  ///< of the place by the start
};

class BodyGroups;

/// Of every element whether it is meant: bodies as wholes.
using ChosenElements = std::vector<bool>;

/// Bodies of an earlier scene. `parents`: of every element of the later one, that which it is or was cut from.
struct BodiesBefore {
  SceneParts scene;
  const BodyGroups& groups;
  const BodiesMotion& motion;
  const Table<ElementIndex, ElementIndex>& parents;
};

/// An accepted step as its bodies saw it.
struct BodiesStep {
  const BodiesMotion& start;
  const UnknownsTable& q;       ///< at the end of the smooth motion
  const UnknownsTable& v;       ///< of the smooth motion
  const UnknownsTable& a;       ///< of the smooth motion
  const UnknownsTable& end;     ///< unknowns after what overlaps were removed
  const PointMemories& points;  ///< at the end
  const UnknownsTable& loads;   ///< weight included
  const StepRule& rule;
  double dt = 0;
};

/// A step without contact: Δq = increments + A⁻¹ Gᵀ λ, v = known + rule.end_velocity Δq, a likewise.
struct FreeStep {
  Flexibility flexibility;
  Flexibility judging;  ///< A⁻¹ with the inertia by which forces are judged; empty where that is the same
  UnknownsTable increments;
  UnknownsTable known_velocity;
  UnknownsTable known_acceleration;
};

/// Bodies whose step is linearised about an estimate of the increments.
class EstimatedStep {
 public:
  virtual ~EstimatedStep() = default;
  /// Puts A⁻¹ about an estimate. False where it has no factor.
  virtual bool linearise(const UnknownsTable& estimate, FreeStep& step) = 0;
  /// Puts the increments about an estimate, with the A⁻¹ of before.
  virtual void evaluate(const UnknownsTable& estimate, FreeStep& step) = 0;
  /// Velocities, accelerations and memories of points of increments that solve the equations.
  virtual void put_end(const UnknownsTable& increments, UnknownsTable& v, UnknownsTable& a,
                       PointMemories& points) const = 0;
};

/// All bodies of a scene that have unknowns of one kind. A group reads and writes its own part of a table of unknowns;
/// elements of other groups have none there. What it adds to, others have begun.
class BodyGroup {
 public:
  virtual ~BodyGroup() = default;

  // What the bodies are.

  virtual bool has(ElementIndex e) const = 0;
  virtual double size() const = 0;                   ///< of the largest that can move
  virtual double mass_of(ElementIndex e) const = 0;  ///< of the body of an element
  virtual bool are_one_body(ElementIndex a, ElementIndex b) const = 0;
  /// Whether something besides fixed points and contact holds bodies, or is held.
  virtual bool has_supports() const = 0;
  /// Whether something besides fixed points holds the body of an element that has unknowns.
  virtual bool is_supported(ElementIndex e) const = 0;
  /// Whether the equations of a step are linear in the increments.
  virtual bool is_linear() const = 0;
  /// Whether some of the rock may yield: the equations of a step then have kinks.
  virtual bool may_yield() const = 0;
  /// Whether a step resolves how an impact goes on: the inertia near the contact takes part in it, and the rebound is
  /// that of elasticity. Otherwise bodies jump apart as wholes, by a restitution.
  virtual bool resolves_impacts() const = 0;
  /// Whether elements may have holes.
  virtual bool takes_holes() const = 0;
  /// Whether the first forces and strains can be balanced with accelerations, so that what slides or falls starts in
  /// balance too; others start suddenly or at rest.
  virtual bool has_compatible_start() const = 0;
  /// The law of stress under large strain; none where strain stays small.
  virtual std::optional<ElasticLaw> law_of_large_strain(const SceneParts& scene, ElementIndex e) const = 0;
  /// The functions of displacement that its bodies share; none where each has unknowns of its own.
  virtual const CoverBasis* shared_basis() const { return nullptr; }
  /// What to add where a body finds no equilibrium.
  virtual std::string_view why_unheld() const = 0;
  /// `contact_stiffness`: of the springs that may hold bodies; 0 without.
  virtual void add_to(MassRange& range, double contact_stiffness) const = 0;

  // Start and loads.

  virtual void put_start(const SceneParts& scene, BodiesMotion& motion) const = 0;
  /// By the share of velocity that materials carry from step to step.
  virtual void carry_over(const SceneParts& scene, UnknownsTable& v) const = 0;
  /// Weight, and what tractions and supports of the problem exert.
  virtual void put_weight(UnknownsTable& loads) const = 0;
  /// M times a uniform field.
  virtual void add_inertia(Point acceleration, UnknownsTable& loads) const = 0;
  virtual void add_to(Scales& scales, const UnknownsTable& loads, const UnknownsTable& q,
                      const UnknownsTable& v) const = 0;
  /// Takes the loads off these bodies.
  virtual void unload(const ChosenElements& bodies, UnknownsTable& loads) const = 0;
  /// Puts unknowns and memories of points of these bodies as another motion has them.
  virtual void put_back(const ChosenElements& bodies, const BodiesMotion& as, BodiesMotion& motion) const = 0;

  // Mechanics.

  virtual void put_mass_inverse(Flexibility& flexibility) const = 0;
  virtual void put_momentum(const UnknownsTable& v, UnknownsTable& momentum) const = 0;  ///< M v
  virtual double kinetic_energy(const UnknownsTable& v) const = 0;
  virtual void add_stored(const BodiesMotion& motion, StoredEnergy& stored) const = 0;
  virtual void add_flow(const BodiesStep& step, EnergyFlow& flow) const = 0;
  /// M⁻¹ times loads less elastic and damping forces.
  virtual void add_acceleration(const UnknownsTable& loads, const BodiesMotion& motion, const Flexibility& mass_inverse,
                                UnknownsTable& a) const = 0;
  /// Of a body.
  virtual double largest_momentum(const UnknownsTable& v) const = 0;
  /// Of a body, initial stress included.
  virtual double largest_load(const UnknownsTable& loads) const = 0;
  /// The largest force of a v-like table `forces`, M a, on each body that has one, with an element of it.
  using SeenForce = std::function<void(ElementIndex, double)>;
  virtual void look_at_forces(const UnknownsTable& a, const SeenForce& seen) const = 0;
  /// The bodies at q, with the resultants of `forces`.
  using SeenBody = std::function<void(const WholeBody&)>;
  virtual void look_at_bodies(const SceneParts& scene, const UnknownsTable& q, const UnknownsTable& forces,
                              const SeenBody& seen) const = 0;
  virtual double fastest_centre(const UnknownsTable& v) const = 0;
  virtual double fastest_point(const UnknownsTable& v) const = 0;  ///< at most
  /// Of increments, relative to the size of bodies; rotation and strain are relative as they are.
  virtual double greatest_change(const UnknownsTable& a, const UnknownsTable& b) const = 0;
  /// Error of an accepted step by its rule, relative as above.
  virtual double step_error(const BodiesMotion& before, const BodiesMotion& after, const StepRule& rule,
                            double dt) const = 0;

  /// Begins a step without contact; what is known of it at once is put into `step`, whose tables have room. Views the
  /// start. None where it is linear and all is known.
  virtual std::unique_ptr<EstimatedStep> begin(const BodiesMotion& start, const UnknownsTable& loads,
                                               const StepRule& rule, double dt, FreeStep& step) const = 0;

  // Fields.

  /// Of an element that lies as `placed`.
  virtual ElementState state_of(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                const Placement& placed) const = 0;
  /// At the point that lay at `start`.
  virtual Stress stress_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion, Point start) const = 0;
  /// Likewise, in the axes of the plane; none of rock that cannot yield.
  virtual std::optional<PlasticState> plastic_at(const SceneParts& scene, ElementIndex e, const BodiesMotion& motion,
                                                 Point start) const = 0;
  /// Areas alone.
  virtual void add_plastic(const BodiesMotion& motion, PlasticTotals& totals) const = 0;
  /// ∫ σ · Δεᵖ of a step, by the stress at its end.
  virtual double plastic_work(const BodiesMotion& before, const BodiesMotion& after) const = 0;
  /// A motion of the body of an element over a region of the start, by points that integrate the products of its fields
  /// with each other, and with a polynomial of `degree`, to round-off.
  virtual std::vector<FieldPoint> field_over(const SceneParts& scene, ElementIndex e,
                                             std::span<const std::vector<Point>> region, int degree,
                                             const BodiesMotion& motion) const = 0;
  /// What rock remembers at the point that lay at `start`; nothing where it cannot yield.
  virtual YieldState memory_at(ElementIndex e, const BodiesMotion& motion, Point start) const = 0;
  /// Puts unknowns, velocities and memories as the bodies before had them.
  virtual void carry(const SceneParts& scene, const BodiesBefore& before, BodiesMotion& carried) const = 0;
};

/// The groups of a scene: every element belongs to one of them.
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
