#pragma once

#include <QString>

#include "core/design/gearboxes/hub_search.h"

namespace geargraph {

/// "the ring of set 1", "sun 2 of set 2": a wheel by its name in files, "1.ring", "2.sun2".
[[nodiscard]] QString hubWheelWords(const QString& name);
/// "gear 4" in the language in use, of a measured gear by its name in files.
[[nodiscard]] QString hubGearWords(const QString& name);
/// "2, 3 or 6": numbers of planets; "none".
[[nodiscard]] QString hubPlanetsText(const HubSet& set);
/// "42 on 14": a sun with its step of the planets.
[[nodiscard]] QString hubSunText(const HubSun& sun);

}  // namespace geargraph
