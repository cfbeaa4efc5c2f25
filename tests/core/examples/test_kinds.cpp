#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/solid.h"
#include "core/mechanism/document_format/file_version.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/patch.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/meshfile/train_files.h"
#include "core/presentation/schematic/schematic.h"
#include "core/teaching/exercises/exercise_kinds.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/toy_kind.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using test::ToyKind;

namespace {

/// "worm: placement" for each kind that a table lacks. quality.kinds demands that every table is listed here.
template <class Kind, class... Facets>
QStringList lacking(std::span<const Kind> kinds, std::string_view (*nameOf)(Kind),
                    const std::pair<const char*, const KindTable<Kind, Facets>*>&... tables) {
  QStringList found;
  for (const Kind kind : kinds) {
    const auto look = [&](const auto& table) {
      if (table.second->find(kind) == nullptr)
        found << QString::fromStdString(std::string(nameOf(kind)) + ": " + table.first);
    };
    (look(tables), ...);
  }
  return found;
}

QStringList lackingFacets() {
  return lacking<MeshKind>(meshKinds(), meshKindName, std::pair("kinds", &std::as_const(pairKinds())),
                           std::pair("placement", &std::as_const(pairRules())),
                           std::pair("train", &std::as_const(pairWheels())),
                           std::pair("ttgraph", &std::as_const(terminalRules())),
                           std::pair("exercises", &std::as_const(pairTeachings()))) +
         lacking<GearKind>(gearKinds(), gearKindName, std::pair("teeth", &std::as_const(wheelKinds())),
                           std::pair("solids", &std::as_const(wheelForms())),
                           std::pair("cad", &std::as_const(wheelCads())),
                           std::pair("schematic", &std::as_const(wheelSymbols())));
}

/// Wheels 1 and 2 with 20 and 40 teeth on two parallel axes, 1 driven.
Mechanism pairOf(MeshKind kind) {
  return test::TrainSketch(2)
      .joint(0, 1, "a")
      .joint(0, 2, "b")
      .mesh(1, 2, 20, 40, kind)
      .inputs({{3, "1"}})
      .build();
}

std::string pictureOf(const Mechanism& mechanism) {
  return svgOf(schematicDrawing(schematicGeometry(mechanism), {}), {});
}

/// What its section shows.
std::set<ElementId> elementsDrawn(const Mechanism& mechanism) {
  std::set<ElementId> elements;
  for (const Mark& mark : schematicDrawing(schematicGeometry(mechanism), {}).marks)
    elements.insert(mark.element);
  return elements;
}

}  // namespace

/// What differs between kinds of gear pairs is asked of the kind alone: a kind that only this test knows goes
/// through everything.
class KindsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyKindHasEveryFacet() { QCOMPARE(lackingFacets(), QStringList()); }

  void aKindWithoutFacetsIsReportedWithEach() {
    const PairKind lonely{.name = "lonely", .other = std::nullopt};
    const WheelKind bare{.name = "bare"};
    const AddedFacet<MeshKind, PairKind> pair(pairKinds(), &lonely);
    const AddedFacet<GearKind, WheelKind> wheel(wheelKinds(), &bare);
    QCOMPARE(lackingFacets(),
             QStringList({"lonely: placement", "lonely: train", "lonely: ttgraph", "lonely: exercises",
                          "bare: solids", "bare: cad", "bare: schematic"}));
  }

  void kindsHaveNamesOfTheirOwn() {
    const ToyKind toy;
    QVERIFY(lackingFacets().isEmpty());
    for (const MeshKind kind : meshKinds()) QVERIFY(meshKindFrom(meshKindName(kind)) == kind);
    QCOMPARE(meshKindFrom("friction"), std::optional(toy.pair()));
  }

  void aDroppedKindLeavesNothing() {
    { const ToyKind toy; }
    QVERIFY(!meshKindFrom("friction"));
    QCOMPARE(meshKinds().size(), kNamedKinds<MeshKind>);
    QCOMPARE(gearKinds().size(), kNamedKinds<GearKind>);
  }

  void aToyKindIsPlacedAndAnalysedByBothMethods() {
    const ToyKind toy;
    const SnapshotPtr snapshot = test::snapshotOf(pairOf(toy.pair()));
    QVERIFY(!hasErrors(snapshot->diagnostics));
    QVERIFY(snapshot->kinematics->placement().meshes[0]->kind == toy.pair());
    QVERIFY(snapshot->solved && snapshot->solved->exact && snapshot->solved->ttExact);
    QCOMPARE(snapshot->solved->exact->matrix, std::vector{Rational(-1, 2)});
    QVERIFY(snapshot->solved->agreement->equal && snapshot->solved->agreement->compared > 0);
  }

  void aToyKindIsDrawnByItsSymbol() {
    const ToyKind toy;
    const std::string own = pictureOf(pairOf(toy.pair()));
    const std::string other = pictureOf(pairOf(kUsualKind));
    QVERIFY(own.size() > 1000);
    QVERIFY(own != other);
    // Nothing of the pair is left out for the other symbol; leaders of labels may differ.
    QCOMPARE(elementsDrawn(pairOf(toy.pair())), elementsDrawn(pairOf(kUsualKind)));
    QVERIFY(elementsDrawn(pairOf(toy.pair())).contains(pairOf(toy.pair()).gearMeshes[0].id));
  }

  void aToyKindIsSavedAndRead() {
    const ToyKind toy;
    const Mechanism drawn = pairOf(toy.pair());
    const std::string document = writeMechanism(drawn);
    QVERIFY(document.find("\"kind\": \"friction\"") != std::string::npos);
    const Expected<Mechanism> read = readMechanism(document);
    QVERIFY(read);
    QVERIFY(*read == drawn);
  }

  /// An old program is not to take a new kind for a mistake, nor a new program to change an old document.
  void aNewKindMakesTheDocumentNew() {
    const ToyKind toy;
    QCOMPARE(fileVersionOf(pairOf(toy.pair())), kFileVersion);
    QCOMPARE(fileVersionOf(pairOf(kUsualKind)), 1);
    QVERIFY(writeMechanism(pairOf(toy.pair())).find("\"version\": 2,") != std::string::npos);
    QVERIFY(writeMechanism(pairOf(kUsualKind)).find("\"version\": 1,") != std::string::npos);
  }

  void anUnknownKindIsRejectedAsBefore() {
    std::string document;
    {
      const ToyKind toy;
      document = writeMechanism(pairOf(toy.pair()));
    }
    const Expected<Mechanism> read = readMechanism(document);
    QVERIFY(!read);
    QCOMPARE(read.error().front().code, Code::schema);
  }

  void aToyKindIsExported() {
    const ToyKind toy;
    const SnapshotPtr snapshot = test::snapshotOf(pairOf(toy.pair()));
    const auto train = snapshot->geometry->train();
    QCOMPARE(train->gears.size(), std::size_t{2});
    GearCache cache;
    for (const TrainGear& gear : train->gears) {
      QVERIFY(gear.spec.kind == toy.roller());
      const Solid solid = gearSolid(gear.spec, kScreenTolerance).value();
      const double radius = pitchRadius(gear.spec), bore = gear.spec.bore / 2;
      const double volume = std::numbers::pi * (radius * radius - bore * bore) * gear.spec.faceWidth;
      QVERIFY(std::abs(signedVolume(solid) / volume - 1) < 0.01);  // a roller, no teeth
    }
    const PlacedTrain placed(*snapshot->mechanism, *snapshot->tree, snapshot->geometry->placement(), *train);
    const std::vector<std::vector<Rational>> motions{{Rational(1), Rational(-1, 2)}};
    const auto assembly = assemblyOf(placed, cache, kScreenTolerance, motions, kMinFrames);
    QVERIFY(assembly);
    QVERIFY(assemblyJson(*assembly).find("\"roller\"") != std::string::npos);
    MeshScene scene{"toy", "mm", {}, {}};
    scene.nodes.emplace_back().solid = assembly->gears.front().solid;
    const auto encoded = encodedMesh(scene, MeshFormat::stl, "toy", {});
    QVERIFY(std::holds_alternative<std::vector<EncodedFile>>(encoded));
    QVERIFY(std::get<std::vector<EncodedFile>>(encoded).front().bytes.size() > 1000);
  }

  void aToyKindIsChosenAndUndone() {
    const ToyKind toy;
    const Mechanism before = pairOf(kUsualKind);
    const auto changed = withKindFitted(PlacedMechanism(before), before.gearMeshes[0].id, toy.pair());
    QVERIFY(changed);
    const Mechanism& after = changed->mechanism();
    QVERIFY(after.gearMeshes[0].kind == toy.pair());
    const MechanismPatch patch(before, after);
    QVERIFY(patch.back(after) == before);
    QVERIFY(patch.forward(before) == after);
  }

  void aToyKindIsAskedAbout() {
    const ToyKind toy;
    const ExerciseSource source(pairOf(toy.pair()));
    ExerciseRandom random(1);
    const Question question = makeQuestion(source, ExerciseKind::terminalEquation, random);
    const bool isNamed =
        std::any_of(question.mistakes.begin(), question.mistakes.end(),
                    [](const auto& mistake) { return mistake.name == "rollers-turn-alike"; });
    QVERIFY(isNamed);
  }
};

QTEST_GUILESS_MAIN(KindsTest)
#include "test_kinds.moc"
