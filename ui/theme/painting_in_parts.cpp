#include "ui/theme/painting_in_parts.h"

#include <QApplication>
#include <QEvent>
#include <QFont>
#include <QMainWindow>
#include <QPalette>
#include <QToolTip>
#include <QWidget>
#include <vector>

#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph::inline theme {
namespace {

std::vector<QWidget*> visibleMainWindows() {
  std::vector<QWidget*> windows;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (qobject_cast<QMainWindow*>(widget) != nullptr && widget->isVisible()) windows.push_back(widget);
  }
  return windows;
}

std::vector<QWidget*> visibleParts(const QWidget& window) {
  std::vector<QWidget*> parts;
  for (QObject* child : window.children()) {
    auto* part = qobject_cast<QWidget*>(child);
    if (part != nullptr && part->isVisible()) parts.push_back(part);
  }
  return parts;
}

/// What no part covers: the lines between docks.
QRegion uncovered(const QWidget& window) {
  QRegion region = window.rect();
  for (const QWidget* part : visibleParts(window)) {
    if (!part->isWindow()) region -= part->geometry();
  }
  return region;
}

}  // namespace

PaintingInParts& PaintingInParts::instance() {
  static QPointer<PaintingInParts> instance;
  if (instance == nullptr) instance = new PaintingInParts(qApp);
  return *instance;
}

void PaintingInParts::hold(QWidget& window) {
  for (QWidget* part : visibleParts(window)) {
    if (!part->updatesEnabled()) continue;  // it waits already
    part->setUpdatesEnabled(false);
    m_held.emplace_back(part);
  }
}

void PaintingInParts::ownFont(QWidget& window) {
  QFont font;
  font.setPixelSize(bodyPixels());
  window.setFont(font);
}

void PaintingInParts::change(const QPalette& palette) {
  const std::vector<QWidget*> windows = visibleMainWindows();
  // Only the attribute of the window itself: the function would enable its parts with it, and repaint all.
  for (QWidget* window : windows) {
    hold(*window);
    window->setAttribute(Qt::WA_UpdatesDisabled);
  }
  if (QFont font = QApplication::font(); font.pixelSize() != bodyPixels()) {
    font.setPixelSize(bodyPixels());
    QApplication::setFont(font);
  }
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::ApplicationPaletteChange);
  renewLooks();
  for (QWidget* window : windows) {
    const bool hasOwn = window->testAttribute(Qt::WA_SetFont) && window->font().pixelSize() != bodyPixels();
    if (hasOwn && window->isActiveWindow()) {
      ownFont(*window);
    } else if (hasOwn) {
      m_otherFont.emplace_back(window);
    }
    window->setAttribute(Qt::WA_UpdatesDisabled, false);
    window->update(uncovered(*window));
  }
  if (!isSettled()) m_turn.request();
}

void PaintingInParts::goOn() {
  std::deque<QPointer<QWidget>>& waiting = m_otherFont.empty() ? m_held : m_otherFont;
  while (!waiting.empty()) {
    const QPointer<QWidget> next = waiting.front();
    waiting.pop_front();
    if (next == nullptr) continue;
    if (&waiting == &m_held) {
      next->setUpdatesEnabled(true);
    } else {
      ownFont(*next);
    }
    break;
  }
  if (!isSettled()) m_turn.request();
}

}  // namespace geargraph::inline theme
