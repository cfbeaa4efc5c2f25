#pragma once

namespace geargraph::soak {

/// Counts QObjects from now on, by the hooks that Qt has for debuggers. Call before the first one is made.
void countObjects();
/// Those that are alive.
[[nodiscard]] long liveObjects();

}  // namespace geargraph::soak
