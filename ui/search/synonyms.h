#pragma once

#include <QString>

namespace geargraph::inline search {

/// Synonyms by which users may search for a command or panel ("brake" for the gearbox panel), folded; empty:
/// none. `command`: the object name of its action.
[[nodiscard]] QString synonymsFor(const QString& command);

}  // namespace geargraph::inline search
