#pragma once

#include <QObject>
#include <map>

#include "ui/document/document.h"

class QAction;
class QMenu;

namespace geargraph::inline canvas {

/// Entries of a menu that are tried while the mouse or the keys are on them: whoever shows the menu is told
/// which edit is to be shown, and when none is any more: the entry was left, chosen, or the menu closed.
/// A choice is carried out after that, by the entry itself.
class MenuPreview : public QObject {
  Q_OBJECT

 public:
  /// The one of the menu, which owns it; made when first asked for.
  [[nodiscard]] static MenuPreview& of(QMenu& menu);
  void add(QAction* entry, const Edit& edit);

 signals:
  void wanted(const geargraph::Edit& edit);
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  explicit MenuPreview(QMenu& menu);
  void tryOut(QAction* entry);  ///< null: none
  void renew();

  QMenu* m_menu;
  std::map<QAction*, Edit> m_edits;
  QAction* m_tried = nullptr;
};

}  // namespace geargraph::inline canvas
