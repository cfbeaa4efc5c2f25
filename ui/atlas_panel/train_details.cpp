#include "ui/atlas_panel/train_details.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/atlas_panel/chain_picture.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kListHeight = 170;

/// "0–1 0–2": pairs of the train's labels.
QString pairsLabel(const Mechanism& mechanism, const std::vector<TurningPair>& pairs) {
  QStringList texts;
  for (const auto& [first, second] : pairs)
    texts << QStringLiteral("%1–%2").arg(mechanism.linkLabel(first)).arg(mechanism.linkLabel(second));
  return texts.isEmpty() ? TrainDetails::tr("none") : texts.join(QStringLiteral("  "));
}

/// Both links of each pair, and the joints that are drawn between them.
std::set<ElementId> elementsOf(const Mechanism& mechanism, const std::vector<TurningPair>& pairs) {
  std::set<ElementId> elements;
  for (const auto& [first, second] : pairs) {
    const LinkId one = mechanism.links[first].id;
    const LinkId other = mechanism.links[second].id;
    elements.insert({one, other});
    for (const TurningJoint& joint : mechanism.turningJoints)
      if ((joint.tail == one && joint.head == other) || (joint.tail == other && joint.head == one))
        elements.insert(joint.id);
  }
  return elements;
}

}  // namespace

TrainDetails::TrainDetails(QWidget* parent)
    : QWidget(parent),
      m_ask(new QPushButton(tr("Trees, inputs and frames"), this)),
      m_choices(makeList(QStringLiteral("choicesList"), tr("Trees, inputs and frames"), 1)),
      m_compare(new QPushButton(tr("Compare with…"), this)),
      m_verdict(new QLabel(this)),
      m_own(new ChainPicture(this)),
      m_other(new ChainPicture(this)),
      m_match(makeList(QStringLiteral("matchList"), tr("Which link is which"), 2)) {
  m_ask->setObjectName(QStringLiteral("askChoices"));
  m_ask->setCheckable(true);
  m_ask->setToolTip(
      tr("Lists all trees of turning joints, valid sets of inputs and frames with which your train can be "
         "drawn"));
  m_compare->setObjectName(QStringLiteral("compareTrains"));
  m_compare->setToolTip(tr("Is the train of another document the same chain, and which link is which?"));
  m_verdict->setObjectName(QStringLiteral("comparison"));
  m_verdict->setWordWrap(true);
  m_verdict->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  m_own->setObjectName(QStringLiteral("ownChain"));
  m_other->setObjectName(QStringLiteral("otherChain"));
  m_match->setHeaderLabels({tr("your train"), tr("the other one")});
  m_match->setHeaderHidden(false);
  m_match->header()->setSectionResizeMode(QHeaderView::Stretch);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  for (QWidget* each :
       std::initializer_list<QWidget*>{m_ask, m_choices, m_compare, m_verdict, m_own, m_other, m_match})
    layout->addWidget(each);
  for (QWidget* each : std::initializer_list<QWidget*>{m_choices, m_verdict, m_own, m_other, m_match})
    each->hide();
  connect(m_ask, &QPushButton::toggled, this, [this](bool isAsked) {
    m_choices->setVisible(isAsked);
    if (isAsked) emit choicesWanted();
  });
  connect(m_compare, &QPushButton::clicked, this, &TrainDetails::chooseOther);
  setTrain(nullptr);
}

QTreeWidget* TrainDetails::makeList(const QString& name, const QString& title, int columns) {
  auto* list = new QTreeWidget(this);
  list->setObjectName(name);
  list->setAccessibleName(title);
  list->setColumnCount(columns);
  list->setHeaderHidden(true);
  list->setFixedHeight(scaledPixels(kListHeight));
  list->setTabKeyNavigation(false);
  connect(list, &QTreeWidget::currentItemChanged, this,
          [this](const QTreeWidgetItem* item) { showOne(item); });
  return list;
}

bool TrainDetails::isIdentified() const {
  return m_train && m_train->identity && m_train->drawn && !m_train->identity->parts.empty();
}

void TrainDetails::setTrain(const TrainAnswerPtr& train) {
  if (train == m_train && m_train) return;
  m_train = train;
  const bool canAsk = isIdentified();
  m_ask->setEnabled(canAsk);
  m_compare->setEnabled(canAsk);
  clearRows(*m_choices);
  if (!canAsk) return;
  if (m_ask->isChecked()) emit choicesWanted();
  if (!m_path.isEmpty()) emit comparisonWanted(m_path);
}

// --- rows -------------------------------------------------------------------------------------------------

QTreeWidgetItem* TrainDetails::addRow(QTreeWidget& list, QTreeWidgetItem* above, const QStringList& texts,
                                      std::set<ElementId> elements) {
  auto* row = above == nullptr ? new QTreeWidgetItem(&list, texts) : new QTreeWidgetItem(above, texts);
  if (!elements.empty()) m_elements[row] = std::move(elements);
  return row;
}

void TrainDetails::clearRows(QTreeWidget& list) {
  std::erase_if(m_elements, [&](const auto& each) { return each.first->treeWidget() == &list; });
  list.clear();
}

void TrainDetails::showOne(const QTreeWidgetItem* item) {
  if (const auto found = m_elements.find(item); found != m_elements.end()) emit showWanted(found->second);
}

// --- trees, inputs, frames --------------------------------------------------------------------------------

void TrainDetails::setChoices(const TrainChoicesPtr& choices) {
  if (choices->train != m_train) return;
  clearRows(*m_choices);
  if (!choices->choices) {
    addRow(*m_choices, nullptr,
           {tr("There are more than %1 sets of inputs to try; they are not listed.").arg(kMaxInputTrials)});
    return;
  }
  const ChainChoices& found = *choices->choices;
  const auto listed = [](const auto& sets) { return static_cast<std::int64_t>(sets.size()); };
  fillPairs(tr("Trees of turning joints: %1")
                .arg(found.treeCount ? locale().toString(static_cast<qlonglong>(*found.treeCount))
                                     : tr("over 2^63")),
            found.trees, found.treeCount == listed(found.trees));
  fillPairs(
      tr("Valid sets of inputs: %1").arg(locale().toString(static_cast<qlonglong>(found.inputSetCount))),
      found.inputSets, found.inputSetCount == listed(found.inputSets));
  const Mechanism& mechanism = *m_train->mechanism;
  auto* frames =
      addRow(*m_choices, nullptr, {tr("Links that differ as the frame: %1").arg(found.frames.size())});
  for (const std::vector<int>& equal : found.frames) {
    QStringList labels;
    std::set<ElementId> links;
    for (const int link : equal) {
      labels << QString::number(mechanism.linkLabel(link));
      links.insert(mechanism.links[link].id);
    }
    addRow(*m_choices, frames, {labels.join(QStringLiteral(", "))}, std::move(links));
  }
}

void TrainDetails::fillPairs(const QString& title, const std::vector<std::vector<TurningPair>>& sets,
                             bool areAll) {
  const Mechanism& mechanism = *m_train->mechanism;
  auto* head = addRow(*m_choices, nullptr, {title});
  for (const std::vector<TurningPair>& set : sets)
    addRow(*m_choices, head, {pairsLabel(mechanism, set)}, elementsOf(mechanism, set));
  if (!areAll) addRow(*m_choices, head, {QStringLiteral("…")});
}

// --- another document -------------------------------------------------------------------------------------

void TrainDetails::chooseOther() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Compare with…"), m_path,
                                                    tr("GearGraph documents (*.geargraph)"));
  if (!path.isEmpty()) compareWith(path);
}

void TrainDetails::compareWith(const QString& path) {
  m_path = path;
  if (isIdentified()) emit comparisonWanted(path);
}

void TrainDetails::setComparison(const TrainComparisonPtr& comparison) {
  if (comparison->train != m_train) return;
  const QString name = QFileInfo(m_path).completeBaseName();
  const bool isSame = comparison->same.has_value();
  if (!comparison->why.empty()) {
    m_verdict->setText(tr("%1: %2").arg(name, shownText(comparison->why)));
  } else if (!isSame) {
    m_verdict->setText(tr("%1 is a different chain.").arg(name));
  } else {
    m_verdict->setText(comparison->same->likeness == ChainLikeness::displacement
                           ? tr("%1 is the same chain.").arg(name)
                           : tr("%1 has the same equations, on other shafts.").arg(name));
  }
  m_verdict->show();
  for (QWidget* each : std::initializer_list<QWidget*>{m_own, m_other, m_match}) each->setVisible(isSame);
  clearRows(*m_match);
  if (!isSame) return;
  showPictures(*comparison);
  fillMatch(*comparison);
}

void TrainDetails::fillMatch(const TrainComparison& comparison) {
  const Mechanism& own = *m_train->mechanism;
  const Mechanism& other = *comparison.other;
  for (const auto& [one, same] : comparison.same->links)
    addRow(*m_match, nullptr,
           {tr("link %1").arg(own.linkLabel(one)), tr("link %1").arg(other.linkLabel(same))},
           {own.links[one].id});
  for (const auto& [one, same] : comparison.same->meshes)
    addRow(*m_match, nullptr,
           {tr("mesh %1").arg(own.meshLabel(one)), tr("mesh %1").arg(other.meshLabel(same))},
           {own.gearMeshes[one].id});
}

/// Links that are the same have one colour; of the same chain both pictures are one drawing.
void TrainDetails::showPictures(const TrainComparison& comparison) {
  const TrainIdentity& own = *m_train->identity;
  const TrainIdentity& other = comparison.identity;
  const Mechanism& mechanism = *m_train->mechanism;
  std::map<int, int> otherOf(comparison.same->links.begin(), comparison.same->links.end());
  std::map<int, int> ownOf;
  for (const auto& [one, same] : otherOf) ownOf[same] = one;
  ChainDrawingStyle ownStyle, otherStyle;
  for (const int link : own.links) {
    ownStyle.labels.push_back(mechanism.linkLabel(link));
    ownStyle.colors.push_back(mechanism.colorNumber(link));
  }
  const bool isOneDrawing = comparison.same->likeness == ChainLikeness::displacement;
  for (const int link : isOneDrawing ? own.links : other.links) {
    const int one = isOneDrawing ? link : ownOf.at(link);
    otherStyle.labels.push_back(comparison.other->linkLabel(isOneDrawing ? otherOf.at(link) : link));
    otherStyle.colors.push_back(mechanism.colorNumber(one));
  }
  m_own->setDrawing(chainDrawing(own.chain, ownStyle), tr("Digraph of your train"));
  m_other->setDrawing(chainDrawing(isOneDrawing ? own.chain : other.chain, otherStyle),
                      tr("Digraph of the other train, with the colours of your links"));
}

}  // namespace geargraph

#include "moc_train_details.cpp"
