#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Notes on the digraph's sheet and their edits: pure functions, as in edits.h. withoutElements() also removes
// notes. No number of the analysis depends on them.

constexpr std::size_t kMaxNoteLength = 1'000;  ///< characters of a note, including line ends
constexpr std::size_t kMaxNotes = 1'000;       ///< in a document

/// Normalizes a typed or pasted text for a note: line ends become "\n", other control characters spaces;
/// leading and trailing spaces and empty lines are removed. The length is not limited.
[[nodiscard]] std::string noteText(std::string_view typed);

/// A new note at the end of the list, with the smallest free id of "N1", "N2", ... Rejects schema: a
/// violation of noteDiagnostics().
[[nodiscard]] Expected<Mechanism> withNote(Mechanism mechanism, CanvasPoint at, std::string text);
/// Rejects unknown-id, and schema as withNote().
[[nodiscard]] Expected<Mechanism> withNoteText(Mechanism mechanism, NoteId note, std::string text);
/// Rejects unknown-id. Cost: O(notes + moves).
[[nodiscard]] Expected<Mechanism> withNotesMoved(Mechanism mechanism,
                                                 std::span<const std::pair<NoteId, CanvasPoint>> notes);

/// The first `count` ids of "N1", "N2", ... that no note has.
[[nodiscard]] std::vector<NoteId> freshNoteIds(const Mechanism& mechanism, std::size_t count);

/// Violations, one `schema` each: a text that is empty, too long or has control characters, an id that is too
/// long, a position beyond +-kLargestLength, too many notes. Part of limitDiagnostics().
[[nodiscard]] Diagnostics noteDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph
