#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <mutex>

#include "core/mechanism/model/edits.h"
#include "ui/analysis/analysis_service.h"
#include "ui/document/document.h"

namespace geargraph {

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
                      [](const Mechanism& mechanism) { return withLink(mechanism, SheetPoint{}); }, 0});
      service.request({document.mechanism(), document.revision()});
    }
    QVERIFY(!service.isUpToDate());
    QTRY_VERIFY(service.isComplete());
    const quint64 newest = document.revision();
    QCOMPARE(arrived, (std::vector<quint64>{newest, newest}));  // live, then complete
    QCOMPARE(service.snapshot()->mechanism.get(), document.mechanism().get());
    QCOMPARE(service.snapshot()->mechanism->n(), 39);
  }

  void askedAgainForTheSameRevisionItAnswersOnce() {
    const auto mechanism = std::make_shared<const Mechanism>(emptyMechanism());
    AnalysisService service;
    int live = 0;
    service.onAnswer(&service, [&](const SnapshotPtr& snapshot) { live += snapshot->isComplete ? 0 : 1; });
    service.request({mechanism, 0});
    QTRY_VERIFY(service.isComplete());
    service.request({mechanism, 0});
    QVERIFY(service.isComplete());
    service.request({mechanism, 1});
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
    service.request({std::make_shared<const Mechanism>(emptyMechanism()), 1});
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(arrived, 2);
    QCOMPARE(ahead.size(), std::size_t{2});
  }

  void destroyedWhileItWorksIsHarmless() {
    for (int round = 0; round < 50; ++round) {
      AnalysisService service;
      service.request({std::make_shared<const Mechanism>(emptyMechanism()), 1});
    }
    QCoreApplication::processEvents();
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::AnalysisServiceTest)
#include "test_analysis_service.moc"
