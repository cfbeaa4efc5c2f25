#include "ui/theme/painting_in_parts.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QFont>
#include <QMainWindow>
#include <QPalette>
#include <QToolTip>
#include <QWidget>
#include <algorithm>
#include <vector>

#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

bool isMainWindow(const QWidget* widget) {
  return qobject_cast<const QMainWindow*>(widget) != nullptr;
}

bool isDock(const QWidget* widget) {
  return qobject_cast<const QDockWidget*>(widget) != nullptr;
}

/// What stands in a window, and its docks that float, alone or in tabs.
std::vector<QWidget*> partsOf(const QWidget& window) {
  std::vector<QWidget*> parts;
  for (QWidget* child : window.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!child->isWindow()) parts.push_back(child);
  }
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    if (dock->isWindow() || dock->parentWidget() != &window) parts.push_back(dock);
  }
  // What is seen comes first.
  std::stable_partition(parts.begin(), parts.end(), [](const QWidget* part) { return part->isVisible(); });
  return parts;
}

/// What no part covers: the lines between docks.
QRegion uncovered(const QWidget& window) {
  QRegion region = window.rect();
  for (const QWidget* part : partsOf(window)) {
    if (part->isVisible() && !part->isWindow()) region -= part->geometry();
  }
  return region;
}

/// Is the window active, or a dock or a dialog of it?
bool isActive(const QWidget& window) {
  const QWidget* active = QApplication::activeWindow();
  while (active != nullptr && active != &window) active = active->parentWidget();
  return active != nullptr;
}

void dress(QWidget& widget) {
  QFont font;
  font.setPixelSize(bodyPixels());
  widget.setFont(font);
  widget.setPalette(QApplication::palette());
}

void follow(QWidget& widget) {
  if (!widget.testAttribute(Qt::WA_WState_Polished)) return;  // it is dressed then
  dress(widget);
  updateLooks(widget);
}

}  // namespace

IncrementalRestyle& IncrementalRestyle::instance() {
  static QPointer<IncrementalRestyle> instance;
  if (instance == nullptr) instance = new IncrementalRestyle(qApp);
  return *instance;
}

void IncrementalRestyle::dressPart(QWidget& widget) {
  const bool isPart = isMainWindow(widget.parentWidget()) && (!widget.isWindow() || isDock(&widget));
  if (isPart || isMainWindow(&widget)) dress(widget);
}

void IncrementalRestyle::hold(QWidget& part) {
  if (std::find(m_waiting.begin(), m_waiting.end(), &part) != m_waiting.end()) return;
  if (part.isVisible()) part.setUpdatesEnabled(false);
  m_waiting.emplace_back(&part);
}

void IncrementalRestyle::change(const QPalette& palette, bool isLaidOutNext) {
  if (QFont font = QApplication::font(); font.pixelSize() != bodyPixels()) {
    font.setPixelSize(bodyPixels());
    QApplication::setFont(font);
  }
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::ApplicationPaletteChange);
  for (QWidget* top : QApplication::topLevelWidgets()) {
    if (!isMainWindow(top)) {
      if (!isDock(top)) updateLooks(*top);
      continue;
    }
    for (QWidget* part : partsOf(*top)) {
      hold(*part);
      if (isLaidOutNext && isActive(*top)) follow(*part);
    }
    // The parts, which repaint in their turns, do not inherit from it. Its attribute is set alone, because
    // the function would enable them with it.
    top->setAttribute(Qt::WA_UpdatesDisabled);
    dress(*top);
    top->setAttribute(Qt::WA_UpdatesDisabled, false);
    top->update(uncovered(*top));
  }
  if (!isSettled()) m_turn.request();
}

void IncrementalRestyle::goOn() {
  while (!m_waiting.empty()) {
    const QPointer<QWidget> part = m_waiting.front();
    m_waiting.pop_front();
    if (part == nullptr) continue;
    follow(*part);
    part->setUpdatesEnabled(true);
    break;
  }
  if (!isSettled()) m_turn.request();
}

}  // namespace geargraph

#include "moc_painting_in_parts.cpp"
