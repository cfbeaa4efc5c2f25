#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <map>
#include <set>

#include "app/cli/command.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/manual/glossary_page.h"
#include "core/presentation/manual/manual.h"
#include "core/presentation/manual/manual_picture.h"
#include "core/presentation/manual/manual_site.h"
#include "core/presentation/manual/markdown.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/teaching/lessons/course.h"

namespace geargraph {

/// What the manual names exists: pages, headings, lessons, pictures, formulas, commands and options.
class ManualTest : public QObject {
  Q_OBJECT

  static QStringList allIn(const std::string& html, const char* pattern) {
    QStringList found;
    const QRegularExpression expression{QString::fromLatin1(pattern)};
    for (auto match = expression.globalMatch(QString::fromStdString(html)); match.hasNext();)
      found << match.next().captured(1);
    return found;
  }
  static bool isLesson(const QString& id) {
    return std::any_of(course().begin(), course().end(),
                       [&](const Lesson& lesson) { return QString::fromStdString(lesson.id) == id; });
  }
  static bool isPlace(const ManualPage& from, const QString& link) {
    const QString page = link.section('#', 0, 0);
    const QString anchor = link.section('#', 1);
    const ManualPage* to = page.isEmpty() ? &from : manualPage(page.toStdString());
    return to != nullptr && (anchor.isEmpty() ||
                             std::any_of(to->sections.begin(), to->sections.end(), [&](const auto& section) {
                               return QString::fromStdString(section.anchor) == anchor;
                             }));
  }
  /// The HTML of one term on the page of the glossary.
  static std::string entryOf(Term term) {
    const std::string& html = manualPages().back().html;
    const std::size_t start = html.find("<h2 id=\"" + anchorOf(term) + "\"");
    return start == std::string::npos ? std::string()
                                      : html.substr(start, html.find("<h2", start + 1) - start);
  }

 private slots:
  void pagesAndHeadingsHaveNamesOfTheirOwn() {
    QVERIFY(manualPages().size() > 12);
    std::set<std::string> ids;
    for (const ManualPage& page : manualPages()) {
      QVERIFY2(ids.insert(page.id).second, page.id.c_str());
      QCOMPARE(manualPage(page.id), &page);
      std::set<std::string> anchors;
      for (const ManualSection& section : page.sections) {
        QVERIFY2(anchors.insert(section.anchor).second, section.anchor.c_str());
        QVERIFY(!section.title.empty() && section.words.find('<') == std::string::npos);
      }
    }
    QCOMPARE(manualPages().back().id, std::string("glossary"));
    QCOMPARE(manualPage("no-such-page"), nullptr);
  }

  void everyLinkLeadsSomewhere() {
    int links = 0;
    for (const ManualPage& page : manualPages()) {
      for (const QString& link : allIn(page.html, "<a href=\"([^\"]*)\"")) {
        ++links;
        const bool leads = link.startsWith("lesson:") ? isLesson(link.mid(7)) : isPlace(page, link);
        QVERIFY2(leads, qPrintable(QString::fromStdString(page.id) + ": " + link));
      }
    }
    QVERIFY(links > 80);
  }

  void everyPictureIsDrawn() {
    std::set<QString> names;
    for (const ManualPage& page : manualPages()) {
      for (const QString& source : allIn(page.html, "<img src=\"([^\"]*)\" alt=\"[^\"]+\"")) {
        if (source.startsWith("window:")) continue;
        QVERIFY2(source.startsWith("picture:"), qPrintable(source));
        names.insert(source.mid(8));
      }
      QCOMPARE(allIn(page.html, "(<img )").size(),
               allIn(page.html, "(<img src=\"[^\"]+\" alt=\"[^\"]+\")").size());
    }
    for (const QString& name : names) {
      const auto list = manualPicture(name.toStdString());
      QVERIFY2(list && list->marks.size() > 5, qPrintable(name));
      const auto plain = manualPicture(name.section('/', 0, 1).toStdString());
      // What is to stand out does.
      QCOMPARE(svgOf(*list, {}) == svgOf(*plain, {}), name.count('/') < 2);
    }
    for (const char* wrong : {"digraph/nothing", "painting/robot", "digraph/robot/link.99",
                              "digraph/robot/cycle.8", "digraph/robot/wheels", "digraph/robot/axis.a", ""})
      QVERIFY2(!manualPicture(wrong), wrong);
  }

  void everyFormulaCanBeSet() {
    int formulas = 0;
    std::string rest;
    for (const ManualPage& page : manualPages()) {
      rest += withElements(page.html, "x-equation", [&](auto, auto tex) {
        ++formulas;
        const std::string fault = readTex(plainTextOf(tex)).fault;
        return fault.empty() ? fault : "FAULT in " + page.id + ": " + fault;
      });
    }
    QVERIFY2(rest.find("FAULT") == std::string::npos,
             rest.substr(std::min(rest.size(), rest.find("FAULT"))).c_str());
    QVERIFY(formulas > 20);
  }

  void everyTermHasDefinitionPictureEquationAndLesson() {
    for (const Definition& definition : glossary()) {
      const std::string entry = entryOf(definition.term);
      const std::string words = plainTextOf(entry);
      const std::string name(definition.name);
      QVERIFY2(words.find(definition.text) != std::string::npos, name.c_str());
      QVERIFY2(
          entry.find("<img src=\"picture:" + std::string(pictureOf(definition.term))) != std::string::npos,
          name.c_str());
      QCOMPARE(formulaOfTerm(definition.term).empty(), definition.equation == PaperEquation::none);
      const std::string number = "Equation " + cited(definition.equation) + " of the paper.";
      QCOMPARE(words.find(number) != std::string::npos, definition.equation != PaperEquation::none);
      const Lesson* lesson = lessonAbout(definition.term);
      QCOMPARE(words.find("No lesson is about it.") != std::string::npos, lesson == nullptr);
      if (lesson != nullptr) QVERIFY(entry.find("lesson:" + lesson->id) != std::string::npos);
    }
    QCOMPARE(lessonAbout(Term::cycle)->id, std::string("paths-trees-cycles"));
  }

  void commandsOfTheCommandLineAreUnderstood() {
    int lines = 0;
    for (const ManualPage& page : manualPages()) {
      for (const QString& text : allIn(page.html, "(geargraph-cli [a-z][^<\\n]*)")) {
        QStringList words =
            QString::fromStdString(plainTextOf(text.toStdString())).split(' ', Qt::SkipEmptyParts);
        words.removeFirst();
        if (words.front() == "export" && words.size() == 1) continue;  // named, not shown
        const auto command =
            std::find_if(cli::commands().begin(), cli::commands().end(), [&](const cli::Command* each) {
              return QString::fromLatin1(each->name.data(), qsizetype(each->name.size())) == words.front();
            });
        QVERIFY2(command != cli::commands().end(), qPrintable(text));
        std::vector<std::string> rest;
        for (const QString& word : words.mid(1)) rest.push_back(word.toStdString());
        const auto parsed = cli::parseArguments(rest, cli::optionsOf(**command));
        QVERIFY2(!std::holds_alternative<cli::UsageError>(parsed), qPrintable(text));
        ++lines;
      }
    }
    QVERIFY(lines > 15);
  }

  void theSiteIsWholeAndNeedsNothingFromElsewhere() {
    const std::vector<ManualFile> files = manualSite({"robot"});
    std::map<QString, const ManualFile*> byName;
    for (const ManualFile& file : files)
      QVERIFY(byName.emplace(QString::fromStdString(file.name), &file).second);
    QVERIFY(byName.contains("index.html") && byName.contains("glossary.html"));
    for (const auto& [name, file] : byName) {
      if (!name.endsWith(".html")) {
        QVERIFY(file->bytes.find("<svg") != std::string::npos);
        continue;
      }
      for (const char* no : {"<script", "http:", "https:", "x-equation", "lesson:", "picture:", "window:"})
        QVERIFY2(file->bytes.find(no) == std::string::npos, qPrintable(name + ": " + no));
      for (const QString& source : allIn(file->bytes, "(?:src|srcset)=\"([^\"]*)\"")) {
        const bool isOfWindow =
            source == "pictures/window-robot-light.png" || source == "pictures/window-robot-dark.png";
        QVERIFY2(isOfWindow || byName.contains(source), qPrintable(name + ": " + source));
      }
      for (const QString& link : allIn(file->bytes, "href=\"([^\"]*)\"")) {
        const QString page = link.section('#', 0, 0);
        const QString anchor = link.section('#', 1);
        const ManualFile* to = page.isEmpty() ? file : byName.contains(page) ? byName[page] : nullptr;
        QVERIFY2(to != nullptr, qPrintable(name + ": " + link));
        const std::string id = "id=\"" + anchor.toStdString() + "\"";
        QVERIFY2(anchor.isEmpty() || to->bytes.find(id) != std::string::npos, qPrintable(name + ": " + link));
      }
    }
    QVERIFY(byName["index.html"]->bytes.find("window-robot-dark.png") != std::string::npos);
    QVERIFY(byName["gearboxes.html"]->bytes.find("window-gearbox") == std::string::npos);  // there is none
  }

  void markdownIsEscapedAndRead() {
    const std::string odd = "G* [a_b] <c> `d` $e$ #f |g| \\h";
    QCOMPARE(plainTextOf(htmlOfMarkdown(escapedMarkdown(odd))), odd + "\n");
    QCOMPARE(slugOf("T–T graph: Γ and more"), std::string("t-t-graph-and-more"));
    QCOMPARE(attributeOf(" src=\"a\" alt=\"b &amp; c\"", "alt"), std::string("b & c"));
    QCOMPARE(attributeOf(" src=\"a\"", "alt"), std::string());
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::ManualTest)
#include "test_manual.moc"
