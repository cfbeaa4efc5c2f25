#include "ui/models/term_tips.h"

#include <QCoreApplication>

#include "core/foundations/base/translation.h"

namespace geargraph {

QString shownText(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString tipOf(Term term) {
  const Definition& definition = definitionOf(term);
  QString head = shownText(translated(definition.name)).toHtmlEscaped();
  if (!definition.symbol.empty()) head += QStringLiteral(" ") + shownText(definition.symbol).toHtmlEscaped();
  QString tip = QStringLiteral("<p style='white-space:normal'><b>%1</b><br>%2")
                    .arg(head, shownText(translated(definition.text)).toHtmlEscaped());
  if (definition.equation != PaperEquation::none) {
    tip += QCoreApplication::translate("geargraph::tipOf", " Eq. (%1)").arg(numberOf(definition.equation));
  }
  return tip + QStringLiteral("</p>");
}

}  // namespace geargraph
