#pragma once

#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/foundations/base/rational.h"
#include "core/teaching/lessons/lesson.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// "links", "output-rates": the name in lessons.
[[nodiscard]] std::string_view quantityName(LessonQuantity quantity);
[[nodiscard]] std::optional<LessonQuantity> quantityFromName(std::string_view name);
/// Does it need AskedQuantity::of?
[[nodiscard]] bool needsName(LessonQuantity quantity);
/// Is it a set of elements? All others are numbers.
[[nodiscard]] bool isSetOfElements(LessonQuantity quantity);

/// Numbers or elements, in the order of the document.
struct QuantityValues {
  std::vector<Rational> numbers;  ///< several only for outputRates
  std::vector<ElementId> elements;
};

/// The results of the analysis of one mechanism. Each part is computed on first use. Not thread-safe.
class LessonAnalysis {
 public:
  explicit LessonAnalysis(MechanismPtr mechanism, std::stop_token stop = {});

  [[nodiscard]] const Mechanism& mechanism() const { return *m_mechanism; }
  /// Fails with `unknown-id` if the mechanism has no element of this name, `schema` if the quantity is not
  /// defined for it. The result is meaningless if `stop` was requested meanwhile.
  /// Cost: a live analysis; for diagnostics a complete one, for ratios the solution of all states, for
  /// torques an exact solution.
  [[nodiscard]] Expected<QuantityValues> valuesOf(const AskedQuantity& asked);
  /// The diagnostics of the complete analysis. Empty if `stop` was requested meanwhile.
  [[nodiscard]] const Diagnostics& diagnostics();

 private:
  const AnalysisSnapshot& live();
  [[nodiscard]] Expected<QuantityValues> ratesOf(const AskedQuantity& asked);
  [[nodiscard]] Expected<QuantityValues> ratioOf(const std::string& state);
  [[nodiscard]] Expected<QuantityValues> torqueOf(const std::string& holder);
  [[nodiscard]] Expected<QuantityValues> leverPlaceOf(const std::string& link);
  [[nodiscard]] Expected<QuantityValues> walkOf(const AskedQuantity& asked);
  [[nodiscard]] QuantityValues diagnosticValues(const AskedQuantity& asked);

  MechanismPtr m_mechanism;
  std::stop_token m_stop;
  SnapshotPtr m_live;
  SnapshotPtr m_complete;
};

}  // namespace geargraph
