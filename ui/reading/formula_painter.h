#pragma once

#include <QColor>
#include <QPainter>
#include <QRawFont>
#include <map>

#include "core/presentation/typeset/formula_box.h"

namespace geargraph {

/// Paints typeset formulas in their fonts.
class FormulaPainter {
 public:
  struct Colors {
    QColor ink;
    QColor label;
  };

  /// Paints a box with the left end of its baseline at `origin` and an em of `size` pixels.
  void paint(QPainter& painter, const FormulaBox& box, QPointF origin, double size, const Colors& colors);

 private:
  const QRawFont& fontOf(FontFace face, double pixels);

  std::map<std::pair<FontFace, int>, QRawFont> m_fonts;  ///< by face and hundredths of a pixel
};

}  // namespace geargraph
