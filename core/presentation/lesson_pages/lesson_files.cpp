#include "core/presentation/lesson_pages/lesson_files.h"

#include <array>
#include <set>
#include <utility>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/export_api/scorm_package.h"
#include "core/presentation/lesson_pages/lesson_page.h"

namespace geargraph {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kForms = {
    {{"html", "html"}, {"scorm", "zip"}}};  // name and suffix, by form
constexpr const char* kIndexName = "index.html";

std::string fileName(const Lesson& lesson, LessonFileForm form) {
  return lesson.id + '.' + std::string(kForms[static_cast<std::size_t>(form)].second);
}

/// A page that lists the lessons with what they teach.
std::string indexPage(std::span<const Lesson> lessons, std::span<const LessonFileForm> forms) {
  const std::string title = escapedXml(translated("Lessons"));
  std::string items;
  for (const Lesson& lesson : lessons) {
    std::string links;
    for (const LessonFileForm form : forms) {
      const std::string file = fileName(lesson, form);
      const bool isPage = form == LessonFileForm::html;
      links += " <a href=\"" + file + "\">" + (isPage ? escapedXml(lesson.title) : file) + "</a>";
    }
    items += "<li>" + links.substr(1) + "<br>" +
             escapedXml(translated("%1 min", {std::to_string(lesson.minutes)}) + ". " +
                        translated("Afterwards you can %1.", {lesson.goal})) +
             "</li>\n";
  }
  return "<!DOCTYPE html>\n<html lang=\"" + escapedXml(translated("en")) +
         "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\">\n<title>" +
         title +
         R"html(</title>
<style>
body { font: 16px/1.5 sans-serif; margin: 2em auto; max-width: 45em; padding: 0 1em; color-scheme: light dark; }
li { margin: 0.7em 0; }
a { font-weight: 600; }
</style>
</head>
<body>
<h1>)html" +
         title + "</h1>\n<ol>\n" + items + "</ol>\n</body>\n</html>\n";
}

}  // namespace

std::optional<LessonFileForm> lessonFileForm(std::string_view name) {
  for (std::size_t form = 0; form < kForms.size(); ++form) {
    if (kForms[form].first == name) return static_cast<LessonFileForm>(form);
  }
  return std::nullopt;
}

std::vector<std::string> lessonFileNames(std::span<const Lesson> lessons,
                                         std::span<const LessonFileForm> forms) {
  std::vector<std::string> names{kIndexName};
  for (const Lesson& lesson : lessons) {
    for (const LessonFileForm form : forms) names.push_back(fileName(lesson, form));
  }
  return names;
}

Expected<FolderFiles> lessonFiles(std::span<const Lesson> lessons, std::span<const LessonFileForm> forms,
                                  const ExampleSource& examples, const std::stop_token& stop) {
  std::set<std::string> ids;
  for (const Lesson& lesson : lessons) {
    if (!ids.insert(lesson.id).second)
      return Diagnostic{
          Code::duplicateId, translated("Two lessons have the id \"%1\".", {lesson.id}), {}, {}};
  }
  FolderFiles files{{kIndexName, indexPage(lessons, forms)}};
  for (const Lesson& lesson : lessons) {
    for (const LessonFileForm form : forms) {
      if (stop.stop_requested()) return files;
      const bool isPackage = form == LessonFileForm::scorm;
      auto page =
          lessonHtml(lesson, examples, isPackage ? HandoutUse::learningPlatform : HandoutUse::alone, stop);
      if (!page) return page.error();
      files.emplace_back(fileName(lesson, form), isPackage ? scormPackage(lesson.title, *page) : *page);
    }
  }
  return files;
}

}  // namespace geargraph
