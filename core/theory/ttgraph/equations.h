#pragma once

#include <string>
#include <vector>

#include "core/theory/ttgraph/substitution_steps.h"

namespace geargraph {

enum class FormulaStyle { text, latex };

/// Writes the method's equations as the paper prints them, in text ("w51'' = w50 - w10") or in LaTeX.
///
/// `graph`, `plan` and `ring` outlive it; the ring has the names that are written (ttRatioRing()).
class TtEquations {
 public:
  /// @pre graph.isComplete()
  TtEquations(const TtGraph& graph, const SubstitutionPlan& plan, RatioNaming naming, FormulaStyle style);

  /// "w51'' = -n25 w21''" [AU, Eqs. (27)-(30)]; with the ratios' matroid names "w51'' = -1/i16 w21''".
  [[nodiscard]] std::string terminal(MeshOrdinal mesh) const;
  /// "w51'' = w50 - w10" [AU, Eqs. (31)-(38)].
  [[nodiscard]] std::string tailCircuit(MeshOrdinal mesh) const;
  [[nodiscard]] std::string headCircuit(MeshOrdinal mesh) const;
  /// "w10 + w21 = 0": the circuit of an engaged coupling, by its position in TtGraph::held().
  [[nodiscard]] std::string heldCircuit(int place) const;
  /// The stages of a step, joined by "=" when printed [AU, Eqs. (39)-(42)]: "w21", "w21''", "-n52 w51''",
  /// "-n52 (w50 - w10)", "-n52*n41 w40 - n52 w50"; of a step with an inner joint also "n73 (-n67 w62')".
  /// Without the last where it exceeded the budget.
  [[nodiscard]] std::vector<std::string> stages(const SubstitutionStep& step) const;

 private:
  struct Term {
    bool negative = false;
    std::string factor;  ///< empty: 1
    std::string symbol;
  };

  [[nodiscard]] std::string write(const VelocityName& name) const;
  [[nodiscard]] std::string write(const std::vector<Term>& terms) const;
  [[nodiscard]] std::string ratio(MeshOrdinal mesh, bool inverse) const;
  [[nodiscard]] std::string bracketed(const RationalFunction& factor) const;
  [[nodiscard]] Term weighted(const RationalFunction& factor, JointOrdinal joint) const;
  /// A joint, and what is written for it.
  struct PutIn {
    JointOrdinal joint = -1;
    std::string text;
  };
  [[nodiscard]] std::vector<Term> sum(std::span<const CircuitTerm> circuit, const PutIn& putIn) const;
  [[nodiscard]] std::vector<std::string> fromMesh(JointOrdinal joint, MeshOrdinal mesh,
                                                  const PutIn& putIn) const;
  [[nodiscard]] std::string fromHeldCircuit(JointOrdinal joint, int equation, const PutIn& putIn) const;
  [[nodiscard]] std::vector<std::string> direct(JointOrdinal joint, int equation, const PutIn& putIn) const;
  void putInner(const SubstitutionStep& step, std::vector<std::string>& stages) const;

  const TtGraph& m_graph;
  const SubstitutionPlan& m_plan;
  FormulaStyle m_style;
  RatioNaming m_naming;
  ByMesh<RatioNames> m_names;
};

}  // namespace geargraph
