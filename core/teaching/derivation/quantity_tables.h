#pragma once

#include "core/teaching/derivation/quantity_table.h"

namespace geargraph {

// The tables of quantity_table.h. @pre formsOf() names the form

/// A row for each joint of each cycle, "C16 12"; columns L M N of its direction, P Q R of its moment about
/// the pitch point, partitioned between them.
[[nodiscard]] QuantityTablePtr screwTable(SnapshotPtr snapshot, EntryForm form);

/// A row for each mesh, a column for each joint: lengths as Eq. (19) prints them; as symbols the row divided
/// by the radius of the head's gear, the inputs first as in Eq. (24).
[[nodiscard]] QuantityTablePtr coefficientTable(SnapshotPtr snapshot, EntryForm form);

/// A row for each output, a column for each input, as Eqs. (23) and (25).
[[nodiscard]] QuantityTablePtr solutionTable(SnapshotPtr snapshot, EntryForm form);

/// The f-circuits of the T-T graph, B = [B_t | U]: a row for each chord; columns: branches, chords. The
/// entries are integers, in the form of fractions.
[[nodiscard]] QuantityTablePtr ttCircuitTable(SnapshotPtr snapshot);

/// The f-cutsets of the T-T graph, Q' = [U | -B_t^T], whose rows are the equations of its statics: a row
/// for each branch; columns as in ttCircuitTable().
[[nodiscard]] QuantityTablePtr ttCutsetTable(SnapshotPtr snapshot);

[[nodiscard]] QuantityEntry decimalEntry(int column, double value);
[[nodiscard]] QuantityEntry fractionEntry(int column, const Rational& value);
/// For an irrational value that was requested as a fraction.
[[nodiscard]] QuantityEntry irrationalEntry(int column, double value);

}  // namespace geargraph
