#include "ui/mainwindow/power_view.h"

#include <QMenu>
#include <algorithm>

#include "core/presentation/diagrams/torque_marks.h"

namespace geargraph {

PowerView::PowerView(Workbench& workbench, std::vector<DrawingView*> drawings, QObject* parent)
    : QObject(parent), m_workbench(workbench) {
  for (DrawingView* view : drawings) {
    const Drawing& drawing = m_drawings.emplace_back(Drawing{view, new Bands(&PowerView::draw, this)});
    drawing.bands->onAnswer(this, [this, view](const std::shared_ptr<const Answer>& bands) {
      view->setUnderlayTips(bands ? bands->tips : std::map<ElementId, QString>());
      view->setUnderlay(bands ? bands->list : DisplayList());
      emit shown();
    });
    connect(view, &DrawingView::redrawn, this, [this, drawing] { renew(drawing); });
  }
  m_workbench.forces().onAnswer(this, [this](const ForcesPtr&) { renew(); });
  connect(&m_workbench.document(), &Document::replaced, this, [this] { setObserver({}); });
}

PowerView::~PowerView() = default;

void PowerView::setOn(bool on) {
  m_isOn = on;
  renew();
}

void PowerView::setObserver(LinkId observer) {
  m_observer = observer;
  renew();
}

QString PowerView::unavailableReason() const {
  const ForcesPtr& forces = m_workbench.forces().answer();
  if (!forces) return tr("Power flows under loads: add one in Forces.");
  if (!forces->report || !forces->report->isSolved || !forces->report->lossless.isBalanced())
    return tr("The loads are not in balance: Forces names what is missing.");
  if (!forces->report->isAnswered()) return tr("With these losses no torques are known: Forces tells why.");
  if (!forces->report->flow) return tr("Without a motion there is no power.");
  if (forces->report->loads.empty()) return tr("Power flows under loads: add one in Forces.");
  return {};
}

bool PowerView::isSettled() const {
  return std::all_of(m_drawings.begin(), m_drawings.end(),
                     [](const Drawing& each) { return each.bands->isComplete(); });
}

PowerPicture PowerView::pictureOf(const Forces& forces, LinkId observer) {
  const Mechanism& mechanism = *forces.solved->mechanism;
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [&](const Link& link) { return link.id == observer; });
  const auto node = found == mechanism.links.end() ? 0 : static_cast<int>(found - mechanism.links.begin());
  const auto& kinematics = *forces.solved->kinematics;
  return powerPicture(mechanism, *kinematics.model, kinematics.placement(), *forces.report, node);
}

void PowerView::draw(const Request& request, const Bands::Responder& respond) {
  const Forces& forces = *request.forces;
  const Mechanism& mechanism = *forces.solved->mechanism;
  const PowerPicture picture = request.showsPower ? pictureOf(forces, request.observer) : PowerPicture();
  if (respond.stop().stop_requested()) return;
  const std::vector<ShownTorque> torques = shownTorques(mechanism, *forces.report);
  auto answer = std::make_shared<Answer>();
  answer->list = request.draw(picture, torques, mechanism);
  for (const ShownTorque& torque : torques) {
    if (torque.tip.empty()) continue;
    QString& tip = answer->tips[torque.element];
    if (!tip.isEmpty()) tip += QLatin1Char('\n');
    tip += QString::fromStdString(torque.tip);
  }
  respond(std::move(answer));
}

void PowerView::renew() {
  for (const Drawing& drawing : m_drawings) renew(drawing);
}

void PowerView::renew(const Drawing& drawing) {
  const ForcesPtr& forces = m_workbench.forces().answer();
  const bool hasLoads = forces && forces->report && !forces->report->loads.empty();
  const DrawingView::PowerDraw draw = hasLoads ? drawing.view->powerDraw() : nullptr;
  if (draw) {
    drawing.bands->request({forces, m_isOn && unavailableReason().isEmpty(), m_observer, draw});
    return;
  }
  if (!drawing.bands->isComplete()) drawing.bands->cancel();
  if (!drawing.view->hasUnderlay()) return;
  drawing.view->setUnderlayTips({});
  drawing.view->setUnderlay({});
  emit shown();
}

void PowerView::fillObservers(QMenu& menu) {
  constexpr std::size_t kMax = 80;
  menu.clear();
  const Mechanism& mechanism = *m_workbench.document().mechanism();
  const auto add = [&](const QString& text, LinkId link) {
    QAction* action = menu.addAction(text, this, [this, link] { setObserver(link); });
    action->setCheckable(true);
    action->setChecked(link == m_observer);
  };
  add(tr("The ground"), {});
  for (std::size_t link = 1; link < std::min(mechanism.links.size(), kMax); ++link) {
    const QString name = QString::fromStdString(mechanism.links[link].name);
    const QString label = QString::number(mechanism.linkLabel(static_cast<int>(link)));
    add(name.isEmpty() ? tr("Link %1").arg(label) : tr("Link %1, %2").arg(label, name),
        mechanism.links[link].id);
  }
}

}  // namespace geargraph

#include "moc_power_view.cpp"
