#include "core/theory/matroid/kinematic_model.h"

#include <algorithm>

namespace geargraph {

std::optional<KinematicModel> KinematicModel::of(DigraphPtr graph, SpanningTreePtr tree,
                                                 const Placement& placement) {
  if (!graph || !tree || !placement.tree) return std::nullopt;
  KinematicModel model;
  const AxisGroups& classes = *placement.classes;
  const JointTree& joints = *placement.tree;

  model.m_rates.reserve(joints.joints.size());
  for (const JointOrdinal j : joints.joints.ordinals()) {
    const LinkOrdinal child = joints.child[j];
    const LinkOrdinal parent = joints.parent[child];
    const LinkOrdinal rootLink = classes.classes[classes.classOf[j]].rootLink;
    const int direction = joints.joints[j].tail == parent ? 1 : -1;
    model.m_rates.push_back(
        {child, parent == rootLink ? LinkOrdinal(0) : parent, direction * classes.orientationSign[j]});
  }

  model.m_rows.reserve(placement.meshes.size());
  for (const MeshOrdinal m : placement.meshes.ordinals()) {
    if (!placement.meshes[m]) return std::nullopt;
    const MeshGeometry& mesh = *placement.meshes[m];
    const LinkOrdinal tailRoot = classes.classes[mesh.tailClass].rootLink;
    const LinkOrdinal headRoot = classes.classes[mesh.headClass].rootLink;
    const auto below = [](LinkOrdinal link, LinkOrdinal rootLink) {
      return link == rootLink ? LinkOrdinal(0) : link;
    };
    model.m_rows.push_back({{below(mesh.tail, tailRoot), below(mesh.carrier, tailRoot),
                             below(mesh.head, headRoot), below(mesh.carrier, headRoot)},
                            mesh.weights.tail,
                            mesh.weights.head,
                            mesh.weights.pi,
                            mesh.sign});
  }
  model.m_graph = std::move(graph);
  model.m_tree = std::move(tree);
  model.countPi();
  return model;
}

void KinematicModel::countPi() {
  m_pi.assign(static_cast<std::size_t>(n()) + 1, 0);
  m_mixed.reset();
  m_hasPi = std::any_of(m_rows.begin(), m_rows.end(), [](const MeshRow& row) { return row.pi != 0; });
  if (!m_hasPi) return;
  // Two phi of one equation, or of one rate: the power of `to` is that of `from` plus `more`.
  struct Tie {
    LinkOrdinal to = 0;
    int more = 0;
    int equation = 0;  ///< a rate's is equations()
  };
  ByLink<std::vector<Tie>> ties(m_pi.size());
  const auto tie = [&](LinkOrdinal a, LinkOrdinal b, int more, int equation) {
    if (a == 0 || b == 0) return;  // a root link has no phi
    ties[a].push_back({b, more, equation});
    ties[b].push_back({a, -more, equation});
  };
  for (const MeshOrdinal mesh : m_rows.ordinals()) {
    const MeshRow& row = m_rows[mesh];
    // tail phi = head pi^pi phi: the powers of the tail's side are those of the head's plus pi.
    tie(row.links[0], row.links[1], 0, mesh);
    tie(row.links[2], row.links[3], 0, mesh);
    for (const LinkOrdinal ofTail : {row.links[0], row.links[1]}) {
      for (const LinkOrdinal ofHead : {row.links[2], row.links[3]}) tie(ofHead, ofTail, row.pi, mesh);
    }
  }
  for (int equation = c(); equation < equations(); ++equation) {
    const std::vector<HeldRow::Term>& terms = heldRow(equation).links;
    for (std::size_t i = 1; i < terms.size(); ++i) tie(terms[0].of, terms[i].of, 0, equation);
  }
  for (const JointRate& rate : m_rates) tie(rate.parent, rate.child, 0, equations());
  ByLink<char> known(m_pi.size(), 0);
  std::vector<LinkOrdinal> queue;
  for (LinkOrdinal seed = 1; seed <= n(); ++seed) {
    if (known[seed] != 0) continue;
    known[seed] = 1;
    queue.assign(1, seed);
    while (!queue.empty()) {
      const LinkOrdinal from = queue.back();
      queue.pop_back();
      for (const Tie& each : ties[from]) {
        const int power = m_pi[from] + each.more;
        if (known[each.to] == 0) {
          known[each.to] = 1;
          m_pi[each.to] = power;
          queue.push_back(each.to);
        } else if (m_pi[each.to] != power && (!m_mixed || each.equation < *m_mixed)) {
          m_mixed = each.equation;
        }
      }
    }
  }
}

}  // namespace geargraph
