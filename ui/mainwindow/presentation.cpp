#include "ui/mainwindow/presentation.h"

#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <utility>

#include "ui/canvas/drawing_view.h"
#include "ui/mainwindow/layout_pause.h"
#include "ui/settings/settings.h"

namespace geargraph {
namespace {

constexpr int kHintMilliseconds = 5000;
const QString kLayoutKey = QStringLiteral("presentation/state");

/// Does it take Space and Esc for what is being typed?
bool isTypedInto(const QWidget& widget) {
  return widget.inherits("QLineEdit") || widget.inherits("QAbstractSpinBox") ||
         widget.inherits("QTextEdit") || widget.inherits("QPlainTextEdit");
}

}  // namespace

Presentation::Presentation(QMainWindow* window) : QObject(window), m_window(window) {}

void Presentation::setBarsVisible(bool visible) {
  m_window->menuBar()->setVisible(visible);
  m_window->statusBar()->setVisible(visible);
  m_window->findChild<QToolBar*>(QStringLiteral("toolBar"))->setVisible(visible);
}

/// The panels of the last presentation; at first the matrices alone, below the drawing.
void Presentation::choosePanels() {
  const QByteArray layout = savedSetting(kLayoutKey).toByteArray();
  if (!layout.isEmpty() && m_window->restoreState(layout)) return;
  for (auto* dock : m_window->findChildren<QDockWidget*>()) {
    dock->setVisible(dock->property(kIsPresented).toBool());
  }
}

void Presentation::setOn(bool on) {
  if (on == m_on) return;
  m_on = on;
  on ? enter() : leave();
}

void Presentation::enter() {
  m_workLayout = {m_window->saveGeometry(), m_window->saveState()};
  m_workState = m_window->windowState();
  {
    const LayoutPause pause(m_window);
    setBarsVisible(false);
    choosePanels();
    m_window->setWindowState(m_workState | Qt::WindowFullScreen);
  }
  emit changed(true);
  qApp->installEventFilter(this);
  showHint();
}

bool Presentation::eventFilter(QObject* watched, QEvent* event) {
  const bool isPressed = event->type() == QEvent::KeyPress;
  if (!isPressed && event->type() != QEvent::KeyRelease && event->type() != QEvent::ShortcutOverride)
    return QObject::eventFilter(watched, event);
  const auto* widget = qobject_cast<QWidget*>(watched);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool isOurs = widget != nullptr && widget == QApplication::focusWidget() &&
                      widget->window() == m_window && QApplication::activePopupWidget() == nullptr &&
                      key.modifiers() == Qt::NoModifier && !isTypedInto(*widget);
  const bool isEscape = key.key() == Qt::Key_Escape;
  if (!isOurs || (!isEscape && key.key() != Qt::Key_Space)) return QObject::eventFilter(watched, event);
  const auto* drawing = qobject_cast<const DrawingView*>(widget);
  const bool goesBack = drawing != nullptr && (drawing->isDrawing() || drawing->tool() == ToolKind::measure);
  if (isEscape && goesBack) return false;
  // In a drawing Space pans while it is held; a tap plays by itself.
  if (!isEscape && drawing != nullptr) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
  } else if (isPressed && !key.isAutoRepeat()) {
    isEscape ? setOn(false) : emit played();
  }
  return true;
}

Presentation::Layout Presentation::workLayout() const {
  return m_on ? m_workLayout : Layout{m_window->saveGeometry(), m_window->saveState()};
}

void Presentation::end() {
  if (std::exchange(m_on, false)) finish();
}

void Presentation::finish() {
  qApp->removeEventFilter(this);
  saveSetting(kLayoutKey, m_window->saveState());
  delete m_hint;
  m_hint = nullptr;
  emit changed(false);
}

/// The type shrinks first: large panels would push the window wider than it was.
void Presentation::leave() {
  finish();
  const LayoutPause pause(m_window);
  m_window->setWindowState(m_workState);
  setBarsVisible(true);
  m_window->restoreState(m_workLayout.state);
  m_window->restoreGeometry(m_workLayout.geometry);
}

void Presentation::showHint() {
  m_hint = new QLabel(
      tr("Esc or F11 ends the presentation, Space plays.  Alt+1, Alt+2, … show and hide panels."), m_window);
  m_hint->setObjectName(QStringLiteral("presentationHint"));
  m_hint->setProperty("look", "toast");
  m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_hint->adjustSize();
  m_hint->move((m_window->width() - m_hint->width()) / 2, 48);
  m_hint->show();
  m_hint->raise();
  QTimer::singleShot(kHintMilliseconds, m_hint, &QWidget::hide);
}

}  // namespace geargraph

#include "moc_presentation.cpp"
