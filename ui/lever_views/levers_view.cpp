#include "ui/lever_views/levers_view.h"

#include <QHelpEvent>
#include <QResizeEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QVariantAnimation>

#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/diagrams/speed_plan_drawing.h"
#include "ui/canvas/context_menu.h"
#include "ui/lever_views/levers_bar.h"
#include "ui/lever_views/levers_tips.h"
#include "ui/lever_views/point_offers.h"
#include "ui/workbench/views.h"

namespace geargraph {

LeversView::LeversView(Document* document, Selection* selection, QWidget* parent)
    : DrawingView(document, selection, new DrawingScene, parent),
      m_service(new LeversService(this)),
      m_sheet(static_cast<DrawingScene*>(scene())),
      m_bar(new LeversBar(this)),
      m_offers(new PointOffers(viewport())) {
  setAccessibleName(tr("Levers"));
  connect(m_bar, &LeversBar::pageChosen, this, &LeversView::choosePage);
  connect(m_bar, &LeversBar::arrowsChosen, this, [this] {
    redraw();
    fit();
  });
  connect(m_offers, &PointOffers::holdWanted, this, [this] {
    if (!m_offered) return;
    const LinkId link = drawnMechanism().links[m_offered->link].id;
    hideOffers();
    if (mechanism().find(link) != nullptr) commands().toggleBrake(link);
  });
  connect(m_offers, &PointOffers::lockWanted, this, &LeversView::startTie);
  for (QScrollBar* bar : {horizontalScrollBar(), verticalScrollBar()})
    connect(bar, &QScrollBar::valueChanged, this, &LeversView::hideOffers);
  m_service->onAnswer(this, [this](const DrawnLeversPtr& drawn) { receive(drawn); });
  layOutBar();
  tellWhatToDo();
}

LeversPage LeversView::page() const {
  return m_bar->page();
}

void LeversView::setPage(LeversPage page) {
  m_bar->setPage(page);
}

bool LeversView::shows(LeversPage page) const {
  return m_drawn && (m_isOpen || m_isRead) && m_drawn->page == page;
}

void LeversView::choosePage() {
  cancel();
  hideOffers();
  delete std::exchange(m_projecting, nullptr);
  m_fitNext = true;
  m_state.reset();
  m_walked = -1;
  layOutBar();
  tellWhatToDo();
  ask();
}

// --- what is shown ----------------------------------------------------------------------------------------

bool LeversView::isUpToDate() const {
  return !m_behind && isSettled() && m_drawn && snapshot() && m_drawn->page == page() &&
         m_drawn->snapshot->mechanism == snapshot()->mechanism;
}

/// All that is drawn follows from the analysis, which is about to come.
void LeversView::rebuild() {}

void LeversView::setSnapshot(const SnapshotPtr& snapshot) {
  DrawingView::setSnapshot(snapshot);
  ask();
}

void LeversView::setAnswersOpen(bool isOpen) {
  m_isOpen = isOpen;
  redraw();
}

void LeversView::setRead(bool isRead) {
  m_isRead = isRead;
  redraw();
}

void LeversView::ask() {
  m_behind = !isVisible();
  if (!m_behind && snapshot()) m_service->request({snapshot(), page()});
}

void LeversView::catchUp() {
  constexpr std::chrono::milliseconds kMoment{30};
  if (!snapshot()) return;
  if (std::exchange(m_behind, false)) m_service->request({snapshot(), page()});
  m_service->await(kMoment);
}

void LeversView::showEvent(QShowEvent* event) {
  DrawingView::showEvent(event);
  if (!m_behind) return;
  catchUp();
  if (isUpToDate()) return;
  m_drawn.reset();  // nobody is shown what the document was long ago
  redraw();
}

void LeversView::forgetDocument() {
  cancel();
  m_service->cancel();
  m_drawn.reset();
  m_state.reset();
  m_walked = -1;
  m_fitNext = true;
  redraw();
}

void LeversView::receive(const DrawnLeversPtr& drawn) {
  if (!snapshot()) return;  // of the document before
  hideOffers();
  const DrawnLeversPtr before = std::exchange(m_drawn, drawn);
  project(before);
  redraw();
  if (!m_pull && !m_tie && (m_fitNext || isFitted())) fit();  // else the sheet would move under the mouse
  m_fitNext = false;
  emit redrawn();
  emit this->drawn();
}

void LeversView::redraw() {
  m_levers = {};
  m_nomogram = {};
  m_points = {};
  DrawingScene::Draw draw = [](const Emphases&) { return DisplayList{}; };
  if (shows(LeversPage::levers)) {
    const LeverLook look{m_bar->showsSpeeds(), m_bar->showsTorques(), m_isOpen,
                         m_pull ? std::optional(m_pull->scale) : std::nullopt};
    const auto sheet = [drawn = m_drawn, look](const Emphases& emphases) {
      return leverSheet(*drawn->snapshot->mechanism, drawn->picture, drawn->layout, emphases, look);
    };
    m_levers = sheet({});
    if (missing().isEmpty()) draw = [sheet](const Emphases& emphases) { return sheet(emphases).drawing; };
  } else if (shows(LeversPage::nomogram)) {
    static const Placement kNowhere{};
    const auto sheet = [drawn = m_drawn, isOpen = m_isOpen](const Emphases& emphases) {
      const StatesOnLevers& states = drawn->states;
      const LiveKinematics* const kinematics = drawn->snapshot->kinematics.get();
      return nomogramSheet(*drawn->snapshot->mechanism, states.plan,
                           states.plan.mainAxis < 0 ? kNowhere : kinematics->placement(), states.states,
                           isOpen ? states.current : std::nullopt, emphases);
    };
    m_nomogram = sheet({});
    if (missing().isEmpty()) draw = [sheet](const Emphases& emphases) { return sheet(emphases).drawing; };
  } else if (shows(LeversPage::plan)) {
    std::optional<PlanProjection> projection;
    if (const auto coupling = projectingCoupling(drawnMechanism(), m_drawn->points))
      projection = PlanProjection{*coupling, m_projecting ? m_projecting->currentValue().toDouble() : 1};
    const auto sheet = [drawn = m_drawn, projection](const Emphases& emphases) {
      return pointPlanSheet(*drawn->snapshot->mechanism, drawn->points, projection, emphases);
    };
    m_points = sheet({});
    if (missing().isEmpty()) draw = [sheet](const Emphases& emphases) { return sheet(emphases).drawing; };
  } else if (shows(LeversPage::speedPlan) && missing().isEmpty()) {
    draw = [drawn = m_drawn](const Emphases& emphases) {
      const AnalysisSnapshot& snapshot = *drawn->snapshot;
      return speedPlanDrawing(*snapshot.mechanism, snapshot.kinematics->placement(), drawn->speedPlan,
                              drawn->section, emphases);
    };
  }
  if (m_walked >= static_cast<int>(m_levers.spots.size())) m_walked = -1;
  m_sheet->show(std::move(draw));
  updateEmphases();
  updateMessage();
  showOverlay();
}

QString LeversView::missing() const {
  if (!m_isOpen && !m_isRead)
    return tr("The levers hold the answer: they are shown when the step is right or shown.");
  if (!m_drawn) return {};
  const Mechanism& mechanism = drawnMechanism();
  switch (m_drawn->page) {
    case LeversPage::levers:
      return QString::fromStdString(absenceSentence(mechanism, m_drawn->picture.plan));
    case LeversPage::nomogram:
      return QString::fromStdString(m_nomogram.missing);
    case LeversPage::plan:
      return QString::fromStdString(whyNoPointPlan(mechanism, m_drawn->points));
    case LeversPage::speedPlan:
      return QString::fromStdString(whyNoSpeedPlan(m_drawn->speedPlan));
  }
  return {};
}

QString LeversView::message() const {
  return missing();
}

QString LeversView::whyNoPicture() const {
  return isUpToDate() ? missing() : tr("The levers are still being laid out. Try again in a moment.");
}

/// Lets the points move to the line that they are projected onto, where a coupling was just engaged.
void LeversView::project(const DrawnLeversPtr& before) {
  delete std::exchange(m_projecting, nullptr);
  constexpr double kSlowing = 1.6;  // as long as other animations of the style, and a little more
  const int duration =
      static_cast<int>(kSlowing * style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this));
  const bool isNew = before && shows(LeversPage::plan) && before->page == LeversPage::plan &&
                     before->snapshot->mechanism->engaged != drawnMechanism().engaged &&
                     projectingCoupling(drawnMechanism(), m_drawn->points).has_value();
  if (!isNew || duration <= 0 || !isVisible()) return;
  m_projecting = new QVariantAnimation(this);
  m_projecting->setStartValue(0.0);
  m_projecting->setEndValue(1.0);
  m_projecting->setDuration(duration);
  m_projecting->setEasingCurve(QEasingCurve::InOutCubic);
  connect(m_projecting, &QVariantAnimation::valueChanged, this, &LeversView::redraw);
  connect(m_projecting, &QVariantAnimation::finished, this, [this] {
    std::exchange(m_projecting, nullptr)->deleteLater();
    redraw();
    if (isFitted()) fit();
    emit drawn();
  });
  m_projecting->start();
}

/// The ring around the point of the keys, the state that is looked at, the tie that is drawn.
void LeversView::showOverlay() {
  DisplayList list;
  const double px = 1 / scaleNow();
  const auto put = [&](Stroke stroke) {
    list.marks.push_back({{}, MarkRole::preview, kPreviewDepth, std::move(stroke)});
  };
  if (const int at = current(); at >= 0 && at == m_walked) {
    constexpr double kRing = 19;
    put({Circle{m_levers.spots[static_cast<std::size_t>(at)].center, kRing}, ColorRole::accent, 1.6 * px,
         Dash::dashed});
  }
  if (m_state) {
    for (const NomogramSheet::Line& line : m_nomogram.lines)
      if (line.state == *m_state)
        put({Polyline{{line.from, line.to}, false}, ColorRole::accent, 3 * px, Dash::solid});
    for (const NomogramSheet::Tag& tag : m_nomogram.tags)
      if (std::find(tag.states.begin(), tag.states.end(), *m_state) != tag.states.end())
        put({geargraph::Box{tag.box.grown(2), 5}, ColorRole::accent, 2 * px, Dash::solid});
  }
  if (m_tie && m_tie->hasMoved)
    put({Polyline{{m_tie->begin, m_tie->end}, false}, ColorRole::accent, 2 * px, Dash::dotted});
  m_sheet->setOverlay(std::move(list));
}

void LeversView::tellWhatToDo() {
  switch (page()) {
    case LeversPage::levers:
      return setHint(
          tr("Drag an arrow: the train turns with it. Click a point to select its link, B holds it"));
    case LeversPage::nomogram:
      return setHint(tr("Click a line or its tag to engage the state"));
    case LeversPage::plan:
      return setHint(tr("Engaging a coupling draws the plane together along its dotted line"));
    case LeversPage::speedPlan:
      return setHint(tr("Each line is a link: its slope is the speed, lines cross at the teeth"));
  }
}

// --- around the drawing -----------------------------------------------------------------------------------

void LeversView::layOutBar() {
  m_bar->resize(width(), m_bar->sizeHint().height());  // it folds where it is too narrow
  const int height = m_bar->sizeHint().height();
  m_bar->setGeometry(0, 0, width(), height);
  if (viewportMargins().top() != height) setViewportMargins(0, height, 0, 0);
}

void LeversView::resizeEvent(QResizeEvent* event) {
  DrawingView::resizeEvent(event);
  layOutBar();
}

void LeversView::adjustMenu(ContextActions& actions, CanvasPoint) {
  actions.addLink = nullptr;
  actions.tidy = nullptr;
}

QString LeversView::cardOf(const LeverSpot& spot) const {
  return leverTip(*m_drawn, drawnMechanism(), *snapshot(), spot);
}

QString LeversView::toolTipFor(const ElementId& element) const {
  const QString plain = DrawingView::toolTipFor(element);
  if (element.kind != ElementKind::link || !m_isOpen || !shows(LeversPage::levers)) return plain;
  const QString points = pointsOfLink(*m_drawn, drawnMechanism(), LinkId(element.id));
  return points.isEmpty() ? plain : plain + QLatin1Char('\n') + points;
}

bool LeversView::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !m_isOpen) return DrawingView::viewportEvent(event);
  auto* help = static_cast<QHelpEvent*>(event);
  const QPointF scenePlace = mapToScene(help->pos());
  const CanvasPoint place{scenePlace.x(), scenePlace.y()};
  if (const int disc = discAt(place); disc >= 0 && snapshot()) {
    QToolTip::showText(help->globalPos(), cardOf(m_levers.spots[static_cast<std::size_t>(disc)]), viewport());
    return true;
  }
  if (const auto state = stateAt(place); state && !elementUnder(help->pos())) {
    QToolTip::showText(help->globalPos(), stateTip(*m_drawn, drawnMechanism(), *state), viewport());
    return true;
  }
  return DrawingView::viewportEvent(event);
}

ViewEntry leversView() {
  return {.id = QStringLiteral("levers"),
          .title = LeversView::tr("Levers"),
          .tip = LeversView::tr("Gear sets as levers: speeds and torques of the links on the ground's axis"),
          .purpose = LeversView::tr(
              "Speeds and torques on levers, the states of a gearbox as a nomogram, and the plane of two "
              "freedoms."),
          .helpPage = QStringLiteral("gearboxes#levers"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* drawing = new LeversView(views.document(), views.selection(), parent);
            QObject::connect(drawing, &LeversView::drawn, &views, &Views::settled);
            return drawing;
          }};
}

}  // namespace geargraph

#include "moc_levers_view.cpp"
