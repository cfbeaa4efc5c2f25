#include "ui/forces/why_page.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <algorithm>

#include "ui/forces/duality_line.h"
#include "ui/forces/explanation_label.h"
#include "ui/forces/folding_section.h"
#include "ui/models/term_tips.h"
#include "ui/theme/looks.h"
#include "ui/theme/sideways_scroll.h"

namespace geargraph {
namespace {

constexpr int kMaxListed = 400;  ///< joints and meshes each: nobody reads a longer list

QString linkTitle(const Mechanism& mechanism, LinkOrdinal link) {
  const QString label = QString::number(mechanism.linkLabel(link));
  const QString name = shownText(mechanism.links[static_cast<std::size_t>(link)].name);
  return name.isEmpty() || name == label ? label : label + QLatin1Char(' ') + name;
}

}  // namespace

WhyPage::WhyPage(Selection* selection, QLayout& controls, QWidget* owner)
    : QScrollArea(owner),
      m_selection(selection),
      m_elements(new QComboBox(owner)),
      m_verdict(new QLabel(owner)),
      m_explanation(new ExplanationLabel(selection, this)),
      m_hint(new QLabel(tr("Choose a joint or a mesh in the list above, in a table or in a drawing."), this)),
      m_duality(new DualityLine(selection, this)) {
  m_elements->setObjectName(QStringLiteral("whyElement"));
  m_elements->setAccessibleName(tr("Joint or mesh that is explained"));
  m_elements->setToolTip(tr("The joint or the mesh whose torque is explained; it is selected in all views"));
  m_elements->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(m_elements, &QComboBox::activated, this, [this](int at) {
    at > 0 ? m_selection->select({m_listed[static_cast<std::size_t>(at) - 1]}) : m_selection->clear();
  });
  connect(selection, &Selection::selectionChanged, this, &WhyPage::followSelection);
  m_verdict->setProperty("look", "hint");
  m_verdict->setToolTip(
      tr("All torques are found twice, by the cutsets of the Matroid method and by those of the T–T graph."));
  controls.addWidget(m_elements);
  controls.addWidget(m_verdict);

  m_hint->setProperty("look", "hint");
  m_hint->setWordWrap(true);
  m_hint->setContentsMargins(12, 0, 12, 4);
  auto* cutset = new QWidget(this);
  auto* words = new QVBoxLayout(cutset);
  words->setContentsMargins(0, 0, 0, 0);
  words->addWidget(m_explanation);
  words->addWidget(m_hint);
  connect(m_explanation, &ExplanationLabel::filled, m_hint, &QWidget::setHidden);

  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 2, 0, 4);
  layout->setSpacing(6);
  layout->addWidget(new FoldingSection(
      QStringLiteral("foldCutset"), tr("The cutset: which torques balance"),
      tr("A joint cuts off links from the ground: all torques that cross add up to 0. Of a mesh: which gear "
         "drives."),
      cutset, page));
  layout->addWidget(new FoldingSection(
      QStringLiteral("foldRow"), tr("The row of speeds and its column of torques"),
      tr("A row of P holds the speeds of a mesh, a column the torque in a joint; one entry is in both."),
      new SidewaysScroll(m_duality, page), page));
  layout->addStretch(1);
  setWidget(page);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);  // what is in it has
}

void WhyPage::setShown(bool isShown) {
  for (QWidget* control : {static_cast<QWidget*>(m_elements), static_cast<QWidget*>(m_verdict)})
    control->setVisible(isShown);
}

void WhyPage::setAwake(bool awake) {
  m_explanation->setAwake(awake);
}

void WhyPage::show(const ForcesPtr& forces) {
  fillElements(forces);
  m_duality->show(forces);
  m_explanation->show(forces);
  showVerdict(forces);
}

void WhyPage::fillElements(const ForcesPtr& forces) {
  QStringList titles{tr("choose a joint or a mesh")};
  std::vector<ElementId> listed;
  if (forces && forces->report) {
    const Mechanism& mechanism = *forces->solved->mechanism;
    const Placement& placement = forces->solved->kinematics->placement();
    const KinematicModel& model = *forces->solved->kinematics->model;
    for (JointOrdinal joint = 0; joint < std::min(mechanism.t(), kMaxListed); ++joint) {
      titles += tr("joint %1: %2")
                    .arg(mechanism.jointLabel(joint))
                    .arg(linkTitle(mechanism, model.tree().child(joint)));
      listed.emplace_back(mechanism.turningJoints[static_cast<std::size_t>(joint)].id);
    }
    for (MeshOrdinal mesh = 0; mesh < std::min(mechanism.c(), kMaxListed); ++mesh) {
      const MeshGeometry& geometry = *placement.meshes[static_cast<std::size_t>(mesh)];
      titles += tr("mesh %1: %2, %3")
                    .arg(mechanism.meshLabel(mesh))
                    .arg(linkTitle(mechanism, geometry.tail), linkTitle(mechanism, geometry.head));
      listed.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
    }
  }
  m_listed = std::move(listed);
  if (titles != m_titles) {
    m_elements->clear();
    m_elements->addItems(titles);
    m_titles = titles;
  }
  m_elements->setEnabled(!m_listed.empty());
  followSelection();
}

/// The first one of several: a row of a table selects a joint with its links.
void WhyPage::followSelection() {
  const auto at = std::find_if(m_listed.begin(), m_listed.end(),
                               [this](const ElementId& each) { return m_selection->isSelected(each); });
  m_elements->setCurrentIndex(at == m_listed.end() ? 0 : static_cast<int>(at - m_listed.begin()) + 1);
}

void WhyPage::showVerdict(const ForcesPtr& forces) {
  m_verdict->clear();
  if (!forces || !forces->report || !forces->report->agreement) return;
  const bool isEqual = forces->report->agreement->equal;
  m_verdict->setText(isEqual ? tr("both methods agree") : tr("The two methods do not agree"));
  setInk(*m_verdict, isEqual ? ColorRole::fine : ColorRole::error);
}

}  // namespace geargraph

#include "moc_why_page.cpp"
