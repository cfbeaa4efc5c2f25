#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <vector>

#include "ui/help/tour.h"

namespace geargraph::inline ui_help {
class HelpWindow;
}  // namespace geargraph::inline ui_help

class QMainWindow;

namespace geargraph::inline mainwindow {

/// What a tour needs of the window that it shows.
struct TourStage {
  std::function<QString()> whyNone;  ///< the reason why there can be no tour now; empty where there can
  std::function<void()> begin;       ///< brings a mechanism and its drawing into sight
  std::function<void(const QString& drawing)> showDrawing;
  std::function<void()> end;
};

/// The manual, "What's this" and the tour of a window.
class WindowHelp : public QObject {
  Q_OBJECT

 public:
  WindowHelp(QMainWindow* window, TourStage stage);

  /// "page" or "page#anchor".
  void showPage(const QString& pageAndAnchor);
  /// The page about the widget that has the keyboard, also in a dialog of this window.
  void showPageForFocus();
  /// Carries out a command by its place in the menus, "File > Print"; one that is not possible is refused()
  /// with its reason.
  void runCommand(const QString& menuPath);

  /// Refused where the stage has a reason for none.
  void startTour();
  /// startTour() at the first start of the program of this user, and never again.
  void offerTour();

  /// Null while it has not been opened.
  [[nodiscard]] HelpWindow* manualWindow() { return m_manual; }
  /// Null while there is none.
  [[nodiscard]] Tour* tour() { return m_tour; }

 signals:
  void lessonWanted(const QString& id);
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] std::vector<TourStep> tourSteps();
  [[nodiscard]] TourStep panelStep(const char* dock, const QString& title, const QString& text);
  [[nodiscard]] TourStep drawingStep(const QString& drawing, const QString& title, const QString& text);
  [[nodiscard]] QRect areaOf(const QWidget* part) const;
  [[nodiscard]] QRegion searchAndLearn() const;

  QMainWindow* m_window;
  TourStage m_stage;
  HelpWindow* m_manual = nullptr;
  QPointer<Tour> m_tour;
};

}  // namespace geargraph::inline mainwindow
