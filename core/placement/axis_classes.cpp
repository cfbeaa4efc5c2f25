#include "core/placement/axis_classes.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "core/base/triple.h"
#include "core/placement/tolerance.h"

namespace geargraph {
namespace {

/// +1 or -1 where the lines coincide, pointing alike or against each other, else 0.
int coincide(const AxisLine& a, const AxisLine& b) {
  if (length(cross(a.direction, b.direction)) > kSameLine) return 0;
  const Vector3 between = b.point - a.point;
  const double size = 1 + length(a.point) + length(b.point);
  if (length(cross(a.direction, between)) > kSameLine * size) return 0;
  return dot(a.direction, b.direction) > 0 ? 1 : -1;
}

/// Sets of joints with the sense of each against its set's root.
class JointSets {
 public:
  struct Member {
    int up = 0;     ///< towards the root, which is its own
    int sense = 1;  ///< against `up`
  };

  explicit JointSets(std::size_t joints) : m_members(joints) {
    for (std::size_t i = 0; i < joints; ++i) m_members[i].up = static_cast<int>(i);
  }
  /// The set's root, and the joint's sense against it.
  Member find(int joint) {
    // Hangs all joints between this one and its root on the root itself, from the root down.
    m_walk.clear();
    for (int at = joint; m_members[at].up != at; at = m_members[at].up) m_walk.push_back(at);
    for (std::size_t i = m_walk.size(); i-- > 0;) {
      Member& member = m_members[m_walk[i]];
      const Member& up = m_members[member.up];
      if (up.up == member.up) continue;
      member = {up.up, member.sense * up.sense};
    }
    return m_members[joint];
  }
  /// `sense`: of b against a. The smaller root stays the root, so that the first joint gives the direction.
  void unite(int a, int b, int sense) {
    const Member rootA = find(a);
    const Member rootB = find(b);
    if (rootA.up == rootB.up) return;
    const auto [low, high] = std::minmax(rootA.up, rootB.up);
    m_members[high] = {low, rootA.sense * rootB.sense * sense};
  }

 private:
  std::vector<Member> m_members;
  std::vector<int> m_walk;
};

/// At each link, joins the joints there that lie on one line.
class Merger {
 public:
  Merger(const Mechanism& mechanism, const JointTree& tree, std::span<const AxisLine> lines)
      : m_mechanism(mechanism),
        m_tree(tree),
        m_lines(lines),
        m_sets(tree.joints.size()),
        m_firstAt(mechanism.axes.size(), -1) {}

  JointSets run(Diagnostics& diagnostics) {
    for (int link = 0; link < m_tree.graph->nodeCount(); ++link) {
      const std::span<const int> joints = m_tree.graph->turningEdgesAt(link);
      if (joints.size() > 1) joinAt(joints);
    }
    report(diagnostics);
    return std::move(m_sets);
  }

 private:
  void joinAt(std::span<const int> joints) {
    m_firstOfAxis.clear();
    for (const int joint : joints) {
      int& first = m_firstAt[m_tree.axisOf[joint]];
      if (first < 0) {
        first = joint;
        m_firstOfAxis.push_back(joint);
      } else {
        m_sets.unite(first, joint, 1);
      }
    }
    for (const int joint : m_firstOfAxis) m_firstAt[m_tree.axisOf[joint]] = -1;
    if (m_firstOfAxis.size() > 1) compareLines();
  }

  /// Compares the lines that may coincide: those whose keys are close. A key does not depend on the
  /// direction's sense, and its weights are arbitrary numbers that tell drawn lines apart.
  void compareLines() {
    m_keyed.clear();
    double farthest = 0;  // from the origin, squared
    for (const int joint : m_firstOfAxis) {
      const AxisLine& line = m_lines[m_tree.axisOf[joint]];
      if (line.automatic) continue;
      const Vector3& u = line.direction;
      const Vector3 foot = line.point - dot(line.point, u) * u;
      farthest = std::max(farthest, dot(line.point, line.point));
      m_keyed.push_back({dot(foot, Vector3{0.7310, 0.5179, 0.4451}) + 0.6133 * u[0] * u[0] +
                             0.2719 * u[1] * u[1] + 0.3557 * u[0] * u[1] + 0.1931 * u[1] * u[2] +
                             0.4373 * u[2] * u[0],
                         joint});
    }
    std::sort(m_keyed.begin(), m_keyed.end());
    const double size = 1 + std::sqrt(farthest);
    for (std::size_t i = 0; i < m_keyed.size(); ++i) {
      for (std::size_t k = i + 1;
           k < m_keyed.size() && m_keyed[k].first - m_keyed[i].first < 8 * kSameLine * size; ++k) {
        joinLines(m_keyed[i].second, m_keyed[k].second);
      }
    }
  }

  void joinLines(int a, int b) {
    const int axisA = m_tree.axisOf[a];
    const int axisB = m_tree.axisOf[b];
    const int sense = coincide(m_lines[axisA], m_lines[axisB]);
    if (sense == 0) return;
    m_sets.unite(a, b, sense);
    const std::pair<int, int> pair = std::minmax(axisA, axisB);
    m_merged.push_back({pair.first, pair.second, sense});
  }

  void report(Diagnostics& diagnostics) {
    std::sort(m_merged.begin(), m_merged.end());
    m_merged.erase(std::unique(m_merged.begin(), m_merged.end()), m_merged.end());
    for (const auto& [a, b, sense] : m_merged) {
      const AxisId first = m_mechanism.axes[a].id;
      const AxisId second = m_mechanism.axes[b].id;
      Diagnostic finding;
      finding.code = Code::mergedAxes;
      finding.message = "Axes " + first.text() + " and " + second.text() +
                        " are one line held by a common link: they are treated as one axis" +
                        (sense < 0 ? ", with opposite directions." : ".");
      finding.elements = {first, second};
      diagnostics.push_back(std::move(finding));
    }
  }

  struct Merged {
    int first = 0;
    int second = 0;
    int sense = 1;
    auto operator<=>(const Merged&) const = default;
  };

  const Mechanism& m_mechanism;
  const JointTree& m_tree;
  std::span<const AxisLine> m_lines;
  JointSets m_sets;
  std::vector<int> m_firstAt;  ///< by axis: its first joint at the link being treated, or -1
  std::vector<int> m_firstOfAxis;
  std::vector<std::pair<double, int>> m_keyed;
  std::vector<Merged> m_merged;
};

/// Is some axis named by joints of several classes?
bool anySplit(const JointTree& tree, const AxisClasses& classes, std::size_t axes) {
  std::vector<int> classOfAxis(axes, -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    int& of = classOfAxis[tree.axisOf[j]];
    if (of >= 0 && of != classes.classOf[j]) return true;
    of = classes.classOf[j];
  }
  return false;
}

void reportSplits(const Mechanism& mechanism, const JointTree& tree, const AxisClasses& classes,
                  Diagnostics& diagnostics) {
  if (!anySplit(tree, classes, mechanism.axes.size())) return;
  std::vector<std::vector<int>> classesOfAxis(mechanism.axes.size());
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    std::vector<int>& list = classesOfAxis[tree.axisOf[j]];
    const int of = classes.classOf[j];
    if (std::find(list.begin(), list.end(), of) == list.end()) list.push_back(of);
  }
  for (std::size_t a = 0; a < classesOfAxis.size(); ++a) {
    if (classesOfAxis[a].size() < 2) continue;
    Diagnostic finding;
    finding.code = Code::splitAxis;
    finding.elements = {mechanism.axes[a].id};
    std::string groups;
    for (const int of : classesOfAxis[a]) {
      const int joint = classes.classes[of].joint;
      groups += (groups.empty() ? "" : ", ") + std::to_string(mechanism.jointLabel(joint));
      finding.elements.emplace_back(mechanism.turningJoints[joint].id);
    }
    finding.message =
        "Axis " + mechanism.axes[a].id.text() + " is named by joints that share no link on it (" + groups +
        " ...): they coincide in the drawn pose only and are treated as different axes. Give each its "
        "own axis.";
    diagnostics.push_back(std::move(finding));
  }
}

}  // namespace

AxisClasses::AxisClasses(const Mechanism& mechanism, const JointTree& tree, std::span<const AxisLine> lines,
                         Diagnostics& diagnostics) {
  JointSets sets = Merger(mechanism, tree, lines).run(diagnostics);
  const int joints = static_cast<int>(tree.joints.size());
  classOf.resize(tree.joints.size());
  sense.resize(tree.joints.size());
  classes.reserve(tree.joints.size());
  for (int joint = 0; joint < joints; ++joint) {
    const auto [root, against] = sets.find(joint);  // a root stands before its set's other joints
    if (root == joint) {
      classOf[joint] = static_cast<int>(classes.size());
      classes.push_back({joint, tree.axisOf[joint], -1, 0});
    } else {
      classOf[joint] = classOf[root];
    }
    sense[joint] = against;
  }
  for (const int link : tree.order) {  // parents first: the first parent seen is the top
    if (link == 0) continue;
    Class& of = classes[classOf[tree.joint[link]]];
    if (of.top >= 0) continue;
    of.top = tree.parent[link];
    const int above = classOfLink(tree, of.top);
    of.depth = above < 0 ? 0 : classes[above].depth + 1;
  }
  reportSplits(mechanism, tree, *this, diagnostics);
}

}  // namespace geargraph
