#include "core/mechanism/placement/axis_classes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory_resource>
#include <span>
#include <string>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {
namespace {

/// Arbitrary ones that tell drawn lines apart.
constexpr Vector3 kKeyWeights{0.7310, 0.5179, 0.4451};

/// Finds the classes from the ground outward: of the joints at a link, those on one line are of one class,
/// that of the joint towards the ground or a new one.
///
/// 1. Group the joints at the link by their axes' names.
/// 2. Join groups whose lines coincide; only lines with close keys can.
/// 3. Give every group its class.
/// 4. In the end, number the classes in the order of their first joints, which also give the senses.
class ClassFinder {
 public:
  ClassFinder(const Mechanism& mechanism, const JointTree& tree, SpanByAxis<const AxisLine> lines)
      : m_mechanism(mechanism), m_tree(tree), m_comparison(mechanism, *tree.graph, lines) {
    const LineKeys keys(lines);
    m_closeKeys = keys.window;
    m_lines = lines;
    m_axes.reserve(lines.size());
    // The infinite key of a line that is not given is close to no other.
    for (const AxisLine& line : lines) m_axes.push_back({keys.of(line, kKeyWeights)});
    m_turningAxes = m_axes.size();
    // Sliding joints of an axis are not of the class of its turning ones: they have marks of their own, and
    // no key, because where they are does not matter.
    if (hasSlides(mechanism)) m_axes.resize(2 * m_turningAxes, {std::numeric_limits<double>::infinity()});
    m_found.reserve(tree.joints.size());
  }

  /// True where some axis is named by joints of several classes.
  bool run(AxisGroups& result, Diagnostics& diagnostics) {
    result.classOf.resize(m_tree.joints.size());
    result.orientationSign.resize(m_tree.joints.size());
    for (const LinkOrdinal link : m_tree.order) {
      const std::span<const int> joints = m_tree.graph->turningEdgesAt(link);
      if (link != 0 && joints.size() == 1) continue;  // its class is known
      groupByAxis(link, joints);
      if (m_groups.size() > 1) joinGroups();
      if (m_groups.size() > 1 && m_axes.size() > m_turningAxes) joinSlides();
      giveClasses(link, joints, result);
    }
    report(diagnostics);
    return number(result);
  }

 private:
  struct AxisMark {
    double key = 0;
    LinkOrdinal link = -1;  ///< where its joints were met last,
    int group = -1;         ///< and the number of their group there
  };
  /// Joints of one axis at the link being treated.
  struct Group {
    AxisOrdinal axis = 0;
    int set = 0;     ///< the first of the groups that it is joined with
    int sign = 1;    ///< of its axis against that one's
    int found = -1;  ///< of the first one of a set: its class, and its axis' sign against that class
    int against = 1;
  };
  /// A class before it has its number.
  struct Found {
    LinkOrdinal rootLink = 0;
    JointKind kind = JointKind::turning;
    int depth = 0;
    int number = -1;
    int sign = 1;  ///< of its first joint
  };
  struct Merged {
    int first = 0;
    int second = 0;
    int sign = 1;
    auto operator<=>(const Merged&) const = default;
  };

  void groupByAxis(LinkOrdinal link, std::span<const int> joints) {
    m_groups.clear();
    for (const JointOrdinal joint : joints) {
      const AxisOrdinal position = markOf(joint);
      AxisMark& axis = m_axes[position];
      if (axis.link == link) continue;
      axis.link = link;
      axis.group = static_cast<int>(m_groups.size());
      m_groups.push_back({position, axis.group});
    }
  }

  void joinGroups() {
    constexpr int kFew = 6;  // are compared sooner than sorted
    const int groups = static_cast<int>(m_groups.size());
    if (groups > kFew) return joinSorted();
    for (int b = 1; b < groups; ++b) {
      for (int a = 0; a < b; ++a) {
        if (std::abs(keyOfGroup(b) - keyOfGroup(a)) < m_closeKeys) joinIfOneLine(a, b);
      }
    }
  }

  void joinSorted() {
    m_keyed.clear();
    for (int group = 0; group < static_cast<int>(m_groups.size()); ++group) {
      m_keyed.emplace_back(keyOfGroup(group), group);
    }
    std::sort(m_keyed.begin(), m_keyed.end());
    for (std::size_t i = 0; i < m_keyed.size(); ++i) {
      for (std::size_t k = i + 1; k < m_keyed.size() && m_keyed[k].first - m_keyed[i].first < m_closeKeys;
           ++k) {
        joinIfOneLine(m_keyed[i].second, m_keyed[k].second);
      }
    }
  }

  [[nodiscard]] double keyOfGroup(int group) const { return m_axes[m_groups[group].axis].key; }

  [[nodiscard]] AxisOrdinal markOf(JointOrdinal joint) const {
    const int axis = m_tree.axisOf[joint];
    return slides(m_mechanism.turningJoints[joint]) ? axis + static_cast<int>(m_turningAxes) : axis;
  }
  [[nodiscard]] bool isSliding(int group) const {
    return m_groups[group].axis >= static_cast<int>(m_turningAxes);
  }

  /// Sliding joints at a link whose lines are given and parallel.
  void joinSlides() {
    const int groups = static_cast<int>(m_groups.size());
    const auto lineOf = [&](int group) -> const AxisLine& {
      return m_lines[m_groups[group].axis - static_cast<int>(m_turningAxes)];
    };
    for (int b = 1; b < groups; ++b) {
      for (int a = 0; a < b; ++a) {
        if (!isSliding(a) || !isSliding(b) || lineOf(a).automatic || lineOf(b).automatic) continue;
        const Vector3& one = lineOf(a).direction;
        const Vector3& other = lineOf(b).direction;
        if (areParallel(one, other)) join(a, b, dot(one, other) < 0 ? -1 : 1);
      }
    }
  }

  void joinIfOneLine(int a, int b) {
    if (isSliding(a) || isSliding(b)) return;
    const auto [low, high] = std::minmax(m_groups[a].axis, m_groups[b].axis);
    const int sign = m_comparison.coincidence(low, high);
    if (sign == 0) return;
    m_merged.push_back({low, high, sign});
    join(a, b, sign);
  }

  void join(int a, int b, int sign) {
    const Group one = m_groups[a];
    const Group other = m_groups[b];
    if (one.set == other.set) return;
    for (Group& group : m_groups) {
      if (group.set != other.set) continue;
      group.set = one.set;
      group.sign *= one.sign * other.sign * sign;
    }
  }

  void giveClasses(LinkOrdinal link, std::span<const int> joints, AxisGroups& result) {
    const int up = m_tree.joint[link];
    int depth = 0;
    if (up >= 0) {
      const Group& group = groupOf(up);
      Group& set = m_groups[group.set];
      set.found = result.classOf[up];
      set.against = result.orientationSign[up] * group.sign;
      depth = m_found[set.found].depth + 1;
    }
    for (const JointOrdinal joint : joints) {
      const Group& group = groupOf(joint);
      Group& set = m_groups[group.set];
      if (set.found < 0) {
        set.found = static_cast<int>(m_found.size());
        m_found.push_back({link, m_mechanism.turningJoints[joint].kind, depth});
      }
      result.classOf[joint] = set.found;
      result.orientationSign[joint] = group.sign * set.against;
    }
  }

  [[nodiscard]] const Group& groupOf(JointOrdinal joint) const {
    return m_groups[static_cast<std::size_t>(m_axes[markOf(joint)].group)];
  }

  bool number(AxisGroups& result) {
    constexpr int kNone = -1;
    bool isSplit = false;
    for (AxisMark& axis : m_axes) axis.group = kNone;  // from now on the class of its joints
    result.classes.reserve(m_found.size());
    result.ofLink.resize(m_tree.joint.size(), kNone);
    for (JointOrdinal joint = 0; joint < static_cast<int>(m_tree.joints.size()); ++joint) {
      Found& found = m_found[result.classOf[joint]];
      const AxisOrdinal axis = m_tree.axisOf[joint];
      if (found.number < 0) {
        found.number = static_cast<int>(result.classes.size());
        found.sign = result.orientationSign[joint];
        result.classes.push_back({joint, axis, found.rootLink, found.kind, found.depth});
      }
      result.classOf[joint] = result.ofLink[m_tree.child[joint]] = found.number;
      result.orientationSign[joint] *= found.sign;
      const int before = std::exchange(m_axes[markOf(joint)].group, found.number);
      isSplit = isSplit || (before != kNone && before != found.number && found.kind == JointKind::turning);
    }
    return isSplit;
  }

  void report(Diagnostics& diagnostics) {
    std::sort(m_merged.begin(), m_merged.end());
    m_merged.erase(std::unique(m_merged.begin(), m_merged.end()), m_merged.end());
    for (const auto& [a, b, sign] : m_merged) {
      const AxisId first = m_mechanism.axes[a].id;
      const AxisId second = m_mechanism.axes[b].id;
      Diagnostic diagnostic;
      diagnostic.code = Code::mergedAxes;
      diagnostic.message =
          sign < 0
              ? translated(
                    "Axes %1 and %2 are one line held by a common link: they are treated as one axis, with "
                    "opposite directions.",
                    {first.text(), second.text()})
              : translated("Axes %1 and %2 are one line held by a common link: they are treated as one axis.",
                           {first.text(), second.text()});
      diagnostic.elements = {first, second};
      diagnostics.push_back(std::move(diagnostic));
    }
  }

  const Mechanism& m_mechanism;
  const JointTree& m_tree;
  LineComparison m_comparison;
  SpanByAxis<const AxisLine> m_lines;
  std::size_t m_turningAxes = 0;         ///< marks of sliding joints follow those of turning ones
  std::array<std::byte, 2048> m_buffer;  // enough for some dozens of joints
  std::pmr::monotonic_buffer_resource m_scratch{m_buffer.data(), m_buffer.size()};
  std::pmr::vector<AxisMark> m_axes{&m_scratch};
  double m_closeKeys = 0;  ///< by how much those of one line may differ
  std::pmr::vector<Group> m_groups{&m_scratch};
  std::pmr::vector<std::pair<double, int>> m_keyed{&m_scratch};
  std::pmr::vector<Found> m_found{&m_scratch};
  std::pmr::vector<Merged> m_merged{&m_scratch};
};

void reportSplits(const Mechanism& mechanism, const JointTree& tree, const AxisGroups& classes,
                  Diagnostics& diagnostics) {
  ByAxis<std::vector<int>> classesOfAxis(mechanism.axes.size());
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    std::vector<int>& list = classesOfAxis[tree.axisOf[j]];
    const int of = classes.classOf[j];
    if (classes.classes[of].kind == JointKind::sliding) continue;
    if (std::find(list.begin(), list.end(), of) == list.end()) list.push_back(of);
  }
  for (std::size_t a = 0; a < classesOfAxis.size(); ++a) {
    if (classesOfAxis[a].size() < 2) continue;
    Diagnostic diagnostic;
    diagnostic.code = Code::splitAxis;
    diagnostic.elements = {mechanism.axes[a].id};
    std::string groups;
    for (const int of : classesOfAxis[a]) {
      const JointOrdinal joint = classes.classes[of].joint;
      groups += (groups.empty() ? "" : ", ") + std::to_string(mechanism.jointLabel(joint));
      diagnostic.elements.emplace_back(mechanism.turningJoints[joint].id);
    }
    diagnostic.message = translated(
        "Axis %1 is named by joints that share no link on it (%2 ...): they coincide in the drawn pose "
        "only and are treated as different axes. Give each its own axis.",
        {mechanism.axes[a].id.text(), groups});
    diagnostics.push_back(std::move(diagnostic));
  }
}

}  // namespace

AxisGroups::AxisGroups(const Mechanism& mechanism, const JointTree& tree, const ByAxis<AxisLine>& lines,
                       Diagnostics& diagnostics) {
  const bool isSplit = ClassFinder(mechanism, tree, lines).run(*this, diagnostics);
  if (isSplit) reportSplits(mechanism, tree, *this, diagnostics);
}

}  // namespace geargraph
