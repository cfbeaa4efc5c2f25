#include "ui/models/link_speeds_model.h"

#include <algorithm>
#include <cmath>

namespace geargraph {
namespace {
constexpr double kRounding = 1e-13;  ///< of a difference of speeds, relative to them
}

void LinkSpeedsModel::setSnapshot(const SnapshotPtr& snapshot) {
  const auto rows = [](const SnapshotPtr& of) {
    const MatroidAnalysis* matroid = of ? of->matroid() : nullptr;
    return matroid != nullptr && matroid->solution ? of->mechanism->n() : 0;
  };
  if (rows(snapshot) == rowCount()) {
    m_snapshot = snapshot;
    m_names.setSnapshot(snapshot);
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1));
    return;
  }
  beginResetModel();
  m_snapshot = snapshot;
  m_names.setSnapshot(snapshot);
  endResetModel();
}

void LinkSpeedsModel::setUnit(const SpeedUnit& unit) {
  m_unit = unit;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1));
}

void LinkSpeedsModel::setNames(const MechanismPtr& newest) {
  m_names.setNewest(newest);
  if (rowCount() > 0) emit dataChanged(index(0, linkColumn), index(rowCount() - 1, linkColumn));
}

void LinkSpeedsModel::setObserver(const std::optional<LinkId>& observer) {
  m_observer = observer;
  if (rowCount() == 0) return;
  emit dataChanged(index(0, 0), index(rowCount() - 1, columnTotal - 1));
  emit headerDataChanged(Qt::Horizontal, aboutColumn, aboutColumn);
}

int LinkSpeedsModel::observerNode() const {
  if (!m_observer) return 0;
  const std::vector<Link>& links = m_snapshot->mechanism->links;
  const auto found =
      std::find_if(links.begin(), links.end(), [this](const Link& link) { return link.id == *m_observer; });
  return found == links.end() ? 0 : static_cast<int>(found - links.begin());
}

std::vector<SpeedAboutOf<PiNumber>> LinkSpeedsModel::absoluteOf(int link) const {
  const Placement& placement = m_snapshot->kinematics->placement();
  const SolvedKinematics& solved = *m_snapshot->solved;
  if (solved.pi) return absoluteSpeed(placement, solved.pi->rates, link);
  std::vector<SpeedAboutOf<PiNumber>> speeds;
  for (const SpeedAbout& about : absoluteSpeed(placement, solved.exact->rates, link))
    speeds.push_back({about.axisGroup, about.speed});
  return speeds;
}

/// Directions that are parallel in the reference pose are one, as in absoluteSpeed().
std::vector<SpeedAboutOf<PiNumber>> LinkSpeedsModel::speedOf(int link) const {
  const Placement& placement = m_snapshot->kinematics->placement();
  std::vector<SpeedAboutOf<PiNumber>> sum = absoluteOf(link);
  const int observer = observerNode();
  if (observer == 0) return sum;
  for (const SpeedAboutOf<PiNumber>& less : absoluteOf(observer)) {
    const auto same = std::find_if(sum.begin(), sum.end(), [&](const SpeedAboutOf<PiNumber>& about) {
      return directionSign(placement, about.axisGroup, less.axisGroup) != 0;
    });
    if (same == sum.end()) {
      sum.push_back({less.axisGroup, -less.speed});
    } else if (directionSign(placement, same->axisGroup, less.axisGroup) > 0) {
      same->speed = same->speed - less.speed;
    } else {
      same->speed = same->speed + less.speed;
    }
  }
  std::erase_if(sum, [](const SpeedAboutOf<PiNumber>& about) { return about.speed.isZero(); });
  return sum;
}

ElementId LinkSpeedsModel::linkAt(int row) const {
  return m_snapshot->mechanism->links[static_cast<std::size_t>(row) + 1].id;
}

bool LinkSpeedsModel::hasExactRates() const {
  return m_snapshot->solved && (m_snapshot->solved->exact || m_snapshot->solved->pi);
}

int LinkSpeedsModel::rowCount(const QModelIndex& parent) const {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (matroid == nullptr || !matroid->solution || parent.isValid()) return 0;
  return m_snapshot->mechanism->n();
}

int LinkSpeedsModel::columnCount(const QModelIndex& parent) const {
  return rowCount() == 0 || parent.isValid() ? 0 : columnTotal;
}

std::optional<PiNumber> LinkSpeedsModel::referenceSpeed() const {
  if (m_unit.kind != SpeedUnit::Kind::ratio || !hasExactRates()) return std::nullopt;
  const auto& joints = m_snapshot->mechanism->turningJoints;
  const Placement& placement = m_snapshot->kinematics->placement();
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (joints[joint].id != m_unit.reference) continue;
    const auto speeds = speedOf(placement.tree->child[joint]);
    if (speeds.size() == 1) return speeds.front().speed;
  }
  return std::nullopt;
}

/// What slides says its unit, as nothing else in the column has one.
QString LinkSpeedsModel::aboutText(const SpeedAboutOf<PiNumber>& about,
                                   const std::optional<PiNumber>& reference) const {
  const Placement& placement = m_snapshot->kinematics->placement();
  const AxisGroups::Class& group = placement.classes->classes[static_cast<std::size_t>(about.axisGroup)];
  const bool isSlide = group.kind == JointKind::sliding;
  const bool hasTurns = m_unit.kind == SpeedUnit::Kind::rpm;
  QString text = speedText(about.speed, isSlide && hasTurns ? SpeedUnit() : m_unit, reference);
  const QString axis =
      QString::fromStdString(m_snapshot->mechanism->axes[static_cast<std::size_t>(group.axis)].id.text());
  if (!hasSlides(*m_snapshot->mechanism)) return tr("%1 about %2").arg(text, axis);
  const QString unit = unitOfRate(*m_snapshot->mechanism, isSlide, m_unit);
  if (!unit.isEmpty()) text += QLatin1Char(' ') + unit;
  return isSlide ? tr("%1 along %2").arg(text, axis) : tr("%1 about %2").arg(text, axis);
}

QString LinkSpeedsModel::aboutText(int link) const {
  if (!hasExactRates()) return QStringLiteral("…");
  const auto reference = referenceSpeed();
  QStringList parts;
  for (const SpeedAboutOf<PiNumber>& about : speedOf(link)) parts << aboutText(about, reference);
  return parts.isEmpty() ? tr("stands still") : parts.join(QStringLiteral(", "));
}

QString LinkSpeedsModel::componentText(int link, int component) const {
  const auto& velocities = m_snapshot->matroid()->linkVelocities;
  const auto at = static_cast<std::size_t>(component);
  const int observer = observerNode();
  const double of = velocities[static_cast<std::size_t>(link)][at];
  const double less = observer == 0 ? 0 : velocities[static_cast<std::size_t>(observer)][at];
  const bool isRounding = std::abs(of - less) <= kRounding * (std::abs(of) + std::abs(less));
  const auto reference = referenceSpeed();
  return speedText(isRounding ? 0 : of - less, m_unit,
                   reference ? std::optional(reference->toDouble()) : std::nullopt);
}

QVariant LinkSpeedsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const int label = index.row() + 1;
  switch (role) {
    case LinkColorRole:
      return m_snapshot->mechanism->colorNumber(label);
    case Qt::ToolTipRole:
      return QString::fromStdString(m_names.nameOf(label));
    case Qt::TextAlignmentRole:
      return static_cast<int>((index.column() >= xColumn ? Qt::AlignRight : Qt::AlignLeft) |
                              Qt::AlignVCenter);
    case Qt::DisplayRole:
      if (index.column() == linkColumn) return linkText(QString::number(label), m_names.nameOf(label));
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
  const QString names[] = {
      tr("link"),
      m_snapshot && observerNode() != 0 ? tr("relative to %1").arg(observerNode()) : tr("absolute speed"),
      tr("x"), tr("y"), tr("z")};
  return names[section];
}

}  // namespace geargraph

#include "moc_link_speeds_model.cpp"
