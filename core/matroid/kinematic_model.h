#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/exact/sparse_rows.h"
#include "core/graph/matrices.h"
#include "core/placement/placement.h"

namespace geargraph {

/// The mechanism as whole numbers, in axis-group coordinates: phi_v is the speed of link v about its class's
/// line, relative to the class's top. Every mesh is then a row of three links at most, whatever its cycle's
/// length:
///     N_tail (phi_i - phi_k) - s N_head (phi_j - phi_k) = 0,  terms of a class's top drop out,
/// and a joint's rate is a difference of two phi. Same solutions as the paper's P, better conditioned,
/// shorter.
///
/// Links and joints are ordinals of the digraph; unknown v - 1 is phi_v.
class KinematicModel {
 public:
  /// One link of a mesh row: which wheel's tooth count it bears, +1 or -1.
  struct RowTerm {
    int link = 0;
    bool tail = false;       ///< N_tail, else N_head
    std::int8_t factor = 1;  ///< the sign; the s of the mesh is in it
  };
  struct MeshRow {
    std::array<RowTerm, 4> terms;
    int size = 0;
    int tailTeeth = 1;
    int headTeeth = 1;
  };
  /// theta = sign * (phi_child - phi_parent); parent 0: it is the class's top and drops out.
  struct JointRate {
    int child = 0;
    int parent = 0;
    int sign = 1;
  };

  /// Nothing where the joints are no spanning tree or a mesh has no geometry.
  /// @pre graph, tree and placement are the mechanism's
  /// Cost: O(n + c).
  [[nodiscard]] static std::optional<KinematicModel> of(const Mechanism& mechanism, DigraphPtr graph,
                                                        SpanningTreePtr tree, const Placement& placement);

  [[nodiscard]] const Digraph& graph() const { return *m_graph; }
  [[nodiscard]] const SpanningTree& tree() const { return *m_tree; }
  [[nodiscard]] int n() const { return m_graph->n(); }
  [[nodiscard]] int t() const { return m_graph->t(); }
  [[nodiscard]] int c() const { return m_graph->c(); }
  [[nodiscard]] const MeshRow& meshRow(int mesh) const { return m_rows[static_cast<std::size_t>(mesh)]; }
  [[nodiscard]] const JointRate& jointRate(int joint) const {
    return m_rates[static_cast<std::size_t>(joint)];
  }

  /// The mesh's row over the phi, added to `rows` (the row is not ended). Entry +-N through `weights`:
  /// weights(mesh, tail) is the field's value for N_tail or N_head of the mesh.
  template <class Value, class Weights>
  void addMeshRow(SparseRows<Value>& rows, int mesh, const Weights& weights) const {
    const MeshRow& row = meshRow(mesh);
    for (int i = 0; i < row.size; ++i) {
      const RowTerm& term = row.terms[static_cast<std::size_t>(i)];
      rows.add(term.link - 1, weights(mesh, term.tail, term.factor));
    }
  }
  /// The joint's rate over the phi, added likewise.
  template <class Field>
  void addRateRow(SparseRows<typename Field::Value>& rows, int joint, const Field& field) const {
    const JointRate& rate = jointRate(joint);
    rows.add(rate.child - 1, field.fromInteger(rate.sign));
    if (rate.parent != 0) rows.add(rate.parent - 1, field.fromInteger(-rate.sign));
  }

  /// The joint's rate, from the phi of all links, `width` solutions side by side as in substitute().
  /// @pre phi has a place for every unknown
  template <class Field>
  [[nodiscard]] typename Field::Value rateOf(const Field& field, int joint,
                                             const std::vector<typename Field::Value>& phi,
                                             std::size_t width = 1, std::size_t place = 0) const {
    const JointRate& rate = jointRate(joint);
    const auto at = [&](int link) -> const auto& {
      return phi[(static_cast<std::size_t>(link) - 1) * width + place];
    };
    auto value = at(rate.child);
    if (rate.parent != 0) field.subtract(value, at(rate.parent));
    return rate.sign > 0 ? value : field.negated(value);
  }

  /// The teeth as a field's numbers, for addMeshRow().
  template <class Field>
  [[nodiscard]] auto teeth(const Field& field) const {
    return [this, &field](int mesh, bool tail, int factor) {
      const MeshRow& row = meshRow(mesh);
      return field.fromInteger(static_cast<std::int64_t>(factor) * (tail ? row.tailTeeth : row.headTeeth));
    };
  }

 private:
  KinematicModel() = default;

  DigraphPtr m_graph;
  SpanningTreePtr m_tree;
  std::vector<MeshRow> m_rows;
  std::vector<JointRate> m_rates;
};

}  // namespace geargraph
