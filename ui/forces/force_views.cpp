#include "ui/forces/force_views.h"

#include <QObject>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

struct ViewFacts {
  ForceView view;
  ForceQuestion question;
  std::optional<ForceTableKind> kind;
};

constexpr ViewFacts kViews[] = {
    {ForceView::needs, ForceQuestion::need, ForceTableKind::needs},
    {ForceView::joints, ForceQuestion::need, ForceTableKind::joints},
    {ForceView::couplings, ForceQuestion::need, ForceTableKind::couplings},
    {ForceView::states, ForceQuestion::need, ForceTableKind::states},
    {ForceView::powers, ForceQuestion::flow, ForceTableKind::powers},
    {ForceView::losses, ForceQuestion::flow, ForceTableKind::meshes},
    {ForceView::circulations, ForceQuestion::flow, ForceTableKind::circulations},
    {ForceView::efficiency, ForceQuestion::flow, std::nullopt},
    {ForceView::meshes, ForceQuestion::parts, ForceTableKind::meshes},
    {ForceView::bearings, ForceQuestion::parts, ForceTableKind::bearings},
    {ForceView::why, ForceQuestion::why, std::nullopt},
};

const ViewFacts& factsOf(ForceView view) {
  return *std::find_if(std::begin(kViews), std::end(kViews),
                       [view](const ViewFacts& each) { return each.view == view; });
}

QString tipOfView(ForceView view) {
  switch (view) {
    case ForceView::needs:
      return QObject::tr("Torque, rate and power where the train is driven, loaded and held");
    case ForceView::joints:
      return QObject::tr("Torque, rate and power in every turning joint, and of what acts on links");
    case ForceView::couplings:
      return QObject::tr("Torques of the brakes and clutches that are engaged");
    case ForceView::states:
      return QObject::tr("Torques of the couplings and efficiency in every state of the gearbox");
    case ForceView::powers:
      return QObject::tr("What every element delivers to each of its links, seen from the ground");
    case ForceView::losses:
      return QObject::tr("What every mesh passes, seen from its carrier, and what it loses of that");
    case ForceView::circulations:
      return QObject::tr("Power that goes round in loops, beside what goes through the train");
    case ForceView::efficiency:
      return QObject::tr(
          "Efficiency forward and backward, where the train locks itself, and both over the ratio of two "
          "speeds or over the efficiency of the meshes");
    case ForceView::meshes:
      return QObject::tr("Torques on the gears of every mesh, and tooth forces");
    case ForceView::bearings:
      return QObject::tr("What holds each link in its turning joint: force and moment");
    case ForceView::why:
      return {};
  }
  return {};
}

QString titleOf(const ViewFacts& facts) {
  if (facts.view == ForceView::losses) return QObject::tr("Losses");
  if (facts.view == ForceView::efficiency) return QObject::tr("Efficiency");
  return facts.kind ? shownText(translated(forceTableTitle(*facts.kind))) : QString();
}

QString nameOf(const ViewFacts& facts) {
  if (facts.view == ForceView::losses) return QStringLiteral("losses");
  if (facts.view == ForceView::efficiency) return QStringLiteral("efficiency");
  return facts.kind ? shownText(forceTableCommandName(*facts.kind)) : QStringLiteral("why");
}

}  // namespace

std::vector<QuestionEntry> questionEntries() {
  return {
      {ForceQuestion::need, QStringLiteral("need"), QObject::tr("What do I need?"),
       QObject::tr("The torques at motors, brakes and clutches, as engaged and in each state")},
      {ForceQuestion::flow, QStringLiteral("flow"), QObject::tr("Where does it go?"),
       QObject::tr("Power, losses, power that circulates, and efficiency forward and backward")},
      {ForceQuestion::parts, QStringLiteral("parts"), QObject::tr("What do parts carry?"),
       QObject::tr("The forces on teeth and bearings")},
      {ForceQuestion::why, QStringLiteral("why"), QObject::tr("Why?"),
       QObject::tr("The cutset whose torques balance, and the row of speeds with its column of torques")},
  };
}

std::vector<ForceViewEntry> forceViewEntries() {
  std::vector<ForceViewEntry> entries;
  for (const ViewFacts& facts : kViews)
    entries.push_back(
        {facts.view, facts.question, facts.kind, nameOf(facts), titleOf(facts), tipOfView(facts.view)});
  return entries;
}

ForceQuestion questionOf(ForceView view) {
  return factsOf(view).question;
}

std::optional<ForceTableKind> kindOf(ForceView view) {
  return factsOf(view).kind;
}

bool showsColumn(ForceView view, int column) {
  const auto at = static_cast<MeshColumn>(column);
  if (view == ForceView::meshes) return at < MeshColumn::efficiency;
  if (view == ForceView::losses) return at < MeshColumn::onTail || at >= MeshColumn::efficiency;
  return true;
}

}  // namespace geargraph
