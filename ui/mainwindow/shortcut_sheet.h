#pragma once

#include <QDialog>
#include <QString>
#include <array>
#include <deque>
#include <memory>

#include "ui/service/turns.h"

class QMenuBar;
class QPrinter;
class QTextBrowser;
class QTextDocument;

namespace geargraph {

/// All keyboard shortcuts on one sheet: those of the menus, and the mouse and keyboard actions in the
/// drawings and the 3D view; it can be printed on one page. Its columns are filled in turns: all of them at
/// once take up to 50 ms.
class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  ShortcutSheet(const QMenuBar& menus, QWidget* parent);

  static constexpr std::size_t kColumns = 4;

  /// The columns as HTML.
  [[nodiscard]] static std::array<QString, kColumns> columnsFor(const QMenuBar& menus);
  /// All of them on one page of this size, in pixels of the screen, in the largest type in which they fit.
  [[nodiscard]] static std::unique_ptr<QTextDocument> pageFor(const QMenuBar& menus, const QSizeF& page);
  static void printOn(QPrinter& printer, const QMenuBar& menus);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fillNext();
  void choosePrinter();

  const QMenuBar* m_menus;
  std::array<QTextBrowser*, kColumns> m_columns{};
  std::deque<QString> m_waiting;  ///< of the last columns
  CoalescedTask m_turn{this, [this] { fillNext(); }};
};

}  // namespace geargraph
