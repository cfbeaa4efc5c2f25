#pragma once

#include <QString>

#include "core/teaching/derivation/glossary.h"

namespace geargraph {

/// The definition of a term as a tooltip: its name in bold, the text, the paper's equation.
[[nodiscard]] QString tipOf(Term term);

/// A text from core in the form that widgets show.
[[nodiscard]] QString shownText(std::string_view text);

}  // namespace geargraph
