#include <QTest>
#include <numbers>

#include "core/presentation/gl_renderer/primitives.h"
#include "core/presentation/scene/feature_edges.h"
#include "core/presentation/scene/image.h"
#include "core/presentation/scene/scene.h"

using namespace geargraph;

class SolidsTest : public QObject {
  Q_OBJECT

 private slots:
  void theCoarsestDetailWithoutVisibleChordsIsChosen() {
    const auto box = [] { return boxSolid({0, 0, 0}, {1, 1, 1}); };
    const auto finer = [&](double error) {
      return DetailLevels::LodLevel{error, std::make_shared<const DeferredSolid>(box)};
    };
    const DetailLevels levels{2, 0.1, {finer(0.03), finer(0.01)}};
    const auto own = std::make_shared<const Solid>(box());
    QCOMPARE(levels.chosen(own, 0), own);
    QCOMPARE(levels.chosen(own, 1), own);  // 0.1 of a pixel
    QCOMPARE(levels.chosen(own, 3.3), own);
    QVERIFY(levels.finer[0].solid->solidIfReady() == nullptr);
    QCOMPARE(levels.chosen(own, 3.4), levels.finer[0].solid->solid());
    QCOMPARE(levels.chosen(own, 11), levels.finer[0].solid->solid());
    QVERIFY(levels.finer[1].solid->solidIfReady() == nullptr);
    QCOMPARE(levels.chosen(own, 12), levels.finer[1].solid->solid());
    QCOMPARE(levels.chosen(own, 500), levels.finer[1].solid->solid());  // there is none closer
    QCOMPARE(levels.within(0.03, own), levels.finer[0].solid->solid());
    QCOMPARE(DetailLevels{}.chosen(own, 500), own);
  }

  void aBoxHasTwelveEdgesAndItsVolume() {
    const Solid box = boxSolid({-1, -2, -3}, {2, 2, 3});
    QCOMPARE(featureEdges(box).size(), 24U);
    QCOMPARE(signedVolume(box), 3.0 * 4 * 6);
  }

  void aCylinderHasRingsButNoSeams() {
    constexpr int kSides = 40;
    const Solid cylinder = cylinderSolid(5, -2, 8, kSides);
    QCOMPARE(featureEdges(cylinder).size(), 2U * 4 * kSides);  // two rings at either chamfer
    const double inscribed = 0.5 * kSides * std::sin(2 * std::numbers::pi / kSides) * 25 * 10;
    QVERIFY(signedVolume(cylinder) < inscribed);  // by the chamfers
    QVERIFY(signedVolume(cylinder) > 0.95 * inscribed);
  }

  void aRevolvedRingIsClosedAndTurnedOutwards() {
    const Solid ring = revolvedSolid({{4, 0}, {6, 0}, {6, 3}, {4, 3}}, 64);
    const double disc = 0.5 * 64 * std::sin(2 * std::numbers::pi / 64);
    QVERIFY(std::abs(signedVolume(ring) - disc * (36 - 16) * 3) < 1e-3);
    QCOMPARE(featureEdges(ring).size(), 2U * 4 * 64);
  }

  void theCreaseAngleDecidesWhichEdgesAreLines() {
    const Solid prism = boxSolid({0, 0, 0}, {1, 1, 1});
    QCOMPARE(featureEdges(prism, 1.5).size(), 24U);
    QCOMPARE(featureEdges(prism, 1.6).size(), 0U);  // right angles are 1.57
  }

  void anOpenBorderIsALine() {
    Solid sheet;
    sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    sheet.normals.assign(4, {0, 0, 1});
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    QCOMPARE(featureEdges(sheet).size(), 8U);
  }

  void aPictureBecomesAPngWithItsSize() {
    const Image image{3, 2, std::vector<std::uint8_t>(24, 200)};
    const std::vector<std::uint8_t> bytes = pngBytes(image);
    const std::vector<std::uint8_t> head = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I',
                                            'H',  'D', 'R', 0,   0,  0,  3,  0,  0, 0, 2, 8,  6};
    QVERIFY(bytes.size() > head.size());
    QVERIFY(std::equal(head.begin(), head.end(), bytes.begin()));
    QVERIFY(pngBytes(Image{}).empty());
  }
};

QTEST_APPLESS_MAIN(SolidsTest)
#include "test_solids.moc"
