#include "ui/models/results_model.h"

#include <algorithm>
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

/// Do both have the same inputs and outputs, under the same labels?
bool sameHeadings(const AnalysisSnapshot& a, const AnalysisSnapshot& b) {
  const MatroidAnalysis *one = a.matroid(), *other = b.matroid();
  if (one == nullptr || other == nullptr || !one->solution || !other->solution) return false;
  if (one->solution->inputs != other->solution->inputs || one->solution->outputs != other->solution->outputs)
    return false;
  const auto& before = a.mechanism->turningJoints;
  const auto& after = b.mechanism->turningJoints;
  return a.mechanism->n() == b.mechanism->n() &&
         std::equal(before.begin(), before.end(), after.begin(), after.end(),
                    [](const TurningJoint& x, const TurningJoint& y) { return x.id == y.id; });
}

}  // namespace

// The rows and columns of a drag stay: then nothing that shows them is laid out anew.
void ResultsModel::setSnapshot(const SnapshotPtr& snapshot) {
  m_names.setSnapshot(snapshot);
  if (m_snapshot && snapshot && sameHeadings(*m_snapshot, *snapshot)) {
    m_snapshot = snapshot;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    return;
  }
  beginResetModel();
  m_snapshot = snapshot;
  endResetModel();
}

void ResultsModel::setNames(const MechanismPtr& newest) {
  m_names.setNewest(newest);
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, 0));
}

void ResultsModel::setSymbolic(bool symbolic) {
  if (symbolic == m_symbolic) return;
  m_symbolic = symbolic;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const LiveSolution* ResultsModel::solution() const {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  return matroid != nullptr && matroid->solution ? &*matroid->solution : nullptr;
}

bool ResultsModel::hasSymbols() const {
  return m_snapshot && m_snapshot->solved && m_snapshot->solved->symbolic &&
         !m_snapshot->solved->symbolic->matrix.empty();
}

int ResultsModel::inputCount() const {
  return solution() != nullptr ? static_cast<int>(solution()->inputs.size()) : 0;
}

ElementId ResultsModel::outputAt(int row) const {
  return m_snapshot->graph->edgeId(jointAt(row));
}

ElementId ResultsModel::inputAt(int input) const {
  return m_snapshot->graph->edgeId(solution()->inputs[static_cast<std::size_t>(input)]);
}

ElementId ResultsModel::linkAt(int row) const {
  return m_snapshot->graph->nodeId(linkNodeAt(row));
}

int ResultsModel::ratioRow() const {
  int found = -1;
  for (int row = 0; row < rowCount(); ++row) {
    if (tailNodeAt(row) != 0 || inputCount() != 1 || isZero(row, 0)) continue;
    if (found >= 0) return -1;
    found = row;
  }
  return found;
}

QString ResultsModel::ratioText(int row) const {
  if (row < 0 || row >= rowCount() || inputCount() != 1 || solution()->matrix.empty() || isZero(row, 0))
    return {};
  const QString names =
      QStringLiteral("i = %1 : %2").arg(jointMotion(solution()->inputs.front()), jointMotion(jointAt(row)));
  const double decimal = solution()->matrix[at(row, 0)];
  QString unit =
      unitOfRatio(*m_snapshot->mechanism, slidesAt(solution()->inputs.front()), slidesAt(jointAt(row)));
  if (!unit.isEmpty()) unit.prepend(QLatin1Char(' '));
  const std::optional<PiNumber> entry = exactEntry(at(row, 0));
  const std::optional<PiNumber> ratio = entry ? quotient(Rational(1), *entry) : std::nullopt;
  if (!ratio) return QStringLiteral("%1 = %2").arg(names, printedNumber(1 / decimal)) + unit;
  const bool isPlain = ratio->isRational() && ratio->rational().isInteger();
  const QString text = printedExact(*ratio);
  return QStringLiteral("%1 = %2").arg(
             names, isPlain ? text : tr("%1 (%2)").arg(text, printedNumber(ratio->toDouble()))) +
         unit;
}

std::optional<PiNumber> ResultsModel::exactEntry(std::size_t at) const {
  if (!m_snapshot->solved) return std::nullopt;
  const SolvedKinematics& solved = *m_snapshot->solved;
  if (solved.exact && !solved.exact->matrix.empty()) return solved.exact->matrix[at];
  if (solved.pi && !solved.pi->matrix.empty()) return solved.pi->matrix[at];
  return std::nullopt;
}

std::optional<PiNumber> ResultsModel::exactRate(int joint) const {
  if (!m_snapshot->solved) return std::nullopt;
  const SolvedKinematics& solved = *m_snapshot->solved;
  if (solved.exact) return solved.exact->rates[static_cast<std::size_t>(joint)];
  if (solved.pi) return solved.pi->rates[static_cast<std::size_t>(joint)];
  return std::nullopt;
}

bool ResultsModel::slidesAt(int joint) const {
  return slides(m_snapshot->mechanism->turningJoints[static_cast<std::size_t>(joint)]);
}

int ResultsModel::rowCount(const QModelIndex& parent) const {
  return solution() == nullptr || parent.isValid() ? 0 : static_cast<int>(solution()->outputs.size());
}

int ResultsModel::columnCount(const QModelIndex& parent) const {
  return solution() == nullptr || parent.isValid() ? 0 : inputCount() + 2;
}

std::size_t ResultsModel::at(int row, int input) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(inputCount()) +
         static_cast<std::size_t>(input);
}

const RationalFunction* ResultsModel::symbolAt(int row, int input) const {
  if (!m_symbolic || !hasSymbols()) return nullptr;
  const auto& entry = m_snapshot->solved->symbolic->matrix[at(row, input)];
  return entry ? &*entry : nullptr;
}

bool ResultsModel::isZero(int row, int input) const {
  if (solution()->matrix.empty()) return false;
  return solution()->matrix[at(row, input)] == 0;  // zeros of the live solution are exact
}

QString ResultsModel::coefficient(int row, int input) const {
  if (isZero(row, input)) return QStringLiteral("0");
  if (const RationalFunction* symbol = symbolAt(row, input)) return QString::fromStdString(symbol->toText());
  if (const auto exact = exactEntry(at(row, input))) return printedExact(*exact);
  if (solution()->matrix.empty()) return QStringLiteral("…");
  return printedNumber(solution()->matrix[at(row, input)]);
}

void ResultsModel::setUnit(const SpeedUnit& unit) {
  beginResetModel();
  m_unit = unit;
  endResetModel();
}

int ResultsModel::referenceJoint() const {
  if (m_unit.kind != SpeedUnit::Kind::ratio) return -1;
  const auto& joints = m_snapshot->mechanism->turningJoints;
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [this](const TurningJoint& joint) { return joint.id == m_unit.reference; });
  return found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
}

QString ResultsModel::rateNow(int row, bool asDecimal) const {
  const int joint = jointAt(row);
  const int reference = referenceJoint();
  const SpeedUnit unit = asDecimal ? SpeedUnit() : m_unit;
  // What slides has no turns a minute.
  const SpeedUnit& own = slidesAt(joint) && unit.kind == SpeedUnit::Kind::rpm ? SpeedUnit() : unit;
  QString suffix;
  if (hasSlides(*m_snapshot->mechanism)) suffix = unitOfRate(*m_snapshot->mechanism, slidesAt(joint), unit);
  if (!suffix.isEmpty()) suffix.prepend(QLatin1Char(' '));
  if (const auto exact = exactRate(joint); exact && !asDecimal)
    return speedText(*exact, own, reference < 0 ? std::nullopt : exactRate(reference)) + suffix;
  const std::vector<double>& rates = solution()->rates;
  return speedText(rates[static_cast<std::size_t>(joint)], own,
                   reference < 0 ? std::nullopt : std::optional(rates[static_cast<std::size_t>(reference)])) +
         suffix;
}

QString ResultsModel::headOfRates() const {
  switch (m_unit.kind) {
    case SpeedUnit::Kind::rpm:
      return hasSlides(*m_snapshot->mechanism) ? tr("now") : tr("rpm");
    case SpeedUnit::Kind::ratio: {
      const int reference = referenceJoint();
      return reference < 0 ? tr("ratio") : tr("to %1").arg(m_snapshot->graph->edgeLabel(reference));
    }
    default:
      return tr("now");
  }
}

QString ResultsModel::rowText(int row) const {
  return jointMotion(jointAt(row));
}

QString ResultsModel::rowText(int row, const QString& name) const {
  return relativeText(QString::number(m_snapshot->graph->nodeLabel(linkNodeAt(row))), name.toStdString(),
                      QString::number(m_snapshot->graph->nodeLabel(tailNodeAt(row))));
}

QString ResultsModel::rowName(int row) const {
  const QString name = QString::fromStdString(m_names.nameOf(linkNodeAt(row))).simplified();
  return rowText(row, name) == rowText(row, {}) ? QString() : name;
}

QString ResultsModel::jointMotion(int joint) const {
  const Digraph& graph = *m_snapshot->graph;
  const DigraphEdge& edge = graph.turningEdge(joint);
  return relativeText(QString::number(graph.nodeLabel(edge.head)), m_names.nameOf(edge.head),
                      QString::number(graph.nodeLabel(edge.tail)));
}

/// With the whole names, which the row may have shortened.
QString ResultsModel::motionTip(int row) const {
  const auto whole = [this](int node) {
    const QString label = QString::number(m_snapshot->graph->nodeLabel(node));
    const QString name = QString::fromStdString(m_names.nameOf(node));
    return name.isEmpty() ? label : tr("%1 (%2)").arg(label, name);
  };
  if (slidesAt(jointAt(row))) {
    return tr("Speed of joint %1: link %2 slides along link %3")
        .arg(QString::number(m_snapshot->graph->edgeLabel(jointAt(row))), whole(linkNodeAt(row)),
             whole(tailNodeAt(row)));
  }
  return tr("Speed of joint %1: link %2 relative to link %3")
      .arg(QString::number(m_snapshot->graph->edgeLabel(jointAt(row))), whole(linkNodeAt(row)),
           whole(tailNodeAt(row)));
}

QVariant ResultsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const int row = index.row();
  const int input = index.column() - 1;
  const bool ofInput = input >= 0 && input < inputCount();
  switch (role) {
    case Qt::DisplayRole:
      if (ofInput) return coefficient(row, input);
      if (input < 0) return rowText(row);
      return rateNow(row, false);
    case Qt::ToolTipRole:
      if (input == inputCount()) {
        return hasSlides(*m_snapshot->mechanism) ? rateNow(row, true)
                                                 : tr("%1 rad/s").arg(rateNow(row, true));
      }
      return input < 0 ? motionTip(row) : ratioText(row);
    case ZeroRole:
      return ofInput && isZero(row, input);
    case SymbolRole:
      return ofInput && !isZero(row, input) && symbolAt(row, input) != nullptr;
    case JointLabelRole:
      return QString::number(m_snapshot->graph->edgeLabel(jointAt(row)));
    case LinkLabelRole:
      return m_snapshot->graph->nodeLabel(linkNodeAt(row));
    case LinkColorRole:
      return m_snapshot->mechanism->colorNumber(linkNodeAt(row));
    default:
      return {};
  }
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const int input = section - 1;
  if (section < 0 || section >= columnCount()) return {};
  if (input < 0) return tr("joint");
  if (input == inputCount()) return headOfRates();
  return QString::number(m_snapshot->graph->edgeLabel(solution()->inputs[static_cast<std::size_t>(input)]));
}

}  // namespace geargraph

#include "moc_results_model.cpp"
