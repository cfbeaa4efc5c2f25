#include "ui/reading/derivation_view.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kMargin = 18;
constexpr int kWidestPage = 900;  // px at zoom 1: longer lines are hard to read
constexpr double kLightRoom = 4;
constexpr std::size_t kManyLines = 60;

QString textOf(const ReportWords& words) {
  QString text;
  for (const ReportSpan& span : words) {
    const QString part = QString::fromStdString(span.text);
    text += span.isFormula ? QLatin1Char('$') + part + QLatin1Char('$') : part;
  }
  return text;
}

struct BlockText {
  QString operator()(const ReportHeading& block) const { return QString::fromStdString(block.text); }
  QString operator()(const ReportParagraph& block) const { return textOf(block.words); }
  QString operator()(const ReportEquation& block) const { return QString::fromStdString(block.tex); }
  QString operator()(const ReportTable& block) const {
    QStringList head, rows;
    for (const std::string& cell : block.head) head += QString::fromStdString(cell);
    rows += head.join(QLatin1Char('\t'));
    for (const auto& row : block.rows) {
      QStringList cells;
      for (const ReportWords& cell : row) cells += textOf(cell);
      rows += cells.join(QLatin1Char('\t'));
    }
    return rows.join(QLatin1Char('\n'));
  }
  QString operator()(const ReportList& block) const {
    QStringList items;
    for (const ReportWords& item : block.items) items += textOf(item);
    return items.join(QLatin1Char('\n'));
  }
  QString operator()(const ReportFigure& /*block*/) const { return {}; }
  QString operator()(const ReportCurves& block) const { return QString::fromStdString(block.caption); }
};

}  // namespace

DerivationView::DerivationView(Selection* selection, QWidget* parent)
    : QAbstractScrollArea(parent), m_selection(selection) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // else the width would depend on the height
  viewport()->setMouseTracking(true);
  connect(selection, &Selection::hoverChanged, viewport(), QOverload<>::of(&QWidget::update));
  connect(selection, &Selection::selectionChanged, this, [this] {
    viewport()->update();
    showSelected();
  });
}

void DerivationView::setReport(const SetReportPtr& report) {
  show(report, nullptr);
}

void DerivationView::setDerivation(const Derivation& derivation) {
  show(derivation.report, &derivation);
}

void DerivationView::show(const SetReportPtr& report, const Derivation* derivation) {
  const Anchor before = anchor();
  m_report = report;
  m_headings.clear();
  if (report) {
    const auto& blocks = report->report().blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (std::holds_alternative<ReportHeading>(blocks[i])) m_headings.push_back(i);
    }
  }
  if (derivation == nullptr || derivation->layout != currentLayout()) return layOutAt(before);
  m_layout = derivation->layout;
  place(derivation->lines);
  returnTo(before);
}

void DerivationView::setZoom(double zoom) {
  const double within = std::clamp(zoom, kLeastZoom, kMaxZoom);
  if (within == m_zoom) return;
  const Anchor before = anchor();
  m_zoom = within;
  layOutAt(before);
}

DerivationView::Anchor DerivationView::anchor() const {
  const int heading = currentHeading();
  return {heading, verticalScrollBar()->value() - topOfHeading(heading)};
}

void DerivationView::layOutAt(const Anchor& anchor) {
  layOut();
  returnTo(anchor);
}

void DerivationView::returnTo(const Anchor& anchor) {
  const int heading = std::min(anchor.heading, std::max(0, static_cast<int>(m_headings.size()) - 1));
  verticalScrollBar()->setValue(topOfHeading(heading) + anchor.below);
  viewport()->update();
  m_heading = -1;
  scrollContentsBy(0, 0);
}

/// A long report takes as long as the rest of the window.
void DerivationView::layOutAnew() {
  if (m_lines.size() < kManyLines) return layOutAt(anchor());
  m_layOutTurn.request();
}

DerivationLayout DerivationView::currentLayout() const {
  const double room = std::min<double>(viewport()->width() - 2 * kMargin, scaledPixels(kWidestPage) * m_zoom);
  return {room, bodyPixels() * m_zoom, (bodyPixels() + 3) * m_zoom, font().toString()};
}

/// Once for a report, a width and a size; scrolling lays out nothing.
void DerivationView::layOut() {
  m_layout = currentLayout();
  if (!m_measure || m_measure->font() != font()) m_measure.emplace(font());
  place(m_report == nullptr ? std::vector<FlowLine>() : derivationLines(*m_report, m_layout, *m_measure));
}

void DerivationView::place(std::vector<FlowLine> lines) {
  m_lines = std::move(lines);
  m_tops.clear();
  m_width = m_layout.width;
  double y = kMargin;
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    y += i == 0 ? 0 : std::round(m_lines[i].above);
    m_tops.push_back(y);
    y += std::ceil(m_lines[i].height);
    for (const FlowFormula& formula : m_lines[i].formulas) {
      m_width = std::max(m_width, formula.x + formula.box->width * formula.size);
    }
  }
  m_tops.push_back(y);
  updateScrollBars();
}

void DerivationView::updateScrollBars() {
  const QSize room = viewport()->size();
  const double width = m_lines.empty() ? 0 : m_width + 2 * kMargin;
  const double height = m_lines.empty() ? 0 : m_tops.back() + kMargin;
  // What is longer than the view scrolls so far that its last section can come to the top.
  const int beyond = static_cast<int>(std::ceil(height)) - room.height();
  const int last = topOfHeading(static_cast<int>(m_headings.size()) - 1);
  verticalScrollBar()->setRange(0, beyond > 0 ? std::max(beyond, last) : 0);
  verticalScrollBar()->setPageStep(room.height());
  verticalScrollBar()->setSingleStep(static_cast<int>(3 * bodyPixels() * m_zoom));
  horizontalScrollBar()->setRange(0, std::max(0, static_cast<int>(std::ceil(width)) - room.width()));
  horizontalScrollBar()->setPageStep(room.width());
  horizontalScrollBar()->setSingleStep(bodyPixels());
}

int DerivationView::topOfHeading(int heading) const {
  if (heading <= 0 || heading >= static_cast<int>(m_headings.size())) return 0;
  const auto line = std::find_if(m_lines.begin(), m_lines.end(), [&](const FlowLine& each) {
    return each.block == m_headings[static_cast<std::size_t>(heading)];
  });
  if (line == m_lines.end()) return 0;
  return static_cast<int>(m_tops[static_cast<std::size_t>(line - m_lines.begin())]) - kMargin / 2;
}

int DerivationView::currentHeading() const {
  const int y = verticalScrollBar()->value() + kMargin;
  int current = 0;
  std::size_t heading = 0;
  for (std::size_t i = 0; i < m_lines.size() && m_tops[i] <= y; ++i) {
    while (heading < m_headings.size() && m_headings[heading] <= m_lines[i].block) {
      current = static_cast<int>(heading++);
    }
  }
  return current;
}

void DerivationView::showHeading(int heading) {
  verticalScrollBar()->setValue(topOfHeading(heading));
}

std::optional<std::size_t> DerivationView::lineAt(QPoint place) const {
  const double y = place.y() + verticalScrollBar()->value();
  const auto after = std::upper_bound(m_tops.begin(), m_tops.end(), y);
  if (m_lines.empty() || after == m_tops.begin() || after == m_tops.end()) return std::nullopt;
  return static_cast<std::size_t>(after - m_tops.begin()) - 1;
}

std::optional<ElementId> DerivationView::elementAt(QPoint place) const {
  const auto line = lineAt(place);
  return line ? m_lines[*line].element : std::nullopt;
}

bool DerivationView::isEquationAt(QPoint place) const {
  const auto line = lineAt(place);
  return line && std::holds_alternative<ReportEquation>(m_report->report().blocks[m_lines[*line].block]);
}

QString DerivationView::textAt(QPoint place) const {
  const auto line = lineAt(place);
  return line ? std::visit(BlockText{}, m_report->report().blocks[m_lines[*line].block]) : QString();
}

QRect DerivationView::equationPlace(int number) const {
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    const auto* equation = std::get_if<ReportEquation>(&m_report->report().blocks[m_lines[i].block]);
    if (equation == nullptr || equation->number != number || equation->isDual) continue;
    return {0, static_cast<int>(m_tops[i]) - verticalScrollBar()->value(), viewport()->width(),
            static_cast<int>(m_lines[i].height)};
  }
  return {};
}

void DerivationView::paintEvent(QPaintEvent* event) {
  QPainter painter(viewport());
  const Theme theme = themeOf(palette());
  painter.fillRect(event->rect(), qColor(ColorRole::sheet, theme));
  if (m_lines.empty()) return;
  const QPointF origin(kMargin - horizontalScrollBar()->value(), -verticalScrollBar()->value());
  // A line's number may stand a little below it.
  const double from = event->rect().top() - origin.y() - 40, to = event->rect().bottom() - origin.y();
  const auto after =
      static_cast<std::size_t>(std::lower_bound(m_tops.begin(), m_tops.end(), from) - m_tops.begin());
  const std::size_t first = after > 0 ? after - 1 : 0;
  for (std::size_t i = first; i < m_lines.size() && m_tops[i] <= to; ++i) paintLight(painter, i, origin);
  const FlowPainter::Colors colors{qColor(ColorRole::ink, theme), qColor(ColorRole::secondary, theme),
                                   qColor(ColorRole::hairline, theme), theme};
  for (std::size_t i = first; i < m_lines.size() && m_tops[i] <= to; ++i) {
    m_painter.paint(painter, m_lines[i], origin + QPointF(0, m_tops[i]), font(), colors);
  }
}

/// Behind the equations of what is pointed at: a band; of what is selected with a bar, too.
void DerivationView::paintLight(QPainter& painter, std::size_t line, QPointF origin) {
  const auto& element = m_lines[line].element;
  if (!element || (!m_selection->isHovered(*element) && !m_selection->isSelected(*element))) return;
  const Theme theme = themeOf(palette());
  // The lines of one equation have one band.
  const auto goesOn = [&](std::size_t next) {
    return next < m_lines.size() && m_lines[next].element == element &&
           m_lines[next].block == m_lines[line].block;
  };
  const double top = m_tops[line] - (line > 0 && goesOn(line - 1) ? 0 : kLightRoom);
  const double end = goesOn(line + 1) ? m_tops[line + 1] : m_tops[line] + m_lines[line].height + kLightRoom;
  const QRectF area(kMargin / 2.0, origin.y() + top, viewport()->width() - kMargin, end - top);
  QColor light = qColor(ColorRole::halo, theme);
  light.setAlphaF(0.45F);
  painter.fillRect(area, light);
  if (m_selection->isSelected(*element)) {
    painter.fillRect(QRectF(area.left(), area.top(), 3, area.height()), qColor(ColorRole::accent, theme));
  }
}

void DerivationView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  currentLayout() != m_layout ? layOutAnew() : updateScrollBars();
}

void DerivationView::wheelEvent(QWheelEvent* event) {
  if ((event->modifiers() & Qt::ControlModifier) == 0) return QAbstractScrollArea::wheelEvent(event);
  setZoom(m_zoom * std::pow(1.1, event->angleDelta().y() / 120.0));
  event->accept();
}

void DerivationView::hover(const std::optional<ElementId>& element) {
  viewport()->setCursor(element ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (element) {
    m_selection->hover(*element);
  } else if (m_hovers) {
    m_selection->unhover();
  }
  m_hovers = element.has_value();
}

void DerivationView::showSelected() {
  const int from = verticalScrollBar()->value(), room = viewport()->height();
  int nearest = -1, leastWay = 0;
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    if (!m_lines[i].element || !m_selection->isSelected(*m_lines[i].element)) continue;
    const int top = static_cast<int>(m_tops[i]), end = static_cast<int>(m_tops[i] + m_lines[i].height);
    const int way = std::max({0, from - end, top - (from + room)});
    if (nearest < 0 || way < leastWay) {
      nearest = top;
      leastWay = way;
    }
  }
  if (leastWay > 0) verticalScrollBar()->setValue(nearest - room / 3);
}

void DerivationView::mouseMoveEvent(QMouseEvent* event) {
  hover(elementAt(event->position().toPoint()));
}

void DerivationView::mousePressEvent(QMouseEvent* event) {
  const auto element = elementAt(event->position().toPoint());
  if (event->button() != Qt::LeftButton || !element) return;
  if ((event->modifiers() & (Qt::ControlModifier | Qt::ShiftModifier)) != 0) {
    m_selection->toggle(*element);
  } else {
    m_selection->select({*element});
  }
}

void DerivationView::contextMenuEvent(QContextMenuEvent* event) {
  if (m_report == nullptr) return;
  const QPoint place = viewport()->mapFromGlobal(event->globalPos());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& words, const QString& text) {
    QAction* action = menu->addAction(words, [text] { QApplication::clipboard()->setText(text); });
    action->setEnabled(!text.isEmpty());
  };
  add(isEquationAt(place) ? tr("Copy equation as LaTeX") : tr("Copy text"), textAt(place));
  add(tr("Copy all as LaTeX"), QString::fromStdString(reportLatex(m_report->report())));
  add(tr("Copy all as Markdown"), QString::fromStdString(reportMarkdown(m_report->report())));
  menu->popup(event->globalPos());
}

bool DerivationView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::Leave) hover(std::nullopt);
  return QAbstractScrollArea::viewportEvent(event);
}

void DerivationView::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  const bool mayBeOther = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (mayBeOther && currentLayout() != m_layout) layOutAnew();
  if (event->type() == QEvent::PaletteChange) viewport()->update();
}

void DerivationView::scrollContentsBy(int dx, int dy) {
  if (dx != 0 || dy != 0) viewport()->scroll(dx, dy);
  if (const int heading = currentHeading(); heading != m_heading) {
    m_heading = heading;
    emit headingChanged(heading);
  }
}

}  // namespace geargraph

#include "moc_derivation_view.cpp"
