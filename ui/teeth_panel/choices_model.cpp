#include "ui/teeth_panel/choices_model.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/foundations/base/locale.h"
#include "core/presentation/diagrams/lever_words.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/teeth_panel/wheel_names.h"

namespace geargraph {
namespace {

QString decimalText(const std::optional<double>& value) {
  return value ? shownText(threeDecimals(Rational::fromDouble(*value))) : ChoicesModel::tr("none");
}

QString planetsText(const std::vector<int>& planets) {
  QStringList texts;
  for (const int each : planets) texts << QString::number(each);
  return texts.isEmpty() ? ChoicesModel::tr("none") : texts.join(QLatin1Char(' '));
}

}  // namespace

QString errorText(const Rational& error) {
  if (error.isZero()) return ChoicesModel::tr("exact");
  const QString percent = shownText(threeDecimals(error * Rational(100)));
  return (error.sign() > 0 ? QStringLiteral("+") : QString()) + percent + QStringLiteral(" %");
}

void ChoicesModel::setResult(const TeethResultPtr& result) {
  beginResetModel();
  m_result = result && result->answer ? result : nullptr;
  m_rows.clear();
  m_columns.clear();
  m_order.clear();
  if (m_result) {
    for (const TeethChoice& choice : m_result->answer->choices) m_rows.push_back(&choice);
    if (m_rows.empty() && m_result->answer->nearest) m_rows.push_back(&*m_result->answer->nearest);
    m_order.resize(m_rows.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    makePairs();
    makeColumns();
  }
  endResetModel();
}

/// Equal planets have equal pairs, of which one is told.
void ChoicesModel::makePairs() {
  m_pairs.clear();
  m_marks.clear();
  m_names.clear();
  for (const WheelName& name : wheelNames(problem())) {
    m_marks << name.mark;
    m_names << name.tip;
  }
  std::set<std::pair<int, int>> known;
  const std::vector<int>& wheelOf = problem().wheelOfEnd;
  for (std::size_t mesh = 0; 2 * mesh + 1 < wheelOf.size(); ++mesh)
    if (known.insert(std::minmax(wheelOf[2 * mesh], wheelOf[2 * mesh + 1])).second) m_pairs.push_back(mesh);
}

void ChoicesModel::makeColumns() {
  m_columns.push_back({Kind::rank, 0});
  for (std::size_t wheel = 0; wheel < problem().wheels.size(); ++wheel)
    m_columns.push_back({Kind::wheel, wheel});
  for (std::size_t ratio = 0; ratio < problem().ratios.size(); ++ratio)
    for (const Kind kind : {Kind::ratio, Kind::decimal, Kind::error}) m_columns.push_back({kind, ratio});
  const auto any = [&](auto has) {
    return std::any_of(m_rows.begin(), m_rows.end(), [&](const TeethChoice* choice) { return has(*choice); });
  };
  if (any([](const TeethChoice& choice) { return !choice.planets.empty(); }))
    m_columns.push_back({Kind::planets, 0});
  m_columns.push_back({Kind::hunting, 0});
  if (any([](const TeethChoice& choice) { return choice.efficiency || choice.backward; })) {
    m_columns.push_back({Kind::efficiency, 0});
    m_columns.push_back({Kind::backward, 0});
  }
}

const TeethChoice& ChoicesModel::choiceAt(int row) const {
  return *m_rows[m_order[static_cast<std::size_t>(row)]];
}

int ChoicesModel::rankAt(int row) const {
  return m_result->answer->choices.empty() ? 0 : static_cast<int>(m_order[static_cast<std::size_t>(row)]) + 1;
}

int ChoicesModel::rowOf(const std::vector<int>& teeth) const {
  for (int row = 0; row < rowCount(); ++row)
    if (choiceAt(row).found.teeth == teeth) return row;
  return -1;
}

int ChoicesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ChoicesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

bool ChoicesModel::isChanged(const TeethChoice& choice, std::size_t wheel) const {
  return m_result->meant && choice.found.teeth[wheel] != problem().wheels[wheel].drawn;
}

/// Exact: fractions are compared as fractions.
bool ChoicesModel::isBefore(const TeethChoice& one, const TeethChoice& other, Column column) const {
  switch (column.kind) {
    case Kind::rank:
      return false;  // the order there is
    case Kind::wheel:
      return one.found.teeth[column.at] < other.found.teeth[column.at];
    case Kind::ratio:
    case Kind::decimal:
      return one.found.ratios[column.at] < other.found.ratios[column.at];
    case Kind::error:
      return one.found.errors[column.at].abs() < other.found.errors[column.at].abs();
    case Kind::planets:
      return one.planets < other.planets;
    case Kind::hunting: {
      const auto hunting = [this](const TeethChoice& choice) {
        return std::count_if(m_pairs.begin(), m_pairs.end(),
                             [&](std::size_t mesh) { return choice.hunting[mesh] != 0; });
      };
      return hunting(one) < hunting(other);
    }
    case Kind::efficiency:
      return one.efficiency.value_or(-1) < other.efficiency.value_or(-1);
    case Kind::backward:
      return one.backward.value_or(-1) < other.backward.value_or(-1);
  }
  return false;
}

void ChoicesModel::sort(int column, Qt::SortOrder order) {
  if (column < 0 || column >= columnCount()) return;
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  const std::vector<std::size_t> shown = m_order;
  std::iota(m_order.begin(), m_order.end(), std::size_t{0});
  if (columnAt(column).kind == Kind::rank) {
    if (order == Qt::DescendingOrder) std::reverse(m_order.begin(), m_order.end());
  } else {
    std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
      const bool isUp = order == Qt::AscendingOrder;
      return isBefore(*m_rows[isUp ? a : b], *m_rows[isUp ? b : a], columnAt(column));
    });
  }
  QModelIndexList after;
  for (const QModelIndex& each : before) {
    const auto place = std::find(m_order.begin(), m_order.end(), shown[static_cast<std::size_t>(each.row())]);
    after << index(static_cast<int>(place - m_order.begin()), each.column());
  }
  changePersistentIndexList(before, after);
  emit layoutChanged();
}

QString ChoicesModel::textOf(const TeethChoice& choice, int row, Column column) const {
  switch (column.kind) {
    case Kind::rank:
      return rankAt(row) > 0 ? QString::number(rankAt(row)) : tr("nearest");
    case Kind::wheel:
      return (isChanged(choice, column.at) ? QStringLiteral("%1 → ").arg(problem().wheels[column.at].drawn)
                                           : QString()) +
             QString::number(choice.found.teeth[column.at]);
    case Kind::ratio:
      return withPrintedMinus(QString::fromStdString(choice.found.ratios[column.at].toString()));
    case Kind::decimal:
      return shownText(threeDecimals(choice.found.ratios[column.at]));
    case Kind::error:
      return errorText(choice.found.errors[column.at]);
    case Kind::planets:
      return planetsText(choice.planets);
    case Kind::hunting:
      return {};
    case Kind::efficiency:
      return decimalText(choice.efficiency);
    case Kind::backward:
      return decimalText(choice.backward);
  }
  return {};
}

QString ChoicesModel::tipOf(const TeethChoice& choice, Column column) const {
  if (column.kind == Kind::hunting) {
    QStringList texts;
    for (const std::size_t mesh : m_pairs) {
      const MeshTeeth& teeth = choice.teeth[mesh];
      const QString label = QString::number(problem().train.meshLabel(static_cast<int>(mesh)));
      const int factor = std::gcd(teeth.tailTeeth, teeth.headTeeth);
      texts << (choice.hunting[mesh] != 0
                    ? tr("Mesh %1: every tooth meets every other").arg(label)
                    : tr("Mesh %1: a tooth meets one in %2 of the others").arg(label).arg(factor));
    }
    return texts.join(QLatin1Char('\n'));
  }
  const auto& undercut = choice.undercut;
  const bool isUndercut =
      column.kind == Kind::wheel &&
      std::find(undercut.begin(), undercut.end(), problem().wheels[column.at].name) != undercut.end();
  if (isUndercut)
    return tr("%1: a rack undercuts it without a profile shift").arg(m_names[static_cast<int>(column.at)]);
  return column.kind == Kind::wheel ? m_names[static_cast<int>(column.at)] : QString();
}

/// From -1 at the lower end of the bounds to 1 at the upper.
QVariant ChoicesModel::placeOf(const TeethChoice& choice, std::size_t ratio) const {
  const RatioBounds& bounds = problem().ratios[ratio].bounds;
  if (rankAt(0) == 0) return {};
  if (bounds.low == bounds.high) return 0.0;
  const Rational middle = (bounds.low + bounds.high) / Rational(2);
  const Rational half = (bounds.high - bounds.low) / Rational(2);
  return ((choice.found.ratios[ratio] - middle) / half).toDouble();
}

QVariant ChoicesModel::data(const QModelIndex& index, int role) const {
  const Column column = columnAt(index.column());
  const TeethChoice& choice = choiceAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return textOf(choice, index.row(), column);
    case Qt::AccessibleTextRole:
      return column.kind == Kind::hunting ? tipOf(choice, column) : textOf(choice, index.row(), column);
    case Qt::ToolTipRole:
      return tipOf(choice, column);
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case PlaceRole:
      return column.kind == Kind::error ? placeOf(choice, column.at) : QVariant();
    case UndercutRole:
      return column.kind == Kind::wheel &&
             std::find(choice.undercut.begin(), choice.undercut.end(), problem().wheels[column.at].name) !=
                 choice.undercut.end();
    case TicksRole: {
      if (column.kind != Kind::hunting) return {};
      QVariantList ticks;
      for (const std::size_t mesh : m_pairs) ticks << (choice.hunting[mesh] != 0);
      return ticks;
    }
    case ShareRole: {
      if (column.kind != Kind::efficiency || !choice.efficiency) return {};
      return *choice.efficiency;
    }
    case StrongRole:
      if (m_result->meant && column.kind == Kind::wheel) return isChanged(choice, column.at);
      return column.kind == Kind::wheel || column.kind == Kind::ratio || column.kind == Kind::efficiency;
    case FineRole:
      return column.kind == Kind::error && choice.found.errors[column.at].isZero();
    default:
      return {};
  }
}

QString ChoicesModel::headOf(Column column) const {
  const bool isOne = problem().ratios.size() == 1;
  const auto numbered = [&](const QString& text) {
    return isOne ? text : QStringLiteral("%1 %2").arg(text).arg(column.at + 1);
  };
  switch (column.kind) {
    case Kind::rank:
      return {};
    case Kind::wheel:
      return m_marks[static_cast<int>(column.at)];
    case Kind::ratio:
      return numbered(tr("ratio"));
    case Kind::decimal:
      return numbered(tr("decimal"));
    case Kind::error:
      return numbered(tr("error"));
    case Kind::planets:
      return tr("planets");
    case Kind::hunting:
      return tr("hunting");
    case Kind::efficiency:
      return tr("η");
    case Kind::backward:
      return tr("η back");
  }
  return {};
}

QString ChoicesModel::tipOfHead(Column column) const {
  switch (column.kind) {
    case Kind::rank:
      return m_result->meant
                 ? tr("The likeliest first: the fewest teeth more or less, then the smallest error")
                 : tr("The best first: the smallest error, then the highest efficiency");
    case Kind::wheel:
      return tr("Teeth of %1").arg(m_names[static_cast<int>(column.at)]);
    case Kind::ratio:
      return tr("The ratio, exactly");
    case Kind::decimal:
      return tr("The ratio, rounded to three decimals");
    case Kind::error:
      return tr(
          "By how much of the wished ratio it is missed; the dot shows where it is within the tolerance");
    case Kind::planets:
      return tr("How many equal planets go in at equal distances and clear each other");
    case Kind::hunting:
      return tr("By pair of wheels: a hunting tooth meets all others before it meets one again");
    case Kind::efficiency:
      return tr("Efficiency of the train, of several ratios the smallest");
    case Kind::backward:
      return tr("The same with the power the other way; none: it locks itself");
  }
  return {};
}

QVariant ChoicesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section >= columnCount()) return {};
  switch (role) {
    case Qt::DisplayRole:
      return headOf(columnAt(section));
    case Qt::ToolTipRole:
      return tipOfHead(columnAt(section));
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

QString ChoicesModel::csvCell(const TeethChoice& choice, int row, Column column) const {
  const auto plain = [](const std::optional<double>& value) {
    return value ? QString::number(*value, 'g', 17) : QString();
  };
  switch (column.kind) {
    case Kind::rank:
      return QString::number(rankAt(row));
    case Kind::wheel:
      return QString::number(choice.found.teeth[column.at]);
    case Kind::ratio:
      return QString::fromStdString(choice.found.ratios[column.at].toString());
    case Kind::decimal:
      return QString::number(choice.found.ratios[column.at].toDouble(), 'g', 17);
    case Kind::error:
      return QString::fromStdString(choice.found.errors[column.at].toString());
    case Kind::planets: {
      QStringList numbers;
      for (const int each : choice.planets) numbers << QString::number(each);
      return numbers.join(QLatin1Char(' '));
    }
    case Kind::hunting: {
      QStringList labels;
      for (const std::size_t mesh : m_pairs)
        if (choice.hunting[mesh] != 0)
          labels << QString::number(problem().train.meshLabel(static_cast<int>(mesh)));
      return labels.join(QLatin1Char(' '));
    }
    case Kind::efficiency:
      return plain(choice.efficiency);
    case Kind::backward:
      return plain(choice.backward);
  }
  return {};
}

QString ChoicesModel::csv() const {
  if (!m_result) return {};
  const auto nameOf = [this](Column column) -> QString {
    const QString number = problem().ratios.size() == 1 ? QString() : QString::number(column.at + 1);
    switch (column.kind) {
      case Kind::rank:
        return QStringLiteral("choice");
      case Kind::wheel:
        return QString::fromStdString(problem().wheels[column.at].name);
      case Kind::ratio:
        return QStringLiteral("ratio") + number;
      case Kind::decimal:
        return QStringLiteral("decimal") + number;
      case Kind::error:
        return QStringLiteral("error") + number;
      case Kind::planets:
        return QStringLiteral("planets");
      case Kind::hunting:
        return QStringLiteral("hunting");
      case Kind::efficiency:
        return QStringLiteral("efficiency");
      case Kind::backward:
        return QStringLiteral("efficiencyBackward");
    }
    return {};
  };
  QStringList lines;
  QStringList cells;
  for (const Column column : m_columns) cells << nameOf(column);
  lines << cells.join(QLatin1Char(','));
  for (int row = 0; row < rowCount(); ++row) {
    cells.clear();
    for (const Column column : m_columns) cells << csvCell(choiceAt(row), row, column);
    lines << cells.join(QLatin1Char(','));
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace geargraph

#include "moc_choices_model.cpp"
