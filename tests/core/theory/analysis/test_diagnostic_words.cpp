#include <QTest>
#include <map>
#include <optional>

#include "core/theory/analysis/analysis.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// External wheels on fixed axes in a ring, which locks where they are odd in number, and one more shaft.
TrainSketch ringOfThree() {
  TrainSketch train(4);
  for (int i = 1; i <= 4; ++i) train.joint(0, i, "axis " + std::to_string(i));
  return train.mesh(1, 2, 20, 30).mesh(2, 3, 30, 40).mesh(3, 1, 40, 20);
}

Mechanism withInputs(Mechanism mechanism, const std::vector<const char*>& joints) {
  mechanism.inputs.emplace();
  for (const char* joint : joints) mechanism.inputs->push_back({JointId(joint), Number(1), {}});
  return mechanism;
}

Mechanism engaged(const std::vector<const char*>& couplings) {
  Mechanism box = eightSpeed();
  for (const char* coupling : couplings) box.engaged.emplace_back(coupling);
  return box;
}

/// Wheels 20:40 on parallel axes 60 apart, or as the places and the direction of the second axis say.
Mechanism placed(std::optional<MeshKind> kind, const std::vector<std::string>& pitchPoint, int teeth = 40,
                 const std::vector<std::string>& point = {"0", "60", "0"},
                 const std::vector<std::string>& direction = {"0", "0", "1"}) {
  return TrainSketch(2)
      .axis("a", {"0", "0", "0"})
      .axis("b", point, direction)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, 20, teeth, kind, pitchPoint)
      .build();
}

/// Mechanisms that are wrong, or noteworthy, in every way that this test is about.
std::vector<Mechanism> noteworthy() {
  const auto chain = [](int first, int last) {
    return TrainSketch(3)
        .joint(0, 1, "a")
        .joint(1, 2, "b")
        .joint(2, 3, "c")
        .mesh(first, last, 20, 30)
        .build();
  };
  return {
      planetary(20, 17, 2),
      planetary(20, 17, 3),
      ringOfThree().build(),
      TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").build(),
      withInputs(planetary(20, 17), {"5"}),
      withInputs(planetary(20, 17), {"5", "5"}),
      withInputs(planetary(20, 17), {"5", "6", "7"}),
      TrainSketch(2).joint(0, 1, "a").build(),
      TrainSketch(3).joint(0, 1, "a").build(),
      TrainSketch(2).joint(0, 1, "a").joint(1, 2, "a").joint(0, 2, "a").build(),
      TrainSketch(2).joint(0, 1, "a").joint(1, 2, "b").joint(0, 2, "c").build(),
      TrainSketch(2).joint(0, 1, "a").joint(0, 2, "a").mesh(1, 2, 20, 30).build(),
      chain(0, 3),
      placed({}, {"0", "60", "3"}),
      placed({}, {"0", "0", "3"}),
      placed(MeshKind::external, {"1/2", "20", "0"}),
      placed(MeshKind::external, {"0", "-60", "0"}),
      placed(MeshKind::internal, {"0", "20", "0"}),
      placed(MeshKind::external, {"0", "20", "0"}, 50),
      placed(MeshKind::bevel, {}),
      placed(MeshKind::internal, {}, 20),
      placed({}, {}, 40, {"0", "60", "0"}, {"1", "0", "0"}),
      placed({}, {"0", "20", "0"}, 40, {"0", "0", "0"}),
      engaged({"A", "B", "C", "D", "E"}),
      engaged({"A", "B", "C", "D"}),
      engaged({"C", "D", "E"}),
  };
}

}  // namespace

/// The messages of diagnostics are looked up in the catalogue.
class DiagnosticWordsTest : public QObject {
  Q_OBJECT
 private slots:
  void messagesAreTranslated() {
    std::map<Code, int> expected{
        {Code::redundantMesh, 0},    {Code::redundantCoupling, 0}, {Code::locked, 0},
        {Code::deadJoint, 0},        {Code::idleJoint, 0},         {Code::noMeshes, 0},
        {Code::invalidInputs, 0},    {Code::disconnected, 0},      {Code::turningLoop, 0},
        {Code::coaxialMesh, 0},      {Code::noTransferVertex, 0},  {Code::pitchGeometry, 0},
        {Code::pitchPointOnAxis, 0}, {Code::teethGeometry, 0}};
    const PseudoLanguage pseudo;
    for (const Mechanism& mechanism : noteworthy()) {
      const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(mechanism));
      for (const Diagnostic& diagnostic : snapshot->diagnostics) {
        const auto entry = expected.find(diagnostic.code);
        if (entry == expected.end()) continue;
        ++entry->second;
        const auto words = PseudoLanguage::english(diagnostic.message);
        QVERIFY2(words.empty(), diagnostic.message.c_str());
      }
    }
    for (const auto& [code, times] : expected) QVERIFY2(times > 0, std::string(codeName(code)).c_str());
  }

  void codesAndElementsAreTheSameInEveryLanguage() {
    for (const Mechanism& mechanism : noteworthy()) {
      const auto shared = std::make_shared<const Mechanism>(mechanism);
      const Diagnostics english = analyze(shared)->diagnostics;
      const PseudoLanguage pseudo;
      const Diagnostics other = analyze(shared)->diagnostics;
      QCOMPARE(other.size(), english.size());
      for (std::size_t i = 0; i < english.size(); ++i) {
        QCOMPARE(other[i].code, english[i].code);
        QVERIFY(other[i].elements == english[i].elements);
      }
    }
  }
};

QTEST_APPLESS_MAIN(DiagnosticWordsTest)
#include "test_diagnostic_words.moc"
