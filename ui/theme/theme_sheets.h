#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <vector>

class QWidget;

namespace geargraph::inline theme {

/// Gives the style sheet of the program to the parts of its windows: each dock, bar, dialog and menu has its
/// own, and the application has none. A change of the theme then takes one part in each turn of the event
/// loop, at most 10 ms; one sheet for the application takes 100 to 300 ms at once in a window of 600 widgets.
/// The windows repaint when all parts have the new sheet; a hidden part gets it when it is shown.
class ThemeSheets : public QObject {
  Q_OBJECT

 public:
  /// The one of the application; made with the first call.
  static ThemeSheets& instance();

  void setSheet(const QString& sheet);
  [[nodiscard]] bool isSettled() const { return m_outdated.empty(); }

 signals:
  /// All parts that are shown have the sheet.
  void settled();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  explicit ThemeSheets(QObject* application);

  void renewNext();
  void holdPainting(bool hold);

  QString m_sheet;
  std::vector<QPointer<QWidget>> m_outdated;
  std::vector<QPointer<QWidget>> m_held;  // windows that do not paint until all their parts have the sheet
  QTimer m_turn;
};

}  // namespace geargraph::inline theme
