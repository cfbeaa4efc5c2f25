#include "core/mechanism/model/notes.h"

#include <QTest>
#include <limits>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/patch.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/mechanisms.h"

using namespace geargraph;

namespace {

Mechanism noted() {
  return *withNote(*withNote(test::robotTopology(), {10, 20}, "sun"), {50, -5}, "two\nlines");
}

std::vector<std::string> idsOf(const Mechanism& mechanism) {
  std::vector<std::string> ids;
  for (const CanvasNote& note : mechanism.view.notes) ids.push_back(note.id.text());
  return ids;
}

}  // namespace

class NotesTest : public QObject {
  Q_OBJECT

 private slots:
  void typedTextsBecomeTextsOfNotes() {
    QCOMPARE(noteText("  a\r\nb\rc \n"), std::string("a\nb\nc"));
    QCOMPARE(noteText("tab\there\x07!"), std::string("tab here !"));
    QCOMPARE(noteText("next\xC2\x85line \xC3\x85"), std::string("next line \xC3\x85"));  // NEL, then an Å
    QCOMPARE(noteText(" \n\t \r\n"), std::string());
  }

  void notesGetTheFirstFreeIds() {
    const Mechanism both = noted();
    QCOMPARE(idsOf(both), (std::vector<std::string>{"N1", "N2"}));
    const Mechanism one = *withoutElements(both, std::vector<ElementId>{NoteId("N1")});
    QCOMPARE(idsOf(one), std::vector<std::string>{"N2"});
    QVERIFY(one.links == both.links && one.gearMeshes == both.gearMeshes);
    QCOMPARE(idsOf(*withNote(one, {}, "again")), (std::vector<std::string>{"N2", "N1"}));
    QCOMPARE(both.find(NoteId("N2"))->text, std::string("two\nlines"));
    QVERIFY(both.find(NoteId("N3")) == nullptr);
  }

  void changesAndMoves() {
    const Mechanism changed = *withNoteText(noted(), NoteId("N2"), "new");
    QCOMPARE(changed.view.notes[1].text, std::string("new"));
    const std::vector<std::pair<NoteId, CanvasPoint>> moves{{NoteId("N1"), {-0.0, 7}},
                                                            {NoteId("N2"), {8, 9}}};
    const Mechanism moved = *withNotesMoved(changed, moves);
    QCOMPARE(moved.view.notes[1].at, (CanvasPoint{8, 9}));
    QVERIFY(!std::signbit(moved.view.notes[0].at.x));  // -0 would be another text in the file
    QCOMPARE(withNoteText(noted(), NoteId("N9"), "x").error()[0].code, Code::unknownId);
    const std::vector<std::pair<NoteId, CanvasPoint>> strange{{NoteId("N9"), {}}};
    QCOMPARE(withNotesMoved(noted(), strange).error()[0].code, Code::unknownId);
  }

  void whatNoFileMayHoldIsRejectedAndSaysWhy() {
    const auto why = [](const std::string& text) {
      const auto made = withNote(test::robotTopology(), {}, text);
      return made ? std::string() : made.error()[0].message;
    };
    QCOMPARE(why("x"), std::string());
    QCOMPARE(why(std::string(kMaxNoteLength, 'x')), std::string());
    QCOMPARE(why(std::string(kMaxNoteLength + 1, 'x')),
             std::string("A note has at most 1,000 characters; this one has 1001."));
    std::string wide;
    for (std::size_t i = 0; i < kMaxNoteLength; ++i) wide += "ä";
    QCOMPARE(why(wide), std::string());  // characters count, not bytes
    QCOMPARE(why(" \n"), std::string("A note needs a text."));
    QCOMPARE(why("a\tb"), std::string("A note is lines of text without control characters."));
    QCOMPARE(why("a\xC2\x85z"), std::string("A note is lines of text without control characters."));
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!withNote(test::robotTopology(), {nowhere, 0}, "x").has_value());
    QVERIFY(!withNote(test::robotTopology(), {0, -1e16}, "x").has_value());
    Mechanism many = test::robotTopology();
    for (const NoteId id : freshNoteIds(many, kMaxNotes)) many.view.notes.push_back({id, "x", {}});
    QVERIFY(wellFormedDiagnostics(many).empty());
    QCOMPARE(withNote(many, {}, "x").error()[0].message,
             std::string("A document has at most 1,000 notes; this one has 1001."));
    many.view.notes[5].id = NoteId("N1");
    QCOMPARE(wellFormedDiagnostics(many)[0].code, Code::duplicateId);
  }

  void theHistoryKeepsThem() {
    const Mechanism before = noted();
    const Mechanism after = *withNoteText(*withNote(before, {1, 2}, "third"), NoteId("N1"), "first");
    const MechanismPatch patch(before, after);
    QVERIFY(!patch.isEmpty());
    QVERIFY(patch.forward(before) == after);
    QVERIFY(patch.back(after) == before);
  }

  void copiesComeAlongAndHideNothing() {
    const Mechanism before = noted();
    const Mechanism alone = fragmentOf(before, {NoteId("N2")});
    QCOMPARE(alone.n(), 0);
    QVERIFY(!isEmptyFragment(alone));
    QVERIFY(isEmptyFragment(fragmentOf(before, {})));
    const Mechanism twice = *withFragment(before, alone);
    QCOMPARE(idsOf(twice), (std::vector<std::string>{"N1", "N2", "N3"}));
    QCOMPARE(twice.view.notes[2].text, std::string("two\nlines"));
    QVERIFY(twice.view.notes[2].at != before.view.notes[1].at);
    QCOMPARE(elementsAdded(before, twice), std::set<ElementId>{NoteId("N3")});
    const Mechanism with = fragmentOf(before, {LinkId("2"), NoteId("N1")});
    QCOMPARE(with.n(), 1);
    QCOMPARE(with.view.notes.size(), std::size_t{1});
  }
};

QTEST_APPLESS_MAIN(NotesTest)
#include "test_notes.moc"
