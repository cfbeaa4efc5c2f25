#include "ui/models/matrix_model.h"

#include <algorithm>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

QString shownText(const std::string& text) {
  return QString::fromStdString(text);
}

/// The same rows and columns, in the same order, under the same labels.
bool sameHeadings(const IntegerMatrix& a, const IntegerMatrix& b) {
  if (a.kind() != b.kind() || a.rows() != b.rows() || a.columns() != b.columns()) return false;
  for (int i = 0; i < a.rows(); ++i) {
    const Heading before = a.rowHeading(i);
    const Heading after = b.rowHeading(i);
    if (before.element != after.element || before.label != after.label) return false;
  }
  for (int j = 0; j < a.columns(); ++j) {
    const Heading before = a.columnHeading(j);
    const Heading after = b.columnHeading(j);
    if (before.element != after.element || before.label != after.label) return false;
  }
  return true;
}

/// Have both the same links, joints and meshes between them? Then all their matrices are equal.
bool sameGraph(const Digraph& a, const Digraph& b) {
  if (a.n() != b.n() || a.t() != b.t() || a.c() != b.c()) return false;
  for (int node = 0; node < a.nodeCount(); ++node) {
    if (a.nodeId(node) != b.nodeId(node)) return false;
  }
  for (int edge = 0; edge < a.edgeCount(); ++edge) {
    const auto [tail, head] = a.edge(edge);
    if (tail != b.edge(edge).tail || head != b.edge(edge).head || a.edgeId(edge) != b.edgeId(edge))
      return false;
  }
  return true;
}

}  // namespace

MatrixModel::MatrixModel(QObject* parent) : QAbstractTableModel(parent) {
  m_glow.setSingleShot(true);
  m_glow.setInterval(kGlowMilliseconds);
  connect(&m_glow, &QTimer::timeout, this, [this] {
    m_before.reset();
    if (rowCount() > 0 && columnCount() > 0) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1), {ChangedRole});
    }
  });
}

void MatrixModel::setResult(const NamedResult& result) {
  if (m_result == &result) return;
  m_result = &result;
  show(false);
}

void MatrixModel::setWantedForm(EntryForm form) {
  if (m_form == form) return;
  m_form = form;
  if (!m_result->isWhole) show(false);
}

void MatrixModel::setSnapshot(const SnapshotPtr& snapshot) {
  const bool same =
      m_snapshot && snapshot && !m_preview && m_matrix && sameGraph(*m_snapshot->graph, *snapshot->graph);
  m_snapshot = snapshot;
  m_preview.reset();  // what was drawn is in the snapshot now, or was given up
  const ResultTablePtr next = same ? tableOf(snapshot) : nullptr;
  if (!next) return show(true);
  m_table = next;  // a drag of teeth leaves the entries alone
  m_matrix = m_table->integers();
}

void MatrixModel::setPreview(std::optional<PreviewSnapshot> preview) {
  if (!preview && !m_preview) return;
  m_preview = std::move(preview);
  if (m_result->of == ResultOf::graph) show(false);
}

ResultTablePtr MatrixModel::tableOf(const SnapshotPtr& snapshot) const {
  if (!snapshot) return nullptr;
  const ResultSource source{snapshot};
  const std::vector<EntryForm> forms = m_result->forms(source);
  if (forms.empty()) return nullptr;
  const bool isThere = std::find(forms.begin(), forms.end(), m_form) != forms.end();
  return resultTable(*m_result, source, isThere ? m_form : forms.back());
}

/// What is not of the graph alone needs the mechanism as it is, not as it would be: the preview lacks it.
void MatrixModel::show(bool glow) {
  ResultTablePtr next = m_preview ? tableOf(m_preview->snapshot) : nullptr;
  if (!next) next = tableOf(m_snapshot);
  const IntegerMatrixPtr matrix = next ? next->integers() : nullptr;
  const IntegerMatrixPtr before = m_matrix;
  // Is it the exact part of an analysis whose matrices are shown already?
  if (matrix && matrix == before && &m_table->result() == m_result) return;
  m_rowsBefore.clear();
  m_columnsBefore.clear();
  m_before = glow && before && matrix && before->kind() == matrix->kind() ? before : nullptr;
  if (m_before) {
    for (int i = 0; i < before->rows(); ++i) m_rowsBefore.emplace(before->rowHeading(i).element, i);
    for (int j = 0; j < before->columns(); ++j) m_columnsBefore.emplace(before->columnHeading(j).element, j);
    m_glow.start();
  }
  const auto put = [&] {
    m_table = next;
    m_matrix = matrix;
    m_rowAsked = -1;
  };
  if (before && matrix && sameHeadings(*before, *matrix)) {
    put();
    if (rowCount() > 0 && columnCount() > 0) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
  } else {
    beginResetModel();
    put();
    endResetModel();
  }
  emit matrixChanged();
}

std::set<ElementId> MatrixModel::elementsOfRow(int row) const {
  return m_table->elementsOfRow(row);
}

std::set<ElementId> MatrixModel::elementsOfCell(int row, int column) const {
  return m_table->elementsOfCell(row, column);
}

CellExplanation MatrixModel::explanation(const QModelIndex& index) const {
  return m_table->explanation(index.row(), index.column());
}

int MatrixModel::partition() const {
  return m_table ? m_table->partition().value_or(-1) : -1;
}

int MatrixModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !isThere() ? 0 : m_table->rows();
}

int MatrixModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !isThere() ? 0 : m_table->columns();
}

QVariant MatrixModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const int row = index.row();
  const int column = index.column();
  if (!m_matrix) return entryData(row, column, role);
  switch (role) {
    case Qt::DisplayRole:
      return shownText(printedEntry(m_matrix->entry(row, column)));
    case Qt::TextAlignmentRole:
      return int(Qt::AlignCenter);
    case Qt::AccessibleTextRole:
      return shownText(explanation(index).title);
    case ValueRole:
      return m_matrix->entry(row, column);
    case ChangedRole:
      return hasChanged(row, column);
    case PreviewRole:
      return isPreview(row, column);
    default:
      return {};
  }
}

QVariant MatrixModel::entryData(int row, int column, int role) const {
  if (m_rowAsked != row) {
    m_rowEntries = m_table->row(row);
    m_rowAsked = row;
  }
  const auto entry = std::find_if(m_rowEntries.begin(), m_rowEntries.end(),
                                  [column](const ResultEntry& e) { return e.column == column; });
  const bool zero = entry == m_rowEntries.end();
  const bool formula = !zero && entry->isFormula;
  switch (role) {
    case Qt::DisplayRole:
      if (zero) return QStringLiteral("0");
      if (formula) return shownText(entry->text);
      if (isLongFraction(entry->text)) return printedNumber(entry->value);
      return withPrintedMinus(shownText(localizedNumber(entry->text)));
    case Qt::TextAlignmentRole:
      return int(Qt::AlignCenter);
    case Qt::AccessibleTextRole:
      return shownText(m_table->explanation(row, column).title);
    case ValueRole:
      return zero ? 0 : (entry->value > 0 ? 1 : -1);
    case FormulaRole:
      return formula;
    default:
      return {};
  }
}

QVariant MatrixModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const bool across = orientation == Qt::Horizontal;
  if (!isThere() || section < 0 || section >= (across ? columnCount() : rowCount())) return {};
  const Heading heading = across ? columnHeading(section) : rowHeading(section);
  switch (role) {
    case Qt::DisplayRole:
      return shownText(heading.text);
    case PreviewRole:
      return m_matrix && m_preview && heading.element == m_preview->drawnJoint;
    case RateRole:
      return m_table->headsAreRates();
    default:
      return {};
  }
}

bool MatrixModel::isPreview(int row, int column) const {
  return m_preview &&
         (rowElement(row) == m_preview->drawnJoint || columnElement(column) == m_preview->drawnJoint);
}

bool MatrixModel::hasChanged(int row, int column) const {
  if (!m_before) return false;
  const auto rowBefore = m_rowsBefore.find(rowElement(row));
  const auto columnBefore = m_columnsBefore.find(columnElement(column));
  const int now = m_matrix->entry(row, column);
  if (rowBefore == m_rowsBefore.end() || columnBefore == m_columnsBefore.end()) return now != 0;
  return m_before->entry(rowBefore->second, columnBefore->second) != now;
}

}  // namespace geargraph

#include "moc_matrix_model.cpp"
