#include "ui/designer/hits_model.h"

#include <algorithm>

#include "core/design/gearboxes/section_rules.h"
#include "ui/designer/hit_words.h"
#include "ui/models/term_tips.h"

namespace geargraph::inline designer {
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

void HitsModel::startAnew(GearboxWishPtr wish) {
  beginResetModel();
  m_wish = std::move(wish);
  m_hits.clear();
  endResetModel();
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

int HitsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_hits.size());
}

int HitsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QString HitsModel::textAt(int row, int column) const {
  const Gearbox& hit = *at(row);
  const auto gearName = [&](int gear) {
    return QString::fromStdString(hit.gears[static_cast<std::size_t>(gear)].name);
  };
  switch (column) {
    case number:
      return QString::number(row + 1);
    case elements:
      return engagedWords(hit);
    case error:
      if (hit.error.isZero()) return percentOf(hit.error);
      return tr("%1 in %2").arg(percentOf(hit.error), gearName(farthestGear(hit)));
    case efficiency: {
      if (const int locked = lockedGear(hit); locked >= 0) return tr("none in %1").arg(gearName(locked));
      const int least = leastEfficientGear(hit);
      if (least < 0) return {};
      return tr("%1 in %2")
          .arg(decimalOf(*hit.losses->efficiencies[static_cast<std::size_t>(least)]), gearName(least));
    }
    case teeth:
      return teethOf(hit);
    case drawable:
      return hit.brokenRule ? QStringLiteral("–") : QStringLiteral("✓");
    default:
      return {};
  }
}

QVariant HitsModel::sortKeyAt(int row, int column) const {
  const Gearbox& hit = *at(row);
  switch (column) {
    case elements:
      return static_cast<int>(hit.elements.size());
    case error:
      return hit.error.toDouble();
    case efficiency: {
      const int least = leastEfficientGear(hit);
      if (least < 0 || lockedGear(hit) >= 0) return -1.0;
      return hit.losses->efficiencies[static_cast<std::size_t>(least)]->toDouble();
    }
    case teeth:
      return textAt(row, column);
    case drawable:
      return hit.brokenRule ? 1 : 0;
    default:
      return row;
  }
}

QVariant HitsModel::data(const QModelIndex& index, int role) const {
  const int row = index.row();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return textAt(row, index.column());
    case SortRole:
      return sortKeyAt(row, index.column());
    case Qt::TextAlignmentRole: {
      const bool isWord = index.column() == teeth || index.column() == drawable;
      return QVariant::fromValue(Qt::AlignVCenter | (isWord ? Qt::AlignLeft : Qt::AlignRight));
    }
    case Qt::ToolTipRole:
      if (index.column() == drawable && at(row)->brokenRule)
        return QString::fromStdString(sectionRuleReason(*at(row)->brokenRule));
      if (index.column() == elements) return elementsOf(*m_wish, *at(row));
      return {};
    default:
      return {};
  }
}

QVariant HitsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && (section == error || section == efficiency))
    return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case elements:
        return tr("Which brakes and clutches each gear engages");
      case error:
        return tr("The largest difference from a wanted ratio, relative to it");
      case efficiency:
        return tr("The least efficiency of a gear; the wish gives that of a mesh");
      case teeth:
        return tr("Sun, planet and ring of each set");
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
    case elements:
      return tr("engaged");
    case error:
      return tr("error");
    case efficiency:
      return tr("worst η");
    case teeth:
      return tr("teeth");
    case drawable:
      return tr("buildable");
    default:
      return {};
  }
}

}  // namespace geargraph::inline designer

#include "moc_hits_model.cpp"
