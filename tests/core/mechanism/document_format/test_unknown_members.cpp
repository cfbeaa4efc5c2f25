#include <QTest>

#include "core/foundations/base/nearest_name.h"
#include "core/mechanism/model/unknown_members.h"
#include "tests/core/mechanism/document_format/support.h"

using namespace geargraph;
using namespace geargraph::test;

/// Members that are no part of the format: kept, reported by name, and rejected where they are common
/// misspellings.
class UnknownMembersTest : public QObject {
  Q_OBJECT

 private slots:
  void namesThatLookAlikeAreFound_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("nearest");
    const auto row = [](const char* name, const char* nearest) { QTest::newRow(name) << name << nearest; };
    row("efficency", "efficiency");
    row("frictoin", "friction");  // two neighbours exchanged
    row("head_teeth", "headTeeth");
    row("HEADTEETH", "headTeeth");
    row("limit", "limits");
    row("kinds", "kind");
    row("tailTeth", "tailTeeth");
    row("toothTrace", "");
    row("finish", "");
    row("x", "");
    row("", "");
    row("Γ", "");
    QTest::newRow("long") << QString(100'000, 'e') << QString();
  }
  void namesThatLookAlikeAreFound() {
    QFETCH(QString, name);
    QFETCH(QString, nearest);
    constexpr std::array<std::string_view, 6> kKnown = {"tailTeeth", "headTeeth", "efficiency",
                                                        "friction",  "limits",    "kind"};
    QCOMPARE(QString::fromStdString(std::string(nearestName(name.toStdString(), kKnown).value_or(""))),
             nearest);
  }

  void misspelledMembersAreRejected_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* from, const char* to, const char* expected) {
      QTest::newRow(to) << from << to << expected;
    };
    row(R"("efficiency": "49/50")", R"("efficency": "49/50")",
        "schema /gearMeshes/0/efficency [gearMeshes:7]");
    row(R"("limits": [-170.0)", R"("limit": [-170.0)", "schema /turningJoints/1/limit [turningJoints:5]");
    row(R"("inputs")", R"("input")", "schema /input");
    row(R"("states")", R"("state")", "schema /state");
    row(R"("loads")", R"("load")", "schema /load");
    row(R"("friction": 0.06)", R"("fricton": 0.06)", "schema /gearDefaults/fricton");
    row(R"("profileShift")", R"("profile_shift")", "schema /wheels/0/profile_shift [wheels:w]");
    row(R"("shapes")", R"("shape")", "schema /links/2/shape [links:arm]");
    // Missing already, and reported once.
    row(R"("turningJoints")", R"("joints")", "schema /turningJoints");
    row(R"("efficiency": "49/50")", R"("efficiency": "49/50", "efficency": 1)",
        "schema /gearMeshes/0/efficency [gearMeshes:7]");
    row(R"("limits": [-170.0)", R"("toothTrace": [-170.0)", "");
  }
  void misspelledMembersAreRejected() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, expected);
    const std::string text = with(kEverything, from.toStdString(), to.toStdString());
    QCOMPARE(QString::fromStdString(diagnosticsFor(text)), expected);
  }

  void misspellingsNameTheMember() {
    const auto read = readMechanism(with(kEverything, R"("efficiency")", R"("efficency")"));
    QCOMPARE(read.error().at(0).message,
             std::string(R"(/gearMeshes/0/efficency: there is no member "efficency"; )"
                         R"("efficiency" is meant.)"));
    QCOMPARE(read.error().at(0).line, 13);
  }

  void otherMembersAreReportedOnceForEachName() {
    std::string text =
        with(kEverything, R"("tailTeeth": 20,)", R"("tailTeeth": 20, "toothTrace": 15, "bore": 8,)");
    text = with(text, R"("offset": -1.50)", R"("offset": -1.50, "ofset": 3, "finish": "fine")");
    text = with(text, R"("limits": [-170.0, null])", R"("limits": [-170.0, null], "finish": "coarse")");
    text = with(text, R"("link": "arm"})", R"("link": "arm", "links": ["arm", "sun"]})");
    text = with(text, R"("name": "stage")", R"("name": "stage", "vendor": {"name": "x"})");
    text = with(text, R"("scale": 0.25)", R"("scale": 0.25, "color": "red")");
    const Diagnostics found = unknownMemberDiagnostics(readMechanism(text).value());
    QCOMPARE(
        summary(found),
        std::string("unknown-member ; unknown-member  [links:arm]; "
                    "unknown-member  [turningJoints:4] [turningJoints:5]; unknown-member  [turningJoints:4]; "
                    "unknown-member  [gearMeshes:7]; unknown-member  [gearMeshes:7]; "
                    "unknown-member  [couplings:B]; unknown-member ; unknown-member  [view/notes:N1]"));
    const auto message = [&](std::size_t i) { return found.at(i).message; };
    QCOMPARE(message(0),
             std::string("The member \"vendor\" of the document is not known here: it is kept and "
                         "changes nothing."));
    QCOMPARE(message(3),
             std::string("The member \"ofset\" in turningJoints is not known here: it is kept and "
                         "changes nothing. Is \"offset\" meant?"));
    QCOMPARE(message(5),
             std::string("The member \"toothTrace\" in gearMeshes is not known here: it is kept and "
                         "changes nothing."));
    QCOMPARE(message(6),
             std::string("The member \"links\" in couplings has no meaning beside the others of its "
                         "object: it is kept and changes nothing."));
    for (const Diagnostic& diagnostic : found) QCOMPARE(diagnostic.severity(), Severity::info);
  }

  void whatTheProgramWritesHasNone() {
    QVERIFY(unknownMemberDiagnostics(emptyMechanism()).empty());
    const Diagnostics found = unknownMemberDiagnostics(everything());
    QCOMPARE(summary(found), std::string("unknown-member ; unknown-member  [view/notes:N1]"));
  }
};

QTEST_GUILESS_MAIN(UnknownMembersTest)
#include "test_unknown_members.moc"
