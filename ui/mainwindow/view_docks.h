#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QMainWindow>
#include <functional>
#include <vector>

#include "ui/workbench/views.h"

class QAction;

namespace geargraph {

class DockTitles;

/// The property of tabs for which the panels round the drawings are put away (ViewEntry::wantsRoom).
constexpr const char* kWantsRoom = "wantsRoom";

/// The panels of a window round its drawing: a dock and an action for each view that is no drawing, named
/// "dock." and the view's id. Layouts saved by users know docks by these names.
class ViewDocks final : public QObject {
  Q_OBJECT

 public:
  /// `leave`: takes the keyboard focus from a panel that is hidden.
  ViewDocks(QMainWindow* window, std::function<void()> leave);

  /// Makes the panel of a view, in its place; the first ten get the keys Alt+1 to Alt+0.
  QDockWidget* add(const ViewEntry& entry, ResultsView& view);

  /// @pre the view has a panel
  [[nodiscard]] QDockWidget* of(const ResultsView& view) const { return panel(view).dock; }
  /// Shows the panel; hides it if it is in front already.
  [[nodiscard]] QAction* actionOf(const ResultsView& view) const { return panel(view).action; }
  [[nodiscard]] QList<QAction*> actions() const;
  void reveal(const ResultsView& view);

  /// Shows all panels in their default places and sizes.
  void reset();
  /// Enables or closes the panels that hold the answer of a lesson's step; `why`: the tip of closed ones.
  void setAnswersOpen(bool isOpen, const QString& why);
  /// Shows or hides the panels in which a lesson has something drawn.
  void showForDrawing(bool isDrawn);
  /// Shows these panels and hides all others.
  void showOnly(const std::vector<const ResultsView*>& views);
  /// Hides the panels round the drawings, not those in windows of their own, until bringBack().
  void putAway();
  /// Lays the panels out as they were before putAway().
  void bringBack();
  /// QMainWindow::saveState(), as if nothing were put away.
  [[nodiscard]] QByteArray layout() const { return m_away.isEmpty() ? m_window->saveState() : m_away; }
  [[nodiscard]] bool arePutAway() const { return !m_away.isEmpty(); }

 private:
  struct Panel {
    ViewEntry entry;
    const ResultsView* view = nullptr;
    QDockWidget* dock = nullptr;
    QAction* action = nullptr;
  };

  [[nodiscard]] const Panel& panel(const ResultsView& view) const;
  /// Null if the place is empty.
  [[nodiscard]] QDockWidget* firstAt(ViewPlace place) const;
  void makeAction(Panel& panel);
  /// @param before the last panel that was placed there; null: none
  void place(const Panel& panel, QDockWidget* before);

  QMainWindow* m_window;
  std::function<void()> m_leave;
  DockTitles* m_titles;
  std::vector<Panel> m_panels;
  QByteArray m_away;  ///< the layout before putAway(); empty: nothing is put away
};

}  // namespace geargraph
