// Holds the rows of the table of settings: name, meaning, member and permitted values of each.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <utility>

#include "settings/setting_row.hpp"

namespace keyblock {
namespace {

constexpr Range kAnyNumber{};
constexpr Range kAboveZero{0, true};
constexpr Range kNotNegative{0};
constexpr Range kShare{0, false, 1};
constexpr Range kFromHalf{0.5, false, 1};

template <class T>
auto at(T Settings::*member) {
  return [member](auto& s) -> auto& {
    return s.*member;
  };
}
template <class T>
auto at(T OpenCloseConstants::*member) {
  return [member](auto& s) -> auto& {
    return s.open_close.*member;
  };
}
template <class T>
auto at(T TrustLimits::*member) {
  return [member](auto& s) -> auto& {
    return s.trust.*member;
  };
}
template <class T>
auto at(T StandardChoices::*member) {
  return [member](auto& s) -> auto& {
    return s.standard.*member;
  };
}

SettingRow of(std::optional<Dynamics> dynamics, SettingRow row) {
  row.dynamics = dynamics;
  return row;
}

SettingRow under(ReadUnder choice, SettingRow row) {
  row.read_under = std::move(choice);
  return row;
}

ReadUnder integrator(Integrator wanted, const char* word) {
  return {fmt::format("integrator = {} outside motion = static", word), [wanted](const Settings& s) {
            return s.standard.integrator == wanted && s.standard.motion != MotionRule::equilibrium;
          }};
}

SettingRow quirk(const std::string& name, const std::string& meaning, bool BerkeleyQuirks::*member) {
  return of(Dynamics::shi,
            row(
                "quirk." + name, meaning, [member](auto& s) -> auto& { return s.quirks.*member; }, off_or_on()));
}

SettingRow downward_gravity() {
  return {"gravity",
          "acceleration of gravity, downward [length/time^2]. It sets gravity.y to its negative and gravity.x to 0",
          [](const Settings& s) { return fmt::format("{}", 0.0 - s.gravity.y); },
          [](Settings& s, const std::string& text) {
            s.gravity = {0, 0.0 - real(kAnyNumber).read("gravity", text)};
          },
          std::nullopt,
          real(kAnyNumber).permitted};
}

std::vector<SettingRow> rows_of_the_run() {
  return {
      row("node_merging",
          "rule by which close crossings become one node: nearest_first does not depend on the order of lines, "
          "in_order_found is Shi's",
          at(&Settings::node_merging),
          one_of<NodeMerging>(
              {{NodeMerging::nearest_first, "nearest_first"}, {NodeMerging::in_order_found, "in_order_found"}})),
      row("near_pieces",
          "treatment of joint pieces that pass a node nearer than edge_node_ratio times the scale: led_through it, or "
          "deleted as in Shi's programs",
          at(&Settings::near_pieces),
          one_of<NearPieces>({{NearPieces::led_through, "led_through"}, {NearPieces::deleted, "deleted"}})),
      row("slivers",
          "treatment of slivers: keep them, glue each to the neighbour with the longest common side, or leave them "
          "out. Slivers are below 1 % of the mean area, or no larger than the mean and narrower than 2 % of their "
          "length",
          at(&Settings::slivers),
          one_of<Slivers>({{Slivers::kept, "keep"}, {Slivers::glued, "glue"}, {Slivers::left_out, "leave_out"}})),
      row("steps", "number of time steps; in statics, of load steps", at(&Settings::step_count), whole(1)),
      row("time_step",
          "step size [time]. Under dynamics=standard with step_control=shi or error: output interval and upper bound "
          "of steps. Under dynamics=shi with step_control=shi: step if nothing moves, and 100 times the smallest step",
          at(&Settings::time_step), real(kAboveZero)),
      row("step_control",
          "rule for the step size: constant, from the displacement of a step (shi), or from its estimated error; error "
          "needs dynamics=standard",
          at(&Settings::step_control),
          one_of<StepControl>(
              {{StepControl::constant, "constant"}, {StepControl::shi, "shi"}, {StepControl::error, "error"}})),
      row(Materials::of_blocks, "velocity_carry_over", "share of the velocity carried into a step: 0 static, 1 dynamic",
          at(&Settings::velocity_carry_over), real(kShare)),
      of(Dynamics::shi, row("rotation", "displacement of points under a rotation: first order in the angle, or exact",
                            at(&Settings::rotation),
                            one_of<Rotation>({{Rotation::first_order, "first_order"}, {Rotation::exact, "exact"}}))),
      row("plane", "plane stress or plane strain", at(&Settings::plane),
          one_of<Plane>({{Plane::stress, "stress"}, {Plane::strain, "strain"}})),
      row(Materials::of_blocks, "basis", "unknowns of a block that may move: 3 (rigid) or 6 (affine)",
          at(&Settings::basis), one_of<BlockBasis>({{BlockBasis::rigid, "rigid"}, {BlockBasis::affine, "affine"}})),
  };
}

std::vector<SettingRow> rows_of_loads_and_materials() {
  return {
      downward_gravity(),
      row(
          "gravity.x",
          "acceleration of gravity in x [length/time^2]. Unit weights rotate with gravity if the case gives gravity",
          [](auto& s) -> auto& { return s.gravity.x; }, real(kAnyNumber)),
      row(
          "gravity.y",
          "acceleration of gravity in y, upward [length/time^2]. Unit weights scale with gravity if the case gives "
          "gravity",
          [](auto& s) -> auto& { return s.gravity.y; }, real(kAnyNumber)),
      row(
          "body_acceleration.x", "constant force per mass on every block in x [length/time^2]",
          [](auto& s) -> auto& { return s.body_acceleration.constant.x; }, real(kAnyNumber)),
      row(
          "body_acceleration.y", "constant force per mass on every block in y [length/time^2]",
          [](auto& s) -> auto& { return s.body_acceleration.constant.y; }, real(kAnyNumber)),
      row(
          "body_acceleration_file",
          "table of a force per mass on every block, CSV with columns time,ax,ay; added to the constant one. A heading "
          "may name a unit if the case declares its own: time [ms], ax [g]. It replaces a table of the case, and "
          "belongs to the whole run. A path in a case file starts at the folder of that file",
          [](auto& s) -> auto& { return s.body_acceleration.file; }, any_text()),
      row(Materials::of_blocks, "mass_damping",
          "coefficient a of the damping matrix a M + b K [1/time]. It slows rigid motion too",
          at(&Settings::mass_damping), real(kNotNegative)),
      row(Materials::of_blocks, "stiffness_damping",
          "coefficient b of the damping matrix a M + b K [time]. If absent: 0 under dynamics=shi, else set by "
          "strain_damping",
          at(&Settings::stiffness_damping), real_or_nothing(kNotNegative)),
      row("joint_strength_factor",
          "factor on tan(friction angle), cohesion and tensile strength of all joint materials",
          at(&Settings::joint_strength_factor), real(kNotNegative)),
  };
}

std::vector<SettingRow> rows_of_contact_and_steps() {
  return {
      row("contact_penalty", "normal contact stiffness [force/length]; its initial value if penalty_control=adaptive",
          at(&Settings::contact_penalty), real(kAboveZero)),
      of(Dynamics::shi,
         row("penalty_control", "rule for the contact stiffness: constant, or adapted to the penetration",
             at(&Settings::penalty_control),
             one_of<PenaltyControl>({{PenaltyControl::constant, "constant"}, {PenaltyControl::adaptive, "adaptive"}}))),
      of(Dynamics::shi,
         row("linear_method", "solver of the linear equations of an open-close iteration", at(&Settings::linear_method),
             one_of<LinearMethod>({{LinearMethod::automatic, "automatic"},
                                   {LinearMethod::factor, "factor"},
                                   {LinearMethod::conjugate_gradients, "conjugate_gradients"},
                                   {LinearMethod::over_relaxation, "over_relaxation"}}))),
      of(Dynamics::shi, row("fixed_point_factor", "stiffness of fixed points over the initial contact stiffness",
                            at(&Settings::fixed_point_factor), real(kAboveZero))),
      row("allowed_displacement_ratio", "allowed displacement per step over half the larger extent of the scene",
          at(&Settings::allowed_displacement_ratio), real(kAboveZero)),
      of(Dynamics::shi, row("pass_limit",
                            "largest number of open-close iterations per attempt. With quirk.fixed_pass_bound it is "
                            "always 8; any other value then accepts steps whose contacts still open or close",
                            at(&Settings::pass_limit), whole(1))),
      of(Dynamics::shi, row("redo_limit", "largest number of repeated attempts at one step; after it the run ends",
                            at(&Settings::redo_limit), whole(0))),
      of(Dynamics::shi,
         row("closing_ratio", "penetration at which a contact closes, over half the larger extent of the scene",
             at(&OpenCloseConstants::closing_ratio), real(kNotNegative))),
      of(Dynamics::shi,
         row("opening_ratio", "separation at which a contact opens, over half the larger extent of the scene",
             at(&OpenCloseConstants::opening_ratio), real(kNotNegative))),
      row("allowed_penetration",
          "penetration that the adaptive contact stiffness aims at, over half the larger extent of the scene",
          at(&OpenCloseConstants::allowed_penetration), real(kAboveZero)),
      of(Dynamics::shi, row("angle_overlap_deg", "angle within which two edges count as parallel [degree]",
                            at(&OpenCloseConstants::angle_overlap_deg), real(kNotNegative))),
      row("normal_to_shear_stiffness", "normal contact stiffness over shear contact stiffness",
          at(&OpenCloseConstants::normal_to_shear_stiffness), real(kAboveZero)),
  };
}

std::vector<SettingRow> rows_of_trust() {
  return {
      row("penetration_limit",
          "largest penetration over the size of the smaller block; beyond it the results are unreliable. Under "
          "dynamics=standard a run ends at a deeper overlap that no spring carries",
          at(&TrustLimits::penetration), real({0, true, 1})),
      row("crushing_limit",
          "smallest area of a block at the end over its initial area; below it the results are unreliable. 0: no limit",
          at(&TrustLimits::crushing), real(kShare)),
      row("energy_limit",
          "largest energy created over the largest stored energy; beyond it the results are unreliable. The reference "
          "is at least the work of all weights over 1e-4 of the block size, and the energy of the initial stress",
          at(&TrustLimits::energy), real(kAboveZero)),
  };
}

std::vector<SettingRow> rows_of_quirks() {
  using Q = BerkeleyQuirks;
  return {
      of(std::nullopt, quirk("moments_about_origin", "rule 7: area moments about the origin of coordinates",
                             &Q::moments_about_origin)),
      quirk("search_full_depth", "rule 2: penetration side searched to the full distance", &Q::search_full_depth),
      quirk("edge_direction_offset", "rule 3: 1e-7 added to |dx| in edge directions", &Q::edge_direction_offset),
      quirk("stale_contact_list", "rule 3: a step without contacts keeps the last list", &Q::stale_contact_list),
      quirk("contact_length_last_vertex", "rule 5: wrong end of a shared edge after a repeated vertex",
            &Q::contact_length_last_vertex),
      quirk("plane_strain_factor", "rule 7.2: stiffness too large in plane strain", &Q::plane_strain_factor),
      quirk("velocity_from_coming_step", "rule 7.4: velocity from the next step size", &Q::velocity_from_coming_step),
      quirk("start_velocity_slots", "rule 7.5: stress gradient and initial velocity share values",
            &Q::start_velocity_slots),
      of(std::nullopt, quirk("weight_of_first_material", "gravity of the first material for all materials",
                             &Q::weight_of_first_material)),
      quirk("cut_step_stays", "rule 11.2: a step size once cut stays cut", &Q::cut_step_stays),
      quirk("fixed_pass_bound", "rule 11.1: always 8 open-close iterations", &Q::fixed_pass_bound),
      quirk("step_rule_by_time", "rule 13: time instead of the displacement ratio in the automatic step",
            &Q::step_rule_by_time),
      row("dynamics", "kind of time step: Shi's, or that of profile standard", at(&Settings::dynamics),
          one_of<Dynamics>({{Dynamics::shi, "shi"}, {Dynamics::standard, "standard"}})),
      row("ledger", "balance of energy and momentum of every step, computed and written to ledger.csv",
          at(&Settings::ledger), one_of<Bookkeeping>({{Bookkeeping::off, "off"}, {Bookkeeping::on, "on"}})),
  };
}

/// Returns the rows of dynamics `standard` about the equations of a step.
std::vector<SettingRow> rows_of_solution() {
  using C = StandardChoices;
  return {
      row("motion", "kind of steps: time steps, or static equilibria under the loads of each time", at(&C::motion),
          one_of<MotionRule>({{MotionRule::dynamic, "dynamic"}, {MotionRule::equilibrium, "static"}},
                             {{"relaxation", "static finds the equilibria that dynamic relaxation did"}})),
      under({"motion = static", [](const Settings& s) { return s.standard.motion != MotionRule::dynamic; }},
            row("load_steps",
                "number of equilibria from zero load to the initial loads, in statics: one per step, or several if "
                "steps are fewer",
                at(&C::load_steps), whole(1))),
      under({"motion = static", [](const Settings& s) { return s.standard.motion == MotionRule::equilibrium; }},
            row("load_control",
                "load steps of elastoplastic NMM bodies without contact: equal increments (share), or equal lengths "
                "along the equilibrium path, on which loads may fall (arc_length)",
                at(&C::load_control),
                one_of<LoadControl>({{LoadControl::share, "share"}, {LoadControl::arc_length, "arc_length"}}))),
      under({"load_control = arc_length",
             [](const Settings& s) { return s.standard.load_control == LoadControl::arc_length; }},
            row("path_step",
                "length of a step along the equilibrium path, over the displacement of elastic rock under an equal "
                "load increment",
                at(&C::path_step), real(kAboveZero))),
      under({"motion = dynamic", [](const Settings& s) { return s.standard.motion == MotionRule::dynamic; }},
            row("start",
                "initial strains and contact forces: in equilibrium with the loads (compatible), or zero (sudden)",
                at(&C::start),
                one_of<StartRule>({{StartRule::compatible, "compatible"}, {StartRule::sudden, "sudden"}}))),
      row("cover_functions", "functions of the physical covers of a cover file. A case file has its own key functions",
          at(&C::cover_functions),
          one_of<CoverFunctions>({{CoverFunctions::constant, "constant"},
                                  {CoverFunctions::derived, "derived"},
                                  {CoverFunctions::linear, "linear"},
                                  {CoverFunctions::quadratic, "quadratic"}})),
      row(Materials::of_blocks, "elastic_law",
          "stress of NMM bodies under large strain: from the Green strain, which softens under strong compression, or "
          "from the logarithmic strain, which does not",
          at(&C::elastic_law),
          one_of<ElasticLaw>(
              {{ElasticLaw::st_venant_kirchhoff, "st_venant_kirchhoff"}, {ElasticLaw::logarithmic, "logarithmic"}})),
  };
}

/// Returns the rows of dynamics `standard` about contact forces.
std::vector<SettingRow> rows_of_contact_forces() {
  using C = StandardChoices;
  return {
      row(Materials::of_joints, "enforcement",
          "method of contact forces: multipliers (lagrange), springs of the contact stiffness (penalty), or springs "
          "until no overlap is left (augmented). Under automatic: springs for NMM bodies, for impact=springs, for "
          "rings in contact if more than 8 blocks can move, and for fewer blocks held at more points than they can "
          "follow; else multipliers",
          at(&C::enforcement),
          one_of<Enforcement>({{Enforcement::lagrange, "lagrange"},
                               {Enforcement::penalty, "penalty"},
                               {Enforcement::augmented, "augmented"},
                               {Enforcement::automatic, "automatic"}})),
      row("spring_points", "places of contact springs between two faces: at the ends, or at three Lobatto points",
          at(&C::spring_points),
          one_of<SpringPoints>({{SpringPoints::ends, "ends"}, {SpringPoints::lobatto, "lobatto"}})),
      under({"impact = jump", [](const Settings& s) { return s.standard.impact == ImpactLaw::jump; }},
            row("corner_rounding",
                "overlap up to which two corners slide past each other, over half the width of the narrower block. 0: "
                "corners are sharp to a millionth of the shorter edge, and blocks catch on small offsets",
                at(&C::corner_rounding), real({0, false, 0.1}))),
      row("force_tolerance",
          "target residual of contact forces over the heaviest load, if more than 50 contacts are solved together",
          at(&C::force_tolerance), real({0, true, 1e-3})),
      row("impact", "law of fast impacts of blocks: a velocity jump with restitution, or the contact springs",
          at(&C::impact), one_of<ImpactLaw>({{ImpactLaw::jump, "jump"}, {ImpactLaw::springs, "springs"}})),
  };
}

/// Returns the rows of dynamics `standard` about time integration.
std::vector<SettingRow> rows_of_integration() {
  using C = StandardChoices;
  return {
      row("strain_damping", "stiffness damping of the strain modes of blocks", at(&C::strain_damping),
          one_of<StrainDamping>({{StrainDamping::critical, "critical"}, {StrainDamping::none, "none"}})),
      row("integrator",
          "time integration: by velocity_weight and force_weight, by Newmark's method, or by the generalised-alpha "
          "method",
          at(&C::integrator),
          one_of<Integrator>({{Integrator::weighted, "weighted"},
                              {Integrator::newmark, "newmark"},
                              {Integrator::generalized_alpha, "generalized_alpha"}})),
      under(integrator(Integrator::weighted, "weighted"),
            row("velocity_weight", "weight of the velocity at the end of a step; 0.5 is second order",
                at(&C::velocity_weight), real(kFromHalf))),
      under(integrator(Integrator::weighted, "weighted"),
            row("force_weight",
                "weight of the elastic force at the end of a step: 1 is Shi's step, 0.5 average acceleration",
                at(&C::force_weight), real(kFromHalf))),
      under(integrator(Integrator::newmark, "newmark"),
            row("newmark_beta",
                "beta of Newmark's method: 0.25 is average acceleration, 0.5 Shi's step; unstable below gamma/2",
                at(&C::newmark_beta), real({0, true, 1}))),
      under(integrator(Integrator::newmark, "newmark"),
            row("newmark_gamma", "gamma of Newmark's method: 0.5 is average acceleration, 1 Shi's step",
                at(&C::newmark_gamma), real(kFromHalf))),
      under(integrator(Integrator::generalized_alpha, "generalized_alpha"),
            row("rho_infinity", "share of the highest frequencies that the generalised-alpha method keeps per step",
                at(&C::rho_infinity), real(kShare))),
      under({"step_control = error", [](const Settings& s) { return s.step_control == StepControl::error; }},
            row("step_tolerance", "allowed error of a step over the block size, under step_control=error",
                at(&C::step_tolerance), real(kAboveZero))),
      under({"step_control = shi or error", [](const Settings& s) { return s.step_control != StepControl::constant; }},
            row("least_step_share", "smallest size of a controlled step over time_step", at(&C::least_step_share),
                real({0, true, 1}))),
      under({"impact = jump", [](const Settings& s) { return s.standard.impact == ImpactLaw::jump; }},
            row(Materials::of_joints, "restitution",
                "rebound speed over approach speed of block impacts, under impact=jump", at(&C::restitution),
                real(kShare))),
  };
}

}  // namespace

std::vector<SettingRow> setting_rows() {
  std::vector<SettingRow> all;
  for (const auto& part : {rows_of_the_run(), rows_of_loads_and_materials(), rows_of_contact_and_steps(),
                           rows_of_trust(), rows_of_quirks()})
    all.insert(all.end(), part.begin(), part.end());
  for (const auto& part : {rows_of_solution(), rows_of_contact_forces(), rows_of_integration()})
    for (const SettingRow& row : part) all.push_back(of(Dynamics::standard, row));
  return all;
}

}  // namespace keyblock
