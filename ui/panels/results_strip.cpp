// The buttons above the results: what speeds are relative to, their unit, and whose joints are the inputs.

#include <QBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <numeric>

#include "core/theory/matroid/input_roles.h"
#include "ui/models/term_tips.h"
#include "ui/panels/results_panel.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxUnits = 40;   ///< entries of a menu
constexpr std::size_t kMaxChains = 12;  ///< entries of a menu, of which each takes ms of a large train

/// Shortens what a menu offers to `most` entries, what is selected first. Returns how many are left out.
template <class Item, class IsSelected>
std::size_t keepSelected(std::vector<Item>& items, std::size_t most, const IsSelected& isSelected) {
  if (items.size() <= most) return 0;
  std::stable_partition(items.begin(), items.end(), isSelected);
  const std::size_t hidden = items.size() - most;
  items.resize(most);
  return hidden;
}

int nodeOf(const Mechanism& mechanism, LinkId link) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [link](const Link& each) { return each.id == link; });
  return found == mechanism.links.end() ? -1 : static_cast<int>(found - mechanism.links.begin());
}

}  // namespace

QLayout* ResultsPanel::makeStrip() {
  auto* strip = new QHBoxLayout;
  strip->setContentsMargins(12, 6, 12, 2);
  strip->setSpacing(6);
  for (QToolButton* button : {m_frame, m_unit, m_motors}) button->setProperty("look", "control");
  m_frame->setObjectName(QStringLiteral("speedFrame"));
  m_unit->setObjectName(QStringLiteral("speedUnit"));
  m_motors->setObjectName(QStringLiteral("readMotors"));
  m_frame->setToolTip(tr("What speeds are relative to: joint by joint, or those of the links seen from one"));
  m_unit->setToolTip(tr("The unit of the speeds, or the member they are taken as ratio to"));
  m_motors->setText(tr("Drive by a link’s joints ▾"));
  m_motors->setToolTip(
      tr("Make the joints that carry a link the inputs: their speeds are set, those of the "
         "motors become results"));
  for (QToolButton* button : {m_frame, m_unit, m_motors}) {
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    button->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu, button] {
      menu->clear();
      if (button == m_frame) fillFrames(*menu);
      if (button == m_unit) fillUnits(*menu);
      if (button == m_motors) fillMotors(*menu);
    });
  }
  strip->addWidget(m_frame);
  strip->addWidget(m_unit);
  strip->addStretch(1);
  strip->addWidget(m_motors);
  setAbsolute(false);
  setUnit({});
  return strip;
}

void ResultsPanel::setNames(const MechanismPtr& newest) {
  const MechanismPtr before = std::exchange(m_newest, newest);
  if (before && before->links == newest->links) return;  // a drag renames nothing
  m_names.setNewest(newest);
  m_model->setNames(newest);
  m_linkModel->setNames(newest);
  updateFrame();
  renew();
}

void ResultsPanel::setAbsolute(bool absolute) {
  m_observer.reset();
  showLinkSpeeds(absolute);
}

void ResultsPanel::setObserver(LinkId observer) {
  m_observer = observer;
  showLinkSpeeds(true);
}

void ResultsPanel::showLinkSpeeds(bool shown) {
  m_absolute = shown;
  m_linkModel->setObserver(m_observer);
  if (shown) m_linkModel->setSnapshot(m_snapshot);
  updateFrame();
  renew();
}

void ResultsPanel::updateFrame() {
  QString text = tr("joint by joint");
  if (m_absolute) text = tr("relative to the ground");
  if (m_absolute && m_observer && m_snapshot) {
    const int node = nodeOf(*m_snapshot->mechanism, *m_observer);
    if (node > 0) text = tr("relative to %1").arg(linkText(QString::number(node), m_names.nameOf(node)));
  }
  m_frame->setText(text + QStringLiteral(" ▾"));
}

void ResultsPanel::fillFrames(QMenu& menu) {
  menu.addAction(tr("Joint by joint: each link relative to the one that carries it"), this,
                 [this] { setAbsolute(false); });
  menu.addAction(tr("Relative to the ground"), this, [this] { setAbsolute(true); });
  if (!m_snapshot || m_snapshot->matroid() == nullptr) return;
  menu.addSeparator();
  std::vector<int> links(static_cast<std::size_t>(m_snapshot->mechanism->n()));
  std::iota(links.begin(), links.end(), 1);
  const auto hidden = keepSelected(
      links, kMaxUnits, [&](int link) { return m_selection->isSelected(m_snapshot->graph->nodeId(link)); });
  for (const int link : links) {
    const LinkId id = m_snapshot->mechanism->links[static_cast<std::size_t>(link)].id;
    menu.addAction(tr("Relative to %1").arg(linkText(QString::number(link), m_names.nameOf(link))), this,
                   [this, id] { setObserver(id); });
  }
  if (hidden > 0) {
    menu.addAction(tr("%1 more links: select one to find it here").arg(hidden))->setEnabled(false);
  }
}

void ResultsPanel::setUnit(const SpeedUnit& unit) {
  m_model->setUnit(unit);
  m_linkModel->setUnit(unit);
  m_unitShown = unit;
  showUnit();
  renew();
}

/// Beside the unit of what turns that of what slides, where something does.
void ResultsPanel::showUnit() {
  const SpeedUnit& unit = m_unitShown;
  QString text = unit.kind == SpeedUnit::Kind::rpm ? tr("rpm") : tr("rad/s");
  if (unit.kind == SpeedUnit::Kind::ratio && m_snapshot) {
    text = tr("ratio to %1").arg(shownText(labelOf(*m_snapshot->mechanism, unit.reference).value_or("?")));
  } else if (m_snapshot && hasSlides(*m_snapshot->mechanism)) {
    text += QStringLiteral(", ") + unitOfRate(*m_snapshot->mechanism, true);
  }
  text += QStringLiteral(" ▾");
  if (text != m_unit->text()) m_unit->setText(text);
}

void ResultsPanel::fillUnits(QMenu& menu) {
  menu.addAction(tr("rad/s"), this, [this] { setUnit({}); });
  menu.addAction(tr("rpm, turns a minute"), this, [this] { setUnit({SpeedUnit::Kind::rpm, {}}); });
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (matroid == nullptr || !matroid->solution) return;
  menu.addSeparator();
  const Mechanism& mechanism = *m_snapshot->mechanism;
  std::vector<std::size_t> turning;
  for (std::size_t joint = 0; joint < mechanism.turningJoints.size(); ++joint) {
    if (matroid->solution->rates[joint] != 0) turning.push_back(joint);
  }
  const auto hidden = keepSelected(turning, kMaxUnits, [&](std::size_t joint) {
    return m_selection->isSelected(mechanism.turningJoints[joint].id);
  });
  for (const std::size_t joint : turning) {
    const JointId id = mechanism.turningJoints[joint].id;
    const int link = m_snapshot->kinematics->placement().tree->child[joint];
    menu.addAction(tr("Ratio to joint %1, %2")
                       .arg(QString::number(mechanism.jointLabel(static_cast<int>(joint))),
                            linkText(QString::number(link), m_names.nameOf(link))),
                   this, [this, id] {
                     setUnit({SpeedUnit::Kind::ratio, id});
                   });
  }
  if (hidden > 0) {
    menu.addAction(tr("%1 more joints: select one to find it here").arg(hidden))->setEnabled(false);
  }
}

/// For every link that carries no other: its chain of joints as inputs, where that is a valid choice.
void ResultsPanel::fillMotors(QMenu& menu) {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (matroid == nullptr || !matroid->solution) {
    menu.addAction(tr("Nothing is solved yet"))->setEnabled(false);
    return;
  }
  const SpanningTree& tree = *m_snapshot->tree;
  std::vector<char> carries(static_cast<std::size_t>(m_snapshot->graph->n()) + 1, 0);
  for (int link = 1; link <= m_snapshot->graph->n(); ++link)
    carries[static_cast<std::size_t>(tree.parent(link))] = 1;
  std::vector<int> ends;
  for (int link = 1; link <= m_snapshot->graph->n(); ++link) {
    if (carries[static_cast<std::size_t>(link)] == 0 && tree.parent(link) != 0) ends.push_back(link);
  }
  const auto hidden = keepSelected(
      ends, kMaxChains, [&](int link) { return m_selection->isSelected(m_snapshot->graph->nodeId(link)); });
  const InputCompletion completion(*m_snapshot->kinematics->model);
  for (const int link : ends) {
    const std::vector<int> chain = chainTo(tree, link);
    QStringList labels;
    for (const int joint : chain) labels << QString::number(m_snapshot->graph->edgeLabel(joint));
    const auto inputs = completion.with(chain, matroid->choice.joints);
    QString text =
        tr("Joints of %1: %2")
            .arg(linkText(QString::number(link), m_names.nameOf(link)), labels.join(QStringLiteral(", ")));
    if (!inputs) text += tr(" (they are not independent)");
    QAction* action = menu.addAction(text);
    action->setEnabled(inputs.has_value());
    if (inputs)
      connect(action, &QAction::triggered, this, [this, joints = *inputs] { emit inputsWanted(joints); });
  }
  if (hidden > 0) {
    menu.addAction(tr("%1 more links: select one to find it here").arg(hidden))->setEnabled(false);
  }
  if (menu.isEmpty()) menu.addAction(tr("Every link turns on the ground"))->setEnabled(false);
}

}  // namespace geargraph
