#pragma once

#include <QDialog>
#include <QString>
#include <array>
#include <deque>

#include "ui/service/turns.h"

class QMenuBar;
class QTextBrowser;

namespace geargraph {

/// All keyboard shortcuts on one sheet: those of the menus, and the mouse and keyboard actions in the
/// drawings and the 3D view. Its columns are filled in turns: all of them at once take up to 50 ms.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  ShortcutSheet(const QMenuBar& menus, QWidget* parent);

  static constexpr std::size_t kColumns = 4;

  /// The columns as HTML.
  [[nodiscard]] static std::array<QString, kColumns> columnsFor(const QMenuBar& menus);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fillNext();

  const QMenuBar* m_menus;
  std::array<QTextBrowser*, kColumns> m_columns{};
  std::deque<QString> m_waiting;  ///< of the last columns
  CoalescedTask m_turn{this, [this] { fillNext(); }};
};

}  // namespace geargraph
