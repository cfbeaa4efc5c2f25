#include "ui/lever_views/levers_tips.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <set>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/diagrams/lever_card.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("ui_levers", text);
}

QString tipText(const std::string& text) {
  return QString::fromStdString(text);
}

QString lettersOf(const std::vector<ShiftElementId>& couplings) {
  std::vector<std::string> names;
  for (const ShiftElementId& each : couplings) names.push_back(each.text());
  return tipText(listed(names, kAllNames, tr("and").toUtf8().constData()));
}

bool isOnPoint(const Mechanism& mechanism, const ShiftElement& coupling, const LeverPoint& point) {
  return std::any_of(point.links.begin(), point.links.end(), [&](LinkOrdinal link) {
    return std::find(coupling.links.begin(), coupling.links.end(), mechanism.links[link].id) !=
           coupling.links.end();
  });
}

/// The ratio of a state, if it is known.
std::optional<Rational> ratioOf(const std::vector<StateSolution>& states, int state) {
  for (const StateSolution& each : states)
    if (each.state == state) return each.ratio;
  return std::nullopt;
}

std::set<ShiftElementId> only(const std::set<ShiftElementId>& from, const std::set<ShiftElementId>& without) {
  std::set<ShiftElementId> rest;
  std::set_difference(from.begin(), from.end(), without.begin(), without.end(),
                      std::inserter(rest, rest.end()));
  return rest;
}

/// States that differ from what is engaged by one coupling for another, one of them at the point.
QStringList otherStates(const Mechanism& mechanism, const AnalysisSnapshot& newest, const LeverPoint& point) {
  constexpr qsizetype kMost = 3;
  QStringList lines;
  const std::set<ShiftElementId> now(mechanism.engaged.begin(), mechanism.engaged.end());
  for (std::size_t i = 0; i < mechanism.states.size() && lines.size() < kMost; ++i) {
    const ShiftState& state = mechanism.states[i];
    const std::set<ShiftElementId> then(state.engaged.begin(), state.engaged.end());
    const std::set<ShiftElementId> leaves = only(now, then);
    const std::set<ShiftElementId> comes = only(then, now);
    if (leaves.size() != 1 || comes.size() != 1) continue;
    const ShiftElement* const left = mechanism.find(*leaves.begin());
    const ShiftElement* const taken = mechanism.find(*comes.begin());
    if (left == nullptr || taken == nullptr) continue;
    if (!isOnPoint(mechanism, *left, point) && !isOnPoint(mechanism, *taken, point)) continue;
    QString line = tr("%1 for %2: state %3")
                       .arg(tipText(taken->id.text()), tipText(left->id.text()), tipText(state.name));
    if (newest.states) {
      if (const auto ratio = ratioOf(*newest.states, static_cast<int>(i)))
        line += tr(", ratio %1").arg(tipText(fractionAndDecimals(*ratio)));
    }
    lines << line;
  }
  return lines;
}

/// What letting go and holding would do to the freedom.
QStringList freedoms(const DrawnLevers& drawn, const Mechanism& mechanism, const LeverPoint& point) {
  QStringList lines;
  bool isHeld = point.links.front() == 0;
  for (const auto& [coupling, freedom] : drawn.freedomWithout) {
    if (!isOnPoint(mechanism, mechanism.couplings[coupling], point)) continue;
    isHeld |= mechanism.couplings[coupling].kind == ShiftElementKind::brake;
    const QString letter = tipText(mechanism.couplings[coupling].id.text());
    lines << (freedom == 1 ? tr("let go of %1: 1 freedom").arg(letter)
                           : tr("let go of %1: %2 freedoms").arg(letter).arg(freedom));
  }
  const MatroidAnalysis* const matroid = drawn.snapshot->matroid();
  if (isHeld || matroid == nullptr || drawn.perInput.empty()) return lines;
  const auto at = static_cast<std::size_t>(drawn.picture.plan.positionOf(point.links.front()));
  const bool turns = std::any_of(drawn.perInput.begin(), drawn.perInput.end(),
                                 [&](const auto& speeds) { return !speeds[at].isZero(); });
  if (!turns) {
    lines << tr("hold it (B): it does not turn anyway");
  } else if (const int left = matroid->dof - 1; left == 0) {
    lines << tr("hold it (B): nothing turns any more");
  } else {
    lines << (left == 1 ? tr("hold it (B): 1 freedom") : tr("hold it (B): %1 freedoms").arg(left));
  }
  return lines;
}

QString tableOf(const QString& title, const std::vector<std::pair<QString, QString>>& rows) {
  QString text =
      QStringLiteral("<p style='white-space:nowrap'><b>%1</b></p><table>").arg(title.toHtmlEscaped());
  for (const auto& [name, what] : rows) {
    text += QStringLiteral("<tr><td style='padding-right:10px'>%1</td><td>%2</td></tr>")
                .arg(name.toHtmlEscaped(),
                     what.toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br>")));
  }
  return text + QStringLiteral("</table>");
}

}  // namespace

QString leverTip(const DrawnLevers& drawn, const Mechanism& mechanism, const AnalysisSnapshot& newest,
                 const LeverSpot& spot) {
  const LeverCard card = leverCard(mechanism, drawn.picture, spot.lever, spot.point);
  std::vector<std::pair<QString, QString>> rows;
  for (const LeverCard::Row& row : card.rows) rows.emplace_back(tipText(row.name), tipText(row.text));
  const LeverPoint& point = drawn.picture.plan.levers[static_cast<std::size_t>(spot.lever)]
                                .points[static_cast<std::size_t>(spot.point)];
  const QStringList instead = otherStates(mechanism, newest, point) + freedoms(drawn, mechanism, point);
  if (!instead.isEmpty()) rows.emplace_back(tr("instead"), instead.join(QLatin1Char('\n')));
  return tableOf(tipText(card.title), rows);
}

QString pointsOfLink(const DrawnLevers& drawn, const Mechanism& mechanism, LinkId link) {
  QStringList lines;
  const auto& levers = drawn.picture.plan.levers;
  for (std::size_t lever = 0; lever < levers.size(); ++lever) {
    for (std::size_t i = 0; i < levers[lever].points.size(); ++i) {
      const auto& links = levers[lever].points[i].links;
      if (std::any_of(links.begin(), links.end(),
                      [&](LinkOrdinal each) { return mechanism.links[each].id == link; }))
        lines << tipText(
            pointSentence(mechanism, drawn.picture, static_cast<int>(lever), static_cast<int>(i)));
    }
  }
  return lines.join(QLatin1Char('\n'));
}

QString stateTip(const DrawnLevers& drawn, const Mechanism& mechanism, int state) {
  const ShiftState& shown = mechanism.states[static_cast<std::size_t>(state)];
  QString text = shown.engaged.empty()
                     ? tr("State %1: nothing engaged").arg(tipText(shown.name))
                     : tr("State %1: %2").arg(tipText(shown.name), lettersOf(shown.engaged));
  if (const auto ratio = ratioOf(drawn.states.states, state))
    text += tr(", ratio %1").arg(tipText(fractionAndDecimals(*ratio)));
  return text;
}

}  // namespace geargraph
