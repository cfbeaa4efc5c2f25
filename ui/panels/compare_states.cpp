#include "ui/panels/compare_states.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QStandardItemModel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/models/printed_number.h"
#include "ui/models/states_model.h"
#include "ui/models/term_tips.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/frozen_column.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kMaxRates = 200;  ///< joints that are listed
constexpr int kValueHeight = 22;

QString engagedText(const Mechanism& mechanism, int state) {
  QStringList names;
  for (const ShiftElementId& each : mechanism.states[static_cast<std::size_t>(state)].engaged)
    names += shownText(each.text());
  return names.isEmpty() ? QStringLiteral("–") : names.join(QLatin1Char(' '));
}

QString rateText(const StateSolution* solution, JointOrdinal joint) {
  if (solution == nullptr || !solution->isSolved()) return QStringLiteral("–");
  if (solution->isIdle(joint)) return CompareStates::tr("free");
  return printedFraction(solution->rates[joint]);
}

}  // namespace

CompareStates::CompareStates(StatesModel* states, QWidget* parent)
    : QWidget(parent),
      m_states(states),
      m_one(new QComboBox(this)),
      m_other(new QComboBox(this)),
      m_values(new QStandardItemModel(this)),
      m_table(new QTableView(this)) {
  auto* choices = new QWidget(this);
  auto* flow = new FlowLayout(choices);
  flow->setContentsMargins(16, 4, 12, 2);
  flow->setSpacing(6);
  flow->addWidget(m_one);
  auto* with = new QLabel(tr("beside"), choices);
  with->setProperty("look", "hint");
  flow->addWidget(with);
  flow->addWidget(m_other);
  m_one->setObjectName(QStringLiteral("oneState"));
  m_other->setObjectName(QStringLiteral("otherState"));
  for (QComboBox* choice : {m_one, m_other}) {
    choice->setAccessibleName(tr("State that is compared"));
    choice->setToolTip(tr("A state of the gearbox that is compared with the other one"));
    connect(choice, &QComboBox::activated, this, &CompareStates::renew);
  }
  m_table->setObjectName(QStringLiteral("comparedStates"));
  m_table->setAccessibleName(tr("Two states side by side"));
  m_table->setModel(m_values);
  m_table->setTabKeyNavigation(false);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setShowGrid(false);
  m_table->setWordWrap(false);
  m_table->setFrameShape(QFrame::NoFrame);
  m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->verticalHeader()->hide();
  m_table->horizontalHeader()->setHighlightSections(false);
  new FrozenColumn(m_table);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(choices);
  layout->addWidget(m_table, 1);
  const auto follow = [this] {
    if (isVisible()) renew();
  };
  connect(states, &QAbstractItemModel::modelReset, this, follow);
  connect(states, &StatesModel::computed, this, follow);
}

void CompareStates::compare(int one, int other) {
  fillChoices();
  m_one->setCurrentIndex(one);
  m_other->setCurrentIndex(other);
  renew();
}

void CompareStates::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  renew();
}

void CompareStates::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

/// The states that were chosen stay by their rows; at first the first two.
void CompareStates::fillChoices() {
  QStringList names;
  for (int row = 0; row < m_states->rowCount(); ++row)
    names += tr("state %1").arg(m_states->index(row, 0).data().toString());
  int usual = 0;
  for (QComboBox* choice : {m_one, m_other}) {
    QStringList there;
    for (int i = 0; i < choice->count(); ++i) there += choice->itemText(i);
    const int at = choice->currentIndex() < 0 ? usual : choice->currentIndex();
    ++usual;
    if (there == names) continue;
    choice->clear();
    choice->addItems(names);
    choice->setCurrentIndex(std::min(at, static_cast<int>(names.size()) - 1));
  }
}

void CompareStates::addRow(const QString& name, const QString& one, const QString& other,
                           const QString& tip) {
  QList<QStandardItem*> row{new QStandardItem(name), new QStandardItem(one), new QStandardItem(other)};
  QFont font;
  font.setBold(one != other);
  for (QStandardItem* item : row) {
    item->setEditable(false);
    if (!tip.isEmpty()) item->setToolTip(tip);
  }
  for (QStandardItem* item : {row[1], row[2]}) {
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setFont(font);
  }
  m_values->appendRow(row);
}

void CompareStates::addColumn(int column, const QString& name) {
  const auto text = [&](const QComboBox& state) {
    const QString value = m_states->index(state.currentIndex(), column).data().toString();
    return value.isEmpty() ? QStringLiteral("–") : value;
  };
  addRow(name, text(*m_one), text(*m_other),
         m_states->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString());
}

void CompareStates::addRates() {
  const Mechanism& mechanism = *m_states->mechanism();
  const StateSolution* one = m_states->solutionAt(m_one->currentIndex());
  const StateSolution* other = m_states->solutionAt(m_other->currentIndex());
  for (JointOrdinal joint = 0; joint < std::min(mechanism.t(), kMaxRates); ++joint) {
    const LinkId head = mechanism.turningJoints[static_cast<std::size_t>(joint)].head;
    const QString link = shownText(labelOf(mechanism, head).value_or(head.text()));
    addRow(tr("speed in joint %1, link %2").arg(mechanism.jointLabel(joint)).arg(link), rateText(one, joint),
           rateText(other, joint), tr("How fast the head turns against the tail, for 1 at the drive"));
  }
}

void CompareStates::renew() {
  fillChoices();
  m_values->clear();
  if (m_one->currentIndex() < 0 || m_other->currentIndex() < 0) return;
  m_values->setHorizontalHeaderLabels({tr("value"), m_one->currentText(), m_other->currentText()});
  const Mechanism& mechanism = *m_states->mechanism();
  addRow(tr("engaged"), engagedText(mechanism, m_one->currentIndex()),
         engagedText(mechanism, m_other->currentIndex()));
  const int couplings = m_states->couplingCount();
  for (int column = couplings + 1; column < m_states->columnCount(); ++column)
    if (!m_states->isTail(column, StatesModel::Tail::step))
      addColumn(column, m_states->headerData(column, Qt::Horizontal).toString());
  const StateSolution* one = m_states->solutionAt(m_one->currentIndex());
  const StateSolution* other = m_states->solutionAt(m_other->currentIndex());
  if (const auto step = one != nullptr && other != nullptr ? stepBetween(*one, *other) : std::nullopt)
    addRow(tr("step"), QStringLiteral("1"), printedNumber(step->toDouble(), 3, 'f'),
           tr("The ratio of the one state over that of the other"));
  for (int coupling = 0; coupling < couplings; ++coupling)
    addColumn(1 + coupling, tr("%1, N m").arg(m_states->headerData(1 + coupling, Qt::Horizontal).toString()));
  addRates();
  fit();
}

void CompareStates::fit() {
  m_table->verticalHeader()->setMinimumSectionSize(scaledPixels(kValueHeight));
  m_table->verticalHeader()->setDefaultSectionSize(scaledPixels(kValueHeight));
  m_table->resizeColumnsToContents();
}

}  // namespace geargraph

#include "moc_compare_states.cpp"
