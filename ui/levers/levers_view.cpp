#include "ui/levers/levers_view.h"

#include <QHelpEvent>
#include <QResizeEvent>
#include <QToolTip>

#include "core/presentation/lever_drawing/lever_words.h"
#include "core/presentation/lever_drawing/point_plan.h"
#include "ui/canvas/context_menu.h"
#include "ui/levers/levers_bar.h"
#include "ui/levers/levers_tips.h"
#include "ui/views/views.h"

namespace geargraph::inline ui_levers {

LeversView::LeversView(Document* document, Selection* selection, QWidget* parent)
    : DrawingView(document, selection, new DrawingScene, parent),
      m_service(new LeversService(this)),
      m_sheet(static_cast<DrawingScene*>(scene())),
      m_bar(new LeversBar(this)) {
  setAccessibleName(tr("Levers"));
  connect(m_bar, &LeversBar::pageChosen, this, &LeversView::choosePage);
  connect(m_bar, &LeversBar::arrowsChosen, this, [this] {
    redraw();
    fit();
  });
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
  m_drawn = drawn;
  redraw();
  if (!m_pull && !m_tie && (m_fitNext || isFitted())) fit();  // else the sheet would move under the mouse
  m_fitNext = false;
  emit redrawn();
  emit this->drawn();
}

void LeversView::redraw() {
  m_levers = {};
  m_nomogram = {};
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
  } else if (shows(LeversPage::plan) && missing().isEmpty()) {
    draw = [drawn = m_drawn](const Emphases& emphases) {
      return pointPlanDrawing(*drawn->snapshot->mechanism, drawn->points, emphases);
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
  }
  return {};
}

QString LeversView::message() const {
  return missing();
}

QString LeversView::whyNoPicture() const {
  return isUpToDate() ? missing() : tr("The levers are still being laid out. Try again in a moment.");
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

void LeversView::adjustMenu(ContextActions& actions, SheetPoint) {
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
  const SheetPoint place{scenePlace.x(), scenePlace.y()};
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

}  // namespace geargraph::inline ui_levers

#include "moc_levers_view.cpp"
