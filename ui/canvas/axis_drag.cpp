#include "ui/canvas/axis_drag.h"

#include <QCursor>
#include <QMenu>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

QString lengthText(double length, const Mechanism& mechanism) {
  return QStringLiteral("%1 %2").arg(printedNumber(length, 5), QString::fromStdString(mechanism.unit));
}

}  // namespace

AxisDrag::AxisDrag(Document* document, QWidget* view) : QObject(view), m_document(document), m_view(view) {}

void AxisDrag::begin(AxisId axis) {
  if (m_drag && m_drag->axis == axis) return;
  m_drag = Drag{m_document->newGesture(), m_document->placed(), axis};
}

bool AxisDrag::apply(const Reduce& reduce) {
  const bool done = m_document->apply(
      {tr("Move axis %1").arg(QString::fromStdString(m_drag->axis.text())), reduce, m_drag->gesture});
  const QString reach = reachText();
  if (done && !reach.isEmpty()) emit hintChanged(tr("%1. Alt places freely, Esc puts back").arg(reach));
  return done;
}

void AxisDrag::move(const Move& move) {
  if (m_drag) apply([move, before = m_drag->before](const PlacedMechanism&) { return move(before); });
}

void AxisDrag::moveBy(const Vector3& way, bool snapped) {
  if (!m_drag) return;
  move([way, snapped, axis = m_drag->axis](const PlacedMechanism& before) {
    return withAxisDragged(before, axis, way, snapped);
  });
}

void AxisDrag::nudge(AxisId axis, const Vector3& way) {
  m_drag.reset();
  begin(axis);
  moveBy(way, false);
  if (const QString reach = reachText(); !reach.isEmpty()) emit hintChanged(reach);
  m_drag.reset();
}

void AxisDrag::putBack() {
  if (!m_drag) return;
  apply([before = m_drag->before](const PlacedMechanism&) { return before; });
  end();
}

QString AxisDrag::reachText() const {
  const PlacedMechanism& placed = m_document->placed();
  const std::optional<AxisReach> reach = axisReach(placed, m_drag->axis);
  if (!reach) return {};
  return tr("Axis %1 is %2 from axis %3, module %4")
      .arg(QString::fromStdString(m_drag->axis.text()), lengthText(reach->distance, placed),
           QString::fromStdString(reach->from.text()), lengthText(reach->module, placed));
}

void AxisDrag::drop() {
  if (!m_drag) return;
  const PlacedMechanism moved = m_document->placed();
  const std::optional<AxisReach> reach = axisReach(moved, m_drag->axis);
  std::vector<TeethOffer> offers;
  if (reach && moved.pointer() != m_drag->before.pointer())
    offers = teethNear(m_drag->before, m_drag->axis, reach->distance);
  if (offers.empty()) return end();
  auto* menu = new QMenu(m_view);
  menu->setObjectName(QStringLiteral("axisOffer"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto offer = [&](const QString& text, const Reduce& reduce) {
    QAction* action = menu->addAction(text);
    const auto take = [this, reduce] {
      if (m_drag) apply(reduce);
    };
    connect(action, &QAction::hovered, this, take);
    connect(action, &QAction::triggered, this, take);
    return action;
  };
  const auto stays = [moved](const PlacedMechanism&) { return moved; };
  QAction* first = offer(tr("Module %1, teeth as they are").arg(lengthText(reach->module, moved)), stays);
  menu->addSeparator();
  for (const TeethOffer& each : offers) {
    const double off = each.distance - reach->distance;
    const QString text =
        tr("%1 : %2 teeth, %3 apart, %4 off")
            .arg(each.tailTeeth)
            .arg(each.headTeeth)
            .arg(lengthText(each.distance, moved),
                 (off < 0 ? QStringLiteral("−") : QStringLiteral("+")) + lengthText(std::abs(off), moved));
    offer(text, [before = m_drag->before, each](const PlacedMechanism&) {
      return withTeethFitted(before, each.mesh, each.tailTeeth, each.headTeeth);
    });
  }
  // Closed without a choice, the axis stays where it was dropped. A choice is told after that.
  connect(menu, &QMenu::aboutToHide, this, [this, stays] {
    if (m_drag) apply(stays);
    QMetaObject::invokeMethod(this, &AxisDrag::end, Qt::QueuedConnection);
  });
  menu->setActiveAction(first);
  emit hintChanged(tr("%1. Choose tooth counts instead, or Esc").arg(reachText()));
  menu->popup(QCursor::pos());
}

void AxisDrag::end() {
  m_drag.reset();
  emit ended();
}

}  // namespace geargraph

#include "moc_axis_drag.cpp"
