#include "ui/theme/theme_sheets.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QWidget>
#include <algorithm>

#include "ui/theme/style_sheet.h"

namespace geargraph::inline theme {
namespace {

bool isMainWindow(const QWidget* widget) {
  return qobject_cast<const QMainWindow*>(widget) != nullptr;
}

/// A widget that has a sheet of its own for all that is in it. A main window has none: its parts would be
/// polished with it, all at once. Qt gives tips the sheet of what they are about.
bool isPart(const QWidget* widget) {
  if (isMainWindow(widget) || widget->inherits("QTipLabel")) return false;
  const QWidget* parent = widget->parentWidget();
  return parent == nullptr || isMainWindow(parent);
}

/// A dock, or several in tabs, that floats.
bool isFloating(const QWidget& part) {
  const bool isDock =
      qobject_cast<const QDockWidget*>(&part) != nullptr || part.inherits("QDockWidgetGroupWindow");
  return isDock && part.isWindow();
}

}  // namespace

ThemeSheets& ThemeSheets::instance() {
  static QPointer<ThemeSheets> sheets;
  if (sheets == nullptr) sheets = new ThemeSheets(qApp);
  return *sheets;
}

ThemeSheets::ThemeSheets(QObject* application) : QObject(application) {
  application->installEventFilter(this);
}

void ThemeSheets::setSheet(const QString& sheet, bool withHidden) {
  if (sheet == m_sheet) return;
  m_sheet = sheet;
  m_outdated.clear();
  m_hidden.clear();
  for (QWidget* widget : QApplication::allWidgets()) {
    if (!isPart(widget)) continue;
    if (widget->isVisible()) {
      m_outdated.emplace_back(widget);
    } else if (withHidden && !widget->styleSheet().isEmpty()) {  // it has been shown before
      m_hidden.emplace_back(widget);
    }
  }
  if (m_outdated.empty() && m_hidden.empty()) return;
  if (!m_outdated.empty()) holdPainting();
  m_turn.request();
}

void ThemeSheets::renewNext() {
  const bool isSettling = !m_outdated.empty();
  if (!isSettling && !m_held.empty()) return paintNext();
  std::vector<QPointer<QWidget>>& waiting = isSettling ? m_outdated : m_hidden;
  while (!waiting.empty()) {
    const QPointer<QWidget> widget = waiting.back();
    waiting.pop_back();
    if (widget == nullptr) continue;
    theme::setSheet(*widget, m_sheet);
    break;
  }
  if (isSettling && m_outdated.empty()) return paintNext();
  if (!m_outdated.empty() || !m_hidden.empty()) m_turn.request();
}

/// Else a window would show some parts in the old colours and some in the new.
void ThemeSheets::holdPainting() {
  for (QWidget* window : QApplication::topLevelWidgets()) {
    if (!isMainWindow(window) || !window->isVisible() || !window->updatesEnabled()) continue;
    window->setUpdatesEnabled(false);
    m_held.emplace_back(window);
  }
}

/// Painting a window takes up to 50 ms: the next one waits for another turn.
void ThemeSheets::paintNext() {
  while (!m_held.empty()) {
    const QPointer<QWidget> window = m_held.back();
    m_held.pop_back();
    if (window == nullptr) continue;
    window->setUpdatesEnabled(true);
    // A request that came in between was dropped, and Qt waits for it where a widget was waiting to be
    // painted.
    QCoreApplication::postEvent(window, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
    break;
  }
  if (!m_held.empty() || !m_hidden.empty()) m_turn.request();
  if (m_held.empty()) emit settled();
}

bool ThemeSheets::eventFilter(QObject* watched, QEvent* event) {
  // A part of a window before its first layout; a window without parent when it is shown, because before that
  // it may be a widget that has not been put into its place.
  const bool isPolish = event->type() == QEvent::Polish;
  if ((isPolish || event->type() == QEvent::Show) && watched->isWidgetType()) {
    auto* widget = static_cast<QWidget*>(watched);
    if (isPart(widget) && !(isPolish && widget->parentWidget() == nullptr)) renewWhenShown(*widget);
  }
  return QObject::eventFilter(watched, event);
}

/// Many parts may be shown by one command, as when the layout is reset or a presentation ends: they wait
/// their turn, and the window with its painting. Not so the first one without a former sheet, nor those of a
/// window that is about to be shown, whose layout begins with them.
void ThemeSheets::renewWhenShown(QWidget& part) {
  if (part.styleSheet() == m_sheet) return;
  const bool isInSight = part.window()->isVisible() && (!part.isWindow() || isFloating(part));
  if (!isInSight || (part.styleSheet().isEmpty() && !m_turn.isDue())) {
    theme::setSheet(part, m_sheet);
    if (isInSight) m_turn.request();  // those that follow are not the first
    return;
  }
  if (std::find(m_outdated.begin(), m_outdated.end(), &part) == m_outdated.end())
    m_outdated.emplace_back(&part);
  holdPainting();
  m_turn.request();
}

}  // namespace geargraph::inline theme
