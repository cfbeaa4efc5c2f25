#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <vector>

#include "ui/help/tour.h"

namespace geargraph {
class HelpWindow;
}  // namespace geargraph

class QDockWidget;
class QMainWindow;

namespace geargraph {

/// What a tour needs from the window.
struct TourStage {
  std::function<QString()> unavailableReason;  ///< why no tour is possible now; empty: one is
  std::function<void()> begin;                 ///< shows a mechanism and its drawing
  std::function<void(const QString& drawing)> showDrawing;
  std::function<void()> end;
  /// The panel of a view by its id.
  std::function<QDockWidget*(const QString& id)> panel;
};

/// The manual, "What's this" and the tour of a window.
class WindowHelp : public QObject {
  Q_OBJECT

 public:
  WindowHelp(QMainWindow* window, TourStage stage);

  /// Shows a page of the manual, "page" or "page#anchor".
  void showPage(const QString& pageAndAnchor);
  /// Shows the page about the widget with the keyboard focus, also in a dialog of this window.
  void showPageForFocus();
  /// Runs a command by its menu path, "File > Print". If it is disabled, rejected() gives the reason.
  void runCommand(const QString& menuPath);

  /// Starts the tour; rejected() if TourStage::unavailableReason() gives a reason.
  void startTour();
  /// startTour() at this user's first start of the program only.
  void offerTour();

  /// Null until it is opened.
  [[nodiscard]] HelpWindow* manualWindow() { return m_manual; }
  /// Null while there is none.
  [[nodiscard]] Tour* tour() { return m_tour; }

 signals:
  void lessonWanted(const QString& id);
  void rejected(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] std::vector<TourStep> tourSteps();
  [[nodiscard]] TourStep panelStep(const QString& view, const QString& title, const QString& text);
  [[nodiscard]] TourStep drawingStep(const QString& drawing, const QString& title, const QString& text);
  [[nodiscard]] QRect areaOf(const QWidget* part) const;
  [[nodiscard]] QRegion searchAndLearn() const;

  QMainWindow* m_window;
  TourStage m_stage;
  HelpWindow* m_manual = nullptr;
  QPointer<Tour> m_tour;
};

}  // namespace geargraph
