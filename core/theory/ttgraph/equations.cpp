#include "core/theory/ttgraph/equations.h"

#include <algorithm>

namespace geargraph {

TtEquations::TtEquations(const TtGraph& graph, const SubstitutionPlan& plan, RatioNaming naming,
                         FormulaStyle style)
    : m_graph(graph), m_plan(plan), m_style(style), m_naming(naming), m_names(ratioNames(graph.graph())) {}

std::string TtEquations::write(const VelocityName& name) const {
  return m_style == FormulaStyle::latex ? name.toLatex() : name.toText();
}

std::string TtEquations::write(const std::vector<Term>& terms) const {
  std::string text;
  for (const Term& term : terms) {
    if (text.empty()) {
      text += term.negative ? "-" : "";
    } else {
      text += term.negative ? " - " : " + ";
    }
    text += term.factor.empty() ? term.symbol : term.factor + " " + term.symbol;
  }
  return text.empty() ? "0" : text;
}

/// N_tail / N_head of the mesh, or the other way up.
std::string TtEquations::ratio(MeshOrdinal mesh, bool inverse) const {
  const RatioNames& names = m_names[mesh];
  const bool latex = m_style == FormulaStyle::latex;
  if (m_naming == RatioNaming::ttGraph) {
    if (inverse) return latex ? names.inverseLatex : names.inverse;
    return latex ? names.latex : names.ttGraph;
  }
  const std::string name = latex ? "i_{" + names.matroid.substr(1) + "}" : names.matroid;
  if (!inverse) return name;
  return latex ? "\\frac{1}{" + name + "}" : "1/" + name;
}

std::string TtEquations::bracketed(const RationalFunction& factor) const {
  const std::string text = m_style == FormulaStyle::latex ? factor.toLatex() : factor.toText();
  const bool fraction =
      m_style == FormulaStyle::latex && (text.starts_with("\\frac") || text.starts_with("-\\frac"));
  const bool isSum = text.find(" + ") != std::string::npos || text.find(" - ") != std::string::npos;
  return isSum && !fraction ? "(" + text + ")" : text;
}

TtEquations::Term TtEquations::weighted(const RationalFunction& factor, JointOrdinal joint) const {
  Term term{false, bracketed(factor), write(branchName(m_graph.graph(), joint))};
  if (term.factor.front() == '-') {
    term.negative = true;
    term.factor.erase(0, 1);
  }
  if (term.factor == "1") term.factor.clear();
  return term;
}

std::vector<TtEquations::Term> TtEquations::sum(std::span<const CircuitTerm> circuit,
                                                const PutIn& putIn) const {
  std::vector<Term> terms;
  for (const CircuitTerm& term : circuit) {
    terms.push_back({term.coefficient < 0,
                     {},
                     term.joint == putIn.joint ? "(" + putIn.text + ")"
                                               : write(branchName(m_graph.graph(), term.joint))});
  }
  return terms;
}

std::string TtEquations::terminal(MeshOrdinal mesh) const {
  const TerminalPair& pair = *m_graph.terminal(mesh);
  return write(tailChordName(pair)) + " = " +
         write({{pair.sign < 0, ratio(mesh, true), write(headChordName(pair))}});
}

std::string TtEquations::tailCircuit(MeshOrdinal mesh) const {
  return write(tailChordName(*m_graph.terminal(mesh))) + " = " + write(sum(m_graph.tailCircuit(mesh), {}));
}

std::string TtEquations::headCircuit(MeshOrdinal mesh) const {
  return write(headChordName(*m_graph.terminal(mesh))) + " = " + write(sum(m_graph.headCircuit(mesh), {}));
}

std::string TtEquations::heldCircuit(int place) const {
  return write(sum(m_graph.held()[static_cast<std::size_t>(place)].terms, {})) + " = 0";
}

std::string TtEquations::fromHeldCircuit(JointOrdinal joint, int equation, const PutIn& putIn) const {
  const std::vector<CircuitTerm>& terms = m_graph.heldCircuit(equation).terms;
  const auto unknown =
      std::find_if(terms.begin(), terms.end(), [&](const CircuitTerm& term) { return term.joint == joint; });
  std::vector<CircuitTerm> rest;
  for (const CircuitTerm& term : terms) {
    if (term.joint != joint) rest.push_back({term.joint, -unknown->coefficient * term.coefficient});
  }
  return write(sum(rest, putIn));
}

/// The unknown is in one of the mesh's two circuits: unknown = +-(own chord - the circuit's other terms). Its
/// chord is a ratio of the other chord, and that one its own circuit.
std::vector<std::string> TtEquations::fromMesh(JointOrdinal joint, MeshOrdinal mesh,
                                               const PutIn& putIn) const {
  const TerminalPair& pair = *m_graph.terminal(mesh);
  const auto tail = m_graph.tailCircuit(mesh);
  const auto head = m_graph.headCircuit(mesh);
  const auto isUnknown = [&](const CircuitTerm& term) { return term.joint == joint; };
  const bool inTail = std::any_of(tail.begin(), tail.end(), isUnknown);
  const auto own = inTail ? tail : head;
  const auto other = inTail ? head : tail;
  const std::string ownChord = write(inTail ? tailChordName(pair) : headChordName(pair));
  const std::string otherChord = write(inTail ? headChordName(pair) : tailChordName(pair));

  const bool turned = std::find_if(own.begin(), own.end(), isUnknown)->coefficient < 0;
  std::vector<CircuitTerm> rest;
  for (const CircuitTerm& term : own) {
    if (!isUnknown(term)) rest.push_back({term.joint, turned ? term.coefficient : -term.coefficient});
  }
  const auto with = [&](Term chord) {
    std::vector<Term> terms{std::move(chord)};
    for (Term& term : sum(rest, putIn)) terms.push_back(std::move(term));
    return write(terms);
  };
  const std::string factor = ratio(mesh, inTail);
  const bool negative = turned != (pair.sign < 0);
  std::vector<std::string> stages{with({turned, {}, ownChord}), with({negative, factor, otherChord})};
  if (other.size() > 1) {
    stages.push_back(with({negative, factor, "(" + write(sum(other, putIn)) + ")"}));
  } else {
    const Term only = sum(other, putIn).front();
    stages.push_back(with({negative != only.negative, factor, only.symbol}));
  }
  return stages;
}

std::vector<std::string> TtEquations::direct(JointOrdinal joint, int equation, const PutIn& putIn) const {
  if (equation >= m_graph.graph().c()) return {fromHeldCircuit(joint, equation, putIn)};
  return fromMesh(joint, equation, putIn);
}

/// The last stage again, with what the inner joint's equation writes for it: its ratio of a chord, and that
/// chord's circuit; not its own chord, which is another name.
void TtEquations::putInner(const SubstitutionStep& step, std::vector<std::string>& stages) const {
  std::vector<std::string> inner = direct(step.inner, step.equations.back(), {});
  if (inner.size() > 1) inner.erase(inner.begin());
  for (std::string& text : inner) {
    stages.push_back(direct(step.joint, step.equations.front(), {step.inner, std::move(text)}).back());
  }
}

std::vector<std::string> TtEquations::stages(const SubstitutionStep& step) const {
  std::vector<std::string> stages{write(branchName(m_graph.graph(), step.joint))};
  if (step.turned != 0) {
    stages.push_back(direct(step.joint, step.equations.front(), {}).back());
  } else if (step.coupled) {
    std::vector<Term> before;
    for (const SolvedTerm& term : step.before) before.push_back(weighted(term.coefficient, term.joint));
    stages.push_back(write(before));
  } else {
    for (std::string& stage : direct(step.joint, step.equations.front(), {}))
      stages.push_back(std::move(stage));
    if (step.inner >= 0) putInner(step, stages);
  }
  std::vector<Term> after;
  for (std::size_t input = 0; input < step.after.size(); ++input) {
    if (!step.after[input]) return stages;
    if (!step.after[input]->isZero()) after.push_back(weighted(*step.after[input], m_plan.inputs[input]));
  }
  std::string last = write(after);
  if (last != stages.back()) stages.push_back(std::move(last));
  return stages;
}

}  // namespace geargraph
