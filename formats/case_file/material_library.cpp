// Declares the tables of the library and their sources.
// Young's modulus and Poisson's ratio of intact rock: means of Kulhawy (1978), as in AASHTO (2002), Standard
// Specifications for Highway Bridges, section 4.4.8; jointed rock is softer.
// Density: usual values of the rock, rounded.
// Friction of flat, unweathered joints: middle of the range of basic friction angles of dry surfaces, Barton & Choubey
// (1977), The shear strength of rock joints in theory and practice, table 1. Rough joints have more, filled and wet
// ones less. No joint has cohesion or tensile strength.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/material_library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/nearest.hpp"
#include "problem/units/unit_conversion.hpp"

namespace keyblock::formats {
namespace {

struct Rock {
  std::string_view name;
  double density;  ///< kg/m3
  double modulus;  ///< GPa
  double poisson;
};
constexpr std::array<Rock, 9> kRocks{{{"granite", 2650, 52.7, 0.20},
                                      {"gabbro", 3000, 75.8, 0.18},
                                      {"diabase", 2950, 88.3, 0.29},
                                      {"basalt", 2800, 56.1, 0.23},
                                      {"quartzite", 2650, 66.1, 0.14},
                                      {"gneiss", 2700, 61.1, 0.22},
                                      {"sandstone", 2350, 14.7, 0.20},
                                      {"limestone", 2600, 39.3, 0.23},
                                      {"dolostone", 2700, 29.1, 0.29}}};

struct Joint {
  std::string_view name;
  double least;  ///< degrees, dry
  double most;
};
constexpr std::array<Joint, 6> kJoints{{{"granite_joint", 31, 35},
                                        {"basalt_joint", 35, 38},
                                        {"gneiss_joint", 26, 29},
                                        {"sandstone_joint", 26, 35},
                                        {"limestone_joint", 31, 37},
                                        {"dolerite_joint", 36, 36}}};

template <class Rows>
std::vector<std::string> names_of(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}

template <class Rows>
std::string one_of_names(const Rows& rows, const std::string& name) {
  const std::vector<std::string> names = names_of(rows);
  return fmt::format("like: a name of the library, one of {}{}", fmt::join(names, ", "), nearest_words(name, names));
}

}  // namespace

std::string take_from_library(const std::string& name, const Units& units, BlockMaterial& material) {
  const auto rock = std::ranges::find(kRocks, name, &Rock::name);
  if (rock == kRocks.end()) return one_of_names(kRocks, name);
  const std::optional<double> density = si_factor(units, kDensity);
  const std::optional<double> stress = si_factor(units, kStress);
  if (!density || !stress)
    return "units of length, mass and time in the case whose material is like one of the library";
  material.density = rock->density / *density;
  material.youngs_modulus = rock->modulus * 1e9 / *stress;
  material.poissons_ratio = rock->poisson;
  return {};
}

std::string take_from_library(const std::string& name, const Units&, JointMaterial& material) {
  const auto joint = std::ranges::find(kJoints, name, &Joint::name);
  if (joint == kJoints.end()) return one_of_names(kJoints, name);
  material.friction_angle_deg = (joint->least + joint->most) / 2;
  return {};
}

std::vector<std::string> library_names(const BlockMaterial&) {
  return names_of(kRocks);
}

std::vector<std::string> library_names(const JointMaterial&) {
  return names_of(kJoints);
}

std::string library_tables() {
  std::string text = "| rock | density, kg/m3 | Young's modulus, GPa | Poisson's ratio |\n|---|---|---|---|\n";
  for (const Rock& rock : kRocks)
    text += fmt::format("| `{}` | {:g} | {:g} | {:g} |\n", rock.name, rock.density, rock.modulus, rock.poisson);
  text += "\n| joint | friction angle, degrees | range |\n|---|---|---|\n";
  for (const Joint& joint : kJoints)
    text += fmt::format("| `{}` | {:g} | {:g} to {:g} |\n", joint.name, (joint.least + joint.most) / 2, joint.least,
                        joint.most);
  return text;
}

}  // namespace keyblock::formats
