// The table of settings: one row a setting, with its kind, range and meaning.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/settings_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>

namespace keyblock {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::max();

struct Real {
  double& (*of)(Settings&);
  double least;
  bool open = false;  ///< the least value itself is excluded
  double greatest = kNoLimit;
};
struct Whole {
  int& (*of)(Settings&);
  int least;
};
/// A number that stands for several settings.
struct Shorthand {
  double (*get)(const Settings&);
  void (*set)(Settings&, double);
};
/// Name of a file that the caller has read.
struct File {
  std::string& (*of)(Settings&);
};
struct Choice {
  std::vector<std::string> names;
  std::function<int(const Settings&)> get;
  std::function<void(Settings&, int)> set;
};

struct Row {
  const char* name;
  const char* meaning;
  std::variant<Real, Whole, Shorthand, File, Choice> kind;
};

template <class E>
Choice choice(E Settings::*member, std::vector<std::string> names) {
  return {std::move(names), [member](const Settings& s) { return static_cast<int>(s.*member); },
          [member](Settings& s, int value) { s.*member = static_cast<E>(value); }};
}

template <class E>
Choice choice(E StandardChoices::*member, std::vector<std::string> names) {
  return {std::move(names), [member](const Settings& s) { return static_cast<int>(s.standard.*member); },
          [member](Settings& s, int value) { s.standard.*member = static_cast<E>(value); }};
}

Choice quirk(bool BerkeleyQuirks::*member) {
  return {{"off", "on"},
          [member](const Settings& s) { return s.quirks.*member ? 1 : 0; },
          [member](Settings& s, int value) { s.quirks.*member = value == 1; }};
}

const std::vector<Row>& table() {
  static const std::vector<Row> rows{
      {"node_merging", "how near crossings become one node when a drawing is cut",
       choice(&Settings::node_merging, {"nearest_first", "in_order_found"})},
      {"steps", "number of time steps", Whole{[](Settings& s) -> int& { return s.step_count; }, 1}},
      {"time_step",
       "step size; under rule shi only the least one, a hundredth of it, and the step where nothing moves [time]",
       Real{[](Settings& s) -> double& { return s.time_step; }, 0, true}},
      {"step_control", "how the step size is chosen", choice(&Settings::step_control, {"constant", "shi", "error"})},
      {"velocity_carry_over", "share of the velocity carried into a step: 0 static, 1 dynamic",
       Real{[](Settings& s) -> double& { return s.velocity_carry_over; }, 0, false, 1}},
      {"rotation", "how points move under a rotation", choice(&Settings::rotation, {"first_order", "exact"})},
      {"plane", "plane stress or plane strain", choice(&Settings::plane, {"stress", "strain"})},
      {"gravity", "acceleration of gravity, downward: gravity.x = 0 and the negative of gravity.y [length/time^2]",
       Shorthand{[](const Settings& s) { return 0.0 - s.gravity.y; },
                 [](Settings& s, double downward) {
                   s.gravity = {0, 0.0 - downward};
                 }}},
      {"gravity.x",
       "acceleration of gravity in x; unit weights of materials turn and grow with gravity [length/time^2]",
       Real{[](Settings& s) -> double& { return s.gravity.x; }, -kNoLimit}},
      {"gravity.y", "acceleration of gravity in y, upward [length/time^2]",
       Real{[](Settings& s) -> double& { return s.gravity.y; }, -kNoLimit}},
      {"body_acceleration.x", "constant force per mass on every block, in x [length/time^2]",
       Real{[](Settings& s) -> double& { return s.body_acceleration.constant.x; }, -kNoLimit}},
      {"body_acceleration.y", "constant force per mass on every block, in y [length/time^2]",
       Real{[](Settings& s) -> double& { return s.body_acceleration.constant.y; }, -kNoLimit}},
      {"body_acceleration_file", "table time,ax,ay (CSV) of a force per mass on every block; added to the constant one",
       File{[](Settings& s) -> std::string& { return s.body_acceleration.file; }}},
      {"joint_strength_factor", "factor on tan(friction angle), cohesion and tensile strength of all joint materials",
       Real{[](Settings& s) -> double& { return s.joint_strength_factor; }, 0}},
      {"contact_penalty", "starting normal contact stiffness [force/length]",
       Real{[](Settings& s) -> double& { return s.contact_penalty; }, 0, true}},
      {"penalty_control", "how the contact stiffness changes",
       choice(&Settings::penalty_control, {"constant", "adaptive"})},
      {"fixed_point_factor", "stiffness of fixed points over the starting contact stiffness",
       Real{[](Settings& s) -> double& { return s.fixed_point_factor; }, 0, true}},
      {"allowed_displacement_ratio", "allowed displacement of a step over half the size of the scene",
       Real{[](Settings& s) -> double& { return s.allowed_displacement_ratio; }, 0, true}},
      {"pass_limit", "open-close passes of one attempt", Whole{[](Settings& s) -> int& { return s.pass_limit; }, 1}},
      {"redo_limit", "redone attempts at one step before the run stops",
       Whole{[](Settings& s) -> int& { return s.redo_limit; }, 0}},
      {"closing_ratio", "penetration at which a contact closes, over half the size of the scene",
       Real{[](Settings& s) -> double& { return s.open_close.closing_ratio; }, 0}},
      {"opening_ratio", "separation at which a contact opens, over half the size of the scene",
       Real{[](Settings& s) -> double& { return s.open_close.opening_ratio; }, 0}},
      {"allowed_penetration", "penetration the adaptive stiffness aims at, over half the size of the scene",
       Real{[](Settings& s) -> double& { return s.open_close.allowed_penetration; }, 0, true}},
      {"angle_overlap_deg", "angle within which two edges count as parallel [degree]",
       Real{[](Settings& s) -> double& { return s.open_close.angle_overlap_deg; }, 0}},
      {"normal_to_shear_stiffness", "normal over shear contact stiffness",
       Real{[](Settings& s) -> double& { return s.open_close.normal_to_shear_stiffness; }, 0, true}},
      {"quirk.moments_about_origin", "rules 7: area moments about the origin of coordinates",
       quirk(&BerkeleyQuirks::moments_about_origin)},
      {"quirk.search_full_depth", "rules 2: penetration side searched to the full distance",
       quirk(&BerkeleyQuirks::search_full_depth)},
      {"quirk.edge_direction_offset", "rules 3: 1e-7 added to |dx| in edge directions",
       quirk(&BerkeleyQuirks::edge_direction_offset)},
      {"quirk.stale_contact_list", "rules 3: a step without contacts keeps the last list",
       quirk(&BerkeleyQuirks::stale_contact_list)},
      {"quirk.contact_length_last_vertex", "rules 5: end of a shared edge mistaken",
       quirk(&BerkeleyQuirks::contact_length_last_vertex)},
      {"quirk.plane_strain_factor", "rules 7.2: plane-strain stiffness too stiff",
       quirk(&BerkeleyQuirks::plane_strain_factor)},
      {"quirk.velocity_from_coming_step", "rules 7.4: velocity from the coming step size",
       quirk(&BerkeleyQuirks::velocity_from_coming_step)},
      {"quirk.start_velocity_slots", "rules 7.5: stress gradient and start velocity share values",
       quirk(&BerkeleyQuirks::start_velocity_slots)},
      {"quirk.weight_of_first_material", "one gravity for all materials",
       quirk(&BerkeleyQuirks::weight_of_first_material)},
      {"quirk.cut_step_stays", "rules 11.2: a cut step stays cut", quirk(&BerkeleyQuirks::cut_step_stays)},
      {"quirk.fixed_pass_bound", "rules 11.1: 8 passes whatever the limit", quirk(&BerkeleyQuirks::fixed_pass_bound)},
      {"quirk.step_rule_by_time", "rules 13: time in place of the displacement ratio",
       quirk(&BerkeleyQuirks::step_rule_by_time)},
      {"dynamics", "whose step is made; the choices below belong to `standard`",
       choice(&Settings::dynamics, {"shi", "standard"})},
      {"ledger", "energy and momentum of every step, kept and written", choice(&Settings::ledger, {"off", "on"})},
      {"motion", "steps in time, of static equilibrium, or of equilibrium by dynamic relaxation",
       choice(&StandardChoices::motion, {"dynamic", "static", "relaxation"})},
      {"load_steps", "equilibria from no load to that of the start, in a run without dynamics",
       Whole{[](Settings& s) -> int& { return s.standard.load_steps; }, 1}},
      {"basis", "unknowns of a block that may move: 3 or 6", choice(&StandardChoices::basis, {"rigid", "affine"})},
      {"enforcement", "contact forces by multipliers or by springs of the contact stiffness",
       choice(&StandardChoices::enforcement, {"lagrange", "penalty", "augmented"})},
      {"spring_points", "where springs stand between two faces: at the ends, or three by Lobatto's rule",
       choice(&StandardChoices::spring_points, {"ends", "lobatto"})},
      {"impact", "what stops blocks that meet fast: a jump with restitution, or the contact springs",
       choice(&StandardChoices::impact, {"jump", "springs"})},
      {"start", "strains and contact forces at the start", choice(&StandardChoices::start, {"compatible", "sudden"})},
      {"strain_damping", "stiffness damping of the strain modes",
       choice(&StandardChoices::strain_damping, {"critical", "none"})},
      {"integrator", "sums of a step: the two weights below, Newmark's, or generalised alpha's",
       choice(&StandardChoices::integrator, {"weighted", "newmark", "generalized_alpha"})},
      {"velocity_weight", "weight of the velocity at the end of a step; 0.5 is second order",
       Real{[](Settings& s) -> double& { return s.standard.velocity_weight; }, 0.5, false, 1}},
      {"force_weight", "weight of the elastic force at the end of a step: 1 Shi, 0.5 average acceleration",
       Real{[](Settings& s) -> double& { return s.standard.force_weight; }, 0.5, false, 1}},
      {"newmark_beta", "beta of Newmark: 0.25 average acceleration, 0.5 Shi; unstable below half of gamma",
       Real{[](Settings& s) -> double& { return s.standard.newmark_beta; }, 0, true, 1}},
      {"newmark_gamma", "gamma of Newmark: 0.5 average acceleration, 1 Shi",
       Real{[](Settings& s) -> double& { return s.standard.newmark_gamma; }, 0.5, false, 1}},
      {"rho_infinity", "what generalised alpha leaves of the highest frequencies in a step",
       Real{[](Settings& s) -> double& { return s.standard.rho_infinity; }, 0, false, 1}},
      {"step_tolerance", "error of a step over block size, under step control error",
       Real{[](Settings& s) -> double& { return s.standard.step_tolerance; }, 0, true}},
      {"least_step_share", "of the time step, below which controlled steps are not cut",
       Real{[](Settings& s) -> double& { return s.standard.least_step_share; }, 0, true, 1}},
      {"restitution", "rebound over approach speed of an impact",
       Real{[](Settings& s) -> double& { return s.standard.restitution; }, 0, false, 1}},
  };
  return rows;
}

template <class T>
std::optional<T> parse(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const Row& row, const std::string& expected, const std::string& found) {
  throw std::invalid_argument(fmt::format("setting {}: expected {}, found \"{}\"", row.name, expected, found));
}

struct Write {
  const Settings& settings;
  std::string operator()(const Real& r) const { return fmt::format("{}", r.of(const_cast<Settings&>(settings))); }
  std::string operator()(const Whole& w) const { return fmt::format("{}", w.of(const_cast<Settings&>(settings))); }
  std::string operator()(const Shorthand& s) const { return fmt::format("{}", s.get(settings)); }
  std::string operator()(const File& f) const { return f.of(const_cast<Settings&>(settings)); }
  std::string operator()(const Choice& c) const { return c.names[static_cast<std::size_t>(c.get(settings))]; }
};

struct Read {
  Settings& settings;
  const Row& row;
  const std::string& text;

  void operator()(const Real& r) const {
    const std::optional<double> value = parse<double>(text);
    const bool in_range =
        value && std::isfinite(*value) && *value <= r.greatest && (r.open ? *value > r.least : *value >= r.least);
    if (!in_range) refuse(row, range_of(r), text);
    r.of(settings) = *value;
  }
  void operator()(const Whole& w) const {
    const std::optional<int> value = parse<int>(text);
    if (!value || *value < w.least) refuse(row, fmt::format("a whole number of at least {}", w.least), text);
    w.of(settings) = *value;
  }
  void operator()(const Shorthand& s) const {
    const std::optional<double> value = parse<double>(text);
    if (!value || !std::isfinite(*value)) refuse(row, "a number", text);
    s.set(settings, *value);
  }
  void operator()(const File& f) const { f.of(settings) = text; }
  void operator()(const Choice& c) const {
    for (std::size_t i = 0; i < c.names.size(); ++i) {
      if (c.names[i] == text) return c.set(settings, static_cast<int>(i));
    }
    refuse(row, fmt::format("one of {}", fmt::join(c.names, ", ")), text);
  }
  static std::string range_of(const Real& r) {
    if (r.least == -kNoLimit) return "a number";
    if (r.greatest != kNoLimit) return fmt::format("a number from {} to {}", r.least, r.greatest);
    return fmt::format("a number {} {}", r.open ? "greater than" : "of at least", r.least);
  }
};

}  // namespace

std::vector<SettingText> list(const Settings& settings) {
  std::vector<SettingText> texts;
  for (const Row& row : table()) {
    const bool is_text = std::holds_alternative<Choice>(row.kind) || std::holds_alternative<File>(row.kind);
    texts.push_back({row.name, std::visit(Write{settings}, row.kind), row.meaning, !is_text});
  }
  return texts;
}

void set(Settings& settings, const std::string& name, const std::string& value) {
  for (const Row& row : table()) {
    if (name == row.name) return std::visit(Read{settings, row, value}, row.kind);
  }
  throw std::invalid_argument(fmt::format("there is no setting \"{}\"; `keyblock run --settings` lists them", name));
}

}  // namespace keyblock
