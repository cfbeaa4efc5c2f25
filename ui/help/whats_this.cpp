#include "ui/help/whats_this.h"

#include <QAction>
#include <QApplication>
#include <QHelpEvent>
#include <QMainWindow>
#include <QWhatsThis>

#include "ui/help/help_page_of.h"

namespace geargraph {
namespace {

/// "E&xport" without the sign of its key.
QString plain(QString text) {
  return text.remove(QLatin1Char('&'));
}

/// A tip is plain text or rich text; a "What's this" is rich text.
QString rich(const QString& tip) {
  return Qt::mightBeRichText(tip) ? tip : QStringLiteral("<p>%1</p>").arg(tip.toHtmlEscaped());
}

}  // namespace

WhatsThis::WhatsThis(QMainWindow* window) : QObject(window), m_window(window) {
  qApp->installEventFilter(this);
}

QString WhatsThis::textFor(const QWidget* widget) {
  QString tip;
  for (const QWidget* each = widget; each != nullptr; each = each->parentWidget()) {
    if (!each->whatsThis().isEmpty()) return each->whatsThis();
    if (tip.isEmpty()) tip = each->toolTip();
    const QString purpose = purposeOf(*each);
    if (purpose.isEmpty()) continue;
    const QString more = tr("F1 opens the page of the manual.");
    return (tip.isEmpty() ? QString() : rich(tip)) +
           QStringLiteral("<p>%1</p><p>%2</p>").arg(purpose.toHtmlEscaped(), more.toHtmlEscaped());
  }
  return tip.isEmpty() ? QString() : rich(tip);
}

QString WhatsThis::textFor(const QAction& action) {
  const QString tip = plain(action.toolTip());
  return tip.isEmpty() ? plain(action.text()) : tip;
}

/// Menus and tool buttons answer for their actions themselves, from texts that are theirs: renewed each time,
/// for tips change with what is possible.
void WhatsThis::prepareActions() {
  for (QAction* action : m_window->findChildren<QAction*>()) {
    if (!action->isSeparator()) action->setWhatsThis(rich(textFor(*action)));
  }
}

bool WhatsThis::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::EnterWhatsThisMode && watched == m_window) prepareActions();
  const bool isAsked = event->type() == QEvent::WhatsThis || event->type() == QEvent::QueryWhatsThis;
  if (!isAsked || !watched->isWidgetType()) return QObject::eventFilter(watched, event);
  auto* widget = static_cast<QWidget*>(watched);
  if (widget->window() != m_window || !widget->whatsThis().isEmpty()) return false;
  const QString text = textFor(widget);
  if (text.isEmpty()) return false;
  if (event->type() == QEvent::WhatsThis)
    QWhatsThis::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, widget);
  event->accept();
  return true;
}

}  // namespace geargraph

#include "moc_whats_this.cpp"
