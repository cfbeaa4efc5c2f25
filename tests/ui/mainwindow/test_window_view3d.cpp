#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/foundations/files/file.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/shapes_dialog.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

/// What the window keeps of its 3D view, and what links wear.
class WindowView3DTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;
  std::unique_ptr<QTemporaryDir> folder;

  [[nodiscard]] QString saved(const QString& name) const {
    const QString path = folder->filePath(name);
    return window->saveDocument(path) ? path : QString();
  }
  void open(const QString& path) {
    QVERIFY(window->openDocument(path));
    QTRY_VERIFY(window->isSettled());
  }
  [[nodiscard]] std::size_t parts() const { return window->view3d().stage()->scene.instances.size(); }

 private slots:
  void initTestCase() {
    qputenv("GEARGRAPH_MESH_READER", GEARGRAPH_MESH_READER);
    test::isolateSettings();
    applyTheme(*qApp, Theme::light);
  }
  void init() {
    folder = std::make_unique<QTemporaryDir>();
    window = std::make_unique<MainWindow>();
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    open(robotExamplePath());
  }
  void cleanup() { window.reset(); }

  /// What has its meshes is not asked for one while its stage is made.
  void aTrainThatIsOnItsWaySaysSo() {
    window->document().replace(emptyMechanism(), {});
    QTRY_VERIFY(window->isSettled());
    QStringList words;
    connect(&window->analysis(), &AnalysisService::answered, window.get(), [&] {
      for (auto* label : window->view3d().findChildren<QLabel*>()) {
        if (label->isVisible() && label->text().contains("gears")) words += label->text();
      }
    });
    open(QStringLiteral(":/examples/eight-speed-gearbox.geargraph"));
    // A stage may be there before its snapshot is: then there is nothing to say.
    for (const QString& said : words) QCOMPARE(said, View3D::waitingText());
  }

  void theCameraComesBackWithTheDocument() {
    QVERIFY(!readDocument(saved("untouched.geargraph"))->view.camera);
    const Camera chosen = Camera::from(0.7, 0.2).placedAt({3, -4, 50}, 700);
    window->view3d().setCamera(chosen);
    QVERIFY(!window->document().isModified());
    const QString path = saved("seen.geargraph");
    QVERIFY(readDocument(path)->view.camera.has_value());
    open(QStringLiteral(":/examples/planetary-ring-held.geargraph"));
    QVERIFY(!(window->view3d().camera() == chosen));
    const Camera planetary = window->view3d().camera();
    QVERIFY((planetary.target() - chosen.target()).norm() > 1);
    open(path);
    const Camera& back = window->view3d().camera();
    QVERIFY((back.target() - chosen.target()).norm() < 1e-3 && std::abs(back.yaw() - chosen.yaw()) < 1e-5);
    QVERIFY(std::abs(back.pitch() - chosen.pitch()) < 1e-5 && std::abs(back.distance() - 700) < 1e-3);
  }

  void theSpeedsAreSavedAsCsv() {
    auto* dock = window->findChild<QDockWidget*>("dock.speeds");
    dock->show();
    dock->raise();
    QTRY_VERIFY(!window->motion().sheets().empty());
    const QString path = folder->filePath("speeds.csv");
    QVERIFY(window->exports().saveSpeeds(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("time s,\"joint 8 rad/s\""));
  }

  void aFileAttachedToALinkMovesWithItAndItsLossIsReported() {
    const std::size_t bare = parts();
    const QString path = saved("dressed.geargraph");
    const std::filesystem::path part = folder->filePath("part.stl").toStdString();
    SceneView view;
    view.hidden = {LinkId("2"), LinkId("3"), LinkId("4"), LinkId("5"), LinkId("6"), LinkId("7"), LinkId("0")};
    QVERIFY(!writeMesh(sceneOf(*window->view3d().stage(), view), MeshFormat::stl, part));
    auto* dialog = new ShapesDialog(&window->document(), LinkId("1"), window.get());
    QVERIFY(dialog->add(QString::fromStdString(part.string())));
    QCOMPARE(window->document().mechanism()->find(LinkId("1"))->shapes.front().file, std::string("part.stl"));
    QTRY_COMPARE_WITH_TIMEOUT(parts(), bare + 1, 60'000);
    QVERIFY(saved("dressed.geargraph") == path);
    const auto& instances = window->view3d().stage()->scene.instances;
    QVERIFY(instances.back().isOpen && instances.back().element == ElementId(LinkId("1")));

    QVERIFY(QFile::remove(QString::fromStdString(part.string())));
    open(QStringLiteral(":/examples/planetary-ring-held.geargraph"));
    open(path);  // opens all the same
    QCOMPARE(parts(), bare);
    QVERIFY(window->view3d().stage()->notes.front().text.find("It is not there.") != std::string::npos);
  }

  void aDocumentWithoutAFileHasNoPlaceForPaths() {
    ShapesDialog dialog(&window->document(), LinkId("1"), window.get());
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QSignalSpy rejected(&window->document(), &Document::rejected);
    QVERIFY(!dialog.add("/tmp/part.stl"));
    QCOMPARE(rejected.size(), qsizetype{1});
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowView3DTest)
#include "test_window_view3d.moc"
