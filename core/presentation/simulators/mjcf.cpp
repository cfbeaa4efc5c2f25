#include <algorithm>
#include <cmath>

#include "core/presentation/simulators/simulator_model.h"
#include "core/presentation/simulators/xml_text.h"

namespace geargraph {
namespace {

constexpr double kRotor = 100;  // times the inertia that the input feels
constexpr const char* kHardConstraint = "0.9999 0.9999 0.001 0.5 2";
constexpr double kServoGain = 0.1;  // of what would turn the whole inertia in one step: stable, and stiff

class MjcfWriter {
 public:
  MjcfWriter(const SimulatorModel& model, const SimulatorOptions& options)
      : m_model(model), m_options(options), m_children(model.links.size()) {
    for (const LinkOrdinal link : model.order) {
      m_children[at(link).parent].push_back(link);
      m_hasLimits = m_hasLimits || isLimited(at(link));
    }
    for (const SimulatedInput& input : model.inputs) {
      if (options.motor != SimulatorMotor::speed) continue;
      m_rotors.emplace_back(input.joint, options.armature.value_or(kRotor * input.inertia));
    }
    if (options.motor == SimulatorMotor::torque && options.armature) {
      for (const SimulatedInput& input : model.inputs) m_rotors.emplace_back(input.joint, *options.armature);
    }
  }

  std::string write() {
    line("<mujoco" + xmlAttribute("model", m_model.name.empty() ? "mechanism" : m_model.name) + ">");
    ++m_depth;
    comments();
    line(R"(<compiler angle="radian" autolimits="true" inertiafromgeom="false"/>)");
    line("<option" + xmlAttribute("timestep", xmlNumber(m_options.timestep)) +
         xmlAttribute("integrator", "Euler") + xmlAttribute("gravity", xmlVector(m_model.gravity)) + ">");
    line(R"(  <flag contact="disable" eulerdamp="disable"/>)");
    line("</option>");
    line("<default>");
    if (m_hasLimits) {
      line("  <joint" + xmlAttribute("solreflimit", stiffness()) +
           xmlAttribute("solimplimit", kHardConstraint) + "/>");
    }
    line(R"(  <geom type="mesh" contype="0" conaffinity="0" group="1"/>)");
    line("  <equality" + xmlAttribute("solref", stiffness()) + xmlAttribute("solimp", kHardConstraint) +
         "/>");
    line("</default>");
    assets();
    line("<worldbody>");
    ++m_depth;
    geom(m_model.links.front());
    for (const LinkOrdinal link : m_children.front()) body(link);
    --m_depth;
    line("</worldbody>");
    rows();
    actuators();
    sensors();
    keyframe();
    --m_depth;
    line("</mujoco>");
    return std::move(m_text);
  }

 private:
  static bool isLimited(const SimulatedLink& link) {
    return std::isfinite(link.limits.low) || std::isfinite(link.limits.high);
  }
  /// As hard as the time step allows.
  [[nodiscard]] std::string stiffness() const { return xmlNumber(2 * m_options.timestep) + " 1"; }
  /// MuJoCo wants both ends: an open one is some hundred thousand turns away.
  static std::string rangeOf(const AngleLimits& limits) {
    constexpr double kOpen = 1e6;  // rad
    return xmlNumber(std::isfinite(limits.low) ? limits.low : -kOpen) + ' ' +
           xmlNumber(std::isfinite(limits.high) ? limits.high : kOpen);
  }
  [[nodiscard]] const SimulatedLink& at(LinkOrdinal link) const {
    return m_model.links[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] const std::string& joint(int ordinal) const {
    return m_model.joints[static_cast<std::size_t>(ordinal)];
  }
  void line(const std::string& text) {
    m_text += std::string(2 * static_cast<std::size_t>(m_depth), ' ') + text + '\n';
  }
  void comment(const std::string& text) { line(xmlComment(text)); }

  /// English in every language of the program: users of other programs read them.
  void comments() {
    comment(
        "Written by GearGraph. Lengths in m, masses in kg, angles in rad. Bodies and joints bear the ids of "
        "links and turning joints.");
    comment(
        "Every gear mesh is a fixed tendon that an equality holds at 0: its length is the slip along the "
        "pitch circles in m, its force the tangential tooth force in N.");
    comment("Masses follow from the solids at " + xmlNumber(m_model.density) +
            " kg/m3 where the document states none. There is no contact, no friction and no clearance.");
    if (m_hasLimits && m_options.motor == SimulatorMotor::speed) {
      comment(
          "Joints stop at their limits, with the servos still pushing: the key frame \"back\" drives them "
          "the "
          "other way.");
    }
    if (m_options.motor == SimulatorMotor::speed && !m_model.inputs.empty()) {
      comment(
          "The rotors (armature) of the inputs are an assumption, so that servos hold their speeds under "
          "load. "
          "Models with motors that take torques have none.");
    }
    const bool hasCouplings =
        std::any_of(m_model.rows.begin(), m_model.rows.end(),
                    [](const SimulatedRow& row) { return row.name.starts_with("coupling"); });
    if (hasCouplings) {
      comment(
          "Shifting while it runs: set eq_data[0] of a coupling to its tendon's present length, less "
          "tendon_length0, before it becomes active; else it turns the links back.");
    }
    for (const SimulatorNote& note : m_model.notes) comment(note.inEnglish);
  }

  void assets() {
    line("<asset>");
    for (const SimulatedLink& link : m_model.links) {
      if (link.mesh.empty()) continue;
      const std::string scale = xmlNumber(m_model.metres);
      line("  <mesh" + xmlAttribute("name", meshName(link)) + xmlAttribute("file", link.mesh) +
           xmlAttribute("scale", scale + ' ' + scale + ' ' + scale) + "/>");
    }
    line("</asset>");
  }
  static std::string meshName(const SimulatedLink& link) { return "link " + link.name; }

  void geom(const SimulatedLink& link) {
    if (link.mesh.empty()) return;
    line("<geom" + xmlAttribute("mesh", meshName(link)) + xmlAttribute("pos", xmlVector(-link.origin)) +
         "/>");
  }

  void body(int ordinal) {
    const SimulatedLink& link = at(ordinal);
    line("<body" + xmlAttribute("name", link.name) +
         xmlAttribute("pos", xmlVector(link.origin - at(link.parent).origin)) + ">");
    ++m_depth;
    if (link.isBall) comment("This link has no solid: a ball of a bearing's size.");
    std::string hinge =
        "<joint" + xmlAttribute("name", link.jointName) + xmlAttribute("axis", xmlVector(link.axis));
    for (const auto& [rotorJoint, armature] : m_rotors) {
      if (rotorJoint == link.joint) hinge += xmlAttribute("armature", xmlNumber(armature));
    }
    if (isLimited(link)) hinge += xmlAttribute("range", rangeOf(link.limits));
    line(hinge + "/>");
    const Eigen::Matrix3d& inertia = link.body.inertia;
    line("<inertial" + xmlAttribute("pos", xmlVector(link.body.center - link.origin)) +
         xmlAttribute("mass", xmlNumber(link.body.mass)) +
         xmlAttribute("fullinertia", xmlVector(inertia.diagonal()) + ' ' + xmlNumber(inertia(0, 1)) + ' ' +
                                         xmlNumber(inertia(0, 2)) + ' ' + xmlNumber(inertia(1, 2))) +
         "/>");
    geom(link);
    for (const int child : m_children[ordinal]) body(child);
    --m_depth;
    line("</body>");
  }

  void rows() {
    if (m_model.rows.empty()) return;
    line("<tendon>");
    for (const SimulatedRow& row : m_model.rows) {
      line("  <fixed" + xmlAttribute("name", row.name) + ">");
      for (const auto& [ordinal, coefficient] : row.joints) {
        line("    <joint" + xmlAttribute("joint", joint(ordinal)) +
             xmlAttribute("coef", xmlNumber(coefficient)) + "/>");
      }
      line("  </fixed>");
    }
    line("</tendon>");
    line("<equality>");
    for (const SimulatedRow& row : m_model.rows) {
      line("  <tendon" + xmlAttribute("name", row.name) + xmlAttribute("tendon1", row.name) +
           (row.isActive ? "" : xmlAttribute("active", "false")) + "/>");
    }
    line("</equality>");
  }

  void actuators() {
    if (m_model.inputs.empty() || m_options.motor == SimulatorMotor::none) return;
    line("<actuator>");
    for (const SimulatedInput& input : m_model.inputs) {
      const std::string name =
          xmlAttribute("name", joint(input.joint)) + xmlAttribute("joint", joint(input.joint));
      if (m_options.motor == SimulatorMotor::torque) {
        line("  <motor" + name + "/>");
        continue;
      }
      const double whole = input.inertia + m_options.armature.value_or(kRotor * input.inertia);
      line("  <velocity" + name + xmlAttribute("kv", xmlNumber(kServoGain * whole / m_options.timestep)) +
           "/>");
    }
    line("</actuator>");
  }

  void sensors() {
    line("<sensor>");
    for (const std::string& name : m_model.joints)
      line("  <jointvel" + xmlAttribute("name", "speed " + name) + xmlAttribute("joint", name) + "/>");
    if (m_options.motor != SimulatorMotor::none) {
      for (const SimulatedInput& input : m_model.inputs) {
        line("  <actuatorfrc" + xmlAttribute("name", "torque " + joint(input.joint)) +
             xmlAttribute("actuator", joint(input.joint)) + "/>");
      }
    }
    for (const SimulatedRow& row : m_model.rows) {
      line("  <tendonpos" + xmlAttribute("name", "slip " + row.name) + xmlAttribute("tendon", row.name) +
           "/>");
    }
    line("</sensor>");
  }

  void keyframe() {
    if (m_model.inputs.empty() || m_options.motor != SimulatorMotor::speed) return;
    std::string forth;
    std::string back;
    for (const SimulatedInput& input : m_model.inputs) {
      forth += (forth.empty() ? "" : " ") + xmlNumber(input.speed);
      back += (back.empty() ? "" : " ") + xmlNumber(-input.speed);
    }
    line("<keyframe>");
    line("  <key" + xmlAttribute("name", "drive") + xmlAttribute("ctrl", forth) + "/>");
    if (m_hasLimits) line("  <key" + xmlAttribute("name", "back") + xmlAttribute("ctrl", back) + "/>");
    line("</keyframe>");
  }

  const SimulatorModel& m_model;
  const SimulatorOptions& m_options;
  ByLink<std::vector<int>> m_children;
  std::vector<std::pair<int, double>> m_rotors;  ///< joint, armature
  bool m_hasLimits = false;
  std::string m_text;
  int m_depth = 0;
};

}  // namespace

std::string mjcfText(const SimulatorModel& model, const SimulatorOptions& options) {
  return MjcfWriter(model, options).write();
}

}  // namespace geargraph
