#include "ui/reading/printed_pages.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

// In points.
constexpr double kSide = 56, kHead = 56, kFoot = 62;
constexpr double kSize = 10, kSmall = 8.5, kTitle = 12;
constexpr double kTitleRoom = 30;  // above a drawing
constexpr double kPoints = 0.75;   // a pixel of a drawing
/// Lines are laid out in dots, whole numbers of which fit glyphs and rules on any paper.
constexpr double kDots = 600.0 / 72;  // a point

const QColor kInk(0, 0, 0), kSoft(85, 93, 102), kHairline(200, 206, 212);

QString tr(const char* text) {
  return QCoreApplication::translate("PrintedPages", text);
}

QFont sized(QFont font, double pixels) {
  font.setPixelSize(std::max(1, qRound(pixels)));
  font.setBold(false);
  return font;
}

}  // namespace

PrintedPages::PrintedPages(QString title, const std::vector<PrintedDrawing>& drawings,
                           std::shared_ptr<const SetReport> report, QSizeF paper, const QFont& font,
                           const std::stop_token& stop)
    : m_title(std::move(title)), m_report(std::move(report)), m_paper(paper), m_font(font) {
  for (const PrintedDrawing& drawing : drawings) {
    if (stop.stop_requested()) return;
    m_drawings.push_back({drawing.title, drawing.draw()});
  }
  if (!m_report || stop.stop_requested()) return;
  const double body = (paper.height() - kHead - kFoot) * kDots;
  FlowParameters flow;
  flow.width = (paper.width() - 2 * kSide) * kDots;
  flow.size = flow.formulaSize = kSize * kDots;
  flow.tallest = body - 3 * flow.size;
  flow.curvesScale = kPoints * kDots;
  const FontMeasure measure(font);
  m_lines = titleLines(*m_report, flow, measure);
  for (FlowLine& line : m_report->lines(flow, measure)) m_lines.push_back(std::move(line));
  m_flow = flowPages(m_lines, body);
}

QString PrintedPages::describe(int page) const {
  const auto at = static_cast<std::size_t>(page);
  return at < m_drawings.size() ? m_drawings[at].title : tr("Derivation");
}

void PrintedPages::paint(QPainter& painter, int page, double scale, FlowPainter& flow) const {
  const auto at = static_cast<std::size_t>(page);
  if (at < m_drawings.size()) {
    paintDrawing(painter, m_drawings[at], scale);
  } else {
    paintFlow(painter, m_flow[at - m_drawings.size()], scale, flow);
  }
  painter.setPen(kSoft);
  painter.setFont(sized(m_font, kSmall * scale));
  painter.drawText(QRectF(0, (m_paper.height() - kFoot) * scale, m_paper.width() * scale, kFoot * scale),
                   Qt::AlignCenter, QStringLiteral("%1 / %2").arg(page + 1).arg(count()));
}

void PrintedPages::paintDrawing(QPainter& painter, const Drawn& drawing, double scale) const {
  const QRectF body = QRectF(kSide, kHead, m_paper.width() - 2 * kSide, m_paper.height() - kHead - kFoot);
  painter.setPen(kInk);
  painter.setFont(sized(m_font, kTitle * scale));
  const QString title =
      m_title.isEmpty() ? drawing.title : QStringLiteral("%1: %2").arg(m_title, drawing.title);
  painter.drawText(QRectF(body.topLeft() * scale, QSizeF(body.width(), kTitleRoom) * scale),
                   Qt::AlignLeft | Qt::AlignTop, title);
  const QRectF room = body.adjusted(0, kTitleRoom, 0, 0);
  const QRectF sheet = toQRect(extentOf(drawing.list));
  if (sheet.isEmpty()) return;
  const double fitted = std::min({kPoints, room.width() / sheet.width(), room.height() / sheet.height()});
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.translate(room.center() * scale);
  painter.scale(fitted * scale, fitted * scale);
  painter.translate(-sheet.center());
  paintMarks(painter, drawing.list.marks, Theme::light, fitted * scale);
  painter.restore();
}

void PrintedPages::paintFlow(QPainter& painter, const FlowPage& page, double scale, FlowPainter& flow) const {
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.scale(scale / kDots, scale / kDots);
  for (const auto& [line, top] : page.lines) {
    flow.paint(painter, m_lines[line], QPointF(kSide, kHead) * kDots + QPointF(0, top), m_font,
               {kInk, kSoft, kHairline}, kDots / 2);
  }
  painter.restore();
}

}  // namespace geargraph
