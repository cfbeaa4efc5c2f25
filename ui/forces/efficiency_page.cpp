#include "ui/forces/efficiency_page.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QStackedWidget>

#include "ui/models/term_tips.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/flow_layout.h"

namespace geargraph {
namespace {

void follow(const EfficiencyRequest& request,
            const Service<EfficiencyRequest, FollowedEfficiencyPtr>::Responder& respond) {
  const Forces& forces = *request.forces;
  const AnalysisSnapshot& snapshot = *forces.solved;
  auto curve = efficiencyCurve(
      *snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(), *snapshot.matroid(),
      *forces.report, optionsOf(forces.question), request.axis, usualRange(request.axis), respond.stop());
  if (curve)
    respond(
        std::make_shared<const FollowedEfficiency>(FollowedEfficiency{request.forces, std::move(*curve)}));
}

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

/// Where the train is now, if that is on the curve.
std::optional<double> placeNow(const FollowedEfficiency& followed) {
  const Forces& forces = *followed.forces;
  if (followed.curve.axis == CurveAxis::meshEfficiency) {
    if (forces.question.efficiency) return forces.question.efficiency->toDouble();
    const std::optional<GearDefaults>& stated = forces.solved->mechanism->gearDefaults;
    return stated && stated->efficiency ? std::optional(stated->efficiency->value()) : std::nullopt;
  }
  const std::vector<Rational>& speeds = forces.solved->matroid()->speeds;
  if (speeds[0].isZero()) return std::nullopt;
  return (speeds[1] / speeds[0]).toDouble();
}

constexpr ColorRole kColours[] = {ColorRole::accent, ColorRole::warning, ColorRole::fine, ColorRole::error};
constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

}  // namespace

EfficiencyPage::EfficiencyPage(QWidget* parent)
    : QWidget(parent),
      m_curves(new Curves(&follow, this)),
      m_choices(new QWidget(this)),
      m_axis(new QComboBox(this)),
      m_quantity(new QComboBox(this)),
      m_pages(new QStackedWidget(this)),
      m_plot(new EfficiencyPlot(this)),
      m_empty(emptyLabel(this)) {
  m_quantity->setObjectName(QStringLiteral("efficiencyQuantity"));
  m_quantity->setToolTip(tr("What is plotted"));
  m_quantity->setAccessibleName(tr("What is plotted"));
  m_quantity->addItems({tr("efficiency"), tr("torques that hold the loads")});
  connect(m_quantity, &QComboBox::currentIndexChanged, this, [this] { showCurve(); });
  m_axis->setObjectName(QStringLiteral("efficiencyAxis"));
  m_axis->setToolTip(tr("What it is plotted over; all else stays as it is"));
  m_axis->setAccessibleName(tr("What it is plotted over"));
  connect(m_axis, &QComboBox::activated, this, [this] {
    m_wantedAxis = static_cast<CurveAxis>(m_axis->currentData().toInt());
    ask();
  });
  auto* bar = new FlowLayout(m_choices);
  bar->setContentsMargins(0, 0, 0, 0);
  bar->setSpacing(6);
  bar->addWidget(m_quantity);
  bar->addWidget(new QLabel(tr("over"), this));
  bar->addWidget(m_axis);
  auto* remark = new QLabel(tr("The same at any torque"), this);
  remark->setObjectName(QStringLiteral("efficiencyRemark"));
  remark->setProperty("look", "hint");
  remark->setToolTip(
      tr("Losses of meshes are proportional to their power, whether an efficiency or a coefficient of "
         "friction is "
         "stated: all loads scaled alike leave the efficiency as it is, so there is no plot over the torque. "
         "Of several loads only the proportions matter."));
  bar->addWidget(remark);
  m_pages->addWidget(m_plot);
  m_pages->addWidget(m_empty);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_choices);
  layout->addWidget(m_pages, 1);
  m_curves->onAnswer(this, [this](const FollowedEfficiencyPtr&) { showCurve(); });
  connect(m_curves, &Curves::failed, this, [this](const QString& why) {
    leaveEmpty(tr("The efficiency could not be followed: %1").arg(why));
  });
  show(nullptr);
}

void EfficiencyPage::show(const ForcesPtr& forces) {
  if (forces && forces == m_forces) return;
  m_forces = forces;
  updateAxes();
  ask();
}

void EfficiencyPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  ask();
}

void EfficiencyPage::updateAxes() {
  m_axis->clear();
  if (!m_forces || !m_forces->report || m_forces->solved->matroid() == nullptr) return;
  const MatroidAnalysis& analysis = *m_forces->solved->matroid();
  for (const CurveAxis axis : curveAxes(analysis, *m_forces->report, optionsOf(m_forces->question)))
    m_axis->addItem(
        shown(axisTitle(*m_forces->solved->mechanism, EfficiencyCurve{axis, analysis.choice.joints, {}, {}})),
        static_cast<int>(axis));
  const int at = m_wantedAxis ? m_axis->findData(static_cast<int>(*m_wantedAxis)) : 0;
  m_axis->setCurrentIndex(at >= 0 ? at : 0);
}

void EfficiencyPage::ask() {
  const bool canFollow = m_axis->count() > 0;
  m_choices->setVisible(canFollow);
  if (!canFollow) {
    m_curves->cancel();
    return leaveEmpty(tr("A plot needs loads that are held, one way to hold them, and a motion."));
  }
  if (!isVisible()) return;
  const auto axis = static_cast<CurveAxis>(m_axis->currentData().toInt());
  if (followed() && followed()->forces == m_forces && followed()->curve.axis == axis &&
      m_curves->isComplete())
    return showCurve();
  m_curves->request({m_forces, axis});
}

void EfficiencyPage::leaveEmpty(const QString& why) {
  m_empty->setText(why);
  m_pages->setCurrentWidget(m_empty);
  emit tableChanged();
}

void EfficiencyPage::showCurve() {
  if (!followed() || m_axis->count() == 0) return;
  m_plot->setSheet(sheetOf(*followed()));
  m_pages->setCurrentWidget(m_plot);
  emit tableChanged();
}

EfficiencyPlot::Sheet EfficiencyPage::sheetOf(const FollowedEfficiency& followed) const {
  const Mechanism& mechanism = *followed.forces->solved->mechanism;
  const EfficiencyCurve& curve = followed.curve;
  EfficiencyPlot::Sheet sheet;
  sheet.across = shown(axisTitle(mechanism, curve));
  sheet.now = placeNow(followed);
  const bool ofTorques = m_quantity->currentIndex() == 1;
  sheet.up = ofTorques ? tr("torque, N m") : tr("efficiency");
  const auto add = [&](const QString& name) -> EfficiencyPlot::Line& {
    const std::size_t seriesIndex = sheet.lines.size() % std::size(kColours);
    return sheet.lines.emplace_back(
        EfficiencyPlot::Line{name, kColours[seriesIndex], kStyles[seriesIndex], {}});
  };
  for (const EfficiencyPoint& point : curve.points) sheet.places.push_back(point.at.toDouble());
  if (!ofTorques) {
    EfficiencyPlot::Line& forward = add(tr("forward"));
    for (const EfficiencyPoint& point : curve.points) forward.values.push_back(point.forward);
    EfficiencyPlot::Line& backward = add(tr("backward"));
    for (const EfficiencyPoint& point : curve.points) backward.values.push_back(point.backward);
    return sheet;
  }
  for (std::size_t i = 0; i < curve.held.size(); ++i) {
    EfficiencyPlot::Line& line = add(shown(heldTitle(mechanism, *followed.forces->report, curve.held[i])));
    for (const EfficiencyPoint& point : curve.points)
      line.values.push_back(i < point.torques.size() ? std::optional(point.torques[i]) : std::nullopt);
  }
  return sheet;
}

QString EfficiencyPage::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

std::optional<ValueTable> EfficiencyPage::table() const {
  if (!followed() || !emptyText().isEmpty()) return std::nullopt;
  return efficiencyTable(*followed()->forces->solved->mechanism, *followed()->forces->report,
                         followed()->curve);
}

}  // namespace geargraph

#include "moc_efficiency_page.cpp"
