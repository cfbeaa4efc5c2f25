#include "ui/canvas/digraph_view.h"

#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/notes.h"
#include "core/presentation/diagrams/power_drawing.h"
#include "core/presentation/diagrams/torque_marks.h"
#include "ui/canvas/cycle_walk.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

constexpr std::size_t kLarge = 750;  ///< links, whose arrows take some 10 ms to place

}  // namespace

DigraphView::DigraphView(Document* document, Selection* selection, QWidget* parent)
    : GraphView(document, selection, new DigraphScene, parent),
      m_scene(static_cast<DigraphScene*>(scene())),
      m_placer(new NodePlacer(this)),
      m_drawings(new Drawings(
          [](const Request& request, const Drawings::Responder& respond) {
            respond({request.places, std::make_shared<const DigraphGeometry>(digraphGeometry(
                                         *request.mechanism, request.places, *request.former))});
          },
          this, {.superseded = Superseded::delivered})) {
  setAccessibleName(tr("Digraph"));
  commands().setSight([this] {
    const QRectF sight = mapToScene(viewport()->rect()).boundingRect();
    return Extent::spanning({sight.left(), sight.top()}, {sight.right(), sight.bottom()});
  });
  m_drawings->onAnswer(this, [this](const Drawing& drawing) {
    m_scene->show(drawing.places, drawing.geometry);
    emit redrawn();
    emitSettledIfIdle();
  });
  connect(m_placer, &NodePlacer::placesFound, this, [this] {
    m_fitWhenDrawn = true;
    rebuild();
    emitSettledIfIdle();
  });
  connect(m_placer, &NodePlacer::laidOut, this, [this](const NodePositions& positions) {
    m_fitWhenDrawn = true;
    place(positions);
    emitSettledIfIdle();
  });
  connect(m_scene, &DigraphScene::drawn, this, &DigraphView::emitSettledIfIdle);
  rebuild();
  updateMessage();
}

void DigraphView::rebuild() {
  const MechanismPtr& now = document().mechanism();
  NodePositions places = m_placer->placesOf(now);
  if (now->links.size() > kLarge) {
    m_drawings->request({now, std::move(places), m_scene->geometry()});
    m_drawn.reset();
    return;
  }
  m_drawings->cancel();
  const bool isThere = m_drawn && isSameDigraph(*m_drawn, *now) && places == m_scene->positions() &&
                       m_drawn->view.notes == now->view.notes;
  if (!isThere) m_scene->show(*now, std::move(places));
  m_drawn = now;
  if (!isThere) emit redrawn();
}

DrawingView::PowerDraw DigraphView::powerDraw() const {
  if (!m_drawn) return {};
  return
      [geometry = m_scene->geometry()](const PowerPicture& picture, const std::vector<ShownTorque>& torques,
                                       const Mechanism& mechanism) {
        DisplayList under = digraphPower(picture, mechanism, *geometry);
        under.append(digraphTorques(torques, *geometry, under));
        return under;
      };
}

bool DigraphView::isSettled() const {
  return !m_placer->isSeeking() && m_drawings->isUpToDate() && m_scene->isDrawn();
}

void DigraphView::emitSettledIfIdle() {
  updateMessage();
  if (!isSettled()) return;
  if (m_fitWhenDrawn) fit();
  m_fitWhenDrawn = false;
  emit settled();
}

void DigraphView::forgetDocument() {
  GraphView::forgetDocument();
  m_placer->forget();
  m_drawings->cancel();
  m_fitWhenDrawn = true;
}

QString DigraphView::message() const {
  if (!isSettled()) return tr("Laying out %1 links").arg(mechanism().links.size());
  return GraphView::message();
}

DrawingView::Highlight DigraphView::highlight() const {
  const MeshId mesh = chosenMesh();
  if (mesh.empty()) return {};
  std::optional<CycleWalk> walk = cycleWalk(*snapshot(), mesh);
  if (!walk) return {};
  return {std::move(walk->emphases), {walk->caption}, {}};
}

void DigraphView::tidy() {
  m_placer->layOut(document().mechanism());
}

Expected<Mechanism> DigraphView::withMoved(const Mechanism& mechanism, const NodeMoves& places) const {
  return withNodesMoved(m_placer->adopted(mechanism), places);
}

Expected<Mechanism> DigraphView::withLinkAt(const Mechanism& mechanism, CanvasPoint at) const {
  return withLink(m_placer->adopted(mechanism), at);
}

/// The places of the nodes are kept with it: the note may be about one of them.
Expected<Mechanism> DigraphView::withNoteAt(const Mechanism& mechanism, CanvasPoint at,
                                            const std::string& text) const {
  return withNote(m_placer->adopted(mechanism), at, text);
}

ViewEntry digraphView() {
  return {.id = QStringLiteral("digraph"),
          .title = DigraphView::tr("Digraph"),
          .tip = tipOf(Term::digraph),
          .purpose = DigraphView::tr("The mechanism as a directed graph: links as circles, turning joints as "
                                     "solid arrows, gear meshes as dashed ones."),
          .helpPage = QStringLiteral("drawing"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* drawing = new DigraphView(views.document(), views.selection(), parent);
            drawing->setMeasuring(&views.workbench().measuring());
            QObject::connect(drawing, &DigraphView::settled, &views, &Views::settled);
            return drawing;
          }};
}

}  // namespace geargraph

#include "moc_digraph_view.cpp"
