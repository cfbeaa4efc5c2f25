#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

// Notes on the digraph's sheet and their edits: pure functions, as in edits.h. Notes also go with
// withoutElements(). No number of the analysis depends on them.

constexpr std::size_t kLongestNote = 1'000;  ///< characters of a note, line ends among them
constexpr std::size_t kMostNotes = 1'000;    ///< of a document

/// What people type or paste, as a note can hold it: line ends are "\n", other control characters blanks;
/// blanks around the text are left out. It is not cut.
[[nodiscard]] std::string noteText(std::string_view typed);

/// A new note at the end of the list, with the smallest free id of "N1", "N2", ... Rejects schema: what
/// noteDiagnostics() finds.
[[nodiscard]] Expected<Mechanism> withNote(Mechanism mechanism, SheetPoint at, std::string text);
/// Rejects unknown-id, and schema as withNote().
[[nodiscard]] Expected<Mechanism> withNoteText(Mechanism mechanism, NoteId note, std::string text);
/// Rejects unknown-id. Cost: O(notes + moves).
[[nodiscard]] Expected<Mechanism> withNotesMoved(Mechanism mechanism,
                                                 std::span<const std::pair<NoteId, SheetPoint>> notes);

/// The first `count` ids of "N1", "N2", ... that no note bears.
[[nodiscard]] std::vector<NoteId> freshNoteIds(const Mechanism& mechanism, std::size_t count);

/// One `schema` each: a text that is empty or too long or has control characters, a place beyond
/// +-kLargestLength, too many notes. Part of limitDiagnostics().
[[nodiscard]] Diagnostics noteDiagnostics(const Mechanism& mechanism);

}  // namespace geargraph::inline model
