// Reads controls, materials and loads of a DDAML analysis; the elements are in the header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "base/sentences/sentences.hpp"
#include "formats/berkeley/ddaml_ignored.hpp"
#include "formats/text/decimal_comma.hpp"
#include "formats/text/demands.hpp"
#include "formats/text/numbers.hpp"
#include "formats/text/tokens.hpp"
#include "problem/limits.hpp"

namespace keyblock::formats {
namespace {

constexpr std::string_view kNothing = "nothing";

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Controls that a file should state, and their defaults. The warning is `default_NAME`.
struct Default {
  std::string_view element;
  std::string_view value;
};
constexpr std::array<Default, 7> kDefaults{{{"Analysistype", "static"},
                                            {"Rotation", "linear"},
                                            {"Gravity", "no gravity phase"},
                                            {"Gravaccel", "9.81"},
                                            {"Autotimestep", "no"},
                                            {"Autopenalty", "no adaptation, penalty factor 50"},
                                            {"Planestrain", "no (plane stress)"}}};
constexpr std::array<std::string_view, 3> kRequired{"Numtimesteps", "Maxtimestep", "Maxdisplacement"};
constexpr std::array<std::string_view, 4> kManyTimes{"Blockmaterial", "Jointproperties", "Boltproperties",
                                                     "Loadpointlist"};
constexpr std::array<std::string_view, 2> kPassedOver{"Mintimestep", "Writevertices"};

Warning absent(const Default& choice, const Element& parent) {
  Facts facts{{}, {{"value", std::string(choice.value)}}};
  if (const auto number = parse_real(choice.value)) facts.numbers = {{"taken", *number}};
  facts.names = {{"element_name", std::string(choice.element)}};
  return warning_of({"default_" + lower_case(choice.element), std::move(facts)}, parent.place());
}

/// Reads values of elements and attributes, and collects warnings.
class ElementValues {
 public:
  Warnings take_warnings() { return std::move(warnings_); }

  void warn(Warning warning) { add_warning(warnings_, std::move(warning)); }

  void pass_over(const Element& element) { add_warning(warnings_, ignored(element)); }

  /// Warns of elements that may occur only once; `taken`: which of several counts.
  void warn_of_repeated(const Element& element, std::string_view taken) {
    std::set<std::string_view> names;
    for (const Element& child : element.children())
      if (!names.insert(child.name()).second) {
        Facts facts{{}, {{"taken", std::string(taken)}}};
        facts.names = {{"element_name", std::string(child.name())}, {"parent", std::string(element.name())}};
        warn(warning_of({"repeated_element:of_parent", std::move(facts)}, child.place()));
      }
  }

  double attribute_real(const Element& element, std::string_view attribute, const Demand& demand) {
    const Tokens tokens = element.attribute_tokens(attribute);
    Cursor cursor(tokens, kNothing);
    cursor.enter({element.name()});
    const Place place = cursor.place();
    const double value = cursor.next_real(attribute, demand);
    if (std::abs(value) > kGreatestQuantity)
      throw InputError(place, fmt::format("expected {} of {} from {:g} to {:g}, found {:g}", attribute, element.name(),
                                          -kGreatestQuantity, kGreatestQuantity, value));
    keep_remainder(tokens, cursor);
    return value;
  }

  int attribute_integer(const Element& element, std::string_view attribute, const Demand& demand) {
    const Tokens tokens = element.attribute_tokens(attribute);
    Cursor cursor(tokens, kNothing);
    cursor.enter({element.name()});
    const int value = cursor.next_integer(attribute, demand);
    keep_remainder(tokens, cursor);
    return value;
  }

  /// Returns the index of an attribute's word; for any other word the first, with a warning.
  std::size_t choice_of(const Element& element, std::string_view attribute,
                        const std::vector<std::string_view>& words) {
    const auto found = element.attribute(attribute);
    const auto word = std::ranges::find(words, found ? lower_case(found->value) : std::string());
    if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
    Facts facts{{},
                {{"expected", fmt::format("{}", fmt::join(words, " or "))},
                 {"found", found ? fmt::format("\"{}\"", found->value.substr(0, 40)) : "none"}}};
    facts.names = {{"element_name", std::string(element.name())},
                   {"attribute", std::string(attribute)},
                   {"taken", std::string(words.front())}};
    warn(warning_of({"unknown_choice", std::move(facts)}, found ? found->place : element.place()));
    return 0;
  }

  bool flag_of(const Element& element) { return choice_of(element, "flag", {"no", "yes"}) == 1; }

  static std::optional<Element> child_of(const Element& element, std::string_view name) {
    for (const Element& child : element.children())
      if (child.name() == name) return child;
    return std::nullopt;
  }

  double child_real(const Element& element, std::string_view name, const Demand& demand) {
    const auto child = child_of(element, name);
    if (!child)
      throw InputError(element.place(), fmt::format("expected the element {} in {}, found none", name, element.name()));
    const Tokens tokens = child->tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter({element.name()});
    const double value = cursor.next_real(name, demand);
    keep_remainder(tokens, cursor);
    return value;
  }

  double child_real(const Element& element, std::string_view name) {
    return child_real(element, name, {});
  }

  std::array<double, 3> child_triple(const Element& element, std::string_view name) {
    const auto child = child_of(element, name);
    if (!child) return {};
    const Tokens tokens = child->tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter({element.name()});
    std::array<double, 3> values{};
    for (double& value : values) value = cursor.next_real(fmt::format("three numbers of {}", name));
    keep_remainder(tokens, cursor);
    return values;
  }

  double damping_of(const Element& element) {
    if (child_of(element, "Damping")) return child_real(element, "Damping", kNotNegative);
    warn(absent({"Damping", "0"}, element));
    return 0;
  }

  void keep_remainder(const Tokens& tokens, const Cursor& cursor) {
    if (cursor.numbers_left() > 0)
      refuse_decimal_commas(*tokens.map, tokens.text, tokens.start_of(0), tokens.end - tokens.start_of(0));
    for (Warning& warning : cursor.remainder()) add_warning(warnings_, std::move(warning));
  }

 private:
  Warnings warnings_;
};

class AnalysisReader {
 public:
  AnalysisReading read(const Element& element) {
    const std::vector<Element> children = element.children();
    analysis_.dialect = AnalysisDialect::ddaml;
    analysis_.gravity = 9.81;
    read_plane(children);
    for (const Element& child : children) read_child(child);
    require(element);
    warn_of_defaults(element);
    analysis_.place = {element.place().file};
    return {std::move(analysis_), values_.take_warnings()};
  }

 private:
  struct Handler {
    std::string_view name;
    void (AnalysisReader::*read)(const Element& element);
  };
  static const std::array<Handler, 19> kHandlers;

  /// Read before the materials in every order of elements: plane strain narrows Poisson's ratio.
  void read_plane(const std::vector<Element>& children) {
    for (const Element& child : children)
      if (child.name() == "Planestrain") analysis_.plane_strain = values_.flag_of(child);
  }

  void read_child(const Element& child) {
    if (std::ranges::find(kPassedOver, child.name()) != kPassedOver.end()) return;
    const auto handler = std::ranges::find(kHandlers, child.name(), &Handler::name);
    if (handler == kHandlers.end()) {
      values_.pass_over(child);
      return;
    }
    if (!seen_.insert(std::string(child.name())).second && !stands_often(child.name())) values_.warn(repeated(child));
    (this->*handler->read)(child);
  }

  static bool stands_often(std::string_view name) { return std::ranges::find(kManyTimes, name) != kManyTimes.end(); }

  void require(const Element& analysis) const {
    for (const std::string_view name : kRequired)
      if (!seen_.contains(std::string(name)))
        throw InputError(analysis.place(), fmt::format("expected the element {} in Analysis, found none", name));
    if (analysis_.block_materials.empty())
      throw InputError(analysis.place(), "expected a block material (Blockmaterial) in Analysis, found none");
    if (analysis_.joint_materials.empty())
      throw InputError(analysis.place(), "expected a joint material (Jointproperties) in Analysis, found none");
  }

  void warn_of_defaults(const Element& analysis) {
    for (const Default& choice : kDefaults)
      if (!seen_.contains(std::string(choice.element))) values_.warn(absent(choice, analysis));
  }

  void read_type(const Element& element) {
    analysis_.velocity_carry_over = values_.choice_of(element, "type", {"static", "dynamic"}) == 1 ? 1 : 0;
  }

  void read_rotation(const Element& element) {
    const bool linear = values_.choice_of(element, "type", {"linear", "secondorder", "exact"}) == 0;
    analysis_.rotation = linear ? Rotation::first_order : Rotation::exact;
  }

  void read_gravity(const Element& element) {
    if (values_.flag_of(element))
      values_.warn({"gravity_phase_ignored", element.place(), "the gravity phase before the analysis is not run"});
  }

  void read_acceleration(const Element& element) {
    analysis_.gravity = values_.attribute_real(element, "value", Demand{});
  }

  void read_automatic_step(const Element& element) { analysis_.automatic_time_step = values_.flag_of(element); }

  void read_automatic_penalty(const Element& element) {
    analysis_.automatic_penalty = values_.flag_of(element);
    if (element.attribute("pfactor"))
      analysis_.penalty_factor = values_.attribute_real(element, "pfactor", kPositive);
    else
      values_.warn(warning_of({"default_pfactor", {{{"pfactor", analysis_.penalty_factor}}}}, element.place()));
  }

  void pass_over(const Element&) {}  // Planestrain: read before the other elements

  void read_step_count(const Element& element) {
    analysis_.step_count = values_.attribute_integer(element, "timesteps", kStepCount);
  }

  void read_time_step(const Element& element) {
    analysis_.time_step_place = element.place();
    analysis_.time_step = values_.attribute_real(element, "maxtimestep", kPositive);
  }

  void read_displacement(const Element& element) {
    analysis_.allowed_displacement_ratio = values_.attribute_real(element, "maxdisplacement", kPositive);
  }

  void read_open_close_limit(const Element& element) {
    analysis_.open_close_limit = values_.attribute_integer(element, "maxopenclose", kAtLeastOne);
  }

  void read_save_interval(const Element& element) {
    const bool empty = !element.attribute("step") || element.attribute_tokens("step").word_count == 0;
    const int interval = empty ? 0 : values_.attribute_integer(element, "step", kNotNegative);
    analysis_.save_interval = interval == 0 ? 10 : interval;
  }

  void read_constants(const Element& element) {
    values_.warn_of_repeated(element, "last");
    OpenCloseConstants& constants = analysis_.open_close;
    for (const Element& child : element.children()) {
      const std::string_view name = child.name();
      if (name == "MinReflineFactor") continue;
      double* target = name == "Openclose"        ? &constants.closing_ratio
                       : name == "Opencriteria"   ? &constants.opening_ratio
                       : name == "NormSpringPen"  ? &constants.allowed_penetration
                       : name == "AngleOverlap"   ? &constants.angle_overlap_deg
                       : name == "ShearNormRatio" ? &constants.normal_to_shear_stiffness
                                                  : nullptr;
      if (target)
        *target = values_.attribute_real(child, "value", kPositive);
      else
        values_.pass_over(child);
    }
  }

  void read_contact_damping(const Element& element) {
    analysis_.contact_damping = values_.attribute_real(element, "value", kNotNegative);
  }

  void read_block_material(const Element& element) {
    values_.warn_of_repeated(element, "first");
    BlockMaterial material;
    material.place = element.place();
    material.density = values_.child_real(element, "Unitmass", kPositive);
    material.unit_weight = values_.child_real(element, "Unitweight");
    material.youngs_modulus = values_.child_real(element, "Youngsmod", kPositive);
    material.poissons_ratio =
        values_.child_real(element, "Poissonratio", analysis_.plane_strain ? kPoissonPlaneStrain : kPoissonPlaneStress);
    material.damping = values_.damping_of(element);
    const auto stress = values_.child_triple(element, "Istress");
    material.initial_stress = {stress[0], stress[1], stress[2]};
    const auto velocity = values_.child_triple(element, "Ivelocity");
    material.initial_velocity = {velocity[0], velocity[1], velocity[2]};
    material.initial_strain = values_.child_triple(element, "Istrain");
    analysis_.block_materials.push_back(material);
  }

  void read_joint_material(const Element& element) {
    values_.warn_of_repeated(element, "first");
    JointMaterial material;
    material.place = element.place();
    material.friction_angle_deg = values_.child_real(element, "Friction", kFrictionAngle);
    material.cohesion = values_.child_real(element, "Cohesion", kNotNegative);
    material.tensile_strength = values_.child_real(element, "Tensile", kNotNegative);
    analysis_.joint_materials.push_back(material);
  }

  void read_bolt_properties(const Element& element) {
    const Tokens tokens = element.tokens();
    Cursor cursor(tokens, kEndOfElement);
    cursor.enter({element.name()});
    BoltProperties properties;
    properties.stiffness = cursor.next_real("the stiffness", kNotNegative);
    properties.strength = cursor.next_real("the strength");
    properties.pretension = cursor.next_real("the pre-tension");
    values_.keep_remainder(tokens, cursor);
    analysis_.bolt_properties.push_back(properties);
  }

  void read_loads(const Element& element) {
    for (const Element& child : element.children()) {
      if (child.name() == "Loadpoint")
        analysis_.point_loads.push_back(load_curve(child));
      else
        values_.pass_over(child);
    }
  }

  TimeCurve load_curve(const Element& element) {
    const Demand two_or_more{{2}, "a whole number, 2 or more", true};
    const int rows = values_.attribute_integer(element, "numpoints", two_or_more);
    const Tokens tokens = element.tokens();
    Cursor cursor(tokens, kEndOfElement);
    TimeCurve curve;
    curve.place = element.place();
    for (int row = 0; row < rows; ++row) {
      cursor.enter({"load record", static_cast<std::size_t>(row) + 1, static_cast<std::size_t>(rows)});
      curve.times.push_back(row == 0 ? cursor.next_real("the time")
                                     : cursor.next_real_above(curve.times.back(), "the time"));
      const double x = cursor.next_real("the load in x");
      curve.values.push_back({x, cursor.next_real("the load in y")});
    }
    values_.keep_remainder(tokens, cursor);
    return curve;
  }

  Analysis analysis_;
  ElementValues values_;
  std::set<std::string> seen_;
};

const std::array<AnalysisReader::Handler, 19> AnalysisReader::kHandlers{{
    {"Analysistype", &AnalysisReader::read_type},
    {"Rotation", &AnalysisReader::read_rotation},
    {"Gravity", &AnalysisReader::read_gravity},
    {"Gravaccel", &AnalysisReader::read_acceleration},
    {"Autotimestep", &AnalysisReader::read_automatic_step},
    {"Autopenalty", &AnalysisReader::read_automatic_penalty},
    {"Planestrain", &AnalysisReader::pass_over},
    {"Numtimesteps", &AnalysisReader::read_step_count},
    {"Maxtimestep", &AnalysisReader::read_time_step},
    {"Maxdisplacement", &AnalysisReader::read_displacement},
    {"Opencloselimit", &AnalysisReader::read_open_close_limit},
    {"OCLimit", &AnalysisReader::read_open_close_limit},
    {"Saveinterval", &AnalysisReader::read_save_interval},
    {"AConstants", &AnalysisReader::read_constants},
    {"ContactDamping", &AnalysisReader::read_contact_damping},
    {"Blockmaterial", &AnalysisReader::read_block_material},
    {"Jointproperties", &AnalysisReader::read_joint_material},
    {"Boltproperties", &AnalysisReader::read_bolt_properties},
    {"Loadpointlist", &AnalysisReader::read_loads},
}};

}  // namespace

AnalysisReading read_analysis(const Element& analysis) {
  return AnalysisReader{}.read(analysis);
}

}  // namespace keyblock::formats
