#include "ui/lever_views/levers_bar.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "ui/theme/folding_bar.h"

namespace geargraph {

LeversBar::LeversBar(QWidget* parent)
    : QWidget(parent),
      m_pages(new QButtonGroup(this)),
      m_arrows(new QWidget(this)),
      m_speeds(new QCheckBox(tr("Speeds"), m_arrows)),
      m_torques(new QCheckBox(tr("Torques"), m_arrows)) {
  setObjectName(QStringLiteral("drawingBar"));
  auto* switches = new QWidget(this);
  auto* row = new QHBoxLayout(switches);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  const auto add = [&](LeversPage page, const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton(switches);
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setProperty("look", "chip");
    button->setChecked(page == LeversPage::levers);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
    m_pages->addButton(button, static_cast<int>(page));
  };
  add(LeversPage::levers, "leversPage", tr("Levers"),
      tr("Each gear set as a lever, its links at their places"));
  add(LeversPage::nomogram, "nomogramPage", tr("Nomogram"),
      tr("The states of the gearbox as lines across the speeds of its links"));
  add(LeversPage::plan, "planPage", tr("Plan"),
      tr("The plane of the links that is left when the coupling engaged last is let go"));
  add(LeversPage::speedPlan, "speedPlanPage", tr("Speed plan"),
      tr("Kutzbach's plan beside the section: peripheral velocities over the radius, a line for each link"));
  row->addStretch();
  auto* boxes = new QHBoxLayout(m_arrows);
  boxes->setContentsMargins(0, 0, 0, 0);
  boxes->setSpacing(14);
  boxes->addStretch();
  m_speeds->setObjectName(QStringLiteral("leverSpeeds"));
  m_speeds->setToolTip(tr("Arrows to the right of the bars: how fast each link turns"));
  m_torques->setObjectName(QStringLiteral("leverTorques"));
  m_torques->setToolTip(
      tr("Arrows to the left of the bars: the torques of the links on the lever, which add up to zero"));
  for (QCheckBox* box : {m_speeds, m_torques}) {
    box->setChecked(true);
    box->setFocusPolicy(Qt::TabFocus);
    boxes->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &LeversBar::arrowsChosen);
  }
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 4);
  all->addWidget(new FoldingBar(switches, m_arrows, this));
  connect(m_pages, &QButtonGroup::idToggled, this, [this](int page, bool isChosen) {
    if (!isChosen) return;
    m_arrows->setVisible(static_cast<LeversPage>(page) == LeversPage::levers);
    emit pageChosen(static_cast<LeversPage>(page));
  });
}

LeversPage LeversBar::page() const {
  return static_cast<LeversPage>(m_pages->checkedId());
}

void LeversBar::setPage(LeversPage page) {
  m_pages->button(static_cast<int>(page))->setChecked(true);
}

bool LeversBar::showsSpeeds() const {
  return m_speeds->isChecked();
}

bool LeversBar::showsTorques() const {
  return m_torques->isChecked();
}

/// As the sheet below it.
void LeversBar::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), palette().color(QPalette::Base));
}

}  // namespace geargraph

#include "moc_levers_bar.cpp"
