#pragma once

#include <QFont>
#include <QFontMetricsF>
#include <map>
#include <string>

#include "core/presentation/pages/flow.h"
#include "ui/derivation/formula_painter.h"

namespace geargraph::inline ui_derivation {

/// Words as QPainter shows them in a font. Remembers the words it has measured: a report says the same words
/// again and again, and its next version does, too.
class FontMeasure : public WordMeasure {
 public:
  explicit FontMeasure(const QFont& base) : m_base(base) {}
  [[nodiscard]] double widthOf(std::string_view utf8, const WordLook& look) const override;
  [[nodiscard]] const QFont& font() const { return m_base; }

 private:
  /// Of one size and weight.
  struct Words {
    QFontMetricsF metrics;
    std::map<std::string, double, std::less<>> widths;
  };

  QFont m_base;
  mutable std::map<std::pair<long, bool>, Words> m_words;
};

/// Paints the strips of a report, on the screen and on pages. Use it on the thread that made it.
class FlowPainter {
 public:
  struct Colors {
    QColor ink;
    QColor soft;
    QColor hairline;
    Theme theme = Theme::light;  ///< of curves
  };

  /// The strip with its upper left corner at `origin`; words in `base`, as FontMeasure has measured them.
  /// Rules are `hair` thick.
  void paint(QPainter& painter, const FlowLine& line, QPointF origin, const QFont& base, const Colors& colors,
             double hair = 1);

 private:
  FormulaPainter m_formulas;
};

}  // namespace geargraph::inline ui_derivation
