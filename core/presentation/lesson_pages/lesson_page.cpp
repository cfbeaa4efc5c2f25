#include "core/presentation/lesson_pages/lesson_page.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/foundations/files/gzip.h"
#include "core/foundations/files/json_writer.h"
#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/export_api/report_lists.h"
#include "core/presentation/handout/page_frame.h"
#include "core/presentation/handout/question_blanks.h"
#include "core/presentation/handout/script_texts.h"
#include "core/presentation/report/written_words.h"
#include "core/teaching/lessons/mastery.h"

namespace geargraph {
namespace {

/// What a page holds of a step.
struct PageStep {
  const LessonStep* step = nullptr;
  MechanismPtr mechanism;
  std::optional<Question> question;
  DisplayList drawing;
  DisplayList solution;  ///< of a task to draw
  bool isFresh = false;
};

constexpr std::array<const char*, 5> kViewTitles = {toTranslate("Digraph"), toTranslate("T-T graph"),
                                                    toTranslate("Schematic"), toTranslate("Levers"),
                                                    toTranslate("Nomogram")};

/// As in the window, without the numbers that may be asked for.
DisplayList drawingFor(StepView view, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  constexpr std::array kDrawings = {ReportDrawing::digraph, ReportDrawing::ttGraph, ReportDrawing::schematic,
                                    ReportDrawing::levers, ReportDrawing::nomogram};
  if (view == StepView::levers) {
    const auto picture = leverPictureOf(snapshot, stop);
    if (!picture || picture->plan.levers.empty()) return {};
    const Mechanism& mechanism = *snapshot.mechanism;
    return leverSheet(mechanism, *picture, leverLayout(mechanism, picture->plan), {},
                      LeverLook{true, true, false, {}})
        .drawing;
  }
  return reportDrawing(kDrawings[static_cast<std::size_t>(view)], snapshot, stop);
}

class LessonPage {
 public:
  LessonPage(const Lesson& lesson, const ExampleSource& examples, const std::stop_token& stop)
      : m_lesson(lesson), m_examples(examples), m_stop(stop) {}

  /// Prepares all steps; what is wrong with one.
  std::optional<Diagnostics> prepare() {
    for (std::size_t i = 0; i < m_lesson.steps.size(); ++i) {
      if (const auto faults = add(m_lesson, i, false)) return faults;
    }
    if (practiceOf(m_lesson).empty()) return std::nullopt;
    constexpr int kMostTries = 4 * kSpareQuestions;
    for (int number = 0; number < kMostTries && static_cast<int>(m_fresh.size()) < kSpareQuestions;
         ++number) {
      m_fresh.push_back(std::make_unique<Lesson>(m_lesson));
      m_fresh.back()->steps = {freshStep(m_lesson, 1, number)};
      if (const auto faults = add(*m_fresh.back(), 0, true)) return faults;
      if (isAskedTwice()) {
        m_steps.pop_back();
        m_fresh.pop_back();
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string html(HandoutUse use) const {
    const bool reports = use == HandoutUse::learningPlatform;
    const std::string title = escapedXml(m_lesson.title);
    std::string page = pageHead(title, PageKind::lesson, reports) + "<body class=\"lesson\">\n<header>\n" +
                       "<div class=\"title\"><h1>" + title + "</h1>\n<p>" + escapedXml(aim()) +
                       "</p></div>\n</header>\n<main>\n<section id=\"exercises\">\n";
    for (std::size_t i = 0; i < m_steps.size(); ++i) page += article(m_steps[i], i + 1);
    page += "</section>\n</main>\n" + pageFooter(reports, {}) +
            "<script type=\"application/json\" id=\"mechanism\">" + data() + "</script>\n" +
            "<script type=\"application/octet-stream\" id=\"lesson-key\">" + key() + "</script>\n" +
            pageScriptElement(pageScript(PageKind::lesson));
    if (reports) page += pageScriptElement(pageReporter());
    return page + "</body>\n</html>\n";
  }

 private:
  std::optional<Diagnostics> add(const Lesson& lesson, std::size_t position, bool isFresh) {
    auto prepared = prepareStep(lesson, position, m_examples, m_stop);
    if (!prepared) return prepared.error();
    PageStep page{
        &lesson.steps[position], prepared->mechanism, std::move(prepared->question), {}, {}, isFresh};
    // As the window counts: two for a right answer at the first check.
    constexpr int kPoints = 2;
    if (page.question) page.question->points = kPoints;
    const SnapshotPtr snapshot = analyze(page.mechanism, 0, m_stop);
    if (snapshot) page.drawing = drawingFor(page.step->view, *snapshot, m_stop);
    if (const auto* draw = std::get_if<DrawTask>(&page.step->task)) {
      const auto solution = mechanismOf(draw->solution, m_examples, {});
      if (!solution) return solution.error();
      const SnapshotPtr solved = analyze(*solution, 0, m_stop);
      if (solved) page.solution = drawingFor(page.step->view, *solved, m_stop);
    }
    m_steps.push_back(std::move(page));
    return std::nullopt;
  }

  [[nodiscard]] bool isAskedTwice() const {
    const Question& last = *m_steps.back().question;
    return std::any_of(m_steps.begin(), m_steps.end() - 1, [&](const PageStep& other) {
      return other.question && other.question->prompt == last.prompt &&
             other.question->solution == last.solution && other.question->formula == last.formula;
    });
  }

  [[nodiscard]] std::string aim() const {
    std::string text;
    if (m_lesson.minutes > 0) text = translated("%1 min", {std::to_string(m_lesson.minutes)}) + ". ";
    if (!m_lesson.goal.empty()) text += translated("Afterwards you can %1.", {m_lesson.goal});
    return text;
  }

  [[nodiscard]] static std::string figure(const DisplayList& drawing, const std::string& title) {
    if (drawing.marks.empty()) return {};
    const std::string svg = svgOf(drawing, SheetStyle());
    return "<figure data-title=\"" + escapedXml(title) + "\">\n" + svg.substr(svg.find("<svg")) +
           "<figcaption>" + escapedXml(title) + "</figcaption>\n</figure>\n";
  }

  [[nodiscard]] static std::string article(const PageStep& page, std::size_t number) {
    const LessonStep& step = *page.step;
    const std::string name = "step-" + std::to_string(number);
    std::vector<ReportBlock> text;
    if (!step.text.empty()) text.emplace_back(ReportParagraph{writtenWords(step.text)});
    addWrittenFormula(text, step.formula, step.equation);
    std::vector<ReportBlock> task{
        ReportHeading{2, translated(taskTitle(step))},
        ReportParagraph{writtenWords(page.question ? page.question->prompt : step.prompt)}};
    if (page.question) addWrittenFormula(task, page.question->formula, PaperEquation::none);
    const std::string view = translated(kViewTitles[static_cast<std::size_t>(step.view)]);
    const char* begin =
        page.isFresh ? "<article class=\"question step fresh\"" : "<article class=\"question step\"";
    std::string html = std::string(begin) + " aria-labelledby=\"" + name + "\">\n<h2 id=\"" + name + "\">" +
                       escapedXml(step.title) + "</h2>\n<div class=\"told\">" + reportHtmlBlocks(text) +
                       "</div>\n" + figure(page.drawing, view) + "<div class=\"task\">" +
                       reportHtmlBlocks(task);
    if (page.question)
      html += questionBlanks(*page.question, translated("Answer to step %1", {std::to_string(number)}));
    html += hints(step);
    if (!page.question) html += drawNote(page);
    return html + "</div>\n</article>\n";
  }
  [[nodiscard]] static std::string hints(const LessonStep& step) {
    std::string items;
    for (const std::string& hint : step.hints) {
      std::string words = reportHtmlBlocks({ReportParagraph{writtenWords(hint)}});
      items += "<li>" + words + "</li>\n";
    }
    return "<details class=\"hint\"><summary>" + escapedXml(translated("Hints")) + "</summary>\n<ol>" +
           items + "</ol></details>\n";
  }
  [[nodiscard]] static std::string drawNote(const PageStep& page) {
    const std::string title = translated("One drawing that is right");
    return "<p class=\"note\">" +
           escapedXml(translated("This is drawn in GearGraph: Learn > Lessons. It gives no points here.")) +
           "</p>\n<details class=\"drawn\"><summary>" + escapedXml(title) + "</summary>\n" +
           figure(page.solution, title) + "</details>\n";
  }

  static void writeKeys(JsonWriter& json, const std::vector<ElementId>& elements) {
    json.beginArray(JsonWriter::Layout::row);
    for (const ElementId& each : elements)
      json.string(std::string(listName(each.kind)) + "/" + each.id.text());
    json.endArray();
  }
  static void writeElement(JsonWriter& json, const ElementId& id, int label, const std::string& mention) {
    json.beginObject(JsonWriter::Layout::row);
    json.member("key", std::string(listName(id.kind)) + "/" + id.id.text());
    json.member("label", std::to_string(label));
    json.member("mention", mention);
    json.endObject();
  }
  static void writeElements(JsonWriter& json, const Mechanism& mechanism) {
    json.beginArray();
    for (int link = 0; link <= mechanism.n(); ++link) {
      const int label = mechanism.linkLabel(link);
      writeElement(json, mechanism.links[static_cast<std::size_t>(link)].id, label,
                   link == 0 ? translated("the ground") : translated("link %1", {std::to_string(label)}));
    }
    for (int joint = 0; joint < mechanism.t(); ++joint) {
      const int label = mechanism.jointLabel(joint);
      writeElement(json, mechanism.turningJoints[static_cast<std::size_t>(joint)].id, label,
                   translated("joint %1", {std::to_string(label)}));
    }
    for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
      const int label = mechanism.meshLabel(mesh);
      writeElement(json, mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id, label,
                   translated("mesh %1", {std::to_string(label)}));
    }
    json.endArray();
  }

  [[nodiscard]] std::string data() const {
    TextSink sink;
    {
      JsonWriter json(sink);
      json.beginObject();
      json.member("format", "geargraph-lesson-page");
      json.member("version", 1);
      json.member("decimal", std::string(1, decimalSign()));
      json.member("lesson", m_lesson.id);
      json.member("fresh", kFreshQuestions);
      json.key("texts");
      json.beginObject();
      for (const ScriptText& each : scriptTexts()) json.member(each.name, translated(each.text));
      json.endObject();
      json.key("steps");
      json.beginArray();
      for (const PageStep& page : m_steps) {
        const auto* answer = std::get_if<AnswerTask>(&page.step->task);
        json.beginObject();
        json.member("isFresh", page.isFresh);
        json.member("isAsked", page.question.has_value());
        json.member("isPicked", answer != nullptr && !answer->from.empty());
        json.key("lit");
        writeKeys(json, page.step->elements);
        json.key("elements");
        writeElements(json, *page.mechanism);
        json.endObject();
      }
      json.endArray();
      json.endObject();
    }
    std::string text = sink.take();
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
      text.replace(at, 1, "\\u003c");
    return text;
  }
  [[nodiscard]] std::string key() const {
    std::vector<Question> questions;
    for (const PageStep& page : m_steps) {
      if (page.question) questions.push_back(*page.question);
    }
    TextSink sink;
    {
      JsonWriter json(sink);
      json.beginObject();
      writeQuestionsWithKeys(json, questions);
      json.endObject();
    }
    return base64(gzip(sink.take()));
  }

  const Lesson& m_lesson;
  const ExampleSource& m_examples;
  const std::stop_token& m_stop;
  std::vector<std::unique_ptr<Lesson>> m_fresh;  ///< by fresh question, its only step
  std::vector<PageStep> m_steps;
};

}  // namespace

Expected<std::string> lessonHtml(const Lesson& lesson, const ExampleSource& examples, HandoutUse use,
                                 const std::stop_token& stop) {
  LessonPage page(lesson, examples, stop);
  if (auto faults = page.prepare()) return *faults;
  return page.html(use);
}

}  // namespace geargraph
