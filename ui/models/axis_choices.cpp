#include "ui/models/axis_choices.h"

#include <QCoreApplication>

namespace geargraph::inline models {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("AxisChoices", text);
}

}  // namespace

std::vector<NamedAxisChoice> axisChoices(const Mechanism& mechanism, const std::set<AxisId>& of) {
  using Way = AxisChoice::Way;
  std::vector<NamedAxisChoice> choices{{{}, tr("Along x"), {Way::alongX}},
                                       {{}, tr("Along y"), {Way::alongY}},
                                       {{}, tr("Along z"), {Way::alongZ}}};
  const std::pair<Way, QString> groups[] = {{Way::squareTo, tr("Square to")},
                                            {Way::parallelTo, tr("Parallel to")},
                                            {Way::throughMeeting, tr("Through the meeting point of")}};
  for (const auto& [way, group] : groups) {
    for (const Axis& axis : mechanism.axes) {
      if (of.contains(axis.id)) continue;
      choices.push_back({group, tr("Axis %1").arg(QString::fromStdString(axis.id.text())), {way, axis.id}});
    }
  }
  return choices;
}

}  // namespace geargraph::inline models
