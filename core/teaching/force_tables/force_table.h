#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/csv.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph::inline force_tables {

/// The tables of statics, as the window shows them and CSV files hold them.
enum class ForceTableKind { joints, couplings, meshes, bearings, powers, circulations, states };

/// Those of one problem: all but `states`.
[[nodiscard]] const std::vector<ForceTableKind>& allForceTableKinds();
[[nodiscard]] std::string forceTableTitle(ForceTableKind kind);             ///< "Torques", translated
[[nodiscard]] std::string_view forceTableCommandName(ForceTableKind kind);  ///< "joint-torques", of the CSV

struct ForceColumn {
  std::string head;
  std::string unit;     ///< empty for texts and plain numbers
  std::string meaning;  ///< the definition of what is in the column, with its sign
  bool isNumber = false;
  bool isFraction = false;    ///< of the next column, which has the same as decimals: CSV leaves it out
  std::string headInFiles{};  ///< English, where `head` is translated
};

struct ForceCell {
  std::string text;              ///< as it is shown: "-7/2", "12.5", "shared"; empty where there is nothing
  std::optional<double> number;  ///< of a number that is determined
  std::string exact;             ///< of a decimal of the shift table: its fraction, where it is a short one
  std::string textInFiles{};     ///< English, where `text` is translated
};

struct ForceRow {
  std::vector<ElementId> elements;  ///< what lights up with it
  std::vector<ForceCell> cells;     ///< one a column
};

/// A table as an immutable value, in the language in use; what files hold of it is English.
struct ValueTable {
  std::vector<ForceColumn> columns;
  std::vector<ForceRow> rows;
};

struct ForceTable : ValueTable {
  ForceTableKind kind = ForceTableKind::joints;
};

/// Torques in N m, forces in N, rates in rad/s, powers in W, places in the document's unit. Without rows
/// where there is no equilibrium, or the quantity is undefined: powers without a motion, forces without a
/// length's size. Cost: O(elements). @pre all of one mechanism
[[nodiscard]] ForceTable forceTable(const Mechanism& mechanism, const KinematicModel& model,
                                    const Placement& placement, const StaticsReport& report,
                                    ForceTableKind kind);

/// The torques in one state of a gearbox; none where nothing was solved.
struct StateForces {
  int state = 0;  ///< position in the document
  std::optional<StaticsReport> report;
};

/// What follows the columns of the couplings in the shift table.
enum class ShiftColumn { exactRatio, ratio, found, efficiency, backward, latent, circulating, count };

/// The shift table of torques: a row for each of these states, a column for each coupling of the document;
/// then those of ShiftColumn: the ratio, the torque at the driven link, efficiency forward and backward, the
/// latent ratio and the greatest power that circulates.
[[nodiscard]] ForceTable shiftTable(const Mechanism& mechanism, std::span<const StateForces> states);

/// The table as CSV [RFC 4180]: a head row with units, then its rows; numbers as the shortest decimals that
/// read back as the same doubles.
void writeForceCsv(ByteSink& sink, const ValueTable& table, const CsvOptions& options = {});

/// About six digits, as screens show them, with the decimal sign in use: "12.5", "-0.333333".
[[nodiscard]] std::string shownNumber(double number);
/// A fraction where it is one and short, else about six digits.
[[nodiscard]] std::string shownReal(const Real& value);

}  // namespace geargraph::inline force_tables
