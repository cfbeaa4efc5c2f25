#include "ui/lever_views/point_offers.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

namespace geargraph {

PointOffers::PointOffers(QWidget* parent)
    : QFrame(parent), m_hold(new QToolButton(this)), m_lock(new QToolButton(this)) {
  setObjectName(QStringLiteral("pointOffers"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Window);
  setFocusPolicy(Qt::NoFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(3, 3, 3, 3);
  row->setSpacing(3);
  m_hold->setObjectName(QStringLiteral("holdPoint"));
  m_lock->setObjectName(QStringLiteral("lockPoint"));
  m_lock->setText(tr("Lock with…"));
  m_lock->setToolTip(tr("A clutch to the link that you click next"));
  for (QToolButton* button : {m_hold, m_lock}) {
    button->setProperty("look", "control");
    button->setFocusPolicy(Qt::NoFocus);  // keys stay with the drawing: B holds, Esc ends
    row->addWidget(button);
  }
  connect(m_hold, &QToolButton::clicked, this, &PointOffers::holdWanted);
  connect(m_lock, &QToolButton::clicked, this, &PointOffers::lockWanted);
  hide();
}

void PointOffers::showAt(int x, int high, int low, bool canHold, bool isHeld) {
  constexpr int kGap = 8;
  m_hold->setVisible(canHold);
  m_hold->setText(isHeld ? tr("Let go (B)") : tr("Hold (B)"));
  m_hold->setToolTip(isHeld ? tr("Release the brake of this link")
                            : tr("Engage the brake of this link, a new one where it has none"));
  adjustSize();
  const QWidget* const around = parentWidget();
  const bool hasRoomBelow = low + kGap + height() <= around->height();
  const int y = hasRoomBelow ? low + kGap : high - kGap - height();
  move(std::clamp(x - width() / 2, 0, std::max(0, around->width() - width())), std::max(0, y));
  show();
  raise();
}

}  // namespace geargraph

#include "moc_point_offers.cpp"
