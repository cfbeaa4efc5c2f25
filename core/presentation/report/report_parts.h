#pragma once

#include "core/foundations/base/words.h"
#include "core/presentation/report/report.h"

namespace geargraph::inline report {

// The parts of a report, each as far as the snapshot goes; of no use when `stop` was requested meanwhile.

/// Longest list of equations, one a joint, a mesh or a step.
constexpr int kMostListed = 100;

/// The mechanism itself, its digraph and the matrices of whole numbers, Eqs. (1)-(5).
void addDigraphPart(Report& report, const AnalysisSnapshot& snapshot);
/// Screws, P and the solution, Eqs. (6)-(25).
void addMatroidPart(Report& report, const SnapshotPtr& snapshot, const std::stop_token& stop);
/// Carriers, terminal and f-circuit equations, the chain of substitutions, Eqs. (26)-(45).
void addTtGraphPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Both methods side by side: that they agree, step by step, mesh by mesh, counted, and what the paper
/// concludes.
void addComparisonPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Cutset equations, the transposed solution and the torques under the document's loads, by both methods;
/// nothing without loads. Starred equations stand beside those of the kinematics that they are the duals of.
void addStaticsPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Adds to a report, for its parts.
class ReportPart {
 protected:
  explicit ReportPart(Report& report, const std::stop_token& stop = {}) : m_report(report), m_stop(stop) {}

  [[nodiscard]] bool isStopped() const { return m_stop.stop_requested(); }

  /// Marked by toTranslate().
  void heading(int level, const char* text) { put(ReportHeading{level, translated(text)}); }
  /// With formulas between dollar signs (reportWords()).
  void paragraph(std::string_view text);
  /// Without the line ends behind it: an empty line would end the formula in LaTeX.
  void equation(std::string tex, std::optional<int> number = std::nullopt,
                std::vector<ElementId> elements = {});
  /// The same of statics: the number of its twin, with a star.
  void dualEquation(std::string tex, int number, std::vector<ElementId> elements = {});
  template <class Block>
  void put(Block block) {
    m_report.blocks.emplace_back(std::move(block));
  }

 private:
  Report& m_report;
  std::stop_token m_stop;
};

}  // namespace geargraph::inline report
