#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/foundations/exact/fields.h"
#include "core/foundations/exact/sparse_rows.h"
#include "core/mechanism/graph/matrices.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// The kinematics with integer coefficients, in axis-group coordinates: phi_v is the speed of link v about
/// the line of its axis class, relative to the root link of the class. Every mesh is then a row over at most
/// three links, however long its cycle:
/// N_tail (phi_i - phi_k) - s N_head (phi_j - phi_k) = 0, terms of a root link drop out, and a joint's rate
/// is a difference of two phi. Same solutions as the paper's P, better conditioned, shorter.
///
/// Links and joints are ordinals of the digraph; unknown v - 1 is phi_v.
class KinematicModel {
 public:
  /// The links of a mesh row, 0 where the term drops out: the tail's gear bears N_tail, the carrier -N_tail
  /// on the tail's axis, the head's gear -s N_head, the carrier s N_head on the head's axis.
  struct MeshRow {
    std::array<int, 4> links{};
    int tailTeeth = 1;  ///< N_tail; where a side slides, the weight of the tail (MeshWeights)
    int headTeeth = 1;
    int pi = 0;    ///< MeshWeights::pi: N_tail : N_head are tailTeeth : headTeeth pi^pi
    int sign = 1;  ///< s
  };
  /// theta = sign * (phi_child - phi_parent); parent 0: the parent is the root link of the class and drops
  /// out.
  struct JointRate {
    LinkOrdinal child = 0;
    LinkOrdinal parent = 0;
    int sign = 1;
  };
  /// The constraint of an engaged coupling about one direction: a sum of speeds that is 0. These rows follow
  /// those of the meshes; P itself has the rows of the meshes only.
  struct HeldRow {
    struct Term {
      int of = 0;      ///< a link, or a joint
      int factor = 1;  ///< +1 or -1
    };
    ShiftElementOrdinal coupling = 0;  ///< position in the document
    int from = 0;                      ///< the links that it holds together; for a brake the ground
    int to = 0;
    AxisGroupOrdinal axisGroup = 0;  ///< about the direction of its line
    std::vector<Term> links;         ///< over the phi
    std::vector<Term> joints;        ///< the same over the rates of the joints on the way
  };

  /// std::nullopt if the joints are no spanning tree or a mesh has no geometry.
  /// @pre graph, tree and placement are of one mechanism
  /// Cost: O(n + c).
  [[nodiscard]] static std::optional<KinematicModel> of(DigraphPtr graph, SpanningTreePtr tree,
                                                        const Placement& placement);

  [[nodiscard]] const Digraph& graph() const { return *m_graph; }
  [[nodiscard]] const SpanningTree& tree() const { return *m_tree; }
  [[nodiscard]] int n() const { return m_graph->n(); }
  [[nodiscard]] int t() const { return m_graph->t(); }
  [[nodiscard]] int c() const { return m_graph->c(); }
  /// The number of rows: c meshes, then the engaged couplings.
  [[nodiscard]] int equations() const { return c() + static_cast<int>(m_held.size()); }
  [[nodiscard]] const std::vector<HeldRow>& held() const { return m_held; }
  /// Sets the rows of the engaged couplings, in place of any set before.
  void hold(std::vector<HeldRow> rows) {
    m_held = std::move(rows);
    countPi();
  }

  /// Ties a row a length to an angle by a power of pi?
  [[nodiscard]] bool hasPi() const { return m_hasPi; }
  /// Equations round a loop that has a power of pi against one that has none, so that no unknown can be
  /// counted in one power: the first of them; none as a rule.
  [[nodiscard]] std::optional<int> mixedEquation() const { return m_mixed; }
  /// The power g of a joint's rate: rates are fractions times pi^(g of the joint - g of the input) where one
  /// input moves. All are 0 without hasPi(). Systems over fractions leave pi out (weightIn()), and solve for
  /// rates divided by pi^g. @pre there is no mixedEquation()
  [[nodiscard]] int piOf(JointOrdinal joint) const { return m_pi[m_rates[joint].child]; }

  [[nodiscard]] const MeshRow& meshRow(MeshOrdinal mesh) const { return m_rows[mesh]; }
  /// @pre equation >= c()
  [[nodiscard]] const HeldRow& heldRow(int equation) const {
    return m_held[static_cast<std::size_t>(equation - c())];
  }
  [[nodiscard]] const JointRate& jointRate(JointOrdinal joint) const { return m_rates[joint]; }

  /// Adds the mesh's entries over the phi to the current row of `rows` (without ending it): its entries are
  /// +-tail and +-head, the field's numbers for N_tail and N_head.
  template <class Field>
  void addMeshRow(SparseRows<typename Field::Value>& rows, MeshOrdinal mesh, const Field& field,
                  const typename Field::Value& tail, const typename Field::Value& head) const {
    const MeshRow& row = meshRow(mesh);
    const auto add = [&](LinkOrdinal link, const typename Field::Value& weight, bool positive) {
      if (link != 0) rows.add(link - 1, positive ? weight : field.negated(weight));
    };
    add(row.links[0], tail, true);
    add(row.links[1], tail, false);
    add(row.links[2], head, row.sign < 0);
    add(row.links[3], head, row.sign > 0);
  }
  /// The same with the teeth themselves.
  template <class Field>
  void addMeshRow(SparseRows<typename Field::Value>& rows, MeshOrdinal mesh, const Field& field) const {
    const MeshRow& row = meshRow(mesh);
    addMeshRow(rows, mesh, field, field.fromInteger(row.tailTeeth), weightIn(field, row.headTeeth, row.pi));
  }
  /// Adds the entries of an engaged coupling likewise.
  template <class Field>
  static void addHeldRow(SparseRows<typename Field::Value>& rows, const HeldRow& row, const Field& field) {
    for (const HeldRow::Term& term : row.links) rows.add(term.of - 1, field.fromInteger(term.factor));
  }
  /// Adds the joint's rate over the phi likewise.
  template <class Field>
  void addRateRow(SparseRows<typename Field::Value>& rows, JointOrdinal joint, const Field& field) const {
    const JointRate& rate = jointRate(joint);
    rows.add(rate.child - 1, field.fromInteger(rate.sign));
    if (rate.parent != 0) rows.add(rate.parent - 1, field.fromInteger(-rate.sign));
  }

  /// The joint's rate, from the phi of all links, `width` solutions side by side as in substitute().
  /// @pre phi has `width` places for every unknown
  template <class Field>
  [[nodiscard]] typename Field::Value rateOf(const Field& field, JointOrdinal joint,
                                             std::span<const typename Field::Value> phi,
                                             std::size_t width = 1, std::size_t place = 0) const {
    const JointRate& rate = jointRate(joint);
    const auto at = [&](LinkOrdinal link) -> const auto& {
      return phi[(static_cast<std::size_t>(link) - 1) * width + place];
    };
    auto value = at(rate.child);
    if (rate.parent != 0) field.subtract(value, at(rate.parent));
    return rate.sign > 0 ? value : field.negated(value);
  }

 private:
  KinematicModel() = default;
  /// Walks the unknowns from row to row, for m_pi and m_mixed.
  void countPi();

  DigraphPtr m_graph;
  SpanningTreePtr m_tree;
  ByMesh<MeshRow> m_rows;
  std::vector<HeldRow> m_held;
  ByJoint<JointRate> m_rates;
  bool m_hasPi = false;
  std::optional<int> m_mixed;
  ByLink<int> m_pi;  ///< the powers of the phi
};

}  // namespace geargraph
