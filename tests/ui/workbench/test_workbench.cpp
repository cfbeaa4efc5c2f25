#include <QTest>
#include <memory>

#include "ui/workbench/workbench.h"

namespace geargraph {

class WorkbenchTest : public QObject {
  Q_OBJECT

 private slots:
  /// Its thread calls the workbench: it must not go on while only the base class is left.
  void theAnalysisEndsWhileTheWorkbenchIsWhole() {
    auto workbench = std::make_unique<Workbench>();
    const QObject* whole = workbench.get();
    QByteArray left;
    connect(&workbench->analysis(), &QObject::destroyed, [&] { left = whole->metaObject()->className(); });
    workbench.reset();
    QCOMPARE(left, QByteArray("geargraph::Workbench"));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WorkbenchTest)
#include "test_workbench.moc"
