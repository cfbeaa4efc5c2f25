#include "ui/models/axis_choices.h"

#include <QCoreApplication>
#include <algorithm>

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("AxisChoices", text);
}

/// The axes with the fewest joints between them and these in the document's order, then others: at most
/// kMaxAxesOffered.
std::vector<AxisId> nearestAxes(const Mechanism& mechanism, const std::set<AxisId>& of) {
  std::set<AxisId> reached = of;
  std::set<LinkId> links;
  const std::size_t most = of.size() + kMaxAxesOffered;
  for (bool grows = true; grows && reached.size() < most;) {
    grows = false;
    const std::set<AxisId> from = reached;
    for (const TurningJoint& joint : mechanism.turningJoints) {
      if (!from.contains(joint.axis)) continue;
      links.insert(joint.tail);
      links.insert(joint.head);
    }
    for (const TurningJoint& joint : mechanism.turningJoints) {
      if (reached.size() >= most) break;
      if (!links.contains(joint.tail) && !links.contains(joint.head)) continue;
      grows |= reached.insert(joint.axis).second;
    }
  }
  std::vector<AxisId> nearest;
  for (const bool isReached : {true, false}) {
    for (const Axis& axis : mechanism.axes) {
      if (nearest.size() >= kMaxAxesOffered) break;
      if (!of.contains(axis.id) && reached.contains(axis.id) == isReached) nearest.push_back(axis.id);
    }
  }
  return nearest;
}

}  // namespace

std::vector<NamedAxisChoice> axisChoices(const Mechanism& mechanism, const std::set<AxisId>& of) {
  using Way = AxisChoice::Way;
  std::vector<NamedAxisChoice> choices{{{}, tr("Along x"), {Way::alongX}},
                                       {{}, tr("Along y"), {Way::alongY}},
                                       {{}, tr("Along z"), {Way::alongZ}}};
  const std::pair<Way, QString> groups[] = {{Way::squareTo, tr("Square to")},
                                            {Way::parallelTo, tr("Parallel to")},
                                            {Way::throughIntersection, tr("Through the meeting point of")}};
  const std::vector<AxisId> offered = nearestAxes(mechanism, of);
  const bool isAll = offered.size() + of.size() >= mechanism.axes.size();
  for (const auto& [way, group] : groups) {
    const QString title = isAll ? group : tr("%1 (nearest axes)").arg(group);
    for (const AxisId& axis : offered)
      choices.push_back({title, tr("Axis %1").arg(QString::fromStdString(axis.text())), {way, axis}});
  }
  return choices;
}

}  // namespace geargraph
