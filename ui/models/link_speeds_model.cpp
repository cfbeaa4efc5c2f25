#include "ui/models/link_speeds_model.h"

#include "core/theory/states/relative_speed.h"

namespace geargraph::inline models {

void LinkSpeedsModel::setSnapshot(const SnapshotPtr& snapshot) {
  const auto rows = [](const SnapshotPtr& of) {
    const MatroidAnalysis* matroid = of ? of->matroid() : nullptr;
    return matroid != nullptr && matroid->solution ? of->mechanism->n() : 0;
  };
  if (rows(snapshot) == rowCount()) {
    m_snapshot = snapshot;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1));
    return;
  }
  beginResetModel();
  m_snapshot = snapshot;
  endResetModel();
}

void LinkSpeedsModel::setUnit(const SpeedUnit& unit) {
  m_unit = unit;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1));
}

ElementId LinkSpeedsModel::linkAt(int row) const {
  return m_snapshot->mechanism->links[static_cast<std::size_t>(row) + 1].id;
}

const std::vector<Rational>* LinkSpeedsModel::exactRates() const {
  return m_snapshot->solved && m_snapshot->solved->exact ? &m_snapshot->solved->exact->rates : nullptr;
}

int LinkSpeedsModel::rowCount(const QModelIndex& parent) const {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (matroid == nullptr || !matroid->solution || parent.isValid()) return 0;
  return m_snapshot->mechanism->n();
}

int LinkSpeedsModel::columnCount(const QModelIndex& parent) const {
  return rowCount() == 0 || parent.isValid() ? 0 : columnTotal;
}

std::optional<Rational> LinkSpeedsModel::referenceSpeed() const {
  const std::vector<Rational>* rates = exactRates();
  if (m_unit.kind != SpeedUnit::Kind::ratio || rates == nullptr) return std::nullopt;
  const auto& joints = m_snapshot->mechanism->turningJoints;
  const Placement& placement = m_snapshot->kinematics->placement();
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (joints[joint].id != m_unit.reference) continue;
    const auto speeds = absoluteSpeed(placement, *rates, placement.tree->child[joint]);
    if (speeds.size() == 1) return speeds.front().speed;
  }
  return std::nullopt;
}

QString LinkSpeedsModel::aboutText(int link) const {
  const std::vector<Rational>* rates = exactRates();
  if (rates == nullptr) return QStringLiteral("…");
  const Placement& placement = m_snapshot->kinematics->placement();
  const auto reference = referenceSpeed();
  QStringList parts;
  for (const SpeedAbout& about : absoluteSpeed(placement, *rates, link)) {
    const int axis = placement.classes->classes[static_cast<std::size_t>(about.axisClass)].axis;
    parts << tr("%1 about %2")
                 .arg(speedText(about.speed, m_unit, reference),
                      QString::fromStdString(
                          m_snapshot->mechanism->axes[static_cast<std::size_t>(axis)].id.text()));
  }
  return parts.isEmpty() ? tr("stands still") : parts.join(QStringLiteral(", "));
}

QString LinkSpeedsModel::componentText(int link, int component) const {
  const Vector3& velocity = m_snapshot->matroid()->linkVelocities[static_cast<std::size_t>(link)];
  const auto reference = referenceSpeed();
  return speedText(velocity[static_cast<std::size_t>(component)], m_unit,
                   reference ? std::optional(reference->toDouble()) : std::nullopt);
}

QVariant LinkSpeedsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const int label = index.row() + 1;
  const Link& element = m_snapshot->mechanism->links[static_cast<std::size_t>(label)];
  switch (role) {
    case LinkLabelRole:
      return label;
    case Qt::ToolTipRole:
      return QString::fromStdString(element.name);
    case Qt::TextAlignmentRole:
      return static_cast<int>((index.column() >= xColumn ? Qt::AlignRight : Qt::AlignLeft) |
                              Qt::AlignVCenter);
    case Qt::DisplayRole:
      if (index.column() == linkColumn) return tr("link %1").arg(label);
      if (index.column() == aboutColumn) return aboutText(label);
      return componentText(label, index.column() - xColumn);
    default:
      return {};
  }
}

QVariant LinkSpeedsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnTotal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((section >= xColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString names[] = {tr("link"), tr("absolute speed"), tr("x"), tr("y"), tr("z")};
  return names[section];
}

}  // namespace geargraph::inline models
