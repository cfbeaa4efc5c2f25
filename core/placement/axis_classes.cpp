#include "core/placement/axis_classes.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <string>

#include "core/base/triple.h"
#include "core/placement/tolerance.h"

namespace geargraph {
namespace {

struct Line {
  Vector3 point;
  Vector3 direction;  ///< unit
};

Vector3 valuesOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

std::vector<std::optional<Line>> linesOf(const Mechanism& mechanism) {
  std::vector<std::optional<Line>> lines;
  lines.reserve(mechanism.axes.size());
  for (const Axis& axis : mechanism.axes) {
    if (axis.point && axis.direction) {
      lines.push_back(Line{valuesOf(*axis.point), unit(valuesOf(*axis.direction))});
    } else {
      lines.emplace_back();
    }
  }
  return lines;
}

/// +1 or -1 where the lines coincide, pointing alike or against each other, else 0.
int coincide(const Line& a, const Line& b) {
  if (length(cross(a.direction, b.direction)) > kSameLine) return 0;
  const Vector3 between = b.point - a.point;
  const double size = 1 + length(a.point) + length(b.point);
  if (length(cross(a.direction, between)) > kSameLine * size) return 0;
  return dot(a.direction, b.direction) > 0 ? 1 : -1;
}

/// Sets of joints with the sense of each against its set's root.
class JointSets {
 public:
  explicit JointSets(std::size_t joints) : m_up(joints), m_sense(joints, 1) {
    std::iota(m_up.begin(), m_up.end(), 0);
  }
  int root(int joint) {
    compress(joint);
    return m_up[joint];
  }
  int senseToRoot(int joint) {
    compress(joint);
    return m_sense[joint];
  }
  /// `sense`: of b against a. The smaller root stays the root, so that the first joint gives the direction.
  void unite(int a, int b, int sense) {
    const int rootA = root(a);
    const int rootB = root(b);
    if (rootA == rootB) return;
    const int between = senseToRoot(a) * senseToRoot(b) * sense;
    const int high = std::max(rootA, rootB);
    m_up[high] = std::min(rootA, rootB);
    m_sense[high] = between;
  }

 private:
  /// Hangs all joints between this one and its root on the root itself, from the root down.
  void compress(int joint) {
    m_walk.clear();
    for (int at = joint; m_up[at] != at; at = m_up[at]) m_walk.push_back(at);
    for (std::size_t i = m_walk.size(); i-- > 0;) {
      const int at = m_walk[i];
      const int up = m_up[at];
      if (m_up[up] == up) continue;
      m_sense[at] *= m_sense[up];
      m_up[at] = m_up[up];
    }
  }

  std::vector<int> m_up;
  std::vector<int> m_sense;
  std::vector<int> m_walk;
};

/// At each link, joins the joints there that lie on one line.
class Merger {
 public:
  Merger(const Mechanism& mechanism, const JointTree& tree)
      : m_mechanism(mechanism),
        m_tree(tree),
        m_lines(linesOf(mechanism)),
        m_sets(tree.joints.size()),
        m_firstAt(mechanism.axes.size(), -1) {}

  JointSets run(Diagnostics& diagnostics) {
    for (std::size_t link = 0; link + 1 < m_tree.aroundStart.size(); ++link) {
      const auto first = static_cast<std::size_t>(m_tree.aroundStart[link]);
      joinAt(std::span(m_tree.around)
                 .subspan(first, static_cast<std::size_t>(m_tree.aroundStart[link + 1]) - first));
    }
    report(diagnostics);
    return m_sets;
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
    compareLines();
  }

  /// Compares the lines that may coincide: those whose keys are close. A key does not depend on the
  /// direction's sense, and its weights are arbitrary numbers that tell drawn lines apart.
  void compareLines() {
    m_keyed.clear();
    double size = 1;
    for (const int joint : m_firstOfAxis) {
      const auto& line = m_lines[m_tree.axisOf[joint]];
      if (!line) continue;
      const Vector3& u = line->direction;
      const Vector3 foot = line->point - dot(line->point, u) * u;
      size = std::max(size, 1 + length(line->point));
      m_keyed.push_back({dot(foot, Vector3{0.7310, 0.5179, 0.4451}) + 0.6133 * u[0] * u[0] +
                             0.2719 * u[1] * u[1] + 0.3557 * u[0] * u[1] + 0.1931 * u[1] * u[2] +
                             0.4373 * u[2] * u[0],
                         joint});
    }
    std::sort(m_keyed.begin(), m_keyed.end());
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
    if (!m_lines[axisA] || !m_lines[axisB]) return;
    const int sense = coincide(*m_lines[axisA], *m_lines[axisB]);
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
  std::vector<std::optional<Line>> m_lines;
  JointSets m_sets;
  std::vector<int> m_firstAt;  ///< by axis: its first joint at the link being treated, or -1
  std::vector<int> m_firstOfAxis;
  std::vector<std::pair<double, int>> m_keyed;
  std::vector<Merged> m_merged;
};

void reportSplits(const Mechanism& mechanism, const JointTree& tree, const AxisClasses& classes,
                  Diagnostics& diagnostics) {
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

AxisClasses::AxisClasses(const Mechanism& mechanism, const JointTree& tree, Diagnostics& diagnostics) {
  JointSets sets = Merger(mechanism, tree).run(diagnostics);
  classOf.assign(tree.joints.size(), -1);
  sense.assign(tree.joints.size(), 1);
  std::vector<int> classOfRoot(tree.joints.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const int joint = static_cast<int>(j);
    const int root = sets.root(joint);
    if (classOfRoot[root] < 0) {
      classOfRoot[root] = static_cast<int>(classes.size());
      classes.push_back({joint, tree.axisOf[joint], 0, 0});
    }
    classOf[j] = classOfRoot[root];
    sense[j] = sets.senseToRoot(joint);
  }
  std::vector<char> seen(classes.size(), 0);
  for (const int link : tree.order) {  // parents first: the first parent seen is the top
    if (link == 0) continue;
    const int of = classOf[tree.joint[link]];
    if (seen[of] != 0) continue;
    seen[of] = 1;
    const int top = tree.parent[link];
    const int above = classOfLink(tree, top);
    classes[of].top = top;
    classes[of].depth = above < 0 ? 0 : classes[above].depth + 1;
  }
  reportSplits(mechanism, tree, *this, diagnostics);
}

}  // namespace geargraph
