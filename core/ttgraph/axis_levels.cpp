#include "core/ttgraph/axis_levels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>

#include "core/base/wording.h"
#include "core/ttgraph/wording.h"

namespace geargraph {
namespace {

// 1. Joints are told apart by the positions of their axes in the document.
// 2. At each link, take one joint for each of its axes; the others of that axis are united with it.
// 3. Compare the lines of those few, sorted by a number that equal lines share, and unite what is collinear.
// 4. Number the levels by their first joints; give senses, names and findings.
class Classifier {
 public:
  Classifier(const Mechanism& mechanism, const Digraph& graph, const ReferenceLines& lines)
      : m_mechanism(mechanism), m_graph(graph), m_lines(lines), m_parent(joints()), m_axisOf(graph.axisOf()) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  AxisLevels run() {
    uniteAtLinks();
    number();
    giveNames();
    reportSplits();
    reportMerges();
    return std::move(m_levels);
  }

 private:
  struct Candidate {
    double key = 0;
    int joint = 0;
  };

  [[nodiscard]] std::size_t joints() const { return m_mechanism.turningJoints.size(); }
  [[nodiscard]] const AxisLine* lineOf(int joint) const {
    return m_lines.axis(m_axisOf[static_cast<std::size_t>(joint)]);
  }

  int rootOf(int joint) {
    while (m_parent[static_cast<std::size_t>(joint)] != joint) {
      int& up = m_parent[static_cast<std::size_t>(joint)];
      joint = up = m_parent[static_cast<std::size_t>(up)];
    }
    return joint;
  }

  /// The smaller root stays, so that a level is known by its first joint.
  void unite(int a, int b) {
    const auto [low, high] = std::minmax({rootOf(a), rootOf(b)});
    m_parent[static_cast<std::size_t>(high)] = low;
  }

  void uniteAtLinks() {
    std::vector<int> seenAs(m_mechanism.axes.size(), -1);
    std::vector<Candidate> different;
    for (int link = 0; link < m_graph.nodeCount(); ++link) {
      const std::span<const int> here = m_graph.turningEdgesAt(link);
      if (here.size() < 2) continue;
      different.clear();
      for (const int joint : here) {
        int& first = seenAs[static_cast<std::size_t>(m_axisOf[static_cast<std::size_t>(joint)])];
        if (first >= 0) {
          unite(first, joint);
          continue;
        }
        first = joint;
        const AxisLine* line = lineOf(joint);
        if (line != nullptr && !line->automatic) different.push_back({0, joint});
      }
      if (different.size() > 1) uniteCollinear(different);
      for (const int joint : here) {
        seenAs[static_cast<std::size_t>(m_axisOf[static_cast<std::size_t>(joint)])] = -1;
      }
    }
  }

  /// A number that changes little where a line changes little, and not with its direction's sign: a slanted
  /// view of its foot below the origin, relative to `size`, and of the products of its direction.
  static double keyOf(const AxisLine& line, double size) {
    const Vector3& u = line.direction;
    const Vector3 foot = line.point - dot(line.point, u) * u;
    return dot(foot, Vector3{0.51, 0.67, 0.54}) / size + 0.31 * u[0] * u[0] + 0.47 * u[1] * u[1] +
           0.83 * u[0] * u[1] + 0.71 * u[1] * u[2] + 0.59 * u[0] * u[2];
  }

  void uniteCollinear(std::vector<Candidate>& different) {
    constexpr double kWindow = 1e-5;  // above what areCollinear() lets pass
    double farthest = 0;              // from the origin, squared
    for (const Candidate& candidate : different) {
      const Vector3& point = lineOf(candidate.joint)->point;
      farthest = std::max(farthest, dot(point, point));
    }
    const double size = 1 + std::sqrt(farthest);
    for (Candidate& candidate : different) candidate.key = keyOf(*lineOf(candidate.joint), size);
    std::sort(different.begin(), different.end(),
              [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
    for (std::size_t a = 0; a < different.size(); ++a) {
      for (std::size_t b = a + 1; b < different.size() && different[b].key - different[a].key <= kWindow;
           ++b) {
        if (areCollinear(*lineOf(different[a].joint), *lineOf(different[b].joint))) {
          unite(different[a].joint, different[b].joint);
        }
      }
    }
  }

  void number() {
    m_levels.ofJoint.reserve(joints());
    m_levels.sense.reserve(joints());
    m_levels.firstJoint.reserve(joints());
    m_levels.axis.reserve(joints());
    for (int j = 0; j < static_cast<int>(joints()); ++j) {
      const int first = rootOf(j);
      const int axis = m_axisOf[static_cast<std::size_t>(j)];
      m_levels.sense.push_back(1);
      if (first == j) {
        m_levels.ofJoint.push_back(m_levels.count());
        m_levels.firstJoint.push_back(j);
        m_levels.axis.push_back(axis);
        continue;
      }
      const int level = m_levels.ofJoint[static_cast<std::size_t>(first)];
      m_levels.ofJoint.push_back(level);
      if (axis == m_levels.axis[static_cast<std::size_t>(level)]) continue;
      if (dot(lineOf(first)->direction, lineOf(j)->direction) < 0) m_levels.sense.back() = -1;
      m_joined.emplace(axis, level);
    }
  }

  void giveNames() {
    std::unordered_set<std::string> taken;  // needed where an axis splits only
    std::vector<char> used(m_mechanism.axes.size(), 0);
    m_levels.axisIds.reserve(m_levels.axis.size());
    for (int level = 0; level < m_levels.count(); ++level) {
      const int axis = m_levels.axis[static_cast<std::size_t>(level)];
      m_levels.axisIds.push_back(m_mechanism.axes[static_cast<std::size_t>(axis)].id);
      if (std::exchange(used[static_cast<std::size_t>(axis)], 1) == 0) continue;
      if (taken.empty()) {
        for (const Axis& other : m_mechanism.axes) taken.insert(other.id.text());
      }
      m_split.insert(axis);
      std::string name = m_levels.axisIds.back().text();
      while (!taken.insert(name).second) name += "'";
      m_levels.primedNames.emplace(level, std::move(name));
    }
  }

  [[nodiscard]] std::string labelOfJoint(std::size_t joint) const {
    return std::to_string(m_mechanism.jointLabel(static_cast<int>(joint)));
  }

  void reportSplits() {
    // An axis splits where it gives two levels their lines, or one and joins another's.
    if (m_joined.empty() && m_split.empty()) return;
    const std::unordered_set<int> own(m_levels.axis.begin(), m_levels.axis.end());
    for (auto joined = m_joined.begin(); joined != m_joined.end(); ++joined) {
      const auto next = std::next(joined);
      const int axis = joined->first;
      if (own.contains(axis) || (next != m_joined.end() && next->first == axis)) m_split.insert(axis);
    }
    for (const int axis : m_split) reportSplit(axis);
  }

  void reportSplit(int axis) {
    std::vector<int> levels;
    for (std::size_t j = 0; j < joints(); ++j) {
      const int found = m_levels.ofJoint[j];
      if (m_axisOf[j] == axis && std::find(levels.begin(), levels.end(), found) == levels.end())
        levels.push_back(found);
    }
    Diagnostic finding;
    finding.code = Code::splitAxis;
    const AxisId id = m_mechanism.axes[static_cast<std::size_t>(axis)].id;
    finding.elements.emplace_back(id);
    std::vector<std::string> labels;
    std::vector<std::string> names;
    for (std::size_t j = 0; j < joints(); ++j) {
      if (m_axisOf[j] != axis) continue;
      labels.push_back(labelOfJoint(j));
      finding.elements.emplace_back(m_mechanism.turningJoints[j].id);
    }
    for (const int found : levels) names.push_back(m_levels.name(found));
    finding.message = "Turning joints " + listed(labels, kMostNames) + " name one axis (" + id.text() +
                      ") but do not all hang together on it by common links: they coincide only in the drawn "
                      "pose and are treated as different axes (" +
                      listed(names, kMostNames) + "). Give each axis of the mechanism its own entry in axes.";
    m_levels.diagnostics.push_back(std::move(finding));
  }

  void reportMerges() {
    std::map<int, std::vector<int>> others;  // by level: the other axes on it
    for (const auto& [axis, level] : m_joined) others[level].push_back(axis);
    for (auto& [level, axes] : others) {
      axes.insert(axes.begin(), m_levels.axis[static_cast<std::size_t>(level)]);
      reportMerge(level, axes);
    }
  }

  void reportMerge(int level, const std::vector<int>& axes) {
    Diagnostic finding;
    finding.code = Code::mergedAxes;
    std::vector<std::string> names;
    std::vector<std::string> opposite;
    const Vector3& along = m_lines.axis(axes.front())->direction;
    for (const int axis : axes) {
      const AxisId id = m_mechanism.axes[static_cast<std::size_t>(axis)].id;
      names.push_back(id.text());
      finding.elements.emplace_back(id);
      if (dot(m_lines.axis(axis)->direction, along) < 0) opposite.push_back(id.text());
    }
    finding.message = "Axes " + listed(names, kMostNames) +
                      " are one line held by common links: they are treated as one axis (" +
                      m_levels.name(level) + ").";
    if (!opposite.empty()) {
      finding.message += " The opposite direction of " + listed(opposite, kMostNames) + " is minded.";
    }
    m_levels.diagnostics.push_back(std::move(finding));
  }

  const Mechanism& m_mechanism;
  const Digraph& m_graph;
  const ReferenceLines& m_lines;
  std::vector<int> m_parent;      ///< union-find over joints
  std::span<const int> m_axisOf;  ///< by joint: its axis, by position
  AxisLevels m_levels;
  std::set<int> m_split;                   ///< axes that fall into several levels
  std::set<std::pair<int, int>> m_joined;  ///< (axis, level of another axis that it lies on)
};

}  // namespace

AxisLevels axisLevels(const Mechanism& mechanism, const Digraph& graph, const ReferenceLines& lines) {
  return Classifier(mechanism, graph, lines).run();
}

}  // namespace geargraph
