// Declares the tables of titles, groups and words, in the order of case_fields.hpp and of fields.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/case_file/schema/case_titles.hpp"

#include <algorithm>
#include <array>

#include "formats/case_file/case_meanings.hpp"

namespace keyblock::formats {
namespace {

struct KeyTitle {
  std::string_view key;  ///< with the key above it if the title depends on it
  std::string_view title;
};

// Keys whose words do not make a title.
constexpr auto kTitles = std::to_array<KeyTitle>({
    {"$schema", "Schema"},
    {"keyblock", "Version of the layout"},
    {"x", "x"},
    {"y", "y"},
    {"x1", "Start x"},
    {"y1", "Start y"},
    {"x2", "End x"},
    {"y2", "End y"},
    {"edge_node_ratio", "Merging distance"},
    {"boundary_count", "Number of boundary lines"},
    {"bolts.type", "Type of bolt"},
    {"covers", "NMM bodies"},
    {"cover", "Elements and covers"},
    {"functions", "Cover functions"},
    {"covers.contact", "Contact of bodies"},
    {"mesh.kind", "Kind of mesh"},
    {"mesh.side", "Side of triangles"},
    {"mesh.shape", "Shape of triangles"},
    {"mesh.angle", "Rotation of the mesh"},
    {"mesh.error", "Permitted error of stresses"},
    {"mesh.materials", "Meshed materials"},
    {"through_x", "x of a node"},
    {"through_y", "y of a node"},
    {"refined", "Refined points"},
    {"tip_side", "Side at crack tips"},
    {"along", "Chain of points"},
    {"held", "Prescribed components"},
    {"displacements.normal", "Outward component"},
    {"force_x", "Force x"},
    {"force_y", "Force y"},
    {"direction_x", "Direction x"},
    {"direction_y", "Direction y"},
    {"xx", "xx"},
    {"yy", "yy"},
    {"xy", "xy"},
    {"zz", "zz"},
    {"corrector", "Corrected direction"},
    {"youngs_modulus", "Young's modulus"},
    {"poissons_ratio", "Poisson's ratio"},
    {"initial_stress_zz", "Initial stress zz"},
    {"stress_gradient_zz", "Stress gradient zz"},
    {"like", "Entry of the library"},
    {"surface", "Yield surface"},
    {"matching", "Match of the cone"},
    {"after", "Strength after yielding"},
    {"mode_1", "Toughness K_Ic"},
    {"mode_2", "Toughness K_IIc"},
    {"motion", "Ground motion"},
    {"set.motion", "Kind of steps"},
    {"run.set", "Settings"},
    {"stages.set", "Settings"},
    {"layers", "Layers of the drawing"},
    {"drawing_unit", "Unit of the drawing"},
    {"join", "Joining distance"},
    {"joint_materials.from", "Joint material before"},
    {"joint_materials.to", "Joint material after"},
    {"held_points", "Fixed points"},
    {"released", "Released regions"},
    {"removes_forces", "Ends earlier forces"},
    {"velocity_x", "Velocity x"},
    {"velocity_y", "Velocity y"},
    {"velocity_rotation", "Rate of rotation"},
    {"stress_xx", "Stress xx"},
    {"stress_yy", "Stress yy"},
    {"stress_xy", "Stress xy"},
    {"displacement_x", "Displacement x"},
    {"displacement_y", "Displacement y"},
    {"is_broken", "Broken"},
});

struct KeyGroup {
  std::string_view parent;
  std::string_view key;
  std::string_view group;
};

constexpr auto kGroups = std::to_array<KeyGroup>({
    {"case", "units", "Case"},
    {"case", "drawing", "Geometry"},
    {"case", "blocks", "Geometry"},
    {"case", "cover", "Geometry"},
    {"case", "layers", "Geometry"},
    {"case", "drawing_unit", "Geometry"},
    {"case", "join", "Geometry"},
    {"case", "covers", "Bodies"},
    {"case", "analysis", "Bodies"},
    {"case", "motion", "Run"},
    {"case", "run", "Run"},
    {"case", "outputs", "Run"},
    {"case", "stages", "Run"},
    {"case", "frames", "Results"},
    {"case", "tracks", "Results"},
    {"case", "keyblock", "Case"},
    {"case", "$schema", "Case"},
    {"analysis", "step_count", "Time steps"},
    {"analysis", "time_step", "Time steps"},
    {"analysis", "allowed_displacement_ratio", "Time steps"},
    {"analysis", "automatic_time_step", "Time steps"},
    {"analysis", "velocity_carry_over", "Time steps"},
    {"analysis", "save_interval", "Time steps"},
    {"analysis", "gravity", "Loads"},
    {"analysis", "body_acceleration", "Loads"},
    {"analysis", "point_loads", "Loads"},
    {"analysis", "fixed_point_motions", "Loads"},
    {"analysis", "contact_penalty", "Contact"},
    {"analysis", "penalty_factor", "Contact"},
    {"analysis", "automatic_penalty", "Contact"},
    {"analysis", "open_close", "Contact"},
    {"analysis", "open_close_limit", "Contact"},
    {"analysis", "plane_strain", "Materials"},
    {"analysis", "block_materials", "Materials"},
    {"analysis", "joint_materials", "Materials"},
    {"analysis", "bolt_properties", "Materials"},
    {"analysis", "dialect", "Old files"},
    {"analysis", "rotation", "Old files"},
    {"analysis", "contact_damping", "Old files"},
    {"analysis", "over_relaxation", "Old files"},
    {"block_materials", "initial_stress", "Initial state"},
    {"block_materials", "initial_stress_zz", "Initial state"},
    {"block_materials", "stress_gradient", "Initial state"},
    {"block_materials", "stress_gradient_zz", "Initial state"},
    {"block_materials", "initial_velocity", "Initial state"},
    {"block_materials", "strength", "Strength and cracks"},
    {"block_materials", "crack_closure", "Strength and cracks"},
    {"block_materials", "toughness", "Strength and cracks"},
    {"block_materials", "damping", "Old files"},
    {"block_materials", "initial_strain", "Old files"},
    {"block_materials", "horizontal_force", "Old files"},
    {"covers", "tractions", "Loads"},
    {"covers", "forces", "Loads"},
    {"covers", "body_force", "Loads"},
    {"covers", "initial_stress_field", "Loads"},
    {"covers", "displacements", "Supports"},
    {"covers", "springs", "Supports"},
    {"covers", "cracks", "Cracks and excavation"},
    {"covers", "growth", "Cracks and excavation"},
    {"covers", "excavations", "Cracks and excavation"},
    {"stages", "excavations", "Excavation"},
    {"stages", "cuts", "Excavation"},
    {"stages", "bolts", "Supports and loads"},
    {"stages", "removed_bolts", "Supports and loads"},
    {"stages", "held_points", "Supports and loads"},
    {"stages", "released", "Supports and loads"},
    {"stages", "forces", "Supports and loads"},
    {"stages", "removes_forces", "Supports and loads"},
    {"stages", "block_materials", "Materials"},
    {"stages", "joint_materials", "Materials"},
    {"stages", "mesh", "Materials"},
    {"stages", "profile", "Settings"},
    {"stages", "set", "Settings"},
});

struct WordMeaning {
  std::string_view key;
  std::string_view word;
  std::string_view meaning;
};

constexpr auto kWords = std::to_array<WordMeaning>({
    {"functions", "constant", "2 unknowns per cover, first order"},
    {"functions", "derived", "2 unknowns per cover, second order"},
    {"functions", "linear", "6 unknowns per cover, second order"},
    {"functions", "quadratic", "12 unknowns per cover, third order"},
    {"contact", "felt", "bodies and sides of a joint touch"},
    {"contact", "ignored", "bodies pass through each other; linear statics"},
    {"kind", "regular", "rows of equal triangles"},
    {"kind", "unstructured", "Delaunay triangles, smaller at refined points"},
    {"shape", "equilateral", "equal sides"},
    {"shape", "old", "1.3 times as wide as high"},
    {"placement", "free", "centred on the bodies"},
    {"placement", "aligned", "rows or sides along edges"},
    {"tip_functions", "none", "no near-tip functions"},
    {"tip_functions", "williams", "four near-tip functions, in linear statics"},
    {"held", "both", "x and y"},
    {"held", "normal", "component along the normal"},
    {"held", "x", "x component"},
    {"held", "y", "y component"},
    {"criterion", "hoop_stress", "largest hoop stress"},
    {"criterion", "strain_energy", "least strain energy density"},
    {"criterion", "energy_release", "largest energy release"},
    {"loads", "automatic", "scaled in statics of NMM bodies, else given"},
    {"loads", "scaled", "loads multiplied until a tip reaches its toughness"},
    {"loads", "given", "loads unchanged"},
    {"dialect", "berkeley", "the Berkeley program"},
    {"dialect", "shi", "Shi's DDA"},
    {"dialect", "ddaml", "DDAML"},
    {"dialect", "manifold", "Shi's manifold program"},
    {"rotation", "first_order", "linear in the angle"},
    {"rotation", "exact", "sine and cosine"},
    {"surface", "tresca", "reads cohesion"},
    {"surface", "von_mises", "reads yield_stress"},
    {"surface", "mohr_coulomb", "reads cohesion and angles"},
    {"surface", "drucker_prager", "cone, reads cohesion and angles"},
    {"matching", "compression", "triaxial compression"},
    {"matching", "extension", "triaxial extension"},
    {"matching", "plane_strain", "plane strain with associated flow"},
    {"contacts", "automatic", "all, thinned in long tables"},
    {"contacts", "all", "all contacts"},
    {"contacts", "chosen", "contacts of histories"},
    {"contacts", "none", "no contacts"},
});

constexpr auto kSections = std::to_array<CaseSection>({
    {"Joint materials", "joint material", "analysis", "joint_materials"},
    {"Block materials", "block material", "analysis", "block_materials"},
    {"Analysis", "", "", "analysis"},
    {"Run", "", "", "run"},
    {"Units", "", "", "units"},
    {"Stages", "stage", "", "stages"},
    {"Bolt properties", "type of bolt", "analysis", "bolt_properties"},
    {"NMM bodies", "", "", "covers"},
    {"Outputs", "", "", "outputs"},
});

std::string spelt_out(std::string_view key) {
  if (key.ends_with("_deg")) key.remove_suffix(4);
  std::string title(key);
  std::ranges::replace(title, '_', ' ');
  std::ranges::replace(title, '.', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

}  // namespace

std::string title_of(std::string_view parent, std::string_view key) {
  const std::string full = std::string(parent) + '.' + std::string(key);
  for (const std::string_view wanted : {std::string_view(full), key}) {
    const auto found = std::ranges::find(kTitles, wanted, &KeyTitle::key);
    if (found != kTitles.end()) return std::string(found->title);
  }
  return spelt_out(key);
}

std::string_view group_of(std::string_view parent, std::string_view key) {
  const auto found =
      std::ranges::find_if(kGroups, [&](const KeyGroup& row) { return row.parent == parent && row.key == key; });
  return found == kGroups.end() ? std::string_view("General") : found->group;
}

std::string_view meaning_of(std::string_view parent, std::string_view key) {
  const std::string full = std::string(parent) + '.' + std::string(key);
  for (const std::string_view wanted : {std::string_view(full), key}) {
    const auto found = std::ranges::find(case_meanings(), wanted, &CaseMeaning::key);
    if (found != case_meanings().end()) return found->meaning;
  }
  return {};
}

std::string_view meaning_of_word(std::string_view key, std::string_view word) {
  const auto found =
      std::ranges::find_if(kWords, [&](const WordMeaning& row) { return row.key == key && row.word == word; });
  return found == kWords.end() ? std::string_view() : found->meaning;
}

std::span<const CaseSection> case_sections() {
  return kSections;
}

}  // namespace keyblock::formats
