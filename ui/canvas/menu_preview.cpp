#include "ui/canvas/menu_preview.h"

#include <QEvent>
#include <QMenu>
#include <utility>

namespace geargraph {

MenuPreview& MenuPreview::of(QMenu& menu) {
  auto* known = menu.findChild<MenuPreview*>({}, Qt::FindDirectChildrenOnly);
  return known != nullptr ? *known : *new MenuPreview(menu);
}

MenuPreview::MenuPreview(QMenu& menu) : QObject(&menu), m_menu(&menu) {
  menu.installEventFilter(this);
  connect(&menu, &QMenu::hovered, this, &MenuPreview::tryOut);
  connect(&menu, &QMenu::aboutToHide, this, [this] { tryOut(nullptr); });
}

void MenuPreview::add(QAction* entry, const Edit& edit) {
  m_edits.insert_or_assign(entry, edit);
}

/// A menu does not tell that an entry is left: it is asked once it has done with what may leave one.
bool MenuPreview::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::Leave || type == QEvent::MouseMove || type == QEvent::KeyPress)
    QMetaObject::invokeMethod(this, &MenuPreview::renew, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

void MenuPreview::renew() {
  tryOut(m_menu->isVisible() ? m_menu->activeAction() : nullptr);
}

void MenuPreview::tryOut(QAction* entry) {
  const auto found = m_edits.find(entry);
  QAction* entryToTry = found != m_edits.end() && entry->isEnabled() ? entry : nullptr;
  if (std::exchange(m_tried, entryToTry) == entryToTry) return;
  if (entryToTry != nullptr) {
    emit wanted(found->second);
  } else {
    emit ended();
  }
}

}  // namespace geargraph

#include "moc_menu_preview.cpp"
