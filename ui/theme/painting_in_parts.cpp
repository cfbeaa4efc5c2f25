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

bool isMainWindow(const QWidget* widget) {
  return qobject_cast<const QMainWindow*>(widget) != nullptr;
}

/// Those that have been dressed.
std::vector<QWidget*> mainWindows() {
  std::vector<QWidget*> windows;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (isMainWindow(widget) && widget->testAttribute(Qt::WA_WState_Polished)) windows.push_back(widget);
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

void PaintingInParts::dress(QWidget& window) {
  QFont font;
  font.setPixelSize(bodyPixels());
  window.setFont(font);
  window.setPalette(QApplication::palette());
}

/// The window repaints in the turns of its parts: only what no part covers is painted with it. Its attribute
/// is set alone, because the function would enable its parts with it, and repaint all.
void PaintingInParts::follow(QWidget& window) {
  window.setAttribute(Qt::WA_UpdatesDisabled);
  dress(window);
  renewLooks(window);
  window.setAttribute(Qt::WA_UpdatesDisabled, false);
  window.update(uncovered(window));
}

void PaintingInParts::change(const QPalette& palette) {
  const std::vector<QWidget*> windows = mainWindows();
  for (QWidget* window : windows) hold(*window);
  if (QFont font = QApplication::font(); font.pixelSize() != bodyPixels()) {
    font.setPixelSize(bodyPixels());
    QApplication::setFont(font);
  }
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::ApplicationPaletteChange);
  for (QWidget* top : QApplication::topLevelWidgets()) {
    if (top->parentWidget() == nullptr && !isMainWindow(top)) renewLooks(*top);
  }
  m_undressed.clear();
  for (QWidget* window : windows) {
    if (window->isActiveWindow()) {
      follow(*window);
    } else {
      m_undressed.emplace_back(window);
    }
  }
  if (!isSettled()) m_turn.request();
}

void PaintingInParts::goOn() {
  const bool isDressing = !m_undressed.empty();
  std::deque<QPointer<QWidget>>& waiting = isDressing ? m_undressed : m_held;
  while (!waiting.empty()) {
    const QPointer<QWidget> next = waiting.front();
    waiting.pop_front();
    if (next == nullptr) continue;
    isDressing ? follow(*next) : next->setUpdatesEnabled(true);
    break;
  }
  if (!isSettled()) m_turn.request();
}

}  // namespace geargraph::inline theme
