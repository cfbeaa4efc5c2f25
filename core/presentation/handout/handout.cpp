#include "core/presentation/handout/handout.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/machine/solids/gear_solid.h"
#include "core/presentation/handout/handout_data.h"
#include "core/presentation/handout/handout_sections.h"
#include "core/presentation/handout/page_frame.h"
#include "core/presentation/handout/page_policy.h"
#include "core/presentation/handout/page_scene.h"

namespace geargraph {
namespace {

std::string counts(const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  std::string text =
      counted(mechanism.n(), toTranslate("%1 moving link"), toTranslate("%1 moving links")) + ", " +
      counted(mechanism.t(), toTranslate("%1 turning joint"), toTranslate("%1 turning joints")) + ", " +
      counted(mechanism.c(), toTranslate("%1 mesh"), toTranslate("%1 meshes"));
  if (const MatroidAnalysis* matroid = snapshot.matroid()) {
    text += ", " +
            counted(matroid->dof, toTranslate("%1 degree of freedom"), toTranslate("%1 degrees of freedom"));
  }
  return text;
}

std::string section(const char* id, const std::string& content) {
  return std::string("<section id=\"") + id + "\">\n" + content + "</section>\n";
}

/// The parts of a page that grow with the mechanism.
struct Parts {
  std::string drawings, matrices, solution, derivation, exercises, key, data, still, geometry;

  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [name, part] : named()) sum += part->size();
    return sum;
  }
  [[nodiscard]] std::string largest() const {
    const auto all = named();
    return translated(std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
                        return a.second->size() < b.second->size();
                      })->first);
  }

 private:
  [[nodiscard]] std::array<std::pair<const char*, const std::string*>, 9> named() const {
    return {std::pair(toTranslate("the drawings"), &drawings),
            {toTranslate("the matrices"), &matrices},
            {toTranslate("the solution"), &solution},
            {toTranslate("the derivation"), &derivation},
            {toTranslate("the exercises"), &exercises},
            {toTranslate("the key of the exercises"), &key},
            {toTranslate("the mechanism's data"), &data},
            {toTranslate("the still picture"), &still},
            {toTranslate("the solids"), &geometry}};
  }
};

/// The translation of a text that toTranslate() marks, as content of an element or attribute.
std::string shown(const char* text) {
  return escapedXml(translated(std::string_view(text)));
}

std::string partLink(const char* id, const char* title) {
  return std::string("<a href=\"#") + id + "\">" + shown(title) + "</a>";
}

std::string navigation(bool hasExercises) {
  return "<nav aria-label=\"" + shown(toTranslate("Parts")) + "\">" +
         partLink("drawings", toTranslate("Drawings")) + partLink("matrices", toTranslate("Matrices")) +
         partLink("solution", toTranslate("Solution")) + partLink("derivation", toTranslate("Derivation")) +
         (hasExercises ? partLink("exercises", toTranslate("Exercises")) : std::string()) + "</nav>\n";
}

std::string wholePage(const AnalysisSnapshot& snapshot, const std::string& title, const Parts& parts,
                      const std::string& note, HandoutUse use) {
  const bool hasScene = !parts.geometry.empty();
  const bool reports = use == HandoutUse::learningPlatform;
  std::string page = pageHead(title, PageKind::handout, reports) +
                     "<body>\n<a class=\"skip\" href=\"#drawings\">" + shown(toTranslate("To the drawings")) +
                     "</a>\n<header>\n<div class=\"title\"><h1>" + title + "</h1>\n<p>" +
                     escapedXml(counts(snapshot)) + "</p></div>\n</header>\n" +
                     navigation(!parts.exercises.empty()) + "<div class=\"columns\">\n<main>\n";
  page += section("drawings", parts.drawings) + section("matrices", parts.matrices) +
          section("derivation", parts.derivation);
  if (!parts.exercises.empty()) page += section("exercises", parts.exercises);
  page += "</main>\n<aside aria-label=\"" + shown(toTranslate("The train and its solution")) + "\">\n";
  if (hasScene) page += section("train", trainSection(parts.still));
  page += section("solution", parts.solution) + "</aside>\n</div>\n" + pageFooter(reports, note) +
          "<script type=\"application/json\" id=\"mechanism\">" + parts.data + "</script>\n";
  if (hasScene) {
    page += "<script type=\"application/octet-stream\" id=\"geometry\">" + parts.geometry + "</script>\n" +
            pageScriptElement(pageLibrary());
  }
  if (!parts.key.empty())
    page += "<script type=\"application/octet-stream\" id=\"exercises-key\">" + parts.key + "</script>\n";
  page += pageScriptElement(pageScript(PageKind::handout));
  if (reports) page += pageScriptElement(pageReporter());
  return page + "</body>\n</html>\n";
}

}  // namespace

Expected<std::string> handoutHtml(const SnapshotPtr& snapshot, const ReportDrawings& drawings,
                                  const HandoutTrain& train, HandoutUse use,
                                  const std::optional<HandoutExercises>& exercises,
                                  const std::stop_token& stop) {
  const Report report = derivationReport(snapshot, stop);
  const bool hasScene = train.stage && !train.stage->scene.instances.empty();
  Parts parts;
  const HandoutLevers levers = handoutLevers(*snapshot, stop);
  parts.drawings = drawingsSection(drawings, levers);
  parts.matrices = matricesSection(snapshot);
  parts.solution = solutionSection(*snapshot, stop);
  parts.derivation = derivationSection(report);
  if (exercises) {
    parts.exercises = exercisesSection(*exercises);
    parts.key = exercisesKey(*exercises);
  }
  parts.still = base64(train.still);
  std::string note;
  std::size_t bytes = 0;
  for (const double tolerance : {kFarTolerance, kMaxTolerance}) {
    if (stop.stop_requested()) return std::string();
    if (hasScene) parts.geometry = pageGeometry(train.stage->scene, tolerance);
    parts.data = handoutData(*snapshot, hasScene ? train.stage.get() : nullptr, tolerance, levers, stop);
    bytes = parts.bytes() + pageStyle().size() + pageScript(PageKind::handout).size() +
            (hasScene ? pageLibrary().size() : 0);
    if (bytes <= kMaxHandoutBytes || !hasScene) break;
    note = translated("The wheels are coarse: finer ones would make the file too large.");
  }
  if (bytes > kMaxHandoutBytes) {
    return Diagnostic{
        Code::graphics,
        translated("The handout would have %1 MB; a page has at most 3 MB. The largest part: %2.",
                   {std::to_string(bytes / 1'000'000), parts.largest()}),
        {},
        {},
        0,
        0};
  }
  return wholePage(*snapshot, escapedXml(report.title), parts, note, use);
}

}  // namespace geargraph
