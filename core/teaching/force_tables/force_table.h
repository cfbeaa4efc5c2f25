#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/csv.h"
#include "core/theory/statics/shift_statics.h"

namespace geargraph {

/// The tables of statics, for the window and CSV files.
enum class ForceTableKind { needs, joints, couplings, meshes, bearings, powers, circulations, states };

/// Those of one problem: all but `states`, and `needs`, which picks rows of others for the window.
[[nodiscard]] const std::vector<ForceTableKind>& allForceTableKinds();
[[nodiscard]] std::string_view forceTableTitle(ForceTableKind kind);        ///< "Joints", to be translated
[[nodiscard]] std::string_view forceTableCommandName(ForceTableKind kind);  ///< "joint-torques", of the CSV

struct ForceColumn {
  std::string head;
  std::string unit;     ///< empty for texts and plain numbers
  std::string meaning;  ///< the definition of the values, with their sign
  bool isNumber = false;
  bool isFraction = false;    ///< the next column has the same values as decimals: CSV leaves this one out
  std::string headInFiles{};  ///< in English, if `head` is translated
  bool isInFiles = true;      ///< false: a name beside a label, for people only
};

struct ForceCell {
  std::string text;              ///< as displayed: "-7/2", "12.5", "shared"; may be empty
  std::optional<double> number;  ///< of a determined number
  std::string exact;             ///< of a decimal of the shift table: its fraction, if short
  std::string textInFiles{};     ///< in English, if `text` is translated
};

struct ForceRow {
  std::vector<ElementId> elements;  ///< that are highlighted with it
  std::vector<ForceCell> cells;     ///< one per column
};

/// A table of texts and numbers in the current language; its texts for files are English.
struct ValueTable {
  std::vector<ForceColumn> columns;
  std::vector<ForceRow> rows;
};

struct ForceTable : ValueTable {
  ForceTableKind kind = ForceTableKind::joints;
  std::string note = {};  ///< of the shift table: which loads act beside the torques at the drives
};

/// Torques in N m, forces in N, rates in rad/s, powers in W, places in the document's unit. Without rows if
/// there is no equilibrium, or the quantity is undefined: powers without a motion, forces with an unknown
/// unit of length. Cost: O(elements). @pre all of one mechanism
[[nodiscard]] ForceTable forceTable(const Mechanism& mechanism, const KinematicModel& model,
                                    const Placement& placement, const StaticsReport& report,
                                    ForceTableKind kind);

/// The columns of the table of meshes.
enum class MeshColumn {
  mesh,
  tail,
  head,
  carrier,
  onTail,
  onHead,
  tangential,
  separating,
  forceX,
  forceY,
  forceZ,
  efficiency,
  drives,
  rolling,
  lost,
  toTail,
  toHead,
  toCarrier,
  count
};

/// The columns after those of the couplings in the shift table.
enum class ShiftColumn { exactRatio, ratio, found, efficiency, backward, latent, circulating, count };

/// The shift table of torques: one row per state, one column per coupling of the document; then those of
/// ShiftColumn: the ratio, the torque found, efficiency forward and backward, the latent ratio and the
/// greatest circulating power, these four of the state under the torque at its drive alone.
[[nodiscard]] ForceTable shiftTable(const Mechanism& mechanism, std::span<const StateForces> states);

/// The same for a file of its own: behind the name of each state its drive, its driven link and what it
/// engages, behind the ratio the step from the state before. @pre `shiftTable` is of these states
[[nodiscard]] ValueTable shiftSheet(const Mechanism& mechanism, const ValueTable& shiftTable);
/// The largest ratio over the smallest of the states that turn forward; std::nullopt with fewer than two.
[[nodiscard]] std::optional<double> spreadOf(const ValueTable& shiftTable);

/// The table as CSV [RFC 4180]: a header row with units, then its rows; numbers as the shortest decimals that
/// read back as the same doubles.
void writeForceCsv(ByteSink& sink, const ValueTable& table, const CsvOptions& options = {});

/// The number with about six digits and the current decimal sign, for the screen: "12.5", "-0.333333".
[[nodiscard]] std::string shownNumber(double number);
/// As a fraction if it is rational and short, else with about six digits.
[[nodiscard]] std::string shownReal(const Real& value);

}  // namespace geargraph
