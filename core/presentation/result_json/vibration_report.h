#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/vibration/frequency_lines.h"

namespace geargraph {

/// The shaft that frequencies are ratios to: a joint by its rate, or a link by its speed against the ground.
using ReferenceShaft = std::variant<JointOrdinal, LinkOrdinal>;

/// Why there are no lines.
enum class FrequencyAbsence {
  none,        ///< there are
  unfinished,  ///< the train, or the state, has no solution
  atRest,      ///< the reference shaft does not turn
  free,        ///< it turns freely, or about several directions at once
};

/// The lines of one motion: of a state, or of the document's inputs.
struct FrequencyCase {
  std::optional<int> state;  ///< position in the document; none: the train as engaged, driven by its inputs
  std::optional<ReferenceShaft> reference;
  FrequencyAbsence absence = FrequencyAbsence::unfinished;
  std::vector<FrequencyLine> lines;
};

struct VibrationOptions {
  FrequencyOptions lines;
  /// None: a state's drive, else the first input that turns.
  std::optional<ReferenceShaft> reference;
  std::optional<double> rpm;  ///< of the reference shaft, above 0: lines have frequencies in Hz
};

/// The case of the train as engaged, with the speeds of its inputs. std::nullopt if `stop` was requested.
/// Cost: an exact solution where the snapshot has none yet, and frequencyLines().
[[nodiscard]] std::optional<FrequencyCase> frequenciesAsEngaged(const AnalysisSnapshot& snapshot,
                                                                const VibrationOptions& options,
                                                                const std::stop_token& stop = {});

/// A case for each state of the document, whatever is engaged; of a document without states, or with
/// couplings engaged, the one as engaged. std::nullopt if `stop` was requested. Cost: solveStates() where the
/// snapshot has no states yet.
[[nodiscard]] std::optional<std::vector<FrequencyCase>> frequencyCases(const AnalysisSnapshot& snapshot,
                                                                       const VibrationOptions& options,
                                                                       const std::stop_token& stop = {});

/// Hz at `rpm` of the reference shaft.
[[nodiscard]] inline double hertzOf(const FrequencyLine& line, double rpm) {
  return line.ratio.toDouble() * rpm / 60;
}

/// "input shaft: joint 8", in the current language.
[[nodiscard]] std::string referenceText(const Mechanism& mechanism, const ReferenceShaft& reference);
/// Why a case has no lines, as a sentence. @pre it has none
[[nodiscard]] std::string absenceText(const Mechanism& mechanism, const FrequencyCase& of);
/// "tooth mesh", in the current language.
[[nodiscard]] std::string frequencyKindText(FrequencyKind kind);
/// What a line is of: "mesh 15", "link 4 in mesh 15, 3 planets", in the current language.
[[nodiscard]] std::string sourceText(const Mechanism& mechanism, const FrequencyLine& line);

/// The columns of frequencyTable(); `state` is there if a case is of a state, `hertz` with a speed.
enum class FrequencyColumn { state, kind, source, harmonic, sideband, ratio, orders, hertz };

/// The lines of all cases, a row a line; `ratio` is exact. For the window and CSV.
[[nodiscard]] ValueTable frequencyTable(const Mechanism& mechanism, const std::vector<FrequencyCase>& cases,
                                        const VibrationOptions& options);

/// `vibration --json`. `mechanism` and `cases`: null where the file could not be read.
[[nodiscard]] std::string vibrationJson(const Mechanism* mechanism, const std::vector<FrequencyCase>* cases,
                                        const VibrationOptions& options);

}  // namespace geargraph
