#pragma once

#include <QString>

namespace geargraph::inline search {

/// What users call a command or a panel who do not know its name here ("brake" for the gearbox panel),
/// folded; empty for none. `command`: the object name of its action.
[[nodiscard]] QString everydayWordsFor(const QString& command);

}  // namespace geargraph::inline search
