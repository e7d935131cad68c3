// Writes DDAML element by element, in the order of Berkeley's examples.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/berkeley/ddaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "formats/shi/analysis_parts.hpp"
#include "formats/text/numbers.hpp"

namespace keyblock::formats {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    text += format_real(value);
  }
  return text;
}

std::string numbers(const Segment& segment) {
  return numbers({segment.start.x, segment.start.y, segment.end.x, segment.end.y});
}

bool is_same(const BoltProperties& a, const BoltProperties& b) {
  return a.stiffness == b.stiffness && a.strength == b.strength && a.pretension == b.pretension;
}

/// Bolts have their own properties in native files, but a type in DDAML. Bolts with properties get types after the
/// existing ones.
void give_bolts_types(Content& content) {
  for (BoltLine& bolt : content.drawing->bolts) {
    const BoltProperties own{bolt.stiffness, bolt.strength, bolt.pretension};
    if (is_same(own, {})) continue;
    if (!content.analysis) throw std::invalid_argument("DDAML holds the properties of bolts in its analysis only");
    std::vector<BoltProperties>& all = content.analysis->bolt_properties;
    const auto found = std::ranges::find_if(all, [&](const BoltProperties& known) { return is_same(known, own); });
    bolt.type = static_cast<int>(found - all.begin());
    if (found == all.end()) all.push_back(own);
  }
}

class Writer {
 public:
  std::string write(Content content) {
    if (!content.drawing && !content.analysis) throw std::invalid_argument("DDAML needs a drawing or an analysis");
    if (content.drawing) give_bolts_types(content);
    text_ = fmt::format(
        "<?xml version=\"1.0\" standalone=\"no\"?>\n<!DOCTYPE DDA SYSTEM \"{}.dtd\">\n"
        "<Berkeley:DDA xmlns:Berkeley=\"http://www.tsoft.com/~bdoolin/dda\">\n",
        content.drawing ? "geometry" : "analysis");
    text_ += "<!-- Berkeley's reader needs a comment here. -->\n";
    if (content.drawing) write(*content.drawing);
    if (content.analysis) write(*content.analysis);
    return text_ + "</Berkeley:DDA>\n";
  }

 private:
  void write(const Drawing& drawing) {
    line("<Geometry>");
    line("<Edgenodedist distance=\"{}\"/>", format_real(drawing.edge_node_ratio));
    const auto boundaries = drawing.joints.begin() + static_cast<std::ptrdiff_t>(drawing.boundary_count);
    list("Boundlist", std::vector<JointLine>(drawing.joints.begin(), boundaries), [](const JointLine& boundary) {
      const std::string type =
          boundary.joint_material == 0 ? "" : fmt::format(" type=\"{}\"", boundary.joint_material + 1);
      return fmt::format("<Line{}> {} </Line>", type, numbers(boundary.segment));
    });
    list("Jointlist", std::vector<JointLine>(boundaries, drawing.joints.end()), [](const JointLine& joint) {
      return fmt::format("<Joint type=\"{}\"> {} </Joint>", joint.joint_material + 1, numbers(joint.segment));
    });
    list("Matlinelist", drawing.material_lines, [](const MaterialLine& material) {
      return fmt::format("<Line type=\"{}\"> {} </Line>", material.block_material + 1, numbers(material.segment));
    });
    list("Boltlist", drawing.bolts, [](const BoltLine& bolt) {
      return fmt::format("<Bolt type=\"{}\"> {} </Bolt>", bolt.type + 1, numbers(bolt.segment));
    });
    list("Fixedpointlist", drawing.fixed_lines,
         [](const FixedLine& fixed) { return fmt::format("<Line> {} </Line>", numbers(fixed.segment)); });
    list("Loadpointlist", drawing.loading_points, point_text);
    list("Measuredpointlist", drawing.measured_points, point_text);
    list("Holepointlist", drawing.hole_points, point_text);
    line("</Geometry>");
  }

  static std::string point_text(const MarkedPoint& point) {
    return fmt::format("<Point> {} </Point>", numbers({point.position.x, point.position.y}));
  }

  void write(const Analysis& analysis) {
    if (analysis.velocity_carry_over != 0 && analysis.velocity_carry_over != 1)
      throw std::invalid_argument("DDAML is static or dynamic: it holds no velocity carry-over between 0 and 1");
    const std::string_view type = analysis.velocity_carry_over == 1 ? "dynamic" : "static";
    line("<Analysis type=\"{}\">", type);
    line("<Analysistype type=\"{}\"/>", type);
    line("<Rotation type=\"{}\"/>", analysis.rotation == Rotation::exact ? "exact" : "linear");
    line("<Gravity flag=\"no\"/>");
    line("<Gravaccel value=\"{}\"/>", format_real(gravity_of(analysis)));
    line("<Autotimestep flag=\"{}\"/>", yes_or_no(analysis.automatic_time_step));
    line("<Autopenalty flag=\"{}\" pfactor=\"{}\"/>", yes_or_no(analysis.automatic_penalty),
         format_real(penalty_factor_of(analysis)));
    line("<Planestrain flag=\"{}\"/>", yes_or_no(analysis.plane_strain));
    line("<Numtimesteps timesteps=\"{}\"/>", analysis.step_count);
    line("<Maxtimestep maxtimestep=\"{}\"/>", format_real(analysis.time_step));
    line("<Maxdisplacement maxdisplacement=\"{}\"/>", format_real(analysis.allowed_displacement_ratio));
    line("<Opencloselimit maxopenclose=\"{}\"/>", analysis.open_close_limit);
    if (analysis.save_interval) line("<Saveinterval step=\"{}\"/>", *analysis.save_interval);
    write(analysis.open_close);
    line("<ContactDamping value=\"{}\"/>", format_real(analysis.contact_damping));
    for (std::size_t i = 0; i < analysis.block_materials.size(); ++i) write(analysis.block_materials[i], i + 1);
    for (std::size_t i = 0; i < analysis.joint_materials.size(); ++i) write(analysis.joint_materials[i], i + 1);
    for (const BoltProperties& bolt : analysis.bolt_properties)
      line("<Boltproperties> {} </Boltproperties>", numbers({bolt.stiffness, bolt.strength, bolt.pretension}));
    list("Loadpointlist", analysis.point_loads, [](const TimeCurve& curve) { return load_text(curve); });
    line("</Analysis>");
  }

  void write(const OpenCloseConstants& constants) {
    line("<AConstants>");
    line("<Openclose value=\"{}\"/>", format_real(constants.closing_ratio));
    line("<Opencriteria value=\"{}\"/>", format_real(constants.opening_ratio));
    line("<NormSpringPen value=\"{}\"/>", format_real(constants.allowed_penetration));
    line("<AngleOverlap value=\"{}\"/>", format_real(constants.angle_overlap_deg));
    line("<ShearNormRatio value=\"{}\"/>", format_real(constants.normal_to_shear_stiffness));
    line("</AConstants>");
  }

  void write(const BlockMaterial& material, std::size_t number) {
    const Stress& stress = material.initial_stress;
    const Velocity& velocity = material.initial_velocity;
    const auto& strain = material.initial_strain;
    line("<Blockmaterial type=\"{}\">", number);
    value("Unitmass", {material.density});
    value("Unitweight", {material.unit_weight});
    value("Youngsmod", {material.youngs_modulus});
    value("Poissonratio", {material.poissons_ratio});
    value("Damping", {material.damping});
    value("Istress", {stress.xx, stress.yy, stress.xy});
    value("Ivelocity", {velocity.x, velocity.y, velocity.rotation});
    value("Istrain", {strain[0], strain[1], strain[2]});
    line("</Blockmaterial>");
  }

  void write(const JointMaterial& material, std::size_t number) {
    line("<Jointproperties type=\"{}\">", number);
    value("Friction", {material.friction_angle_deg});
    value("Cohesion", {material.cohesion});
    value("Tensile", {material.tensile_strength});
    line("</Jointproperties>");
  }

  /// The format requires at least two rows: a constant or zero load is written as two.
  static std::string load_text(const TimeCurve& curve) {
    TimeCurve rows = curve;
    if (rows.times.empty()) rows.times.push_back(0), rows.values.push_back({});
    rows = with_two_rows(std::move(rows));
    std::string text = fmt::format("<Loadpoint numpoints=\"{}\">", rows.times.size());
    for (std::size_t i = 0; i < rows.times.size(); ++i)
      text += fmt::format(" {};", numbers({rows.times[i], rows.values[i].x, rows.values[i].y}));
    return text + " </Loadpoint>";
  }

  static std::string_view yes_or_no(bool flag) { return flag ? "yes" : "no"; }

  /// Native files state weights: gravity is the value that Berkeley's program derives from them.
  static double gravity_of(const Analysis& analysis) {
    if (analysis.gravity || analysis.block_materials.empty()) return analysis.gravity.value_or(0);
    return analysis.block_materials.front().unit_weight / analysis.block_materials.front().density;
  }

  static double penalty_factor_of(const Analysis& analysis) {
    const double largest = largest_modulus(analysis);
    return analysis.contact_penalty && largest > 0 ? *analysis.contact_penalty / largest : analysis.penalty_factor;
  }

  template <typename... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    text_ += fmt::format(format, std::forward<Values>(values)...) + '\n';
  }

  void value(std::string_view name, std::initializer_list<double> values) {
    line("<{}> {} </{}>", name, numbers(values), name);
  }

  template <typename Item, typename TextOf>
  void list(std::string_view name, const std::vector<Item>& items, TextOf text_of) {
    if (items.empty()) return;
    line("<{}>", name);
    for (const Item& item : items) line("{}", text_of(item));
    line("</{}>", name);
  }

  std::string text_;
};

}  // namespace

std::string ddaml_text(const Content& content) {
  return Writer{}.write(content);
}

}  // namespace keyblock::formats
