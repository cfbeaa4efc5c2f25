#include "ui/models/states_model.h"

#include <algorithm>
#include <utility>

#include "core/mechanism/model/shift_edits.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

QString decimalText(double value, int digits) {
  return printedNumber(value, digits, 'f');
}

QString decimalText(const Rational& value, int digits) {
  return decimalText(value.toDouble(), digits);
}

/// What the window calls a number of the shift table: "0.9688", "locks", or that there is none.
QString efficiencyText(const ForceCell* cell) {
  if (cell == nullptr) return {};
  if (cell->number) return decimalText(*cell->number, 4);
  return cell->text.empty() ? QStringLiteral("–") : shown(cell->text);
}

}  // namespace

void StatesModel::setMechanism(const MechanismPtr& mechanism) {
  const bool same = m_mechanism && mechanism && m_mechanism->states.size() == mechanism->states.size() &&
                    m_mechanism->couplings == mechanism->couplings && m_mechanism->links == mechanism->links;
  if (same) {
    const bool engages = m_mechanism->engaged != mechanism->engaged;
    const bool sameStates = m_mechanism->states == mechanism->states;
    m_mechanism = mechanism;
    updateRows();
    if (engages && couplingCount() > 0) emit headerDataChanged(Qt::Horizontal, 1, couplingCount());
    // No reset: a name that is typed in the table changes a state, and its editor is still there.
    if (!sameStates) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
      emit computed();
    }
    return;
  }
  beginResetModel();
  m_mechanism = mechanism;
  m_rows = rowsNow();
  endResetModel();
}

void StatesModel::setSnapshot(const SnapshotPtr& snapshot) {
  const bool isFirstStep = snapshot && !snapshot->isComplete && !snapshot->states;
  if (isFirstStep && m_snapshot && m_snapshot->states) return;
  m_snapshot = snapshot;
  updateRows();
}

void StatesModel::setTorques(const std::shared_ptr<const ForceTable>& torques,
                             const MechanismPtr& mechanism) {
  m_torques = torques;
  m_torquesOf = mechanism;
  updateRows();
}

void StatesModel::updateRows() {
  const std::vector<Row> before = std::exchange(m_rows, rowsNow());
  if (m_rows == before) return;
  for (int row = 0; row < rowCount(); ++row) tellChange(row, before[static_cast<std::size_t>(row)]);
  emit computed();
}

// Cell by cell: a drag changes some ratios, and of the table only these are painted again.
void StatesModel::tellChange(int row, const Row& before) {
  const Row& now = m_rows[static_cast<std::size_t>(row)];
  if (now.isRunning != before.isRunning || now.torques != before.torques) {
    emit dataChanged(index(row, 0), index(row, columnCount() - 1));
    return;
  }
  for (std::size_t tail = 0; tail < now.tails.size(); ++tail) {
    const bool isRatio = tail == static_cast<std::size_t>(Tail::ratio);
    if (now.tails[tail] == before.tails[tail] && (!isRatio || now.isRemark == before.isRemark)) continue;
    const QModelIndex cell = index(row, couplingCount() + 1 + static_cast<int>(tail));
    emit dataChanged(cell, cell);
  }
}

std::vector<StatesModel::Row> StatesModel::rowsNow() const {
  std::vector<Row> rows(static_cast<std::size_t>(rowCount()));
  const int running = m_mechanism ? engagedState(*m_mechanism) : -1;
  for (int row = 0; row < rowCount(); ++row) {
    Row& shown = rows[static_cast<std::size_t>(row)];
    for (std::size_t tail = 0; tail < shown.tails.size(); ++tail)
      shown.tails[tail] = tailText(row, static_cast<Tail>(tail));
    for (int coupling = 0; coupling < couplingCount(); ++coupling) {
      const ForceCell* cell = torqueCell(row, coupling);
      shown.torques.push_back(cell == nullptr ? QString()
                              : cell->number  ? decimalText(*cell->number, 3)
                                              : QString::fromStdString(cell->text));
    }
    shown.isRunning = row == running;
    const StateSolution* solution = solutionAt(row);
    shown.isRemark = solution == nullptr || !solution->ratio;
  }
  return rows;
}

int StatesModel::couplingCount() const {
  return m_mechanism ? static_cast<int>(m_mechanism->couplings.size()) : 0;
}

int StatesModel::couplingAt(int column) const {
  return column >= 1 && column <= couplingCount() ? column - 1 : -1;
}

bool StatesModel::isTail(int column, Tail tail) const {
  return column == couplingCount() + 1 + static_cast<int>(tail);
}

const StateSolution* StatesModel::solutionAt(int row) const {
  if (!m_snapshot || !m_snapshot->states) return nullptr;
  const Mechanism& solved = *m_snapshot->mechanism;
  if (solved.states != m_mechanism->states || solved.couplings != m_mechanism->couplings) return nullptr;
  return &(*m_snapshot->states)[static_cast<std::size_t>(row)];
}

const ForceTable* StatesModel::torques() const {
  if (!m_torques || !m_torquesOf || !m_mechanism) return nullptr;
  const bool isOfThese = m_torquesOf->states == m_mechanism->states &&
                         m_torquesOf->couplings == m_mechanism->couplings &&
                         m_torques->rows.size() == m_mechanism->states.size();
  return isOfThese ? m_torques.get() : nullptr;
}

const ForceCell* StatesModel::torqueCell(int row, int coupling) const {
  const ForceTable* const table = torques();
  if (table == nullptr) return nullptr;
  return &table->rows[static_cast<std::size_t>(row)].cells[1 + static_cast<std::size_t>(coupling)];
}

const ForceCell* StatesModel::shiftCell(int row, ShiftColumn column) const {
  return torqueCell(row, couplingCount() + static_cast<int>(column));
}

bool StatesModel::isEngagedNow(int coupling) const {
  return isEngaged(*m_mechanism, m_mechanism->couplings[static_cast<std::size_t>(coupling)].id);
}

int StatesModel::rowCount(const QModelIndex& parent) const {
  return !m_mechanism || parent.isValid() ? 0 : static_cast<int>(m_mechanism->states.size());
}

int StatesModel::columnCount(const QModelIndex& parent) const {
  return !m_mechanism || parent.isValid() ? 0 : 1 + couplingCount() + static_cast<int>(Tail::count);
}

bool StatesModel::lacksLinks(int row) const {
  const ShiftState& state = m_mechanism->states[static_cast<std::size_t>(row)];
  return !state.drive || !state.driven;
}

QString StatesModel::linkText(const std::optional<LinkId>& link) const {
  return link ? shown(labelOf(*m_mechanism, *link).value_or("?")) : QStringLiteral("–");
}

QString StatesModel::ratioText(int row) const {
  const StateSolution* solution = solutionAt(row);
  if (solution == nullptr) return QStringLiteral("…");
  if (solution->ratio) return printedFraction(*solution->ratio);
  for (const Diagnostic& diagnostic : solution->diagnostics) {
    if (diagnostic.code == Code::stateLocked) return tr("locked");
    if (diagnostic.code == Code::stateFree) return tr("%1 free").arg(solution->dof);
    if (diagnostic.code != Code::stateIdle) return tr("linkage");
  }
  if (lacksLinks(row)) return QStringLiteral("–");
  return solution->isDrivenAtRest ? tr("stands") : tr("tumbles");
}

QString StatesModel::tailText(int row, Tail tail) const {
  const ShiftState& state = m_mechanism->states[static_cast<std::size_t>(row)];
  const StateSolution* solution = solutionAt(row);
  switch (tail) {
    case Tail::links:
      if (lacksLinks(row)) return tr("choose…");
      return QStringLiteral("%1 → %2").arg(linkText(state.drive), linkText(state.driven));
    case Tail::ratio:
      return ratioText(row);
    case Tail::decimal:
      return solution != nullptr && solution->ratio ? decimalText(*solution->ratio, 4) : QString();
    case Tail::efficiency:
      return efficiencyText(shiftCell(row, ShiftColumn::efficiency));
    case Tail::backward:
      return efficiencyText(shiftCell(row, ShiftColumn::backward));
    case Tail::circulating: {
      const ForceCell* cell = shiftCell(row, ShiftColumn::circulating);
      if (cell == nullptr) return {};
      if (!cell->number) return QStringLiteral("–");
      return *cell->number > 0 ? decimalText(*cell->number, 3) : QStringLiteral("·");
    }
    default: {
      const auto step =
          row > 0 && solution != nullptr ? stepBetween(*solutionAt(row - 1), *solution) : std::nullopt;
      return step ? decimalText(*step, 3) : QString();
    }
  }
}

QString StatesModel::textOf(int row, int column) const {
  if (column == 0) return shown(m_mechanism->states[static_cast<std::size_t>(row)].name);
  if (const int coupling = couplingAt(column); coupling >= 0)
    return m_rows[static_cast<std::size_t>(row)].torques[static_cast<std::size_t>(coupling)];
  return m_rows[static_cast<std::size_t>(row)].tails[static_cast<std::size_t>(column - couplingCount() - 1)];
}

/// In words what the eye sees: a dot, an empty cell.
QString StatesModel::accessibleText(const QModelIndex& index) const {
  const int coupling = couplingAt(index.column());
  if (coupling < 0) {
    const QString text = textOf(index.row(), index.column());
    return text.isEmpty() ? tr("none") : text;
  }
  const QString name = shown(m_mechanism->couplings[static_cast<std::size_t>(coupling)].id.text());
  return data(index, EngagedRole).toBool() ? tr("%1 engaged").arg(name) : tr("%1 released").arg(name);
}

QVariant StatesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const int row = index.row();
  switch (role) {
    case Qt::DisplayRole:
      return textOf(row, index.column());
    case Qt::AccessibleTextRole:
      return accessibleText(index);
    case Qt::EditRole:
      return index.column() == 0 ? QVariant(textOf(row, 0)) : QVariant();
    case EngagedRole: {
      const int coupling = couplingAt(index.column());
      if (coupling < 0) return false;
      const auto& engaged = m_mechanism->states[static_cast<std::size_t>(row)].engaged;
      const ShiftElementId id = m_mechanism->couplings[static_cast<std::size_t>(coupling)].id;
      return std::find(engaged.begin(), engaged.end(), id) != engaged.end();
    }
    case RunningRole:
      return isRunning(row);
    case RemarkRole:
      return isTail(index.column(), Tail::ratio) && m_rows[static_cast<std::size_t>(row)].isRemark;
    case Qt::ToolTipRole: {
      const StateSolution* solution = solutionAt(row);
      if (solution != nullptr && !solution->diagnostics.empty())
        return shown(solution->diagnostics.front().message);
      const int coupling = couplingAt(index.column());
      return coupling >= 0 ? torqueTip(row, coupling) : tailTip(row, index.column());
    }
    default:
      return {};
  }
}

/// What bears how much, as a fraction where there is one.
QString StatesModel::torqueTip(int row, int position) const {
  const ForceCell* cell = torqueCell(row, position);
  if (cell == nullptr || cell->text.empty()) return {};
  const ShiftElement& coupling = m_mechanism->couplings[static_cast<std::size_t>(position)];
  const QString id = shown(coupling.id.text());
  const QString on = linkText(coupling.links.front());
  if (!cell->number)
    return tr("Several couplings share the load in proportions that stiffness and clearance decide.");
  const QString torque = shown(cell->exact.empty() ? cell->text : cell->exact);
  return coupling.kind == ShiftElementKind::brake
             ? tr("Brake %1 bears %2 N m, its torque on link %3").arg(id, torque, on)
             : tr("Clutch %1 bears %2 N m, its torque on link %3 from link %4")
                   .arg(id, torque, on, linkText(coupling.links.back()));
}

QString StatesModel::tailTip(int row, int column) const {
  const bool needsLinks = isTail(column, Tail::links) || isTail(column, Tail::ratio);
  if (needsLinks && lacksLinks(row)) return tr("Click to choose the input and the output link of this state");
  const StateSolution* solution = solutionAt(row);
  if (isTail(column, Tail::ratio) && solution != nullptr && solution->symbolicRatio)
    return tr("In the gear ratios: %1").arg(shown(solution->symbolicRatio->toText()));
  for (const auto& [tail, cell] : {std::pair(Tail::efficiency, shiftCell(row, ShiftColumn::efficiency)),
                                   std::pair(Tail::backward, shiftCell(row, ShiftColumn::backward)),
                                   std::pair(Tail::circulating, shiftCell(row, ShiftColumn::circulating))})
    if (isTail(column, tail) && cell != nullptr) return shown(cell->exact.empty() ? cell->text : cell->exact);
  return {};
}

Qt::ItemFlags StatesModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() == 0) flags |= Qt::ItemIsEditable;
  return flags;
}

bool StatesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role == Qt::EditRole && index.column() == 0) emit renamed(index.row(), value.toString());
  return false;
}

QVariant StatesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  const int position = couplingAt(section);
  if (position >= 0) {
    const ShiftElement& coupling = m_mechanism->couplings[static_cast<std::size_t>(position)];
    const bool isBrake = coupling.kind == ShiftElementKind::brake;
    if (role == Qt::DisplayRole) return shown(coupling.id.text());
    if (role == EngagedRole) return isEngagedNow(position);
    if (role == HoldsRole) {
      return isBrake ? tr("%1 = 0").arg(linkText(coupling.links.front()))
                     : tr("%1 = %2").arg(linkText(coupling.links.front()), linkText(coupling.links.back()));
    }
    if (role == Qt::ToolTipRole) {
      return isBrake ? tr("Brake %1 holds link %2")
                           .arg(shown(coupling.id.text()), linkText(coupling.links.front()))
                     : tr("Clutch %1 makes links %2 and %3 turn as one")
                           .arg(shown(coupling.id.text()), linkText(coupling.links.front()),
                                linkText(coupling.links.back()));
    }
    return {};
  }
  if (role == Qt::ToolTipRole && isTail(section, Tail::links))
    return tr("The ratio is the speed of the first link over that of the second. Click to choose them.");
  if (role == Qt::ToolTipRole && isTail(section, Tail::step)) return tr("The ratio before over this one");
  if (role == Qt::ToolTipRole && isTail(section, Tail::efficiency))
    return tr("Power taken over power fed, with the drive driving; none while the meshes state no losses");
  if (role == Qt::ToolTipRole && isTail(section, Tail::backward))
    return tr("The efficiency with all known torques reversed: the output drives");
  if (role == Qt::ToolTipRole && isTail(section, Tail::circulating))
    return tr("The greatest power that goes round in a loop, for each watt that is fed");
  if (role != Qt::DisplayRole) return {};
  const QString names[] = {tr("links"), tr("ratio"),  tr("decimal"), tr("step"),
                           tr("η"),     tr("η back"), tr("circul.")};
  return section == 0 ? tr("state") : names[section - couplingCount() - 1];
}

}  // namespace geargraph

#include "moc_states_model.cpp"
