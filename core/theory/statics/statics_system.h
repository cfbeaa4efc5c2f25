#pragma once

#include <span>
#include <vector>

#include "core/foundations/exact/sparse_rows.h"
#include "core/theory/matroid/kinematic_model.h"
#include "core/theory/statics/held_parts.h"

namespace geargraph {

/// The equations of statics in axis-group coordinates: the transposed rows of the kinematics. One torque
/// balance per link v, sign as in (17*) tau + ell = P^T F:
///
///     sum over meshes c of row_c[v] mu_c - sum over held parts h of h[v] lambda_h - sum over loads k g_k[v]
///     = 0
///
/// Shape    n rows; columns: the meshes, the held parts (couplings, then balances), then one given column for
///          each part of the loads.
/// Units    mu_c is the torque per tooth, N m: M_ik = -mu_c N_i on the tail's gear, M_jk = s mu_c N_j on the
///          head's gear; lambda in N m.
/// Cost     the entries: at most four per mesh, however long its cycle.
///
/// `weights(mesh, tail)`: the field's number for N_i or N_j, times the efficiency on the driven side.
/// `factor(rational)`: the field's number for a factor of a held part or a load.
template <class Field, class Weights, class Factor>
[[nodiscard]] SparseRows<typename Field::Value> staticsRows(const KinematicModel& model, const Field& field,
                                                            std::span<const HeldPart> held,
                                                            const RadicalColumns& loads,
                                                            const Weights& weights, const Factor& factor) {
  using Value = typename Field::Value;
  struct Entry {
    int column = 0;
    Value value{};
  };
  const auto links = static_cast<std::size_t>(model.n());
  // The entries of each row, by counting; a row of the kinematics gives entries to four rows at most.
  ByLink<int> starts(links + 1, 0);
  const auto count = [&](LinkOrdinal link) {
    if (link != 0) ++starts[link];
  };
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh)
    for (const LinkOrdinal link : model.meshRow(mesh).links) count(link);
  for (const HeldPart& part : held)
    for (const auto& [link, coefficient] : part.byLink) count(link);
  for (const RadicalColumns::Column& column : loads.columns())
    for (const auto& [link, coefficient] : column.entries) count(link);
  for (std::size_t v = 1; v <= links; ++v) starts[v] += starts[v - 1];

  std::vector<Entry> entries(static_cast<std::size_t>(starts[links]));
  std::vector<int> next(starts.begin(), starts.end() - 1);
  const auto put = [&](LinkOrdinal link, int column, Value value) {
    if (link == 0) return;
    entries[static_cast<std::size_t>(next[static_cast<std::size_t>(link) - 1]++)] = {column,
                                                                                     std::move(value)};
  };
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const KinematicModel::MeshRow& row = model.meshRow(mesh);
    const Value tail = weights(mesh, true);
    const Value head = weights(mesh, false);
    put(row.links[0], mesh, tail);
    put(row.links[1], mesh, field.negated(tail));
    put(row.links[2], mesh, row.sign < 0 ? head : field.negated(head));
    put(row.links[3], mesh, row.sign > 0 ? head : field.negated(head));
  }
  int column = model.c();
  for (const HeldPart& part : held) {
    for (const auto& [link, coefficient] : part.byLink) put(link, column, field.negated(factor(coefficient)));
    ++column;
  }
  for (const RadicalColumns::Column& load : loads.columns()) {
    for (const auto& [link, coefficient] : load.entries)
      put(link, column, field.negated(factor(coefficient)));
    ++column;
  }
  SparseRows<Value> rows;
  rows.reserve(links, entries.size());
  for (std::size_t v = 0; v < links; ++v) {
    for (int at = starts[v]; at < starts[v + 1]; ++at) {
      Entry& entry = entries[static_cast<std::size_t>(at)];
      rows.add(entry.column, std::move(entry.value));
    }
    rows.endRow();
  }
  return rows;
}

}  // namespace geargraph
