#pragma once

#include <QAction>
#include <QActionGroup>
#include <array>
#include <optional>

#include "core/presentation/drawing/palette.h"
#include "ui/tools/tool.h"

class QMainWindow;

namespace geargraph::inline mainwindow {

/// All commands of the window, with shortcut, icon and tool tip, for menus and the tool bar. An unavailable
/// one is disabled, with the reason as its tool tip.
struct WindowActions {
  explicit WindowActions(QMainWindow* window);

  /// Enables or disables an action; `why` becomes the tip of a disabled one.
  static void setAvailable(QAction* action, bool available, const QString& why);
  void setTheme(Theme theme, bool asSystem, double typeScale);

  QAction* newDocument;
  QAction* newWindow;
  QAction* startPage;
  QAction* open;
  QAction* save;
  QAction* saveAs;
  QAction* revert;
  QAction* exportMatrix;
  QAction* restoreSession;
  QAction* exportPicture;
  QAction* exportDerivation;
  QAction* exportHandout;
  QAction* print;
  QAction* showDerivation;
  QAction* compareMethods;
  QAction* lessons;
  QAction* lessonFile;
  QAction* close;
  QAction* quit;

  QAction* undo;
  QAction* redo;
  QAction* cut;
  QAction* history;
  QAction* copy;
  QAction* copyPicture;
  QAction* paste;
  QAction* duplicate;
  QAction* remove;
  QAction* rename;
  QAction* selectAll;

  QActionGroup* tools;
  std::array<QAction*, kToolCount> tool{};

  QAction* flip;
  QAction* makeGround;
  QAction* attachGear;
  QAction* drive;
  QAction* tidy;
  QAction* hold;
  QAction* load;
  QAction* releaseAll;
  QAction* insertSet;
  std::array<QAction*, 5> planets{};  ///< 2 to 6 planets like the selected one

  QAction* fit;
  QAction* zoomIn;
  QAction* zoomOut;
  QAction* fitSelected;
  QAction* asSystem;
  QAction* light;
  QAction* dark;
  QAction* highContrast;
  QActionGroup* typeSizes;  ///< with the scale as data
  QAction* presentation;
  QAction* half3d;
  QAction* grid;
  QAction* powerFlow;
  QAction* resetLayout;

  QAction* play;
  QAction* toStart;
  QAction* faster;
  QAction* slower;
  QAction* normalSpeed;
  QAction* backwards;

  QAction* exercises;
  QAction* checkPaper;
  QAction* lookUp;
  QAction* search;
  QAction* manual;
  QAction* whatsThis;
  QAction* tour;
  QAction* shortcuts;
  QAction* about;

 private:
  QAction* make(const char* name, const QString& text, const QString& tip, const QList<QKeySequence>& keys,
                const QString& iconName = {});
  void makeTools();
  void makeMotion();
  void makeAppearance();

  QMainWindow* m_window;
  std::vector<std::pair<QAction*, QString>> m_icons;
  std::optional<Theme> m_iconTheme;  ///< that the icons have the colours of; none: not yet
};

}  // namespace geargraph::inline mainwindow
