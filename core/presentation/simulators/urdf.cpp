#include <algorithm>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/simulators/simulator_model.h"
#include "core/presentation/simulators/xml_text.h"

namespace geargraph {
namespace {

/// The inputs that a joint follows, by position.
std::vector<std::size_t> leadersOf(const std::vector<Rational>& gains) {
  std::vector<std::size_t> leaders;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    if (!gains[i].isZero()) leaders.push_back(i);
  }
  return leaders;
}

/// "Joint 12 follows 8 and 9 (q12 = -1/3 q8 - 2/3 q9)"
std::string severalLeaders(const SimulatorModel& model, std::size_t joint) {
  std::vector<std::string> names;
  std::string sum;
  for (const std::size_t i : leadersOf(model.gains[joint])) {
    const Rational& gain = model.gains[joint][i];
    const std::string& name = model.joints[static_cast<std::size_t>(model.inputs[i].joint)];
    names.push_back(name);
    const bool isNegative = gain.sign() < 0;
    sum += sum.empty() ? (isNegative ? "-" : "") : (isNegative ? " - " : " + ");
    sum += (isNegative ? -gain : gain).toString() + " q" + name;
  }
  return translated("Joint %1 follows %2 (q%1 = %3)", {model.joints[joint], listed(names, kAllNames), sum});
}

class UrdfWriter {
 public:
  explicit UrdfWriter(const SimulatorModel& model) : m_model(model) {}

  /// The comments are English in every language of the program: users of other programs read them.
  std::string write() {
    m_text = "<?xml version=\"1.0\"?>\n<robot" +
             xmlAttribute("name", m_model.name.empty() ? "mechanism" : m_model.name) + ">\n";
    comment(
        "Written by GearGraph. Lengths in m, masses in kg, angles in rad. Links and joints bear the ids of "
        "links and turning joints.");
    comment(
        "Gears are mimic joints: each follows one input. Some programs leave mimic out; MuJoCo and Gazebo "
        "with bullet-featherstone do not.");
    comment("Masses follow from the solids at " + xmlNumber(m_model.density) +
            " kg/m3 where the document states none. Limits of joints are not written.");
    const bool hasFixed = std::any_of(m_model.order.begin(), m_model.order.end(),
                                      [this](LinkOrdinal link) { return leadersOf(gainsOf(link)).empty(); });
    if (hasFixed) comment("Joints that cannot turn are fixed; Gazebo joins their links to their parents.");
    for (const SimulatorNote& note : m_model.notes) comment(note.inEnglish);
    m_text += "  <link name=\"world\"/>\n";
    m_text += "  <joint name=\"world joint\" type=\"fixed\">\n    <parent link=\"world\"/>\n    <child" +
              xmlAttribute("link", m_model.links.front().name) + "/>\n  </joint>\n";
    link(m_model.links.front());
    for (const int ordinal : m_model.order) {
      const SimulatedLink& each = m_model.links[static_cast<std::size_t>(ordinal)];
      link(each);
      joint(each);
    }
    m_text += "</robot>\n";
    return std::move(m_text);
  }

 private:
  [[nodiscard]] const std::vector<Rational>& gainsOf(LinkOrdinal link) const {
    return m_model.gains[m_model.links[static_cast<std::size_t>(link)].joint];
  }
  void comment(const std::string& text) { m_text += "  " + xmlComment(text) + "\n"; }

  /// A ground without mass makes some readers drop the whole tree.
  void link(const SimulatedLink& each) {
    constexpr double kGround = 1;  // kg, kg m²: it does not move
    MassProperties body = each.body;
    if (each.link == 0 && body.mass <= 0) {
      body.mass = kGround;
      body.center = each.origin;
      body.inertia = kGround * Eigen::Matrix3d::Identity();
    }
    const Eigen::Matrix3d& inertia = body.inertia;
    m_text += "  <link" + xmlAttribute("name", each.name) + ">\n";
    if (each.isBall && each.link != 0) comment("This link has no solid: a ball of a bearing's size.");
    m_text += "    <inertial>\n      <origin" + xmlAttribute("xyz", xmlVector(body.center - each.origin)) +
              "/>\n      <mass" + xmlAttribute("value", xmlNumber(body.mass)) + "/>\n      <inertia" +
              xmlAttribute("ixx", xmlNumber(inertia(0, 0))) + xmlAttribute("ixy", xmlNumber(inertia(0, 1))) +
              xmlAttribute("ixz", xmlNumber(inertia(0, 2))) + xmlAttribute("iyy", xmlNumber(inertia(1, 1))) +
              xmlAttribute("iyz", xmlNumber(inertia(1, 2))) + xmlAttribute("izz", xmlNumber(inertia(2, 2))) +
              "/>\n    </inertial>\n";
    if (!each.mesh.empty()) {
      const std::string scale = xmlNumber(m_model.metres);
      m_text += "    <visual>\n      <origin" + xmlAttribute("xyz", xmlVector(-each.origin)) +
                "/>\n      <geometry><mesh" + xmlAttribute("filename", each.mesh) +
                xmlAttribute("scale", scale + ' ' + scale + ' ' + scale) + "/></geometry>\n    </visual>\n";
    }
    m_text += "  </link>\n";
  }

  void joint(const SimulatedLink& child) {
    const std::vector<std::size_t> leaders = leadersOf(gainsOf(child.link));
    const SimulatedLink& parent = m_model.links[static_cast<std::size_t>(child.parent)];
    m_text += "  <joint" + xmlAttribute("name", child.jointName) +
              xmlAttribute("type", leaders.empty() ? "fixed" : "continuous") + ">\n    <origin" +
              xmlAttribute("xyz", xmlVector(child.origin - parent.origin)) + "/>\n    <parent" +
              xmlAttribute("link", parent.name) + "/>\n    <child" + xmlAttribute("link", child.name) +
              "/>\n    <axis" + xmlAttribute("xyz", xmlVector(child.axis)) + "/>\n";
    if (!leaders.empty()) {
      const int leader = m_model.inputs[leaders.front()].joint;
      if (leader != child.joint) {
        m_text += "    <mimic" + xmlAttribute("joint", m_model.joints[static_cast<std::size_t>(leader)]) +
                  xmlAttribute("multiplier", xmlNumber(gainsOf(child.link)[leaders.front()].toDouble())) +
                  xmlAttribute("offset", "0") + "/>\n";
      }
    }
    m_text += "  </joint>\n";
  }

  const SimulatorModel& m_model;
  std::string m_text;
};

}  // namespace

std::variant<std::string, SimulatorError> urdfText(const SimulatorModel& model) {
  constexpr std::size_t kMaxNamed = 3;
  std::vector<std::string> several;
  std::size_t count = 0;
  for (std::size_t joint = 0; joint < model.gains.size(); ++joint) {
    if (leadersOf(model.gains[joint]).size() < 2) continue;
    if (++count <= kMaxNamed) several.push_back(severalLeaders(model, joint));
  }
  if (count > 0) {
    std::string named;
    for (const std::string& each : several) named += (named.empty() ? "" : "; ") + each;
    if (count > kMaxNamed) named = translated("%1; and %2 more", {named, std::to_string(count - kMaxNamed)});
    return SimulatorError{
        SimulatorError::Kind::model,
        translated(
            "A joint of URDF can follow one other joint. %1. Use --to mjcf, or --state with one freedom.",
            {named})};
  }
  return UrdfWriter(model).write();
}

}  // namespace geargraph
