#pragma once

#include <QPoint>
#include <QStringList>
#include <memory>

#include "core/mechanism/model/mechanism.h"
#include "ui/mainwindow/main_window.h"

namespace geargraph::test {

/// A person at the digraph of a window: real mouse and key events, links named by the paper's labels.
class Hand {
 public:
  explicit Hand(MainWindow& window) : m_window(window) {}

  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  /// Clicks at this part of the drawing's width and height.
  void click(double across, double down);
  void clickLink(int label);
  void press(int link);
  void moveOver(int link);
  void release(int link);
  /// Presses one link, moves to another, lets go.
  void drag(int from, int to);
  /// The robot of the paper [AU, Fig. 2]: seven links, seven turning joints, four meshes.
  void drawRobot();

  [[nodiscard]] QPoint placeOf(int link);
  /// On the arrow of a mesh, by its position in the list.
  [[nodiscard]] QPoint placeOfMesh(int mesh);

 private:
  [[nodiscard]] QWidget* sheet();

  MainWindow& m_window;
};

/// The rows of the matrix that is shown, entries parted by blanks, with "-" for minus.
[[nodiscard]] QStringList shownRows(MainWindow& window, MatrixKind kind);

/// The names of the docks that are not hidden, in tabs or not, sorted.
[[nodiscard]] QStringList shownDocks(const MainWindow& window);

/// Settings in a folder of their own, thrown away at the end of the program; call before the first window.
void isolateSettings();
/// Settings in a folder that somebody else throws away.
void keepSettingsIn(const QString& folder);
/// isolateSettings(), and the light theme, whatever the machine's is.
void setUpProgram();

/// Forgets all settings.
void clearSettings();

/// A window that shows a document, active and with its analysis; none where it does not come to that.
[[nodiscard]] std::unique_ptr<MainWindow> openedWindow(const QString& path);

}  // namespace geargraph::test
