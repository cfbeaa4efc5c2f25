// Loads in a drawing: torques that are typed, or set by dragging an element or the chip of a load.

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/presentation/drawing/hit_test.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/in_place_editor.h"
#include "ui/canvas/mark_painter.h"
#include "ui/canvas/rename_editor.h"

namespace geargraph {
namespace {

/// What a drag changes a torque by at a time: a tenth of its power of ten, 1 N m for none.
double stepOf(double torque) {
  if (torque == 0) return 1;
  return std::pow(10, std::floor(std::log10(std::abs(torque))) - 1);
}

QString words(std::string_view text) {
  return QCoreApplication::translate("tools", std::string(text).c_str());
}

}  // namespace

QString DrawingView::whyNoLoadOn(const ElementId& element) const {
  if (element == ElementId(mechanism().links.front().id))
    return tr("The ground takes any load: select a moving link.");
  const bool can = element.kind == ElementKind::turningJoint || element.kind == ElementKind::link;
  return can ? QString() : tr("Loads act in turning joints and on links.");
}

QString DrawingView::whyNoLoad() const {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1) return tr("Select one turning joint or link to load it.");
  return whyNoLoadOn(*selected.begin());
}

void DrawingView::editLoad() {
  if (!whyNoLoad().isEmpty()) return;
  const ElementId element = *m_selection->selected().begin();
  const std::vector<Outline>& outlines = m_scene->outlines();
  const auto drawn = std::find_if(outlines.begin(), outlines.end(),
                                  [&](const Outline& outline) { return outline.element == element; });
  if (drawn == outlines.end()) return;
  auto* editor = new RenameEditor(m_commands.torqueOf(element), viewport());
  editor->setObjectName(QStringLiteral("torqueEditor"));
  editor->setPlaceholderText(tr("10 Nm"));
  editor->setAccessibleName(tr("Torque that acts here"));
  constexpr QSize kSize(110, 26);
  const CanvasPoint middle = extentOf(drawn->shape).center;
  editor->setGeometry(
      QRect(mapFromScene(QPointF(middle.x, middle.y)) - QPoint(kSize.width() / 2, -12), kSize));
  connect(editor, &RenameEditor::taken, this, [this, element](const QString& text) {
    const QString why = m_commands.setTorque(element, text);
    if (!why.isEmpty()) setHint(why);
  });
  openInPlace(editor, this, *m_document);
}

std::optional<ElementId> DrawingView::loadUnder(QPointF viewportPlace) const {
  const CanvasPoint place = toSheetPoint(mapToScene(viewportPlace.toPoint()));
  if (elementAt(m_scene->outlines(), place, 0)) return std::nullopt;
  const auto element = elementAt(m_scene->underlay().outlines, place, 0);
  const bool isOne = element && whyNoLoadOn(*element).isEmpty() && m_commands.hasTorque(*element);
  return isOne ? element : std::nullopt;
}

bool DrawingView::grabLoad(QPointF viewportPlace, Pointer pointer) {
  if (tool() == ToolKind::select) {
    const std::optional<ElementId> load = pointer.add ? std::nullopt : loadUnder(viewportPlace);
    if (!load) return false;
    pointer.on = load;
  } else if (tool() != ToolKind::load) {
    return false;
  }
  if (!pointer.on) {
    m_selection->clear();
    return true;
  }
  m_selection->select({*pointer.on});
  if (const QString why = whyNoLoadOn(*pointer.on); !why.isEmpty()) {
    setHint(why);
    return true;
  }
  stepLoad(Pressed{pointer});
  return true;
}

void DrawingView::stepLoad(const ToolEvent& event) {
  load_tool::Step step = load_tool::on(m_load, event);
  m_load = std::move(step.next);
  if (!step.proposal) return;
  if (const auto* pull = std::get_if<load_tool::PullTorque>(&*step.proposal)) pullLoad(*pull);
  if (std::holds_alternative<load_tool::TypeTorque>(*step.proposal) && tool() == ToolKind::load) editLoad();
  if (std::holds_alternative<load_tool::TorquePutBack>(*step.proposal) && m_loadDrag) {
    // Back to the very value it had: the step merges with the drag's and both are gone.
    m_document->apply(
        {tr("Set load"),
         [before = m_loadDrag->before](const Mechanism&) -> Expected<Mechanism> { return *before; },
         m_loadDrag->gesture});
  }
  if (isLoadDragged()) return;
  if (m_loadDrag && m_fitted) fit();  // what the torques have done to the chips
  m_loadDrag.reset();
  if (!m_hintBeforeLoad.isNull()) setHint(std::exchange(m_hintBeforeLoad, QString()));
}

void DrawingView::pullLoad(const load_tool::PullTorque& pull) {
  if (!m_loadDrag) {
    m_loadDrag = LoadDrag{m_document->newGesture(), m_document->mechanism()};
    m_hintBeforeLoad = m_hint;
  }
  const MechanismPtr& before = m_loadDrag->before;
  Number torque = givenTorque(*before, pull.element);
  if (pull.steps != 0) {
    const double step = stepOf(torque.value()) / (pull.fine ? 10 : 1);
    const auto count = std::llround(torque.value() / step) + pull.steps;
    torque = Number(Rational(count) * Number::fromDouble(step).exact());
  }
  m_document->apply({m_commands.hasTorque(pull.element) ? tr("Set load") : tr("Add load"),
                     [before, torque, element = pull.element](const Mechanism&) {
                       return withTorque(*before, element, torque);
                     },
                     m_loadDrag->gesture});
  setHint(tr("%1 N m. %2").arg(QString::fromStdString(torque.text()), words(load_tool::hint(m_load))));
}

}  // namespace geargraph
