#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <mutex>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/edits.h"
#include "ui/document/document.h"
#include "ui/workbench/analysis_service.h"

namespace geargraph {

static DerivedGeometryPtr geometryOf(const Mechanism& mechanism) {
  return std::make_shared<const DerivedGeometry>(mechanism);
}

class AnalysisServiceTest : public QObject {
  Q_OBJECT

 private slots:
  void onlyTheNewestOf39RapidEditsArrives() {
    Document document;
    AnalysisService service;
    std::vector<quint64> arrived;
    service.onAnswer(&service, [&](const SnapshotPtr& snapshot) {
      QCOMPARE(QThread::currentThread(), qApp->thread());
      arrived.push_back(snapshot->revision);
    });
    for (int i = 0; i < 39; ++i) {
      document.apply({QStringLiteral("Add link"),
                      [](const Mechanism& mechanism) { return withLink(mechanism, CanvasPoint{}); }, 0});
      service.request({document.geometry(), document.revision()});
    }
    QVERIFY(!service.isUpToDate());
    QTRY_VERIFY(service.isComplete());
    const quint64 newest = document.revision();
    QCOMPARE(arrived, (std::vector<quint64>{newest, newest}));  // live, then complete
    QCOMPARE(service.snapshot()->mechanism.get(), document.mechanism().get());
    QCOMPARE(service.snapshot()->mechanism->n(), 39);
  }

  void askedAgainForTheSameRevisionItAnswersOnce() {
    const DerivedGeometryPtr geometry = geometryOf(emptyMechanism());
    AnalysisService service;
    int live = 0;
    service.onAnswer(&service, [&](const SnapshotPtr& snapshot) { live += snapshot->isComplete ? 0 : 1; });
    service.request({geometry, 0});
    QTRY_VERIFY(service.isComplete());
    service.request({geometry, 0});
    QVERIFY(service.isComplete());
    service.request({geometry, 1});
    QVERIFY(!service.isUpToDate());
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(live, 2);
  }

  /// Further work begins on the analysis' own threads, before the GUI thread hears of a snapshot.
  void whoIsToldAheadHearsOfEverySnapshotFirst() {
    std::mutex mutex;
    std::vector<SnapshotPtr> ahead;
    AnalysisService service(nullptr, [&](const SnapshotPtr& snapshot) {
      const std::lock_guard lock(mutex);
      if (QThread::currentThread() != qApp->thread()) ahead.push_back(snapshot);
    });
    int arrived = 0;
    service.onAnswer(&service, [&](const SnapshotPtr& snapshot) {
      const std::lock_guard lock(mutex);
      QVERIFY(std::find(ahead.begin(), ahead.end(), snapshot) != ahead.end());
      ++arrived;
    });
    service.request({geometryOf(emptyMechanism()), 1});
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(arrived, 2);
    QCOMPARE(ahead.size(), std::size_t{2});
  }

  void destroyedWhileItWorksIsHarmless() {
    for (int round = 0; round < 50; ++round) {
      AnalysisService service;
      service.request({geometryOf(emptyMechanism()), 1});
    }
    QCoreApplication::processEvents();
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::AnalysisServiceTest)
#include "test_analysis_service.moc"
