#include <QSignalSpy>
#include <QTest>

#include "tests/ui/view3d/toy_stage.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

class ViewerTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsPointedAtElsewhereLightsUpAtOnce() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
    QSignalSpy changed(&viewer, &Viewer::viewChanged);
    selection.hover(viewer.stage()->scene.instances.front().element);
    QCOMPARE(changed.count(), 1);
    selection.hover(ElementId(MeshId("nowhere")));
    QCOMPARE(changed.count(), 2);
    selection.hover(ElementId(MeshId("nowhere else")));
    QCOMPARE(changed.count(), 2);  // nothing here was lit before or is now
  }

  void dearPicturesWaitUntilTheHandRests() {
    Selection selection;
    Viewer viewer(&selection);
    viewer.setStage(test::toyStage());
    viewer.setPictureCost(40);
    QSignalSpy changed(&viewer, &Viewer::viewChanged);
    for (int i = 0; i < 5; ++i) {
      selection.hover(viewer.stage()->scene.instances.front().element);
      selection.unhover();
    }
    selection.hover(viewer.stage()->scene.instances.front().element);
    QCOMPARE(changed.count(), 0);
    QVERIFY(changed.wait());
    QCOMPARE(changed.count(), 1);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ViewerTest)
#include "test_viewer.moc"
