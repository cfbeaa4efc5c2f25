#pragma once

#include <QFont>
#include <QFontMetricsF>
#include <map>
#include <string>

#include "core/presentation/page_layout/flow.h"
#include "ui/reading/formula_painter.h"

namespace geargraph {

/// Measures words as painted by QPainter in a font. Caches the widths, because words are repeated within a
/// report and in its next version.
class FontMeasure : public WordMeasure {
 public:
  explicit FontMeasure(const QFont& base) : m_base(base) {}
  [[nodiscard]] double widthOf(std::string_view utf8, const TextStyle& style) const override;
  [[nodiscard]] const QFont& font() const { return m_base; }

 private:
  /// The cache for one size and weight.
  struct Words {
    QFontMetricsF metrics;
    std::map<std::string, double, std::less<>> widths;
  };

  QFont m_base;
  mutable std::map<std::pair<long, bool>, Words> m_words;
};

/// Paints the strips of a report, on screen and on pages. To be used on the thread that made it.
class FlowPainter {
 public:
  struct Colors {
    QColor ink;
    QColor soft;
    QColor hairline;
    Theme theme = Theme::light;  ///< of curves
  };

  /// Paints a strip with its upper left corner at `origin`; words in the font `base`, as measured by
  /// FontMeasure. `hair`: thickness of rules.
  void paint(QPainter& painter, const FlowLine& line, QPointF origin, const QFont& base, const Colors& colors,
             double hair = 1);

 private:
  FormulaPainter m_formulas;
};

}  // namespace geargraph
