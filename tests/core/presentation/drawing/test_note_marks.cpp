#include "core/presentation/drawing/note_marks.h"

#include <QTest>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/hit_test.h"
#include "core/presentation/drawing/svg_writer.h"
#include "tests/core/support/mechanisms.h"

using namespace geargraph;

namespace {

Mechanism noted(const std::string& text) {
  Mechanism mechanism = test::robotTopology();
  mechanism.view.notes.push_back({NoteId("N1"), text, {300, 40}});
  return mechanism;
}

std::vector<std::string> textsOf(const DisplayList& list, const ElementId& element) {
  std::vector<std::string> texts;
  for (const Mark& mark : list.marks) {
    if (const auto* text = std::get_if<Text>(&mark.what); text != nullptr && mark.element == element)
      texts.push_back(text->text);
  }
  return texts;
}

}  // namespace

class NoteMarksTest : public QObject {
  Q_OBJECT

 private slots:
  void linesAreThoseOfTheText() {
    QCOMPARE(noteLines("sun"), std::vector<std::string>{"sun"});
    QCOMPARE(noteLines("a\n\nb"), (std::vector<std::string>{"a", "", "b"}));
  }

  void longLinesBreakBetweenWords() {
    const std::string text =
        "The planet carrier is held by a brake while the sun drives the ring gear of the second set";
    const std::vector<std::string> lines = noteLines(text);
    QVERIFY(lines.size() > 1);
    std::string joined;
    for (const std::string& line : lines) joined += (joined.empty() ? "" : " ") + line;
    QCOMPARE(joined, text);
    const NotePlace place{NoteId("N1"), lines, {0, 0}};
    QVERIFY(noteExtent(place).halfWidth < 150);
  }

  void wordsWithoutBlanksBreakAtCharacters() {
    std::string word;
    for (int i = 0; i < 200; ++i) word += "ä";
    std::string joined;
    for (const std::string& line : noteLines(word)) {
      QVERIFY(line.size() % 2 == 0);  // no character is cut
      joined += line;
    }
    QCOMPARE(joined, word);
  }

  void theDigraphShowsThemWithoutMovingAnythingElse() {
    const NodePositions places{{LinkId("0"), {0, 0}}, {LinkId("1"), {120, 0}}, {LinkId("2"), {240, 80}}};
    const DisplayList plain = digraphDrawing(test::robotTopology(), places, {});
    const DisplayList with = digraphDrawing(noted("first\nsecond"), places, {});
    QCOMPARE(textsOf(with, NoteId("N1")), (std::vector<std::string>{"first", "second"}));
    DisplayList rest = with;
    std::erase_if(rest.marks, [](const Mark& mark) { return mark.element == ElementId(NoteId("N1")); });
    std::erase_if(rest.outlines, [](const Outline& o) { return o.element == ElementId(NoteId("N1")); });
    QVERIFY(rest == plain);
    QVERIFY(elementAt(with.outlines, {300, 40}, 0) == ElementId(NoteId("N1")));
  }

  void selectionShows() {
    const NotePlace place{NoteId("N1"), {"x"}, {0, 0}};
    QVERIFY(!(noteDrawing(place, {.selected = true}) == noteDrawing(place, {})));
    QCOMPARE(noteDrawing(place, {.hovered = true}).marks.front().role, MarkRole::halo);
  }

  void picturesHoldTheirWords() {
    const NodePositions places{{LinkId("0"), {0, 0}}};
    const std::string svg = svgOf(digraphDrawing(noted("عربي & <b>"), places, {}), SheetStyle{});
    QVERIFY(svg.find("عربي &amp; &lt;b&gt;") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(NoteMarksTest)
#include "test_note_marks.moc"
