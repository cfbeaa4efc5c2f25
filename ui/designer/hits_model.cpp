#include "ui/designer/hits_model.h"

#include <algorithm>

#include "core/design/gearboxes/section_rules.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

/// "1: A C, 2: B C": which elements each gear engages.
QString engagedWords(const Gearbox& gearbox) {
  QStringList gears;
  for (const GearState& gear : gearbox.gears) {
    QStringList letters;
    for (const int each : gear.engaged) letters << elementLetter(each);
    gears << QString::fromStdString(gear.name) + QStringLiteral(": ") + letters.join(' ');
  }
  return gears.join(QStringLiteral(", "));
}

}  // namespace

std::optional<HitMeasure> HitsModel::measureOf(int column) {
  switch (column) {
    case error:
      return HitMeasure::error;
    case efficiency:
      return HitMeasure::efficiency;
    case circulating:
      return HitMeasure::circulating;
    case speed:
      return HitMeasure::speed;
    case torque:
      return HitMeasure::torque;
    default:
      return std::nullopt;
  }
}

void HitsModel::startAnew(GearboxWishPtr wish) {
  beginResetModel();
  m_wish = std::move(wish);
  m_hits.clear();
  m_ticked.clear();
  endResetModel();
  emit tickedChanged();
}

void HitsModel::add(const std::vector<GearboxPtr>& found) {
  int first = rowCount();
  for (const GearboxPtr& each : found) {
    const auto place = std::upper_bound(m_hits.begin(), m_hits.end(), each,
                                        [](const auto& a, const auto& b) { return ranksBefore(*a, *b); });
    const int row = static_cast<int>(place - m_hits.begin());
    beginInsertRows({}, row, row);
    m_hits.insert(place, each);
    endInsertRows();
    first = std::min(first, row);
  }
  if (!found.empty()) emit dataChanged(index(first, number), index(rowCount() - 1, number));
}

int HitsModel::rowOf(const GearboxPtr& gearbox) const {
  const auto found = std::find(m_hits.begin(), m_hits.end(), gearbox);
  return found == m_hits.end() ? -1 : static_cast<int>(found - m_hits.begin());
}

bool HitsModel::isTicked(const GearboxPtr& gearbox) const {
  return std::find(m_ticked.begin(), m_ticked.end(), gearbox) != m_ticked.end();
}

void HitsModel::setTicked(const GearboxPtr& gearbox, bool isTicked) {
  if (isTicked == this->isTicked(gearbox)) return;
  if (isTicked) {
    m_ticked.push_back(gearbox);
    if (m_ticked.size() > kMaxTicked) m_ticked.erase(m_ticked.begin());
  } else {
    std::erase(m_ticked, gearbox);
  }
  emit dataChanged(index(0, number), index(rowCount() - 1, number), {Qt::CheckStateRole});
  emit tickedChanged();
}

void HitsModel::repaintPictures() {
  if (rowCount() > 0) emit dataChanged(index(0, levers), index(rowCount() - 1, schematic));
}

int HitsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_hits.size());
}

int HitsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

Qt::ItemFlags HitsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == number ? usual | Qt::ItemIsUserCheckable : usual;
}

bool HitsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (index.column() != number || role != Qt::CheckStateRole) return false;
  setTicked(at(index.row()), value.toInt() == Qt::Checked);
  return true;
}

QString HitsModel::textAt(int row, int column) const {
  const Gearbox& hit = *at(row);
  if (const auto measure = measureOf(column)) {
    const QString gear = measureGear(*measure, hit);
    return gear.isEmpty() ? measureText(*measure, hit) : measureText(*measure, hit) + ' ' + gear;
  }
  switch (column) {
    case number:
      return QString::number(row + 1);
    case levers:
      return linksOf(*m_wish, hit);
    case schematic:
      return teethOf(hit);
    case elements:
      return engagedWords(hit);
    case drawable:
      return hit.brokenRule ? QStringLiteral("–") : QStringLiteral("✓");
    default:
      return {};
  }
}

QVariant HitsModel::sortKeyAt(int row, int column) const {
  const Gearbox& hit = *at(row);
  if (const auto measure = measureOf(column)) return sortKeyOf(*measure, hit);
  switch (column) {
    case elements:
      return static_cast<int>(hit.elements.size());
    case drawable:
      return hit.brokenRule ? 1 : 0;
    default:
      return row;
  }
}

QVariant HitsModel::data(const QModelIndex& index, int role) const {
  const int row = index.row();
  const int column = index.column();
  const auto measure = measureOf(column);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return textAt(row, column);
    case Qt::CheckStateRole:
      return column == number ? QVariant(isTicked(at(row)) ? Qt::Checked : Qt::Unchecked) : QVariant();
    case SortRole:
      return sortKeyAt(row, column);
    case ValueRole:
      return measure ? measureText(*measure, *at(row)) : textAt(row, column);
    case GearRole:
      return measure ? measureGear(*measure, *at(row)) : QString();
    case WarningRole:
      return measure && isWarning(*measure, *at(row));
    case Qt::ToolTipRole:
      if (column == drawable && at(row)->brokenRule)
        return shownText(sectionRuleReason(*at(row)->brokenRule));
      if (column == elements) return elementsOf(*m_wish, *at(row));
      if (column == levers || column == schematic)
        return linksOf(*m_wish, *at(row)) + '\n' + teethOf(*at(row));
      return {};
    default:
      return {};
  }
}

QVariant HitsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue((measureOf(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case number:
        return tr("Tick two to compare them (Space)");
      case levers:
        return tr("A bar a set, its links at their exact places; the filled points are input and output");
      case elements:
        return tr("Which brakes and clutches each gear engages");
      case error:
        return tr("The largest difference from a wanted ratio, relative to it");
      case efficiency:
        return tr("The least efficiency of a gear; the wish gives that of a mesh");
      case circulating:
        return tr("The largest circulating power, as a part of the power at the input");
      case speed:
        return tr("The speed of the fastest link, as a multiple of the input's");
      case torque:
        return tr("The largest torque in a brake or clutch, as a multiple of the input's");
      case drawable:
        return tr("Can its section be drawn without shafts that cross?");
      default:
        return {};
    }
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case number:
      return tr("No.");
    case levers:
      return tr("levers");
    case schematic:
      return tr("schematic");
    case elements:
      return tr("engaged");
    case error:
      return tr("error");
    case efficiency:
      return tr("worst η");
    case circulating:
      return tr("circul.");
    case speed:
      return tr("speed");
    case torque:
      return tr("torque");
    case drawable:
      return tr("buildable");
    default:
      return {};
  }
}

// --- what is shown ----------------------------------------------------------------------------------------

ShownHits::ShownHits(HitsModel* hits, QObject* parent) : QSortFilterProxyModel(parent), m_hits(hits) {
  setSourceModel(hits);
  setSortRole(HitsModel::SortRole);
}

void ShownHits::startAnew() {
  m_filter = {};
  m_hidden.clear();
  updateChoice();
}

void ShownHits::setFilter(const HitFilter& filter) {
  m_filter = filter;
  updateChoice();
}

void ShownHits::hideHit(const GearboxPtr& gearbox) {
  m_hidden.push_back(gearbox);
  updateChoice();
}

bool ShownHits::showLastHidden() {
  if (m_hidden.empty()) return false;
  m_hidden.pop_back();
  updateChoice();
  return true;
}

void ShownHits::showAllHidden() {
  m_hidden.clear();
  updateChoice();
}

void ShownHits::updateChoice() {
  invalidateFilter();
  emit choiceChanged();
}

const GearboxPtr& ShownHits::at(const QModelIndex& index) const {
  return m_hits->at(mapToSource(index).row());
}

bool ShownHits::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  const GearboxPtr& hit = m_hits->at(row);
  return m_filter.accepts(*hit) && std::find(m_hidden.begin(), m_hidden.end(), hit) == m_hidden.end();
}

}  // namespace geargraph

#include "moc_hits_model.cpp"
