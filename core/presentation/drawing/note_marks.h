#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph::inline drawing {

/// The lines of a text as a note shows them: broken where it has line ends, and between words where a line
/// would be wider than kNoteWidth, within words that are. Cost: O(text).
[[nodiscard]] std::vector<std::string> noteLines(std::string_view text);

[[nodiscard]] std::vector<NotePlace> placedNotes(const std::vector<SheetNote>& notes);

/// The box of a note.
[[nodiscard]] Extent noteExtent(const NotePlace& place);

/// One outline, the box. Lines are centred, so that no font and no direction of writing moves them out of it.
[[nodiscard]] DisplayList noteDrawing(const NotePlace& place, const Emphasis& emphasis);

}  // namespace geargraph::inline drawing
