#include "ui/canvas/tt_graph_view.h"

#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/edits.h"
#include "core/theory/ttgraph/mesh_words.h"
#include "ui/canvas/f_circuits.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

constexpr std::size_t kLargeTtGraph = 300;  ///< links; up to here it takes less than a frame

/// Null where the turning joints are no spanning tree.
const TtGraph* graphOf(const SnapshotPtr& snapshot) {
  return snapshot && snapshot->kinematics ? snapshot->kinematics->ttGraph.get() : nullptr;
}

QString paragraph(const QString& text) {
  return QStringLiteral("<p style='white-space:normal'>%1</p>").arg(text.toHtmlEscaped());
}

}  // namespace

TtGraphView::TtGraphView(Document* document, Selection* selection, QWidget* parent)
    : GraphView(document, selection, new TtGraphScene, parent),
      m_scene(static_cast<TtGraphScene*>(scene())),
      m_worker([this](const Request& request, const std::stop_token&) {
        const TtGraphSheetPtr sheet =
            ttGraphSheet(*request.mechanism, graphOf(request.snapshot), request.layout, request.stop);
        if (!sheet) return;
        QMetaObject::invokeMethod(
            this, [this, request, sheet] { arrived(request, sheet); }, Qt::QueuedConnection);
      }) {
  setAccessibleName(tr("T-T graph"));
  updateMessage();
}

TtGraphView::~TtGraphView() {
  m_stop.request_stop();
}

void TtGraphView::requestStop() {
  m_stop.request_stop();
  m_worker.requestStop();
}

// --- what is shown ----------------------------------------------------------------------------------------

bool TtGraphView::isAnalyzed() const {
  return snapshot() && isSameButForView(*snapshot()->mechanism, mechanism());
}

const TtGraph* TtGraphView::graph() const {
  return graphOf(snapshot());
}

void TtGraphView::rebuild() {
  if (isAnalyzed()) draw();  // else the analysis is about to come
}

void TtGraphView::setSnapshot(const SnapshotPtr& snapshot) {
  // Places that moved since are drawn already.
  const bool isDrawn =
      this->snapshot() && !m_toFit && isSameButForView(*this->snapshot()->mechanism, *snapshot->mechanism);
  GraphView::setSnapshot(snapshot);
  if (isDrawn) return;
  m_layout.clear();
  if (isAnalyzed()) draw();
}

void TtGraphView::showEvent(QShowEvent* event) {
  GraphView::showEvent(event);
  catchUp();
}

void TtGraphView::catchUp() {
  if (m_behind && isAnalyzed()) drawNow();
}

void TtGraphView::forgetDocument() {
  GraphView::forgetDocument();
  m_stop.request_stop();
  m_stop = {};
  m_shown = m_wanted;
  m_layout.clear();
  m_toFit = true;
}

void TtGraphView::draw() {
  m_behind = !isVisible();
  if (!m_behind) drawNow();
}

void TtGraphView::drawNow() {
  m_behind = false;
  const Request request{document().mechanism(), snapshot(), m_layout, ++m_wanted, m_stop.get_token()};
  if (mechanism().links.size() <= kLargeTtGraph) {
    return arrived(request, ttGraphSheet(*request.mechanism, graph(), request.layout));
  }
  m_worker.request(request);
  updateMessage();
}

void TtGraphView::arrived(const Request& request, const TtGraphSheetPtr& sheet) {
  if (request.number <= m_shown) return;  // of another document, or superseded
  m_shown = request.number;
  if (request.snapshot == snapshot()) m_layout = sheet->layout;
  m_scene->show(sheet);
  captionLater();
  tellWhatIsMissing();
  updateEmphases();
  updateMessage();
  if (std::exchange(m_toFit, false)) fit();
  emit drawn();
}

const NodePositions& TtGraphView::positions() const {
  static const NodePositions kNone;
  return m_scene->sheet() == nullptr ? kNone : m_scene->sheet()->positions;
}

QString TtGraphView::message() const {
  if (!isUpToDate() && m_toFit) return tr("Laying out %1 links").arg(mechanism().links.size());
  return GraphView::message();
}

QString TtGraphView::whyNoPicture() const {
  return isUpToDate() && !m_behind ? QString()
                                   : tr("The T–T graph is still being laid out. Try again in a moment.");
}

void TtGraphView::tellWhatIsMissing() {
  constexpr std::size_t kMaxLines = 3;
  QStringList lines;
  if (graph() == nullptr) {
    if (mechanism().n() > 0) {
      lines << tr("No tree yet: turning joints have to tie every link to the ground and close no loop.");
      if (mechanism().c() > 0) lines << tr("Then the dotted meshes get their transfer vertices.");
    }
  } else {
    const Diagnostics missing = graph()->diagnostics();
    for (std::size_t i = 0; i < std::min(missing.size(), kMaxLines); ++i) {
      lines << QString::fromStdString(missing[i].message);
    }
    if (missing.size() > kMaxLines) lines << tr("And %1 more.").arg(missing.size() - kMaxLines);
  }
  setNotice(lines);
}

DrawingView::Highlight TtGraphView::highlight() const {
  const MeshId chosen = chosenMesh();
  if (chosen.empty() || graph() == nullptr) return {};
  const Digraph& digraph = graph()->graph();
  for (int mesh = 0; mesh < digraph.c(); ++mesh) {
    if (digraph.edgeId(digraph.t() + mesh) != ElementId(chosen)) continue;
    std::optional<FCircuits> circuits = fCircuits(*graph(), mesh);
    if (!circuits) return {};
    return {std::move(circuits->emphases), std::move(circuits->caption), std::move(circuits->colors)};
  }
  return {};
}

// --- tips -------------------------------------------------------------------------------------------------

QString TtGraphView::toolTipFor(const ElementId& element) const {
  const QString plain = paragraph(GraphView::toolTipFor(element));
  if (graph() == nullptr) return plain;
  const Digraph& digraph = graph()->graph();
  if (element.kind == ElementKind::link) {
    QStringList carried;
    for (int mesh = 0; mesh < digraph.c(); ++mesh) {
      const auto& vertex = graph()->transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
      if (vertex && digraph.nodeId(vertex->carrier) == LinkId(element.id)) {
        carried << QString::number(digraph.edgeLabel(digraph.t() + mesh));
      }
    }
    if (carried.empty()) return plain;
    return plain + paragraph(tr("Transfer vertex of %1").arg(carried.join(QStringLiteral(", ")))) +
           tipOf(Term::transferVertex);
  }
  for (int edge = 0; edge < digraph.edgeCount(); ++edge) {
    if (digraph.edgeId(edge) != element) continue;
    if (edge >= digraph.t()) return plain + meshTip(edge - digraph.t());
    const QString name = QString::fromStdString(inPrint(branchName(digraph, edge).toText()));
    const QString level = QString::fromStdString(graph()->levels().levelOf(edge));
    return plain + paragraph(tr("Branch %1 on level %2").arg(name, level)) + tipOf(Term::level);
  }
  return plain;
}

QString TtGraphView::meshTip(int mesh) const {
  const std::optional<MeshWords> words = meshWords(*graph(), mesh);
  if (!words) return paragraph(tr("It has no transfer vertex.")) + tipOf(Term::transferVertex);
  QString tip = QString::fromStdString(words->set + ": " + words->path);
  if (!words->terminal.empty()) tip += QStringLiteral(". ") + QString::fromStdString(words->terminal);
  return paragraph(tip) + tipOf(Term::chord);
}

QString TtGraphView::captionToolTip() const {
  return tipOf(Term::transferVertex) + tipOf(Term::terminalEquation) + tipOf(Term::fundamentalCircuit);
}

// --- places -----------------------------------------------------------------------------------------------

void TtGraphView::tidy() {
  document().apply({tr("Tidy the T-T graph"),
                    [](Mechanism before) {
                      before.view.ttNodes.clear();
                      return before;
                    },
                    0});
  fit();
}

Expected<Mechanism> TtGraphView::withMoved(const Mechanism& mechanism, const NodeMoves& places) const {
  return withTtNodesMoved(mechanism, places);
}

Expected<Mechanism> TtGraphView::withLinkAt(const Mechanism& mechanism, CanvasPoint at) const {
  Expected<Mechanism> added = withLink(mechanism, at);
  if (!added) return added;
  Mechanism next = std::move(added).value();
  const NodeMoves place{{next.links.back().id, at}};
  next.view.nodes.erase(place.front().first);  // that place is one of this drawing, not of the digraph
  return withTtNodesMoved(std::move(next), place);
}

ViewEntry ttGraphView() {
  return {.id = QStringLiteral("ttgraph"),
          .title = TtGraphView::tr("T–T graph"),
          .tip = tipOf(Term::ttGraph),
          .purpose = TtGraphView::tr(
              "The mechanism after Tsai and Tokad, with levels, chords and transfer vertices."),
          .helpPage = QStringLiteral("t-t-graph-method"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* drawing = new TtGraphView(views.document(), views.selection(), parent);
            drawing->setMeasuring(&views.workbench().measuring());
            QObject::connect(drawing, &TtGraphView::drawn, &views, &Views::settled);
            return drawing;
          }};
}

}  // namespace geargraph

#include "moc_tt_graph_view.cpp"
