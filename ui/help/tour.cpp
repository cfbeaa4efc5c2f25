#include "ui/help/tour.h"

#include <QAccessible>
#include <QApplication>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <array>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kCardWidth = 380;
constexpr int kGap = 14;    ///< between the card and what it points at
constexpr int kEdge = 16;   ///< between the card and the edge of the window
constexpr int kCorner = 8;  ///< radius of what is not dimmed
constexpr int kDimLight = 110;
constexpr int kDimDark = 160;

}  // namespace

Tour::Tour(std::vector<TourStep> steps, QWidget* window)
    : QWidget(window),
      m_steps(std::move(steps)),
      m_card(new QFrame(this)),
      m_title(new QLabel(m_card)),
      m_text(new QLabel(m_card)),
      m_count(new QLabel(m_card)) {
  setObjectName(QStringLiteral("tour"));
  setAccessibleName(tr("Tour"));
  setFocusPolicy(Qt::StrongFocus);
  makeCard();
  window->installEventFilter(this);
  show();
  raise();
  goTo(0);
}

QPushButton* Tour::makeButton(const char* name, const QString& text, void (Tour::*slot)()) {
  auto* button = new QPushButton(text, m_card);
  button->setObjectName(QLatin1String(name));
  button->setAutoDefault(false);
  button->installEventFilter(this);  // whose arrow keys would move the focus
  connect(button, &QPushButton::clicked, this, slot);
  return button;
}

void Tour::makeCard() {
  m_card->setObjectName(QStringLiteral("tourCard"));
  m_card->setProperty("look", "card");
  m_title->setProperty("look", "heading");
  m_title->setWordWrap(true);
  m_text->setWordWrap(true);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setObjectName(QStringLiteral("tourText"));
  m_count->setProperty("look", "hint");
  m_skip = makeButton("tourSkip", tr("Skip"), &Tour::end);
  m_skip->setToolTip(tr("Help > Tour shows it again (Esc)"));
  m_back = makeButton("tourBack", tr("Back"), &Tour::back);
  m_next = makeButton("tourNext", tr("Next"), &Tour::next);
  m_next->setDefault(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_count);
  buttons->addStretch(1);
  buttons->addWidget(m_skip);
  buttons->addWidget(m_back);
  buttons->addWidget(m_next);
  auto* layout = new QVBoxLayout(m_card);
  layout->setContentsMargins(18, 14, 18, 14);
  layout->setSpacing(10);
  layout->addWidget(m_title);
  layout->addWidget(m_text);
  layout->addLayout(buttons);
}

void Tour::next() {
  if (m_step + 1 < count()) return goTo(m_step + 1);
  end();
}

void Tour::back() {
  if (m_step > 0) goTo(m_step - 1);
}

void Tour::end() {
  if (m_hasEnded) return;
  m_hasEnded = true;
  hide();
  deleteLater();
  emit ended();
}

void Tour::goTo(int step) {
  m_step = step;
  const TourStep& now = m_steps[static_cast<std::size_t>(step)];
  if (now.prepare) now.prepare();
  const bool isLast = step + 1 == count();
  m_title->setText(now.title);
  m_text->setText(now.text);
  m_count->setText(tr("%1 of %2").arg(step + 1).arg(count()));
  m_back->setEnabled(step > 0);
  m_back->setToolTip(step > 0 ? tr("The part before (Left)") : tr("This is the beginning."));
  m_next->setText(isLast ? tr("Finish") : tr("Next"));
  m_next->setToolTip(isLast ? tr("To the window (Return)") : tr("The next part (Right)"));
  m_skip->setVisible(!isLast);
  m_card->setAccessibleName(now.title);
  m_card->setAccessibleDescription(now.text);
  raise();
  place();
  m_next->setFocus();
  QAccessibleEvent alert(m_card, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void Tour::place() {
  setGeometry(parentWidget()->rect());
  const TourStep& now = m_steps[static_cast<std::size_t>(m_step)];
  m_target = now.target ? now.target().intersected(rect()) : QRegion();
  const int width = std::min(scaledPixels(kCardWidth), this->width() - 2 * kEdge);
  m_card->setFixedWidth(width);
  m_card->layout()->activate();
  m_card->resize(width, m_card->layout()->totalHeightForWidth(width));
  m_card->move(cardPlace(m_card->size()));
  update();
}

/// Where the card covers nothing of what it points at: right, left, below or above of it, else in its lower
/// right corner.
QPoint Tour::cardPlace(const QSize& size) const {
  const QRect room = rect().adjusted(kEdge, kEdge, -kEdge, -kEdge);
  const QPoint half = QPoint(size.width(), size.height()) / 2;
  if (m_target.isEmpty()) return room.center() - half;
  const QRect around = m_target.boundingRect();
  const QPoint middle = around.center() - half;
  const std::array places = {
      QPoint(around.right() + kGap, middle.y()), QPoint(around.left() - kGap - size.width(), middle.y()),
      QPoint(middle.x(), around.bottom() + kGap), QPoint(middle.x(), around.top() - kGap - size.height())};
  for (const QPoint& each : places) {
    const QPoint inside(std::clamp(each.x(), room.left(), room.right() - size.width()),
                        std::clamp(each.y(), room.top(), room.bottom() - size.height()));
    if (!QRect(inside, size).intersects(around)) return inside;
  }
  return around.bottomRight() - QPoint(size.width() + kGap, size.height() + kGap);
}

bool Tour::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // no command of the window meanwhile
    return true;
  }
  return QWidget::event(event);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::KeyPress && m_card->isAncestorOf(qobject_cast<QWidget*>(watched))) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Tab || key->key() == Qt::Key_Backtab || key->key() == Qt::Key_Space)
      return false;
    keyPressEvent(key);
    return true;
  }
  if (type == QEvent::Resize || type == QEvent::LayoutRequest)
    QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      return end();
    case Qt::Key_Right:
    case Qt::Key_PageDown:
      return next();
    case Qt::Key_Left:
    case Qt::Key_PageUp:
      return back();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (auto* button = qobject_cast<QPushButton*>(QApplication::focusWidget()); button != nullptr)
        return button->click();
      return next();
    default:
      event->accept();
  }
}

/// Tab goes round the card, and never below it.
bool Tour::focusNextPrevChild(bool next) {
  std::vector<QPushButton*> buttons;
  for (QPushButton* each : {m_skip, m_back, m_next})
    if (each->isVisible() && each->isEnabled()) buttons.push_back(each);
  if (buttons.empty()) return true;
  const auto now = std::find(buttons.begin(), buttons.end(), QApplication::focusWidget());
  const auto size = static_cast<std::ptrdiff_t>(buttons.size());
  const std::ptrdiff_t at = now == buttons.end() ? -1 : now - buttons.begin();
  buttons[static_cast<std::size_t>((at + (next ? 1 : size - 1) + size) % size)]->setFocus(Qt::TabFocusReason);
  return true;
}

void Tour::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = themeOf(palette());
  QPainterPath dimmed;
  dimmed.addRect(rect());
  QPainterPath shown;
  for (const QRect& part : m_target) shown.addRoundedRect(part, kCorner, kCorner);
  painter.fillPath(dimmed.subtracted(shown), QColor(0, 0, 0, theme == Theme::light ? kDimLight : kDimDark));
  painter.setPen(QPen(qColor(ColorRole::accent, theme), 2));
  for (const QRect& part : m_target) painter.drawRoundedRect(part.adjusted(1, 1, -1, -1), kCorner, kCorner);
}

}  // namespace geargraph

#include "moc_tour.cpp"
