#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph {

/// The lines of a note's text: broken at line ends, and wrapped to the width of notes between words, or
/// within a word that is wider. Cost: O(text).
[[nodiscard]] std::vector<std::string> noteLines(std::string_view text);

[[nodiscard]] std::vector<NotePlace> placedNotes(const std::vector<CanvasNote>& notes);

/// The bounding box of a note.
[[nodiscard]] Extent noteExtent(const NotePlace& place);

/// The box is the only outline. Lines are centred, to stay in it in any font and writing direction.
[[nodiscard]] DisplayList noteDrawing(const NotePlace& place, const Emphasis& emphasis);

}  // namespace geargraph
