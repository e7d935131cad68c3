// Two made-up files that differ in all they can say show which values a profile takes from the file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/settings_guide.hpp"

#include <fmt/format.h>

#include "settings/profile.hpp"
#include "settings/settings_table.hpp"

namespace keyblock {
namespace {

Analysis one_file() {
  Analysis analysis;
  analysis.dialect = AnalysisDialect::shi;
  analysis.block_materials.resize(1);
  analysis.block_materials[0].density = analysis.block_materials[0].unit_weight = 1;
  analysis.block_materials[0].youngs_modulus = 1;
  analysis.joint_materials.resize(1);
  analysis.velocity_carry_over = 1;
  analysis.step_count = 1;
  analysis.time_step = 1;
  analysis.contact_penalty = 1;
  analysis.allowed_displacement_ratio = 1;
  return analysis;
}

Analysis another_file() {
  Analysis analysis = one_file();
  analysis.dialect = AnalysisDialect::ddaml;
  analysis.velocity_carry_over = 0;
  analysis.step_count = 2;
  analysis.time_step = 2;
  analysis.contact_penalty = 2;
  analysis.allowed_displacement_ratio = 2;
  analysis.gravity = 2;
  analysis.automatic_time_step = !analysis.automatic_time_step;
  analysis.automatic_penalty = !analysis.automatic_penalty;
  analysis.plane_strain = !analysis.plane_strain;
  analysis.rotation = analysis.rotation == Rotation::exact ? Rotation::first_order : Rotation::exact;
  analysis.open_close_limit += 1;
  for (double* constant : {&analysis.open_close.closing_ratio, &analysis.open_close.opening_ratio,
                           &analysis.open_close.allowed_penetration, &analysis.open_close.angle_overlap_deg,
                           &analysis.open_close.normal_to_shear_stiffness})
    *constant *= 2;
  return analysis;
}

struct Column {
  std::vector<SettingText> one, other;

  std::string value(std::size_t row) const {
    if (one[row].value != other[row].value) return "(file)";
    return one[row].value.empty() ? "-" : one[row].value;
  }
};

std::string word_for(const std::optional<Dynamics>& dynamics) {
  if (!dynamics) return "both";
  return *dynamics == Dynamics::shi ? "shi" : "standard";
}

}  // namespace

std::string settings_guide() {
  std::vector<Column> columns;
  std::string table = fmt::format("{:32} ", "setting");
  for (const std::string& profile : profile_names()) {
    columns.push_back({list(profile_settings(profile, one_file())), list(profile_settings(profile, another_file()))});
    table += fmt::format("{:15} ", profile);
  }
  table += fmt::format("{:9} meaning: permitted values\n", "read by");
  for (std::size_t row = 0; row < columns[0].one.size(); ++row) {
    const SettingText& setting = columns[0].one[row];
    table += fmt::format("{:32} ", setting.name);
    for (const Column& column : columns) table += fmt::format("{:15} ", column.value(row));
    table += fmt::format("{:9} {}: {}\n", word_for(setting.dynamics), setting.meaning, setting.expected);
  }
  return table +
         "(file): taken from the analysis file; of its step, or that of --set, draft takes twice and reference a "
         "quarter, over the same time. \"read by\": the dynamics that read it.\n";
}

}  // namespace keyblock
