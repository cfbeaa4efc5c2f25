#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <vector>

#include "ui/service/turns.h"

class QWidget;

namespace geargraph::inline theme {

/// Sets the style sheet of the program on the parts of its windows (docks, bars, dialogs, menus), not on the
/// application. A change of the theme then updates one part per turn of the event loop, in 10 to 30 ms; a
/// sheet of the application would block for 100 to 300 ms in a window of 600 widgets. Windows repaint when
/// all visible parts have the new sheet. The hidden ones follow: a command that shows many of them would wait
/// for the sheets of all. A part that is shown earlier gets its sheet next.
class ThemeSheets : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call.
  static ThemeSheets& instance();

  /// @param withHidden false if the former sheet is to return soon, as after a presentation, which shows the
  ///   hidden parts again: they keep it
  void setSheet(const QString& sheet, bool withHidden = true);
  [[nodiscard]] bool isSettled() const { return m_outdated.empty(); }

 signals:
  /// All visible parts have the sheet.
  void settled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  explicit ThemeSheets(QObject* application);

  void renewNext();
  void renewWhenShown(QWidget& part);
  void holdPainting();
  void paintNext();

  QString m_sheet;
  std::vector<QPointer<QWidget>> m_outdated;  ///< visible parts
  std::vector<QPointer<QWidget>> m_hidden;    ///< parts that get it after those
  std::vector<QPointer<QWidget>> m_held;  ///< windows that do not repaint while visible parts are outdated
  TurnOf m_turn{this, [this] { renewNext(); }};
};

}  // namespace geargraph::inline theme
