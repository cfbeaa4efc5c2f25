#include "ui/designer/hit_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "core/design/gearboxes/gearbox_json.h"
#include "core/presentation/lever_drawing/lever_words.h"
#include "ui/models/printed_number.h"

namespace geargraph::inline designer {
namespace {

QString membersJoined(const std::vector<std::string>& members) {
  QStringList words;
  for (const std::string& each : members) words << QString::fromStdString(each);
  return words.join(' ');
}

}  // namespace

QString elementLetter(int position) {
  return QChar('A' + position);
}

QString decimalOf(const Rational& value) {
  return QString::fromStdString(threeDecimals(value));
}

QString percentOf(const Rational& part) {
  if (part.isZero()) return QCoreApplication::translate("designer", "exact");
  return decimalOf(part * Rational(100)) + QStringLiteral(" %");
}

QString fractionOf(const Rational& value) {
  return withPrintedMinus(QString::fromStdString(value.toString()));
}

QString elementsOf(const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  QStringList words;
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
    const ElementLinks& each = gearbox.elements[i];
    const std::string other = each.isBrake() ? "0" : linkWord(sets, gearbox.layout, each.b);
    words << QStringLiteral("%1: %2 = %3")
                 .arg(elementLetter(static_cast<int>(i)),
                      QString::fromStdString(linkWord(sets, gearbox.layout, each.a)),
                      QString::fromStdString(other));
  }
  return words.join(QStringLiteral(", "));
}

QString linksOf(const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  QStringList links;
  for (int link = 1; link <= wish.limits.shafts; ++link)
    links << membersJoined(membersOn(sets, gearbox.layout, link));
  const QString held = membersJoined(membersOn(sets, gearbox.layout, 0));
  if (!held.isEmpty()) links << held + QStringLiteral(" = 0");
  return links.join(QStringLiteral(", "));
}

QString teethOf(const Gearbox& gearbox) {
  QStringList sets;
  for (const TeethOption& option : gearbox.teeth) {
    QStringList parts;
    for (const SetTeeth& part : option.parts) {
      QStringList numbers{QString::number(part.sun), QString::number(part.planet)};
      if (part.outer != 0) numbers << QString::number(part.outer);
      parts << (numbers << QString::number(part.ring)).join(' ');
    }
    sets << parts.join(QStringLiteral(" + "));
  }
  return sets.join(QStringLiteral(", "));
}

int leastEfficientGear(const Gearbox& gearbox) {
  int least = -1;
  if (!gearbox.losses) return least;
  const auto& all = gearbox.losses->efficiencies;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] && (least < 0 || *all[i] < *all[static_cast<std::size_t>(least)])) least = static_cast<int>(i);
  }
  return least;
}

int lockedGear(const Gearbox& gearbox) {
  if (!gearbox.losses) return -1;
  const auto& all = gearbox.losses->efficiencies;
  const auto found = std::find(all.begin(), all.end(), std::nullopt);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

int farthestGear(const Gearbox& gearbox) {
  const auto found =
      std::max_element(gearbox.gears.begin(), gearbox.gears.end(),
                       [](const GearState& a, const GearState& b) { return a.error < b.error; });
  return static_cast<int>(found - gearbox.gears.begin());
}

}  // namespace geargraph::inline designer
