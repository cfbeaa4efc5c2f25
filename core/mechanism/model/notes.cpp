#include "core/mechanism/model/notes.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/checked_edit.h"
#include "core/mechanism/model/element_pointer.h"
#include "core/mechanism/model/limits.h"

namespace geargraph {
namespace {

/// The control characters of ASCII; those of Latin-1 are the two bytes C2 80 .. C2 9F.
bool isControl(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  if (byte < 0x20 || byte == 0x7F) return true;
  return byte == 0xC2 && at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) < 0xA0;
}

bool hasControls(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\n' && isControl(text, i)) return true;
  }
  return false;
}

bool isBlank(std::string_view text) {
  return text.find_first_not_of(" \n") == std::string_view::npos;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & '\xC0') != '\x80'; }));
}

/// Without the sign of a zero, which would be lost on the way through a file or the history.
CanvasPoint place(CanvasPoint at) {
  return {at.x + 0.0, at.y + 0.0};
}

Expected<Mechanism> checked(Mechanism mechanism) {
  return checkedEdit(std::move(mechanism), "/view/notes", &noteDiagnostics);
}

Diagnostic unknown(NoteId note) {
  return {Code::unknownId, translated("There is no note \"%1\".", {note.text()}), {note}, {}, 0, 0};
}

}  // namespace

std::string noteText(std::string_view typed) {
  std::string text;
  for (std::size_t i = 0; i < typed.size(); ++i) {
    if (typed[i] == '\r') {
      if (i + 1 == typed.size() || typed[i + 1] != '\n') text += '\n';
    } else if (typed[i] == '\n' || !isControl(typed, i)) {
      text += typed[i];
    } else {
      text += ' ';
      if (typed[i] == '\xC2') ++i;
    }
  }
  const std::size_t begin = std::min(text.find_first_not_of(" \n"), text.size());
  const std::size_t end = text.find_last_not_of(" \n");
  return end == std::string::npos ? std::string() : text.substr(begin, end + 1 - begin);
}

std::vector<NoteId> freshNoteIds(const Mechanism& mechanism, std::size_t count) {
  std::unordered_set<NoteId> taken;
  for (const CanvasNote& note : mechanism.view.notes) taken.insert(note.id);
  std::vector<NoteId> fresh;
  for (int number = 1; fresh.size() < count; ++number) {
    const NoteId id("N" + std::to_string(number));
    if (!taken.contains(id)) fresh.push_back(id);
  }
  return fresh;
}

Expected<Mechanism> withNote(Mechanism mechanism, CanvasPoint at, std::string text) {
  const NoteId id = freshNoteIds(mechanism, 1).front();
  mechanism.view.notes.push_back({id, std::move(text), place(at)});
  return checked(std::move(mechanism));
}

Expected<Mechanism> withNoteText(Mechanism mechanism, NoteId note, std::string text) {
  std::vector<CanvasNote>& notes = mechanism.view.notes;
  const auto found =
      std::find_if(notes.begin(), notes.end(), [note](const CanvasNote& each) { return each.id == note; });
  if (found == notes.end()) return unknown(note);
  found->text = std::move(text);
  return checked(std::move(mechanism));
}

Expected<Mechanism> withNotesMoved(Mechanism mechanism,
                                   std::span<const std::pair<NoteId, CanvasPoint>> notes) {
  std::unordered_map<NoteId, CanvasNote*> known;
  for (CanvasNote& note : mechanism.view.notes) known.emplace(note.id, &note);
  for (const auto& [id, at] : notes) {
    const auto found = known.find(id);
    if (found == known.end()) return unknown(id);
    found->second->at = place(at);
  }
  return checked(std::move(mechanism));
}

Diagnostics noteDiagnostics(const Mechanism& mechanism) {
  const std::vector<CanvasNote>& notes = mechanism.view.notes;
  Diagnostics diagnostics;
  const auto add = [&](std::string message, std::vector<ElementId> elements, std::string pointer) {
    diagnostics.push_back({Code::schema, std::move(message), std::move(elements), std::move(pointer), 0, 0});
  };
  if (notes.size() > kMaxNotes)
    add(translated("A document has at most 1,000 notes; this one has %1.", {std::to_string(notes.size())}),
        {}, "/view/notes");
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const CanvasNote& note = notes[i];
    const std::string at = pointerTo(ElementKind::note, i);
    if (characters(note.id.text()) > kMaxNameLength)
      add(translated("A name has at most 1,000 characters; this one has %1.",
                     {std::to_string(characters(note.id.text()))}),
          {note.id}, at + "/id");
    if (characters(note.text) > kMaxNoteLength)
      add(translated("A note has at most 1,000 characters; this one has %1.",
                     {std::to_string(characters(note.text))}),
          {note.id}, at + "/text");
    if (isBlank(note.text)) add(translated("A note needs a text."), {note.id}, at + "/text");
    if (hasControls(note.text))
      add(translated("A note is lines of text without control characters."), {note.id}, at + "/text");
    constexpr double kMax = static_cast<double>(kLargestLength);
    const bool isNear = std::abs(note.at.x) <= kMax && std::abs(note.at.y) <= kMax;
    if (!isNear) add(translated("expected a coordinate from -1e15 to 1e15."), {note.id}, at + "/at");
  }
  return diagnostics;
}

}  // namespace geargraph
