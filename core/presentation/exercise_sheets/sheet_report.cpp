#include "core/presentation/exercise_sheets/sheet_report.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/report/report_words.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxOptions = 12;  ///< that are listed beside a blank

/// An answer as print sets it: a minus sign, a blank after each comma of a set.
std::string printed(const AnswerField& field, const std::string& answer) {
  std::string text;
  for (const char c : answer) {
    text += c == '-' && text.empty() ? std::string("\u2212") : std::string(1, c);
    if (c == ',' && field.kind == FieldKind::set) text += ' ';
  }
  return text;
}

std::string points(int count) {
  const std::string number = std::to_string(count);
  return count == 1 ? translated("%1 point", {number}) : translated("%1 points", {number});
}

class SheetWriter {
 public:
  SheetWriter(const ExerciseSource& source, SheetForm form, Report& report)
      : m_source(source), m_isSolution(form == SheetForm::solution), m_report(report) {}

  void addHead(const SheetPlan& plan, const SheetVariant& sheet, const std::string& student) {
    std::string title = plan.title;
    if (plan.variants > 1) title = translated("%1, variant %2", {title, std::to_string(sheet.variant)});
    m_report.title = m_isSolution ? translated("%1: solution", {title}) : title;
    m_report.subtitle = difficultyTitle(difficultyOf(m_source).level);
    const std::string count = std::to_string(sheet.questions.size());
    put(ReportParagraph{plainWords(
        translated("Name: %1", {student.empty() ? std::string(30, '_') : student}) + "   \u00b7   " +
        (sheet.questions.size() == 1 ? translated("%1 question", {count})
                                     : translated("%1 questions", {count})) +
        ", " + points(sheet.points()))});
  }

  void addMechanism() {
    const Mechanism& mechanism = m_source.mechanism();
    put(ReportHeading{1, mechanism.name.empty() ? translated("The mechanism") : mechanism.name});
    put(ReportFigure{ReportDrawing::schematic, translated("Functional schematic")});
    put(ReportFigure{ReportDrawing::digraph, translated("Digraph")});
    const Digraph& graph = m_source.graph();
    ReportTable joints{
        {translated("Turning joint"), translated("From"), translated("To"), translated("Axis")}, {}};
    for (int joint = 0; joint < graph.t(); ++joint) {
      joints.rows.push_back({plainWords(m_source.edgeLabel(joint)), linkWords(graph.edge(joint).tail),
                             linkWords(graph.edge(joint).head), plainWords(axisName(joint))});
    }
    if (!joints.rows.empty()) put(std::move(joints));
    ReportTable meshes{{translated("Gear mesh"), translated("From"), translated("Teeth"), translated("To"),
                        translated("Teeth"), translated("Kind")},
                       {}};
    for (int mesh = 0; mesh < graph.c(); ++mesh) {
      const GearMesh& gears = mechanism.gearMeshes[static_cast<std::size_t>(mesh)];
      meshes.rows.push_back({plainWords(m_source.meshLabel(mesh)), linkWords(graph.meshEdge(mesh).tail),
                             plainWords(std::to_string(gears.tailTeeth)),
                             linkWords(graph.meshEdge(mesh).head),
                             plainWords(std::to_string(gears.headTeeth)), plainWords(kindOf(mesh))});
    }
    if (!meshes.rows.empty()) put(std::move(meshes));
    addStates();
  }

  void addQuestion(const Question& question, int number) {
    const std::string title(kindTitle(*kindFromName(question.kind)));
    put(ReportHeading{2, std::to_string(number) + ". " + title + " (" + points(question.points) + ")"});
    put(ReportParagraph{reportWords(question.prompt)});
    if (!question.formula.empty()) put(ReportEquation{question.formula, std::nullopt, question.elements});
    question.table.columns.empty() ? addList(question) : addTable(question);
    if (m_isSolution) put(ReportParagraph{plainWords(question.rule)});
  }

  /// Marked by toTranslate().
  void heading(const char* text) { put(ReportHeading{1, translated(text)}); }

 private:
  template <class Block>
  void put(Block block) {
    m_report.blocks.emplace_back(std::move(block));
  }

  [[nodiscard]] ReportWords linkWords(int node) const { return plainWords(m_source.linkLabel(node)); }
  [[nodiscard]] std::string axisName(int joint) const {
    const auto& live = m_source.snapshot()->kinematics;
    if (live) return live->ttGraph->levels().levelOf(joint);
    return m_source.mechanism().turningJoints[static_cast<std::size_t>(joint)].axis.text();
  }
  [[nodiscard]] std::string kindOf(int mesh) const {
    if (m_source.matroid() == nullptr) return {};
    return kindWord(m_source.meshKind(mesh));
  }
  [[nodiscard]] ReportWords cell(const Question& question, std::size_t field) const {
    return plainWords(m_isSolution ? printed(question.fields[field], question.solution[field])
                                   : std::string("____"));
  }

  void addStates() {
    ReportTable couplings{{translated("Brake or clutch"), translated("Engaged, it holds")}, {}};
    for (const ShiftElement& coupling : m_source.mechanism().couplings) {
      std::vector<std::string> links;
      for (const LinkId link : coupling.links)
        links.push_back(m_source.linkLabel(m_source.graph().nodeOf(link)));
      couplings.rows.push_back(
          {plainWords(coupling.id.text()),
           plainWords(coupling.kind == ShiftElementKind::brake
                          ? translated("link %1 against the ground", {links.front()})
                          : translated("links %1 together", {listed(links, kAllNames)}))});
    }
    if (!couplings.rows.empty()) put(std::move(couplings));
  }

  void addTable(const Question& question) {
    ReportTable table{{""}, {}, true};
    std::size_t field = 0;
    for (std::size_t column = 0; column < question.table.columns.size(); ++column) {
      const bool isParted = question.table.partition == static_cast<int>(column);
      table.head.push_back((isParted ? "\u00a6 " : "") +
                           translated(std::string_view(question.table.columns[column])));
    }
    for (const std::string& name : question.table.rows) {
      table.rows.push_back({plainWords(name)});
      for (std::size_t column = 0; column < question.table.columns.size(); ++column)
        table.rows.back().push_back(cell(question, field++));
    }
    put(std::move(table));
  }

  void addList(const Question& question) {
    ReportTable table{{"", translated("Answer"), ""}, {}, true};
    for (std::size_t field = 0; field < question.fields.size(); ++field) {
      const AnswerField& asked = question.fields[field];
      const bool isShort = asked.kind == FieldKind::choice && asked.options.size() <= kMaxOptions;
      std::string note =
          isShort ? translated("one of %1", {listed(asked.options, kMaxOptions, toTranslate("or"))})
                  : std::string();
      if (asked.kind == FieldKind::set) note = translated("a list");
      ReportWords answer = cell(question, field);
      if (!m_isSolution) answer = plainWords("____________________");
      table.rows.push_back({plainWords(asked.shownName()), std::move(answer), plainWords(note)});
    }
    put(std::move(table));
  }

  const ExerciseSource& m_source;
  bool m_isSolution;
  Report& m_report;
};

}  // namespace

Report sheetReport(const ExerciseSource& source, const SheetPlan& plan, const SheetVariant& sheet,
                   const std::string& student, SheetForm form) {
  Report report;
  SheetWriter writer(source, form, report);
  writer.addHead(plan, sheet, student);
  writer.addMechanism();
  writer.heading(form == SheetForm::solution ? toTranslate("Solution") : toTranslate("Questions"));
  int number = 0;
  for (const Question& question : sheet.questions) writer.addQuestion(question, ++number);
  return report;
}

}  // namespace geargraph
