#pragma once

#include <QFont>
#include <QPointF>
#include <QString>

class QPainter;

namespace geargraph::inline panels {

/// A formula in the gear ratios, "-i18*i17/(i15 + 1)", as print sets it: italic i with its label lowered,
/// products side by side, the minus sign of print.
///
/// @return the advance in pixels; without a painter nothing is drawn. `at`: where the base line begins.
double paintRatios(QPainter* painter, const QFont& font, const QPointF& at, const QString& formula);

}  // namespace geargraph::inline panels
