// Mouse and keys on the levers and the nomogram.

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/foundations/base/locale.h"
#include "core/mechanism/model/quantity.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/diagrams/lever_card.h"
#include "core/presentation/diagrams/lever_marks.h"
#include "core/theory/states/state_edits.h"
#include "ui/canvas/in_place_editor.h"
#include "ui/canvas/rename_editor.h"
#include "ui/lever_views/levers_bar.h"
#include "ui/lever_views/levers_tips.h"
#include "ui/lever_views/levers_view.h"
#include "ui/lever_views/point_offers.h"

namespace geargraph {

// --- what is where ----------------------------------------------------------------------------------------

const LeverPoint& LeversView::pointOf(const LeverSpot& spot) const {
  return m_drawn->picture.plan.levers[static_cast<std::size_t>(spot.lever)]
      .points[static_cast<std::size_t>(spot.point)];
}

LinkId LeversView::linkOf(const LeverSpot& spot) const {
  return drawnMechanism().links[pointOf(spot).links.front()].id;
}

int LeversView::discAt(CanvasPoint place) const {
  for (std::size_t i = 0; i < m_levers.spots.size(); ++i) {
    const LeverSpot& spot = m_levers.spots[i];
    const Extent disc{spot.center, LeverPainter::halfWidthOf(pointOf(spot).links), kDiscRadius};
    if (disc.contains(place)) return static_cast<int>(i);
  }
  return -1;
}

std::optional<LeversView::Disc> LeversView::anyDiscAt(CanvasPoint place) const {
  if (const int at = discAt(place); at >= 0) {
    const LeverSpot& spot = m_levers.spots[static_cast<std::size_t>(at)];
    return Disc{pointOf(spot).links.front(), spot.center, at};
  }
  for (const PointPlanSheet::Spot& spot : m_points.spots) {
    const Extent disc{spot.center, LeverPainter::halfWidthOf(spot.links), kDiscRadius};
    if (disc.contains(place)) return Disc{spot.links.front(), spot.center};
  }
  return std::nullopt;
}

int LeversView::arrowAt(CanvasPoint place) const {
  constexpr double kReachOfTip = 9;  // px on the screen
  if (m_levers.speedScale == 0 || discAt(place) >= 0) return -1;
  int nearest = -1;
  double least = kReachOfTip / scaleNow();
  for (std::size_t i = 0; i < m_levers.spots.size(); ++i) {
    const LeverSpot& spot = m_levers.spots[i];
    if (std::abs(spot.tip.x - spot.at.x) < 1) continue;
    const double away = distance(spot.tip, place);
    if (away > least) continue;
    least = away;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

std::optional<int> LeversView::stateAt(CanvasPoint place) const {
  constexpr double kReachOfLine = 6;  // px on the screen
  if (!shows(LeversPage::nomogram)) return std::nullopt;
  for (const NomogramSheet::Tag& tag : m_nomogram.tags)
    if (tag.box.grown(1).contains(place)) return tag.states.front();
  std::optional<int> nearest;
  double least = kReachOfLine / scaleNow();
  for (const NomogramSheet::Line& line : m_nomogram.lines) {
    const double away = distanceToSegment(place, line.from, line.to);
    if (away > least) continue;
    least = away;
    nearest = line.state;
  }
  return nearest;
}

// --- mouse ------------------------------------------------------------------------------------------------

void LeversView::pressed(const Pointer& pointer) {
  m_pressedState.reset();
  hideOffers();
  if (m_tie && m_tie->isOffered) return endTie(pointer);
  if (tool() == ToolKind::input) {
    const bool can = pointer.on && pointer.on->kind == ElementKind::link;
    const QString why = can ? commands().toggleInputs({*pointer.on}) : QString();
    if (!why.isEmpty()) setHint(why);
    return;
  }
  if (tool() != ToolKind::select || !m_isOpen) return DrawingView::pressed(pointer);
  if (!pointer.on) m_pressedState = stateAt(pointer.at);
  if (m_pressedState || grabTip(pointer)) return;
  DrawingView::pressed(pointer);
  if (const auto disc = anyDiscAt(pointer.at); disc && !pointer.add) {
    m_walked = disc->spot;
    m_tie = Tie{disc->link, disc->center, pointer.at};
  }
  showOverlay();
}

void LeversView::moved(const Pointer& pointer) {
  if (m_pull) return pull(pointer);
  if (m_tie) {
    m_tie->hasMoved |= distance(pointer.at, m_tie->begin) > kDiscRadius + pointer.slop;
    m_tie->end = pointer.at;
    return showOverlay();
  }
  if (shows(LeversPage::nomogram)) return lookAt(pointer.on ? std::nullopt : stateAt(pointer.at));
  const bool isOver = tool() == ToolKind::select && !pointer.on && arrowAt(pointer.at) >= 0;
  if (isOver == m_isOverTip) return;
  m_isOverTip = isOver;
  isOver ? viewport()->setCursor(Qt::SizeHorCursor) : updateCursor();
}

void LeversView::released(const Pointer& pointer) {
  if (m_pull) return endPull();
  if (m_tie && m_tie->isOffered) return;  // the click on the offer itself
  if (m_tie) {
    if (m_tie->hasMoved) return endTie(pointer);
    m_tie.reset();
    if (const auto disc = anyDiscAt(pointer.at)) offer(*disc);
    return;
  }
  const auto state = std::exchange(m_pressedState, std::nullopt);
  if (state && stateAt(pointer.at) == state) engageState(*state);
}

void LeversView::leaveEvent(QEvent* event) {
  DrawingView::leaveEvent(event);
  if (!m_pull) lookAt(std::nullopt);
}

bool LeversView::cancel() {
  m_pressedState.reset();
  const bool offered = m_offered.has_value();
  hideOffers();
  if (m_tie) {
    m_tie.reset();
    showOverlay();
    tellWhatToDo();
    return true;
  }
  if (offered) return true;
  if (!m_pull) return false;
  if (m_pull->hasMoved)
    document().apply({tr("Set speed"), [before = m_pull->before](const PlacedMechanism&) { return before; },
                      m_pull->gesture});
  endPull();
  return true;
}

void LeversView::endTie(const Pointer& pointer) {
  const Tie tied = *std::exchange(m_tie, std::nullopt);
  showOverlay();
  tellWhatToDo();
  if (const auto disc = anyDiscAt(pointer.at)) tie(tied.from, disc->link);
}

/// What can be done with the point, in a bar below its disc.
void LeversView::offer(const Disc& disc) {
  const LinkId link = drawnMechanism().links[disc.link].id;
  const bool isHeld =
      std::any_of(mechanism().couplings.begin(), mechanism().couplings.end(), [&](const ShiftElement& each) {
        return each.kind == ShiftElementKind::brake && each.links.front() == link &&
               isEngaged(mechanism(), each.id);
      });
  m_offered = disc;
  const QPoint center = mapFromScene(QPointF(disc.center.x, disc.center.y));
  const int reach = static_cast<int>(std::ceil(kDiscRadius * scaleNow()));
  m_offers->showAt(center.x(), center.y() - reach, center.y() + reach, disc.link != 0, isHeld);
}

void LeversView::hideOffers() {
  m_offered.reset();
  m_offers->hide();
}

/// The next click on a point locks both together.
void LeversView::startTie() {
  if (!m_offered) return;
  const Disc disc = *m_offered;
  hideOffers();
  m_tie = Tie{disc.link, disc.center, disc.center, true, true};
  setHint(tr("Click the point to lock link %1 with. Esc ends")
              .arg(QString::fromStdString(std::to_string(drawnMechanism().linkLabel(disc.link)))));
}

/// Two links get a clutch, or the one that they have is engaged; with the ground it is a brake.
void LeversView::tie(LinkOrdinal from, LinkOrdinal to) {
  if (from == to) return;
  const LinkId one = drawnMechanism().links[from].id;
  const LinkId other = drawnMechanism().links[to].id;
  if (mechanism().find(one) == nullptr || mechanism().find(other) == nullptr) return;
  const bool isBrake = from == 0 || to == 0;
  const LinkId held = from == 0 ? other : one;
  for (const ShiftElement& coupling : mechanism().couplings) {
    const auto names = [&](LinkId link) {
      return std::find(coupling.links.begin(), coupling.links.end(), link) != coupling.links.end();
    };
    if (isBrake ? coupling.kind != ShiftElementKind::brake || !names(held)
                : coupling.kind != ShiftElementKind::clutch || !names(one) || !names(other))
      continue;
    return commands().engage(coupling.id, true);
  }
  isBrake ? commands().addBrake(held) : commands().addClutch(one, other);
}

// --- speeds -----------------------------------------------------------------------------------------------

bool LeversView::grabTip(const Pointer& pointer) {
  if (pointer.on || pointer.add || !isUpToDate()) return false;
  const int arrow = arrowAt(pointer.at);
  if (arrow < 0) return false;
  const LeverSpot& spot = m_levers.spots[static_cast<std::size_t>(arrow)];
  selection().select({ElementId(linkOf(spot))});
  m_walked = arrow;
  const auto handle = handleOn(*m_drawn, pointOf(spot).links.front());
  if (!handle) {
    setHint(tr("With so many inputs no arrow is dragged: set them in Inputs and results"));
    return true;
  }
  m_pull = Pull{document().newGesture(), document().placed(), *handle, spot.at.x, m_levers.speedScale};
  showOverlay();
  return true;
}

void LeversView::pull(const Pointer& pointer) {
  const double speed = (pointer.at.x - m_pull->left) / m_pull->scale;
  const SpeedHandle& handle = m_pull->handle;
  const double perInput = handle.perInput.toDouble();
  const double wandered = std::abs(speed - handle.link.toDouble()) * m_pull->scale;
  if (!m_pull->hasMoved && wandered <= pointer.slop) return;
  m_pull->hasMoved = true;
  const double perPixel = std::abs(1 / (m_pull->scale * scaleNow() * perInput));
  const Number wanted = handSet(handle.now.toDouble() + (speed - handle.link.toDouble()) / perInput,
                                pointer.unsnapped ? perPixel / 10 : perPixel);
  document().apply(inputSpeedEdit(*m_drawn, handle, wanted, m_pull->gesture));
  const auto label = labelOf(mechanism(), handle.joint);
  setHint(tr("Input %1: %2 rad/s. Esc puts back")
              .arg(QString::fromStdString(label.value_or(handle.joint.text())),
                   QString::fromStdString(localizedNumber(wanted.text()))));
}

/// The scale follows the speeds again.
void LeversView::endPull() {
  m_pull.reset();
  m_isOverTip = false;  // the cursor is renewed
  redraw();
  if (isFitted()) fit();
  tellWhatToDo();
}

void LeversView::openElement(const ElementId& element) {
  hideOffers();
  if (element.kind == ElementKind::coupling && shows(LeversPage::levers)) {
    const ShiftElementId coupling(element.id);
    const auto& engaged = mechanism().engaged;
    return commands().engage(coupling, std::find(engaged.begin(), engaged.end(), coupling) == engaged.end());
  }
  const int at = element.kind == ElementKind::link && m_isOpen ? current() : -1;
  if (at < 0) return DrawingView::openElement(element);
  typeSpeed(m_levers.spots[static_cast<std::size_t>(at)]);
}

/// In a field under the disc.
void LeversView::typeSpeed(const LeverSpot& spot) {
  const LinkId link = linkOf(spot);
  const auto handle = handleOn(*m_drawn, pointOf(spot).links.front());
  if (!handle) return setHint(tr("No input turns this link: there is no speed to set"));
  constexpr QSize kSize(110, 26);
  auto* editor =
      new RenameEditor(QString::fromStdString(localizedNumber(Number(handle->link).text())), viewport());
  editor->setAccessibleName(tr("Speed of the link, rad/s"));
  const QPoint under = mapFromScene(QPointF(spot.center.x, spot.center.y + kDiscRadius + 3));
  editor->setGeometry(QRect(under - QPoint(kSize.width() / 2, 0), kSize));
  editor->selectAll();
  connect(editor, &RenameEditor::taken, this,
          [this, link](const QString& typed) { setSpeedOf(link, typed); });
  openInPlace(editor, this, document());
}

void LeversView::setSpeedOf(LinkId link, const QString& typed) {
  if (!shows(LeversPage::levers)) return;
  QString text = typed.trimmed();
  if (!text.contains(QLatin1Char('.'))) text.replace(QLatin1Char(','), QLatin1Char('.'));
  text.replace(QChar(0x2212), QLatin1Char('-'));
  auto speed = withUnitFromText(text.toStdString(), Quantity::speed);
  if (!speed) speed = typedNumber(text.toStdString());
  if (!speed) return setHint(tr("“%1” is no speed: a number, or one with a unit such as 30 rpm").arg(typed));
  for (const LinkOrdinal each : m_drawn->picture.plan.links) {
    if (drawnMechanism().links[each].id != link) continue;
    const auto handle = handleOn(*m_drawn, each);
    if (!handle || speed->exact() == handle->link) return;
    document().apply(inputSpeedEdit(*m_drawn, *handle, Number(handle->inputFor(speed->exact())), 0));
    return;
  }
}

// --- states -----------------------------------------------------------------------------------------------

void LeversView::lookAt(std::optional<int> state) {
  if (state == m_state) return;
  m_state = state;
  showOverlay();
  emit stateLookedAtChanged(state.value_or(-1));
  if (state && shows(LeversPage::nomogram)) return setHint(stateTip(*m_drawn, drawnMechanism(), *state));
  tellWhatToDo();
}

void LeversView::lookAtState(int state) {
  const bool isThere = state >= 0 && static_cast<std::size_t>(state) < mechanism().states.size();
  if (!shows(LeversPage::nomogram) || !m_isOpen) return;
  lookAt(isThere ? std::optional(state) : std::nullopt);
}

void LeversView::engageState(int state) {
  const std::string name = drawnMechanism().states[static_cast<std::size_t>(state)].name;
  if (static_cast<std::size_t>(state) >= mechanism().states.size()) return;  // edited meanwhile
  document().apply({tr("Engage state %1").arg(QString::fromStdString(name)),
                    [state](const Mechanism& before) { return withStateEngaged(before, state); }, 0});
}

bool LeversView::walkStates(int steps) {
  std::vector<int> shown;
  for (const NomogramSheet::Line& line : m_nomogram.lines)
    if (std::find(shown.begin(), shown.end(), line.state) == shown.end()) shown.push_back(line.state);
  if (shown.empty()) return false;
  std::sort(shown.begin(), shown.end());
  const std::optional<int> from = m_state ? m_state : m_drawn->states.current;
  const auto found = from ? std::find(shown.begin(), shown.end(), *from) : shown.end();
  const auto count = static_cast<int>(shown.size());
  const int at = found == shown.end() ? (steps > 0 ? -1 : count) : static_cast<int>(found - shown.begin());
  lookAt(shown[static_cast<std::size_t>(std::clamp(at + steps, 0, count - 1))]);
  return true;
}

// --- keys -------------------------------------------------------------------------------------------------

int LeversView::current() const {
  const std::optional<ElementId> element = currentElement();
  if (!element || element->kind != ElementKind::link) return -1;
  const auto isThere = [&](const LeverSpot& spot) { return ElementId(linkOf(spot)) == *element; };
  const auto& spots = m_levers.spots;
  const auto walked = static_cast<std::size_t>(std::max(m_walked, 0));
  if (m_walked >= 0 && walked < spots.size() && isThere(spots[walked])) return m_walked;
  const auto found = std::find_if(spots.begin(), spots.end(), isThere);
  return found == spots.end() ? -1 : static_cast<int>(found - spots.begin());
}

void LeversView::goTo(int spot) {
  const LeverSpot& to = m_levers.spots[static_cast<std::size_t>(spot)];
  m_walked = spot;
  setHint(QString::fromStdString(pointSentence(drawnMechanism(), m_drawn->picture, to.lever, to.point)));
  walkTo(linkOf(to));
  showOverlay();
}

/// To the point of another bar that is nearest in height; to the first bar where the keys are at none.
bool LeversView::walkBars(int steps) {
  const auto& spots = m_levers.spots;
  if (spots.empty()) return false;
  const int from = current();
  const int bar =
      from < 0 ? (steps > 0 ? 0 : spots.back().bar) : spots[static_cast<std::size_t>(from)].bar + steps;
  const double height = from < 0 ? spots.front().at.y : spots[static_cast<std::size_t>(from)].at.y;
  int nearest = -1;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (spots[i].bar != bar) continue;
    const double away = std::abs(spots[i].at.y - height);
    if (nearest < 0 || away < std::abs(spots[static_cast<std::size_t>(nearest)].at.y - height))
      nearest = static_cast<int>(i);
  }
  if (nearest < 0) return false;
  goTo(nearest);
  return true;
}

void LeversView::nudge(double dx, double dy, bool /*repeated*/) {
  if (shows(LeversPage::nomogram) && dy != 0) {
    walkStates(dy > 0 ? 1 : -1);
    return;
  }
  if (!shows(LeversPage::levers) || m_levers.spots.empty()) return;
  const int from = current();
  if (from < 0 || dx != 0) {
    walkBars(dx < 0 ? -1 : 1);
    return;
  }
  const auto to = static_cast<std::size_t>(from + (dy > 0 ? 1 : -1));
  if (to < m_levers.spots.size() &&
      m_levers.spots[to].bar == m_levers.spots[static_cast<std::size_t>(from)].bar)
    goTo(static_cast<int>(to));
}

void LeversView::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && m_isOpen && m_state && shows(LeversPage::nomogram)) return engageState(*m_state);
  DrawingView::keyPressEvent(event);
}

bool LeversView::focusNextPrevChild(bool next) {
  if (hasFocus() && isVisible() && shows(LeversPage::levers) && walkBars(next ? 1 : -1)) return true;
  return DrawingView::focusNextPrevChild(next);
}

}  // namespace geargraph
