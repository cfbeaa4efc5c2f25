#pragma once

namespace geargraph::soak {

/// MB that the program has allocated and not freed.
[[nodiscard]] double heldMemory();

}  // namespace geargraph::soak
