#include "core/presentation/diagrams/lever_card.h"

#include <optional>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_words.h"

namespace geargraph {
namespace {

const LeverPoint& cardPoint(const LeverPicture& picture, int lever, int point) {
  return picture.plan.levers[static_cast<std::size_t>(lever)].points[static_cast<std::size_t>(point)];
}

std::optional<Rational> cardSpeed(const LeverPicture& picture, const LeverPoint& point) {
  if (picture.speeds.empty()) return std::nullopt;
  return picture.speeds[static_cast<std::size_t>(picture.plan.positionOf(point.links.front()))];
}

/// The engaged brake that holds a link of the point; null if none does.
const ShiftElement* holdingBrake(const Mechanism& mechanism, const LeverPicture& picture,
                                 const LeverPoint& point) {
  for (const ShiftElementOrdinal each : picture.engaged) {
    const ShiftElement& coupling = mechanism.couplings[each];
    if (coupling.kind != ShiftElementKind::brake) continue;
    for (const LinkOrdinal link : point.links)
      if (mechanism.links[link].id == coupling.links.front()) return &coupling;
  }
  return nullptr;
}

std::string pointTitle(const Mechanism& mechanism, const LeverPicture& picture, const LeverPoint& point) {
  const std::string labels = labelsOf(point.links);
  if (point.links.size() == 1 && point.links.front() == 0) return translated("The ground");
  std::string title;
  if (point.links.size() > 1) {
    title = translated("Links %1", {labels});
  } else if (const std::string& name = mechanism.links[point.links.front()].name; !name.empty()) {
    title = translated("Link %1 (%2)", {labels, name});
  } else {
    title = translated("Link %1", {labels});
  }
  if (point.links.front() == 0) return title;
  const ShiftElement* const brake = holdingBrake(mechanism, picture, point);
  return brake == nullptr ? title : translated("%1: held by brake %2", {title, brake->id.text()});
}

/// "as 96 : 48 teeth", where the parts are those of the lever's two wheels.
std::string teethOfParts(const LeverPlan& plan, const Lever& lever, const Rational& parts) {
  if (lever.groups.size() != 1) return {};
  const auto& wheels = plan.groups[static_cast<std::size_t>(lever.groups.front())].wheels;
  if (wheels.size() != 2) return {};
  for (const auto& [one, other] :
       {std::pair(wheels[0].teeth, wheels[1].teeth), std::pair(wheels[1].teeth, wheels[0].teeth)}) {
    if (parts == Rational(one, other))
      return translated(", as %1 : %2 teeth", {std::to_string(one), std::to_string(other)});
  }
  return {};
}

/// Where an inner point is between the ends; the one inner point where the point itself is an end.
std::string placeWords(const LeverPlan& plan, const Lever& lever, int point) {
  const int last = static_cast<int>(lever.points.size()) - 1;
  const bool isEnd = point == 0 || point == last;
  if (isEnd && last != 2) {
    const LeverPoint& other = lever.points[static_cast<std::size_t>(last - point)];
    return translated("an end of the lever, %1 the other", {labelsOf(other.links)});
  }
  const LeverPoint& inner = lever.points[static_cast<std::size_t>(isEnd ? 1 : point)];
  const Rational parts = inner.at / (Rational(1) - inner.at);
  const std::string text = parts.toString();
  const std::size_t slash = text.find('/');
  return translated("%1 divides %2 to %3 in %4 : %5",
                    {labelsOf(inner.links), labelsOf(lever.points.front().links),
                     labelsOf(lever.points.back().links), text.substr(0, slash),
                     slash == std::string::npos ? "1" : text.substr(slash + 1)}) +
         teethOfParts(plan, lever, parts);
}

std::string speedWords(const Lever& lever, int point, const Rational& speed) {
  std::string words = translated("%1 rad/s", {fractionAndDecimals(speed)});
  const int last = static_cast<int>(lever.points.size()) - 1;
  if (point == 0 || point == last) return words;
  const Rational& at = lever.points[static_cast<std::size_t>(point)].at;
  return words + translated(": %1 of the speed of %2 and %3 of that of %4",
                            {(Rational(1) - at).toString(), labelsOf(lever.points.front().links),
                             at.toString(), labelsOf(lever.points.back().links)});
}

const Rational* cardTorque(const LeverPicture& picture, int lever, int point) {
  const auto at = static_cast<std::size_t>(lever);
  if (at >= picture.torques.size() || picture.torques[at].empty()) return nullptr;
  return &picture.torques[at][static_cast<std::size_t>(point)];
}

}  // namespace

std::string fractionAndDecimals(const Rational& value) {
  const std::string decimals = threeDecimals(value);
  if (value.isInteger()) return decimals;
  return (value.sign() < 0 ? "−" : "") + value.abs().toString() + " = " + decimals;
}

LeverCard leverCard(const Mechanism& mechanism, const LeverPicture& picture, int lever, int point) {
  const Lever& bar = picture.plan.levers[static_cast<std::size_t>(lever)];
  const LeverPoint& at = cardPoint(picture, lever, point);
  LeverCard card{pointTitle(mechanism, picture, at), {}};
  std::string place = placeWords(picture.plan, bar, point);
  if (!at.isByMeshes) place += translated(", by these tooth counts only");
  card.rows.push_back({translated("place"), std::move(place)});
  if (const auto speed = cardSpeed(picture, at))
    card.rows.push_back({translated("speed"), speedWords(bar, point, *speed)});
  if (const Rational* const torque = cardTorque(picture, lever, point))
    card.rows.push_back(
        {translated("torque"), translated("%1 N m on this lever", {fractionAndDecimals(*torque)})});
  return card;
}

std::string pointSentence(const Mechanism& mechanism, const LeverPicture& picture, int lever, int point) {
  const Lever& bar = picture.plan.levers[static_cast<std::size_t>(lever)];
  const LeverPoint& at = cardPoint(picture, lever, point);
  const std::string sets = setsOf(bar);
  const std::string title = pointTitle(mechanism, picture, at);
  const bool isInner = point > 0 && point + 1 < static_cast<int>(bar.points.size());
  std::string words = sets.empty() ? title : translated("%1: %2", {sets, title});
  words += isInner ? translated(", %1 of the way from %2 to %3",
                                {at.at.toString(), labelsOf(bar.points.front().links),
                                 labelsOf(bar.points.back().links)})
                   : translated(", an end of the lever");
  if (const auto speed = cardSpeed(picture, at)) words += translated(", %1 rad/s", {threeDecimals(*speed)});
  if (const Rational* const torque = cardTorque(picture, lever, point))
    words += translated(", %1 N m", {threeDecimals(*torque)});
  return words;
}

}  // namespace geargraph
