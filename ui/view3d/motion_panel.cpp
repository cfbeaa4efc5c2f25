#include "ui/view3d/motion_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/view3d/motion_plot.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/views.h"

namespace geargraph {
namespace {

constexpr double kSpanWithoutPeriod = 60;  // s
constexpr int kSheets = 3;                 // at most: what turns, what slides, traced points

}  // namespace

MotionPanel::MotionPanel(Selection* selection, View3D* view, QWidget* parent)
    : QWidget(parent),
      m_selection(selection),
      m_view(view),
      m_empty(new QLabel(this)),
      m_components(new QCheckBox(tr("x, y, z"), this)),
      m_save(new QToolButton(this)),
      m_worker([this](const Request& request, const std::stop_token& stop) {
        auto sheets = motionCurves(*request.stage, request.view, request.choice, stop);
        if (stop.stop_requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, sheets = std::move(sheets), number = request.number]() mutable {
              arrived(std::move(sheets), number);
            },
            Qt::QueuedConnection);
      }) {
  m_components->setToolTip(tr("Coordinates beside the magnitudes of links and points"));
  m_save->setText(tr("CSV…"));
  m_save->setToolTip(tr("Save what is plotted as CSV"));
  m_save->setAutoRaise(true);
  auto* hint = new QLabel(tr("Select joints or links; trace points in the 3D view."), this);
  hint->setProperty("look", "hint");
  hint->setWordWrap(true);
  m_empty->setProperty("look", "empty");
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->hide();  // until it is known that there is nothing
  m_empty->setText(tr("Nothing moves yet: the speeds appear here when the mechanism has valid inputs."));
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 2, 8, 2);
  row->addWidget(hint, 1);
  row->addWidget(m_components);
  row->addWidget(m_save);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addLayout(row);
  whole->addWidget(m_empty, 1);
  auto* sheets = new QHBoxLayout;
  sheets->setContentsMargins(0, 0, 0, 0);
  sheets->setSpacing(1);
  whole->addLayout(sheets, 1);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  for (int i = 0; i < kSheets; ++i) {
    auto* plot = new MotionPlot(this);
    plot->setObjectName(QStringLiteral("motionPlot%1").arg(i));
    plot->hide();
    sheets->addWidget(plot, 1);
    m_plots.push_back(plot);
    connect(plot, &MotionPlot::timeWanted, &view->playback(), &Playback::setTime);
    connect(&view->playback(), &Playback::timeChanged, plot, &MotionPlot::setTime);
  }
  connect(selection, &Selection::selectionChanged, this, &MotionPanel::updateIfSeen);
  connect(view, &View3D::contentChanged, this, &MotionPanel::updateIfSeen);
  connect(m_components, &QCheckBox::toggled, this, &MotionPanel::updateIfSeen);
  connect(m_save, &QToolButton::clicked, this, &MotionPanel::fileWanted);
}

void MotionPanel::setComponents(bool shown) {
  m_components->setChecked(shown);
}

void MotionPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  renew();
}

void MotionPanel::updateIfSeen() {
  if (isVisible()) renew();
}

void MotionPanel::renew() {
  const MechanismScenePtr& stage = m_view->stage();
  ++m_wanted;
  if (stage == nullptr) return arrived({}, m_wanted);
  const InputTrajectory* const along = trajectoryOf(*stage, m_view->view());
  const double round = along != nullptr ? along->seconds() : stage->period;
  const double span = round > 0 ? round : kSpanWithoutPeriod;
  m_worker.request(
      {stage, m_view->view(), {m_selection->selected(), m_components->isChecked(), span}, m_wanted});
}

void MotionPanel::arrived(std::vector<CurveSheet> sheets, quint64 number) {
  if (number <= m_shown) return;  // superseded
  m_shown = number;
  m_sheets = std::move(sheets);
  showSheets();
  m_empty->setVisible(m_sheets.empty());
  m_save->setEnabled(!m_sheets.empty());
}

void MotionPanel::showSheets() {
  for (std::size_t i = 0; i < m_plots.size(); ++i) {
    const bool isThere = i < m_sheets.size();
    m_plots[i]->setVisible(isThere);
    if (isThere) m_plots[i]->setSheet(withNames(m_sheets[i]));
    m_plots[i]->setTime(m_view->playback().time());
  }
}

void MotionPanel::setMechanism(const MechanismPtr& newest) {
  const bool isOther = !m_names || m_names->links != newest->links;
  m_names = newest;
  if (isOther && !m_sheets.empty()) showSheets();
}

CurveSheet MotionPanel::withNames(CurveSheet sheet) const {
  const auto nameOf = [this](const ElementId& element) -> std::string {
    const Link* link = nullptr;
    if (element.kind == ElementKind::link) link = m_names->find(LinkId(element.id));
    if (element.kind == ElementKind::turningJoint) {
      const TurningJoint* joint = m_names->find(JointId(element.id));
      if (joint != nullptr) link = m_names->find(joint->head);
    }
    return link != nullptr ? link->name : std::string();
  };
  for (MotionCurve& curve : sheet.curves) {
    if (!m_names || !curve.element || curve.isComponent) continue;
    const std::string name = nameOf(*curve.element);
    if (!name.empty()) curve.name += " (" + name + ")";
  }
  return sheet;
}

QString MotionPanel::emptyText() const {
  return m_empty->isHidden() ? QString() : m_empty->text();
}

ViewEntry speedsView() {
  return {.id = QStringLiteral("speeds"),
          .title = MotionPanel::tr("Speeds"),
          .purpose = MotionPanel::tr("Speeds over one period of the motion."),
          .helpPage = QStringLiteral("inputs-and-results#motion"),
          .searchWords = QStringLiteral("plot graph chart curve diagram time"),
          .place = ViewPlace::bottom,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            return new MotionPanel(views.selection(), &views.get<View3D>(), parent);
          }};
}

}  // namespace geargraph

#include "moc_motion_panel.cpp"
