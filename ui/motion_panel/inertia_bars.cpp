#include "ui/motion_panel/inertia_bars.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/models/printed_number.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr double kLeft = 76, kRight = 124;  // logical pixels, for titles and sums at least
constexpr double kGap = 1;

QString printed(double inertia) {
  return printedNumber(inertia, 4);
}

}  // namespace

InertiaBars::InertiaBars(Selection* selection, QWidget* parent) : QWidget(parent), m_selection(selection) {
  measure();
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Inertia at the motors"));
  connect(selection, &Selection::selectionChanged, this, qOverload<>(&QWidget::update));
  connect(selection, &Selection::hoverChanged, this, qOverload<>(&QWidget::update));
}

QString InertiaBars::sumOf(const Bar& bar) {
  return bar.parts.empty() ? tr("moves no mass") : tr("%1 kg m²").arg(printed(bar.inertia));
}

/// The longest title and sum decide where the bars begin and end.
void InertiaBars::measure() {
  m_left = kLeft;
  m_right = kRight;
  const QFontMetricsF metrics(font());
  for (const Bar& bar : m_bars) {
    m_left = std::max(m_left, metrics.horizontalAdvance(bar.title) + 22);
    m_right = std::max(m_right, metrics.horizontalAdvance(sumOf(bar)) + 22);
  }
}

void InertiaBars::show(const DynamicsPtr& dynamics) {
  m_bars.clear();
  if (dynamics && dynamics->train) {
    const Mechanism& mechanism = *dynamics->snapshot->mechanism;
    const Eigen::MatrixXd& reflected = dynamics->state.reflected;
    for (Eigen::Index input = 0; input < reflected.cols(); ++input) {
      const int joint = dynamics->train->inputs[static_cast<std::size_t>(input)];
      Bar bar;
      bar.joint = mechanism.turningJoints[static_cast<std::size_t>(joint)].id;
      bar.title = tr("joint %1").arg(mechanism.jointLabel(joint));
      bar.inertia = reflected.col(input).sum();
      double before = 0;
      for (Eigen::Index link = 1; link < reflected.rows(); ++link) {
        const double inertia = reflected(link, input);
        if (!(inertia > 0)) continue;
        const double share = inertia / bar.inertia;
        bar.parts.push_back({mechanism.links[static_cast<std::size_t>(link)].id,
                             mechanism.linkLabel(static_cast<int>(link)),
                             mechanism.colorNumber(static_cast<int>(link)), inertia, before, share});
        before += share;
      }
      m_bars.push_back(std::move(bar));
    }
  }
  QStringList words;
  for (std::size_t bar = 0; bar < m_bars.size(); ++bar)
    for (std::size_t part = 0; part < m_bars[bar].parts.size(); ++part) words += tipOf(bar, part);
  setAccessibleDescription(words.join(QLatin1Char(' ')));
  measure();
  updateGeometry();
  update();
}

int InertiaBars::rowHeight() const {
  return fontMetrics().height() + 16;
}

QSize InertiaBars::sizeHint() const {
  return {480, rowHeight() * static_cast<int>(std::max<std::size_t>(m_bars.size(), 1)) + 8};
}

QSize InertiaBars::minimumSizeHint() const {
  return {static_cast<int>(m_left + m_right) + 80, sizeHint().height()};
}

QRectF InertiaBars::barAt(std::size_t bar) const {
  const double height = rowHeight();
  return {m_left, 4 + height * static_cast<double>(bar) + 3, width() - m_left - m_right, height - 6};
}

QRectF InertiaBars::placeOf(std::size_t bar, std::size_t part) const {
  const QRectF whole = barAt(bar);
  const Part& shown = m_bars[bar].parts[part];
  return {whole.left() + shown.before * whole.width(), whole.top(), shown.share * whole.width(),
          whole.height()};
}

QString InertiaBars::tipOf(std::size_t bar, std::size_t part) const {
  const Part& shown = m_bars[bar].parts[part];
  return tr("Link %1: %2 kg m² at %3, %4 % of all.")
      .arg(shown.label)
      .arg(printed(shown.inertia), m_bars[bar].title)
      .arg(printedNumber(100 * shown.share, 1, 'f'));
}

std::optional<InertiaBars::Place> InertiaBars::placeAt(const QPointF& at) const {
  for (std::size_t bar = 0; bar < m_bars.size(); ++bar)
    for (std::size_t part = 0; part < m_bars[bar].parts.size(); ++part)
      if (placeOf(bar, part).contains(at)) return Place{bar, part};
  return std::nullopt;
}

void InertiaBars::paintPart(QPainter& painter, std::size_t bar, std::size_t part) const {
  const Part& shown = m_bars[bar].parts[part];
  const Theme theme = themeOf(palette());
  const QRectF room = placeOf(bar, part).adjusted(0, 0, -kGap, 0);
  const QColor colour = qColor(linkColor(shown.color));
  painter.fillRect(room.width() < 1 ? QRectF(room.topLeft(), QSizeF(1, room.height())) : room, colour);
  if (m_selection->isSelected(shown.link) || m_selection->isHovered(shown.link)) {
    const bool isSelected = m_selection->isSelected(shown.link);
    painter.setPen(QPen(qColor(isSelected ? ColorRole::accent : ColorRole::halo, theme), 3));
    painter.drawRect(room.adjusted(1.5, 1.5, -1.5, -1.5));
  }
  const QString name = QString::number(shown.label);
  const QString whole = tr("link %1").arg(shown.label);
  const double free = room.width() - 8;
  const QFontMetrics metrics = painter.fontMetrics();
  const QString text = metrics.horizontalAdvance(whole) <= free  ? whole
                       : metrics.horizontalAdvance(name) <= free ? name
                                                                 : QString();
  painter.setPen(colour.lightnessF() > 0.5 || colour.green() > 140 ? Qt::black : Qt::white);
  painter.drawText(room, Qt::AlignCenter, text);
}

void InertiaBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = themeOf(palette());
  for (std::size_t bar = 0; bar < m_bars.size(); ++bar) {
    const Bar& shown = m_bars[bar];
    const QRectF room = barAt(bar);
    painter.setPen(qColor(ColorRole::ink, theme));
    painter.drawText(QRectF(12, room.top(), m_left - 16, room.height()), Qt::AlignVCenter, shown.title);
    painter.drawText(QRectF(room.right() + 8, room.top(), m_right - 12, room.height()), Qt::AlignVCenter,
                     sumOf(shown));
    for (std::size_t part = 0; part < shown.parts.size(); ++part) paintPart(painter, bar, part);
    if (!shown.parts.empty()) continue;
    painter.setPen(qColor(ColorRole::hairline, theme));
    painter.drawRect(room);
  }
}

bool InertiaBars::event(QEvent* event) {
  if (event->type() == QEvent::FontChange) measure();
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto place = placeAt(help->pos());
  const QString meaning =
      tr("The inertia that each link has at the motor while the other inputs stand still: for a link that "
         "turns about one axis its moment of inertia times the square of its ratio.");
  QToolTip::showText(help->globalPos(), place ? tipOf(place->bar, place->part) : meaning, this);
  return true;
}

void InertiaBars::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  const auto place = placeAt(event->position());
  place ? m_selection->select({m_bars[place->bar].parts[place->part].link}) : m_selection->clear();
}

void InertiaBars::mouseMoveEvent(QMouseEvent* event) {
  const auto place = placeAt(event->position());
  place ? m_selection->hover(m_bars[place->bar].parts[place->part].link) : m_selection->unhover();
}

void InertiaBars::leaveEvent(QEvent*) {
  m_selection->unhover();
}

/// Left and right go through the parts of the first bar that has any.
void InertiaBars::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  const auto bar =
      std::find_if(m_bars.begin(), m_bars.end(), [](const Bar& each) { return !each.parts.empty(); });
  if (step == 0 || bar == m_bars.end()) return QWidget::keyPressEvent(event);
  const auto selected = std::find_if(bar->parts.begin(), bar->parts.end(),
                                     [this](const Part& each) { return m_selection->isSelected(each.link); });
  const auto count = static_cast<int>(bar->parts.size());
  const int at = selected == bar->parts.end() ? (step > 0 ? -1 : count)
                                              : static_cast<int>(selected - bar->parts.begin());
  m_selection->select({bar->parts[static_cast<std::size_t>((at + step + count) % count)].link});
}

}  // namespace geargraph

#include "moc_inertia_bars.cpp"
