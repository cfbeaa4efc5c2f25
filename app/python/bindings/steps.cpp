// The steps of both methods, and the derivation as data.

#include "app/python/bindings/snapshot.h"
#include "core/presentation/report/report.h"

namespace geargraph::python {
namespace {

py::object formula(const std::optional<RationalFunction>& function) {
  if (!function) return py::none();
  return py::make_tuple(function->toText(), function->toLatex());
}

/// By line: the joint, the meshes or couplings that give it, and its terms (joint, (text, LaTeX)).
py::object matroidSteps(Snapshot& self) {
  (void)self.matroid(true);
  const SnapshotPtr snapshot = self.solved();
  if (!snapshot->solved || !snapshot->solved->symbolic) return py::none();
  py::list steps;
  for (const SymbolicLine& line : snapshot->solved->symbolic->lines) {
    py::list terms;
    for (const SymbolicLine::Term& term : line.terms)
      terms.append(py::make_tuple(term.joint, formula(term.coefficient)));
    steps.append(py::make_tuple(line.joint, line.equation, terms));
  }
  return steps;
}

/// By step: number, joint, equations, coupled, uses, terms before (joint, formula), formulas after by input.
py::object ttSteps(Snapshot& self) {
  (void)self.matroid(true);
  const SnapshotPtr snapshot = self.solved();
  if (!snapshot->solved || !snapshot->solved->ttSteps) return py::none();
  py::list steps;
  for (const SubstitutionStep& step : *snapshot->solved->ttSteps) {
    py::list before, after;
    for (const SolvedTerm& term : step.before)
      before.append(py::make_tuple(term.joint, formula(term.coefficient)));
    for (const auto& coefficient : step.after) after.append(formula(coefficient));
    steps.append(py::make_tuple(step.number, step.joint, step.equations, step.coupled, step.uses, before,
                                after, branchName(*snapshot->graph, step.joint).toText(),
                                branchName(*snapshot->graph, step.joint).toLatex()));
  }
  return steps;
}

/// By mesh: "i15", "n41" and their inverses, as (matroid, T-T graph, LaTeX, inverse, its LaTeX).
py::list ratios(const Snapshot& self) {
  py::list names;
  for (const RatioNames& name : ratioNames(*self.live()->graph))
    names.append(py::make_tuple(name.matroid, name.ttGraph, name.latex, name.inverse, name.inverseLatex));
  return names;
}

py::list wordsOf(const ReportWords& words) {
  py::list spans;
  for (const ReportSpan& span : words) spans.append(py::make_tuple(span.text, span.isFormula));
  return spans;
}

py::tuple blockOf(const ReportBlock& block) {
  struct Visitor {
    py::tuple operator()(const ReportHeading& heading) const {
      return py::make_tuple("heading", heading.level, heading.text);
    }
    py::tuple operator()(const ReportParagraph& paragraph) const {
      return py::make_tuple("paragraph", wordsOf(paragraph.words));
    }
    py::tuple operator()(const ReportEquation& equation) const {
      py::list elements;
      for (const ElementId& element : equation.elements)
        elements.append(py::make_tuple(kindName(element.kind), element.id.text()));
      return py::make_tuple("equation", equation.tex, equation.label(), elements);
    }
    py::tuple operator()(const ReportTable& table) const {
      py::list rows;
      for (const auto& row : table.rows) {
        py::list cells;
        for (const ReportWords& words : row) cells.append(wordsOf(words));
        rows.append(cells);
      }
      return py::make_tuple("table", table.head, rows);
    }
    py::tuple operator()(const ReportList& list) const {
      py::list items;
      for (const ReportWords& words : list.items) items.append(wordsOf(words));
      return py::make_tuple("list", items);
    }
    py::tuple operator()(const ReportFigure& figure) const {
      constexpr std::array kDrawings = {"schematic", "digraph", "ttgraph", "levers", "nomogram"};
      static_assert(kDrawings.size() == kReportDrawingCount);
      return py::make_tuple("figure", kDrawings.at(static_cast<std::size_t>(figure.drawing)), figure.caption);
    }
    py::tuple operator()(const ReportCurves& curves) const {
      return py::make_tuple("figure", "curves", curves.caption);
    }
  };
  return std::visit(Visitor(), block);
}

py::tuple derivation(Snapshot& self) {
  if (self.mechanism().n() > kMaxReportLinks)
    raise("limit", "A derivation is written of at most " + std::to_string(kMaxReportLinks) + " links.");
  const SnapshotPtr snapshot = self.full();
  const Report report =
      interruptible([&](const std::stop_token& stop) { return derivationReport(snapshot, stop); });
  py::list blocks;
  for (const ReportBlock& block : report.blocks) blocks.append(blockOf(block));
  return py::make_tuple(report.title, blocks);
}

}  // namespace

void addSteps(py::module_& module) {
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot"))
      .def("matroid_steps", matroidSteps)
      .def("tt_steps", ttSteps)
      .def("ratios", ratios)
      .def("derivation", derivation);
}

}  // namespace geargraph::python
