#include "ui/models/diagnostic_model.h"

#include <QRegularExpression>
#include <algorithm>

#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

/// The numbers in it with Unicode minus signs, which command line and files write as hyphens.
QString messageOf(const Diagnostic& diagnostic) {
  static const QRegularExpression kMinus(QStringLiteral("(?<![\\p{L}\\p{N}_.,-])-(?=\\p{N})"));
  return shownText(diagnostic.message).replace(kMinus, QStringLiteral("−"));
}

QString placeOf(const Diagnostic& diagnostic) {
  QString place;
  if (diagnostic.line > 0) {
    place = DiagnosticModel::tr("line %1, column %2").arg(diagnostic.line).arg(diagnostic.column);
  }
  if (!diagnostic.pointer.empty()) {
    if (!place.isEmpty()) place += QStringLiteral(" · ");
    place += shownText(diagnostic.pointer);
  }
  return place;
}

/// Not connected yet: nothing is wrong with what is being drawn.
bool isUnfinished(const Diagnostic& diagnostic) {
  return diagnostic.code == Code::disconnected;
}

Severity shownSeverity(const Diagnostic& diagnostic) {
  return isUnfinished(diagnostic) ? Severity::info : diagnostic.severity();
}

}  // namespace

void DiagnosticModel::setDiagnostics(Diagnostics diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.severity() < b.severity(); });
  if (diagnostics == m_diagnostics) return;
  beginResetModel();
  m_diagnostics = std::move(diagnostics);
  endResetModel();
}

std::set<ElementId> DiagnosticModel::elementsOf(const QModelIndex& index) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const auto& elements = m_diagnostics[static_cast<std::size_t>(index.row())].elements;
  return {elements.begin(), elements.end()};
}

int DiagnosticModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_diagnostics.size());
}

QVariant DiagnosticModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const Diagnostic& diagnostic = m_diagnostics[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return messageOf(diagnostic);
    case Qt::AccessibleTextRole:
      return shownText(severityName(shownSeverity(diagnostic))) + QStringLiteral(": ") +
             messageOf(diagnostic);
    case Qt::ToolTipRole:
      return tr("Code: %1").arg(shownText(codeName(diagnostic.code)));
    case SeverityRole:
      return static_cast<int>(shownSeverity(diagnostic));
    case UnfinishedRole:
      return isUnfinished(diagnostic);
    case CodeRole:
      return shownText(codeName(diagnostic.code));
    case PlaceRole:
      return placeOf(diagnostic);
    default:
      return {};
  }
}

}  // namespace geargraph

#include "moc_diagnostic_model.cpp"
