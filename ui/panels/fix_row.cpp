#include "ui/panels/fix_row.h"

#include <QPushButton>
#include <algorithm>

namespace geargraph {
namespace {

constexpr int kGap = 6;
constexpr int kBelow = 8;
constexpr int kLineHeight = 24;

}  // namespace

FixRow::FixRow(int indent, QWidget* parent) : QWidget(parent), m_indent(indent) {}

QPushButton* FixRow::addButton(const QString& text) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QStringLiteral("fix"));
  button->setProperty("look", "fix");
  button->setToolTip(tr("Fixes it; Ctrl+Z undoes that"));
  m_buttons << button;
  return button;
}

QList<QRect> FixRow::placesFor(int width) const {
  QList<QRect> places;
  QPoint at(m_indent, 0);
  for (const QPushButton* button : m_buttons) {
    const int wide = std::min(button->sizeHint().width(), width - m_indent - kGap);
    if (at.x() > m_indent && at.x() + wide > width - kGap) at = {m_indent, at.y() + kLineHeight + kGap};
    places << QRect(at, QSize(wide, kLineHeight));
    at.rx() += wide + kGap;
  }
  return places;
}

int FixRow::heightFor(int width) const {
  const QList<QRect> places = placesFor(width);
  return places.isEmpty() ? 0 : places.last().bottom() + 1 + kBelow;
}

void FixRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int top = height() - heightFor(width());
  const QList<QRect> places = placesFor(width());
  for (qsizetype i = 0; i < places.size(); ++i) m_buttons[i]->setGeometry(places[i].translated(0, top));
  setMask(childrenRegion());
}

}  // namespace geargraph

#include "moc_fix_row.cpp"
