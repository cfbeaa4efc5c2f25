#include "ui/forces/efficiency_view.h"

#include <QBoxLayout>
#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>

#include "ui/forces/efficiency_card.h"
#include "ui/forces/efficiency_page.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kCardWidth = 250;
constexpr int kPlotWidth = 260;  ///< px that a plot needs beside the card

}  // namespace

EfficiencyView::EfficiencyView(Document* document, QWidget* parent)
    : QWidget(parent),
      m_card(new EfficiencyCard(document, this)),
      m_plots(new EfficiencyPage(this)),
      m_cardView(new QScrollArea(this)),
      m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  m_cardView->setWidget(m_card);
  m_cardView->setWidgetResizable(true);
  m_cardView->setFrameShape(QFrame::NoFrame);
  m_cardView->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_cardView->setFocusPolicy(Qt::NoFocus);  // what is in it has
  m_card->installEventFilter(this);
  m_layout->setContentsMargins(12, 0, 10, 4);
  m_layout->setSpacing(8);
  m_layout->addWidget(m_cardView);
  m_layout->addWidget(m_plots, 1);
  arrange();
}

void EfficiencyView::show(const ForcesPtr& forces) {
  m_card->show(forces);
  m_plots->show(forces);
}

bool EfficiencyView::isUpToDate() const {
  return m_card->isUpToDate() && m_plots->isUpToDate();
}

void EfficiencyView::arrange() {
  const int wanted = std::max(scaledPixels(kCardWidth), m_card->minimumSizeHint().width()) +
                     m_cardView->verticalScrollBar()->sizeHint().width();
  const bool isBeside = width() >= wanted + scaledPixels(kPlotWidth);
  m_layout->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  m_cardView->setMinimumWidth(isBeside ? wanted : 0);
  m_cardView->setMaximumWidth(isBeside ? wanted : QWIDGETSIZE_MAX);
}

void EfficiencyView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool EfficiencyView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_card && event->type() == QEvent::LayoutRequest) arrange();
  return QWidget::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_efficiency_view.cpp"
