#pragma once

#include <QFont>
#include <QPointF>
#include <QString>

class QPainter;

namespace geargraph {

/// Paints a formula in the gear ratios, "-i18*i17/(i15 + 1)", typeset: italic i with its label as a
/// subscript, products without a sign, a Unicode minus sign. The glyphs of the last formulas are kept, and
/// only those left of the painter's clip are painted.
///
/// @param painter null: only measures
/// @param at the start of the baseline
/// @return the advance in pixels
double paintRatios(QPainter* painter, const QFont& font, const QPointF& at, const QString& formula);

}  // namespace geargraph
