#pragma once

#include <QFont>
#include <QSizeF>
#include <QString>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/page_layout/page_break.h"
#include "ui/reading/flow_painter.h"

namespace geargraph {

/// A drawing printed on a page of its own.
struct PrintedDrawing {
  QString title;
  std::function<DisplayList()> draw;  ///< may be called on any thread
};

/// The pages of a printed document: drawings fitted to their pages but not larger than on the screen, then
/// the derivation with its matrices. Black on white in any theme. Immutable; may be created on any thread.
class PrintedPages {
 public:
  /// @param paper size of a page, in points
  /// @param report null: no derivation
  /// Cost: the drawings', and linear in the report. The result is meaningless if `stop` was requested
  /// meanwhile.
  PrintedPages(QString title, const std::vector<PrintedDrawing>& drawings,
               std::shared_ptr<const SetReport> report, QSizeF paper, const QFont& font,
               const std::stop_token& stop = {});

  [[nodiscard]] int count() const { return static_cast<int>(m_drawings.size() + m_flow.size()); }
  [[nodiscard]] const QString& title() const { return m_title; }
  [[nodiscard]] QSizeF paper() const { return m_paper; }
  /// A short description of a page for screen readers.
  [[nodiscard]] QString describe(int page) const;

  /// Paints a page with its upper left corner at the origin, `scale` pixels per point, without the paper.
  /// @pre 0 <= page < count()
  void paint(QPainter& painter, int page, double scale, FlowPainter& flow) const;

 private:
  struct Drawn {
    QString title;
    DisplayList list;
  };

  void paintDrawing(QPainter& painter, const Drawn& drawing, double scale) const;
  void paintFlow(QPainter& painter, const FlowPage& page, double scale, FlowPainter& flow) const;

  QString m_title;
  std::vector<Drawn> m_drawings;
  std::shared_ptr<const SetReport> m_report;
  QSizeF m_paper;
  QFont m_font;
  std::vector<FlowLine> m_lines;
  std::vector<FlowPage> m_flow;
};

using PrintedPagesPtr = std::shared_ptr<const PrintedPages>;

}  // namespace geargraph
