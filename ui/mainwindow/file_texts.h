#pragma once

#include <QString>

#include "core/mechanism/model/difference.h"
#include "ui/document/document.h"

namespace geargraph {

/// The file types of the dialog that saves documents.
[[nodiscard]] QString documentFilter();
/// Those of the dialog that opens them, including tables.
[[nodiscard]] QString readableFilter();

/// A difference between documents as text: "2 links added, 1 mesh removed".
[[nodiscard]] QString textOf(const Difference& difference);

/// The edit that replaces the whole mechanism, named `text` in the undo list.
[[nodiscard]] Edit takingOver(const QString& text, const MechanismPtr& mechanism);

}  // namespace geargraph
