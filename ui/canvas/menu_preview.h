#pragma once

#include <QObject>
#include <map>

#include "ui/document/document.h"

class QAction;
class QMenu;

namespace geargraph {

/// Previews menu entries while they are highlighted: wanted() gives the edit to be previewed, ended() is
/// emitted when the entry is left or chosen, or the menu closes. A chosen entry is carried out afterwards by
/// its action.
class MenuPreview : public QObject {
  Q_OBJECT

 public:
  /// The preview of the menu, which owns it; created on first use.
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

}  // namespace geargraph
