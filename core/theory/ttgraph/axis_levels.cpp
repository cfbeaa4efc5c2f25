#include "core/theory/ttgraph/axis_levels.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <memory_resource>
#include <numeric>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>

#include "core/foundations/base/scratch.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/theory/ttgraph/wording.h"

namespace geargraph {
namespace {

// 1. Every axis of the document gets a number that equal lines share.
// 2. At each link, sort the joints by these numbers: those of one axis, and those whose lines may be one,
//    come to stand together. Unite what is of one axis or collinear.
// 3. Number the levels by their first joints; give senses, names and diagnostics.
class Classifier {
 public:
  Classifier(const Mechanism& mechanism, const Digraph& graph, const ReferenceLines& lines)
      : m_mechanism(mechanism),
        m_graph(graph),
        m_lines(lines),
        m_comparison(mechanism, graph, lines.axes()),
        m_parent(joints(), &m_scratch),
        m_keys(&m_scratch),
        m_here(&m_scratch),
        m_axisOf(graph.axisOf()) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  AxisLevels run() {
    giveKeys();
    for (LinkOrdinal link = 0; link < m_graph.nodeCount(); ++link) {
      const std::span<const int> here = m_graph.turningEdgesAt(link);
      if (here.size() > 1) uniteAt(here);
    }
    number();
    giveNames();
    reportSplits();
    reportMerges();
    return std::move(m_levels);
  }

 private:
  static constexpr double kNoLine = std::numeric_limits<double>::infinity();

  struct Candidate {
    double key = 0;
    AxisOrdinal axis = 0;
    JointOrdinal joint = 0;
  };

  [[nodiscard]] std::size_t joints() const { return m_mechanism.turningJoints.size(); }

  /// The smaller root stays, so that a level is known by its first joint.
  int rootOf(JointOrdinal joint) {
    while (m_parent[static_cast<std::size_t>(joint)] != joint) {
      int& up = m_parent[static_cast<std::size_t>(joint)];
      joint = up = m_parent[static_cast<std::size_t>(up)];
    }
    return joint;
  }
  void unite(int a, int b) {
    const auto [low, high] = std::minmax({rootOf(a), rootOf(b)});
    m_parent[static_cast<std::size_t>(high)] = low;
  }

  /// A number that changes little where a line changes little, and not with its direction's sign: a slanted
  /// view of its foot, and of its direction squared. An axis without a line of its author's gets none.
  void giveKeys() {
    constexpr Vector3 kView{0.51, 0.67, 0.54};
    const LineKeys keys(m_lines.axes());
    m_window = keys.window;
    m_keys.reserve(m_mechanism.axes.size());
    for (const AxisLine& line : m_lines.axes()) m_keys.push_back(keys.of(line, kView));
    m_keys.resize(m_mechanism.axes.size(), kNoLine);
  }

  void uniteAt(std::span<const int> here) {
    m_here.clear();
    for (const JointOrdinal joint : here) {
      const AxisOrdinal axis = m_axisOf[joint];
      if (isSliding(joint)) {
        uniteSlides(joint, here);
        continue;
      }
      m_here.push_back({m_keys[static_cast<std::size_t>(axis)], axis, joint});
    }
    std::sort(m_here.begin(), m_here.end(), [](const Candidate& a, const Candidate& b) {
      return a.key != b.key ? a.key < b.key : a.axis < b.axis;
    });
    for (std::size_t a = 0; a + 1 < m_here.size(); ++a) uniteWithNext(a);
  }

  [[nodiscard]] bool isSliding(JointOrdinal joint) const { return slides(m_mechanism.turningJoints[joint]); }

  /// With those before it that slide the same way.
  void uniteSlides(JointOrdinal joint, std::span<const int> here) {
    for (const JointOrdinal other : here) {
      if (other == joint) return;
      if (isSliding(other) && slideTogether(joint, other)) unite(joint, other);
    }
  }
  [[nodiscard]] bool slideTogether(JointOrdinal joint, JointOrdinal other) const {
    const AxisOrdinal a = m_axisOf[joint];
    const AxisOrdinal b = m_axisOf[other];
    if (a == b) return true;
    const AxisLine* const one = m_lines.axis(a);
    const AxisLine* const two = m_lines.axis(b);
    if (one == nullptr || two == nullptr || one->automatic || two->automatic) return false;
    return areParallel(one->direction, two->direction);
  }

  void uniteWithNext(std::size_t first) {
    const Candidate& a = m_here[first];
    for (std::size_t next = first + 1; next < m_here.size(); ++next) {
      const Candidate& b = m_here[next];
      if (a.axis == b.axis) {
        unite(a.joint, b.joint);
        return;  // what follows is as near to this one, which is on the same axis
      }
      if (!(b.key - a.key <= m_window)) return;
      if (m_comparison.coincidence(a.axis, b.axis) != 0) unite(a.joint, b.joint);
    }
  }

  void number() {
    m_levels.ofJoint.reserve(joints());
    m_levels.axes.reserve(joints());
    for (int j = 0; j < static_cast<int>(joints()); ++j) {
      const AxisOrdinal axis = m_axisOf[j];
      const int earlier = m_parent[static_cast<std::size_t>(j)];  // of the same level
      if (earlier == j) {
        m_levels.ofJoint.push_back(m_levels.count());
        m_levels.axes.push_back({axis, m_mechanism.axes[axis].id, m_mechanism.turningJoints[j].kind});
        continue;
      }
      const int level = m_levels.ofJoint[earlier];
      m_levels.ofJoint.push_back(level);
      const int along = m_levels.axisOf(level);
      if (axis == along) continue;
      if (dot(m_lines.axis(along)->direction, m_lines.axis(axis)->direction) < 0) {
        m_levels.reversed.insert(j);
      }
      if (!m_levels.isSliding(level)) m_joined.emplace(axis, level);
    }
  }

  void giveNames() {
    std::unordered_set<std::string> taken;  // needed where an axis splits only
    std::pmr::vector<char> used(m_mechanism.axes.size(), 0, &m_scratch);
    for (int level = 0; level < m_levels.count(); ++level) {
      const auto& [axis, id, kind] = m_levels.axes[static_cast<std::size_t>(level)];
      const char before =
          std::exchange(used[static_cast<std::size_t>(axis)], m_levels.isSliding(level) ? 2 : 1);
      if (before == 0) continue;
      if (taken.empty()) {
        for (const Axis& other : m_mechanism.axes) taken.insert(other.id.text());
      }
      if (before == 1 && kind == JointKind::turning) m_split.insert(axis);
      std::string name = id.text();
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
    std::unordered_set<int> own;
    for (const AxisLevels::Axis& axis : m_levels.axes) {
      if (axis.kind == JointKind::turning) own.insert(axis.position);
    }
    for (auto joined = m_joined.begin(); joined != m_joined.end(); ++joined) {
      const auto next = std::next(joined);
      const AxisOrdinal axis = joined->first;
      if (own.contains(axis) || (next != m_joined.end() && next->first == axis)) m_split.insert(axis);
    }
    for (const AxisOrdinal axis : m_split) reportSplit(axis);
  }

  void reportSplit(AxisOrdinal axis) {
    std::vector<int> levels;
    for (std::size_t j = 0; j < joints(); ++j) {
      const int found = m_levels.ofJoint[j];
      if (m_axisOf[j] == axis && !m_levels.isSliding(found) &&
          std::find(levels.begin(), levels.end(), found) == levels.end())
        levels.push_back(found);
    }
    Diagnostic diagnostic;
    diagnostic.code = Code::splitAxis;
    const AxisId id = m_mechanism.axes[axis].id;
    diagnostic.elements.emplace_back(id);
    std::vector<std::string> labels;
    std::vector<std::string> names;
    for (std::size_t j = 0; j < joints(); ++j) {
      if (m_axisOf[j] != axis || m_levels.isSliding(m_levels.ofJoint[j])) continue;
      labels.push_back(labelOfJoint(j));
      diagnostic.elements.emplace_back(m_mechanism.turningJoints[j].id);
    }
    for (const int found : levels) names.push_back(m_levels.name(found));
    diagnostic.message = translated(
        "Turning joints %1 name one axis (%2) but do not all hang together on it by common links: they "
        "coincide "
        "only in the drawn pose and are treated as different axes (%3). Give each axis of the mechanism its "
        "own "
        "entry in axes.",
        {listed(labels, kMaxNames), id.text(), listed(names, kMaxNames)});
    m_levels.diagnostics.push_back(std::move(diagnostic));
  }

  void reportMerges() {
    std::map<int, std::vector<int>> others;  // by level: the other axes on it
    for (const auto& [axis, level] : m_joined) others[level].push_back(axis);
    for (auto& [level, axes] : others) {
      axes.insert(axes.begin(), m_levels.axisOf(level));
      reportMerge(level, axes);
    }
  }

  void reportMerge(int level, const std::vector<int>& axes) {
    Diagnostic diagnostic;
    diagnostic.code = Code::mergedAxes;
    std::vector<std::string> names;
    std::vector<std::string> opposite;
    const Vector3& along = m_lines.axis(axes.front())->direction;
    for (const AxisOrdinal axis : axes) {
      const AxisId id = m_mechanism.axes[axis].id;
      names.push_back(id.text());
      diagnostic.elements.emplace_back(id);
      if (dot(m_lines.axis(axis)->direction, along) < 0) opposite.push_back(id.text());
    }
    diagnostic.message =
        translated("Axes %1 are one line held by common links: they are treated as one axis (%2).",
                   {listed(names, kMaxNames), m_levels.name(level)});
    if (!opposite.empty())
      diagnostic.message +=
          ' ' + translated("The opposite direction of %1 is minded.", {listed(opposite, kMaxNames)});
    m_levels.diagnostics.push_back(std::move(diagnostic));
  }

  const Mechanism& m_mechanism;
  const Digraph& m_graph;
  const ReferenceLines& m_lines;
  LineComparison m_comparison;
  Scratch<> m_scratch;
  std::pmr::vector<int> m_parent;   ///< union-find over joints
  std::pmr::vector<double> m_keys;  ///< by axis
  double m_window = 0;              ///< by how much those of one line may differ
  std::pmr::vector<Candidate> m_here;
  SpanByJoint<const int> m_axisOf;  ///< their axes
  AxisLevels m_levels;
  std::set<int> m_split;                   ///< axes that fall into several levels
  std::set<std::pair<int, int>> m_joined;  ///< (axis, level of another axis that it lies on)
};

}  // namespace

AxisLevels axisLevels(const Mechanism& mechanism, const Digraph& graph, const ReferenceLines& lines) {
  return Classifier(mechanism, graph, lines).run();
}

}  // namespace geargraph
