#include "ui/designer/hub_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace geargraph {
QString hubWheelWords(const QString& name) {
  const QString set = name.section('.', 0, 0);
  const QString wheel = name.section('.', 1);
  if (wheel == QLatin1String("ring"))
    return QCoreApplication::translate("designer", "the ring of set %1").arg(set);
  const QString step = wheel.right(1);
  return (wheel.startsWith(QLatin1String("sun"))
              ? QCoreApplication::translate("designer", "sun %2 of set %1")
              : QCoreApplication::translate("designer", "planet step %2 of set %1"))
      .arg(set, step);
}

QString hubGearWords(const QString& name) {
  return QCoreApplication::translate("designer", "gear %1").arg(name.section(' ', 1));
}

QString hubPlanetsText(const HubSet& set) {
  if (set.planets.empty()) return QCoreApplication::translate("designer", "none");
  QStringList numbers;
  for (const int each : set.planets) numbers << QString::number(each);
  return numbers.join(' ');
}

QString hubSunText(const HubSun& sun) {
  return QCoreApplication::translate("designer", "%1 on %2").arg(sun.teeth).arg(sun.planet);
}

}  // namespace geargraph
