#pragma once

#include "core/teaching/derivation/named_results.h"

namespace geargraph {

// The tables of the catalogue. @pre the result's forms() name the form

/// A matrix of the digraph. @pre not null
[[nodiscard]] ResultTablePtr matrixTable(const NamedResult& result, const SnapshotPtr& snapshot,
                                         MatrixKind kind);

/// A row for each joint of each cycle, "C16 12"; columns L M N of its direction, P Q R of its moment about
/// the pitch point, partitioned between them.
[[nodiscard]] ResultTablePtr screwTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form);

/// A row for each mesh, a column for each joint: lengths as Eq. (19) prints them; as symbols the row divided
/// by the radius of the head's gear, the inputs first as in Eq. (24).
[[nodiscard]] ResultTablePtr coefficientTable(const NamedResult& result, SnapshotPtr snapshot,
                                              EntryForm form);

/// A row for each output, a column for each input, as Eqs. (23) and (25).
[[nodiscard]] ResultTablePtr solutionTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form);

/// The f-circuits of the T-T graph, B = [B_t | U]: a row for each chord; columns: branches, chords. The
/// entries are integers, in the form of fractions.
[[nodiscard]] ResultTablePtr ttCircuitTable(const NamedResult& result, SnapshotPtr snapshot);

/// The f-cutsets of the T-T graph, Q' = [U | -B_t^T], whose rows are the equations of its statics: a row
/// for each branch; columns as in ttCircuitTable().
[[nodiscard]] ResultTablePtr ttCutsetTable(const NamedResult& result, SnapshotPtr snapshot);

/// (23*): a row for each balanced joint, a column for each loaded one.
[[nodiscard]] ResultTablePtr torqueTable(const NamedResult& result, SolvedStaticsPtr statics, EntryForm form);
/// (17*), P transposed: a row for each joint, a column for each mesh; lengths in the document's unit.
[[nodiscard]] ResultTablePtr cutsetEquationTable(const NamedResult& result, SnapshotPtr snapshot);
/// A table of force_table.h.
[[nodiscard]] ResultTablePtr recordTable(const NamedResult& result, ValueTable records);

}  // namespace geargraph
