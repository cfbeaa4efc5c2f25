#include "tests/ui/mainwindow/hand.h"

#include <QApplication>
#include <QDockWidget>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "ui/canvas/digraph_view.h"
#include "ui/panels/matrices_panel.h"
#include "ui/settings/settings.h"
#include "ui/theme/application_theme.h"

namespace geargraph::test {

QWidget* Hand::sheet() {
  return m_window.digraph().viewport();
}

void Hand::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(&m_window.digraph(), key, modifiers);
}

void Hand::click(double across, double down) {
  const QPoint at(qRound(across * sheet()->width()), qRound(down * sheet()->height()));
  QTest::mouseMove(sheet(), at);
  QTest::mouseClick(sheet(), Qt::LeftButton, {}, at);
}

QPoint Hand::placeOf(int link) {
  const Mechanism& mechanism = *m_window.document().mechanism();
  const LinkId id = mechanism.links.at(static_cast<std::size_t>(link)).id;
  const DisplayList drawing = m_window.digraph().displayList();
  for (const Outline& outline : drawing.outlines) {
    const auto* disc = std::get_if<Circle>(&outline.shape);
    if (disc == nullptr || outline.element != ElementId(id)) continue;
    return m_window.digraph().mapFromScene(QPointF(disc->center.x, disc->center.y));
  }
  return {};
}

QPoint Hand::placeOfMesh(int mesh) {
  const MeshId id = m_window.document().mechanism()->gearMeshes.at(static_cast<std::size_t>(mesh)).id;
  for (const Outline& outline : m_window.digraph().displayList().outlines) {
    const auto* curve = std::get_if<Curve>(&outline.shape);
    if (curve == nullptr || outline.element != ElementId(id)) continue;
    const CanvasPoint middle = curve->at(0.3);
    return m_window.digraph().mapFromScene(QPointF(middle.x, middle.y));
  }
  return {};
}

void Hand::clickLink(int label) {
  QTest::mouseClick(sheet(), Qt::LeftButton, {}, placeOf(label));
}

void Hand::press(int link) {
  QTest::mouseMove(sheet(), placeOf(link));
  QTest::mousePress(sheet(), Qt::LeftButton, {}, placeOf(link));
}

void Hand::moveOver(int link) {
  const QPoint at = placeOf(link);
  QTest::mouseMove(sheet(), at + QPoint(3, 0));
  QTest::mouseMove(sheet(), at);
}

void Hand::release(int link) {
  QTest::mouseRelease(sheet(), Qt::LeftButton, {}, placeOf(link));
}

void Hand::drag(int from, int to) {
  press(from);
  moveOver(to);
  release(to);
}

void Hand::drawRobot() {
  for (int i = 0; i < 3; ++i) m_window.digraph().zoomOut();
  key(Qt::Key_L);
  const double places[7][2] = {{0.36, 0.8},  {0.62, 0.3}, {0.88, 0.15}, {0.14, 0.2},
                               {0.36, 0.12}, {0.62, 0.9}, {0.88, 0.85}};
  for (const auto& place : places) click(place[0], place[1]);
  key(Qt::Key_T);
  const int joints[7][2] = {{0, 4}, {0, 5}, {0, 1}, {1, 6}, {1, 2}, {2, 7}, {2, 3}};
  for (const auto& joint : joints) drag(joint[0], joint[1]);
  key(Qt::Key_G);
  const int meshes[4][2] = {{4, 1}, {5, 2}, {6, 7}, {7, 3}};
  for (const auto& mesh : meshes) drag(mesh[0], mesh[1]);
}

QStringList shownRows(MainWindow& window, MatrixKind kind) {
  window.matrices().showResult(resultOf(kind));
  const MatrixModel& model = window.matrices().model();
  QStringList rows;
  for (int i = 0; i < model.rowCount(); ++i) {
    QStringList entries;
    for (int j = 0; j < model.columnCount(); ++j) {
      entries << model.index(i, j).data().toString().replace(QStringLiteral("−"), QStringLiteral("-"));
    }
    rows << entries.join(QLatin1Char(' '));
  }
  return rows;
}

QStringList shownDocks(const MainWindow& window) {
  QStringList names;
  for (const auto* dock : window.findChildren<QDockWidget*>()) {
    if (!dock->isHidden()) names << dock->objectName();
  }
  names.sort();
  return names;
}

void isolateSettings() {
  static const QTemporaryDir folder;
  keepSettingsIn(folder.path());
}

void keepSettingsIn(const QString& folder) {
  QCoreApplication::setOrganizationName(QStringLiteral("GearGraphTest"));
  QCoreApplication::setApplicationName(QStringLiteral("GearGraphTest"));
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
}

void clearSettings() {
  changeSettings({}, [](QSettings& settings) { settings.clear(); });
  flushSettings();
}

void setUpProgram() {
  isolateSettings();
  applyTheme(*qApp, Theme::light);
}

std::unique_ptr<MainWindow> openedWindow(const QString& path) {
  auto window = std::make_unique<MainWindow>();
  if (!window->openDocument(path)) return nullptr;
  window->show();
  window->activateWindow();
  if (!QTest::qWaitForWindowActive(window.get())) return nullptr;
  if (!QTest::qWaitFor([&] { return window->isSettled(); })) return nullptr;
  return window;
}

}  // namespace geargraph::test
