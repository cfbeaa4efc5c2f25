#include "ui/mainwindow/fitting_tool_bar.h"

#include <QEvent>
#include <QLayout>
#include <QToolButton>

namespace geargraph {

void FittingToolBar::addNamed(QAction* action) {
  addAction(action);
  m_named << action;
}

void FittingToolBar::showNames(bool shown) {
  m_areNamesShown = shown;
  for (QAction* action : m_named)
    qobject_cast<QToolButton*>(widgetForAction(action))
        ->setToolButtonStyle(shown ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
  layout()->activate();
}

// The layout itself decides what fits: fields shrink before it hides a control.
void FittingToolBar::fit() {
  const auto* extension = findChild<QWidget*>(QStringLiteral("qt_toolbar_ext_button"));
  if (extension == nullptr) return;
  if (!m_areNamesShown) showNames(true);
  if (extension->isVisibleTo(this)) showNames(false);
}

void FittingToolBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fit();
}

/// Larger type, of a presentation for one, needs more room.
void FittingToolBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fit();
}

}  // namespace geargraph

#include "moc_fitting_tool_bar.cpp"
