#pragma once

#include "core/foundations/base/translation.h"
#include "core/mechanism/graph/paper_equation.h"
#include "core/presentation/report/report.h"

namespace geargraph {

// The parts of a report, each as far as the snapshot allows; meaningless if `stop` was requested meanwhile.

/// The longest list of equations, with one per joint, mesh or step.
constexpr int kMaxListed = 100;

/// The mechanism itself, its digraph and the matrices of whole numbers, Eqs. (1)-(5).
void addDigraphPart(Report& report, const SnapshotPtr& snapshot);
/// Screws, P and the solution, Eqs. (6)-(25).
void addMatroidPart(Report& report, const SnapshotPtr& snapshot, const std::stop_token& stop);
/// Carriers, terminal and f-circuit equations, the chain of substitutions, Eqs. (26)-(45).
void addTtGraphPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Both methods compared: their agreement, step by step, mesh by mesh, operation counts, and the paper's
/// conclusions.
void addComparisonPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Cutset equations, the transposed solution and the torques under the document's loads, by both methods;
/// nothing without loads. Starred equations are paired with the equations of the kinematics whose duals they
/// are.
void addStaticsPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// The gear sets as levers, with places and speeds of their links, and the nomogram of the states; nothing
/// without a lever.
void addLeversPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Base of the parts, which adds blocks to a report.
class ReportPart {
 protected:
  explicit ReportPart(Report& report, const std::stop_token& stop = {}) : m_report(report), m_stop(stop) {}

  [[nodiscard]] bool isStopped() const { return m_stop.stop_requested(); }

  /// Adds a heading, translated. `text` is marked by toTranslate().
  void heading(int level, const char* text) { put(ReportHeading{level, translated(text)}); }
  /// Adds a paragraph, with formulas between dollar signs (reportWords()).
  void paragraph(std::string_view text);
  /// Adds an equation, without trailing line ends: an empty line would end the formula in LaTeX.
  void equation(std::string tex, std::optional<int> number = std::nullopt,
                std::vector<ElementId> elements = {});
  void equation(std::string tex, PaperEquation number, std::vector<ElementId> elements = {});
  /// The same for statics: `number` is that of its dual, with a star.
  void dualEquation(std::string tex, int number, std::vector<ElementId> elements = {});
  void dualEquation(std::string tex, PaperEquation number, std::vector<ElementId> elements = {});
  template <class Block>
  void put(Block block) {
    m_report.blocks.emplace_back(std::move(block));
  }

 private:
  Report& m_report;
  std::stop_token m_stop;
};

}  // namespace geargraph
