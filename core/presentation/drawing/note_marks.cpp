#include "core/presentation/drawing/note_marks.h"

#include <algorithm>

#include "core/presentation/drawing/arrow_marks.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr double kNoteWidth = 260;  ///< px of the longest line
constexpr double kLinePitch = 17;
constexpr double kPadding = 8;
constexpr double kCorner = 3;
constexpr double kHaloGrowth = 5;

double widthOf(std::string_view text) {
  return textWidth(text, kNoteTextSize, false);
}

/// The bytes of the longest beginning of a word that fits into a line, whole characters, at least one.
std::size_t fittingBytes(std::string_view word) {
  std::size_t fits = 0;
  double width = 0;
  for (std::size_t i = 0; i < word.size();) {
    std::size_t end = i + 1;
    while (end < word.size() && (word[end] & '\xC0') == '\x80') ++end;
    width += widthOf(word.substr(i, end - i));
    if (width > kNoteWidth && fits > 0) break;
    fits = end;
    i = end;
  }
  return fits;
}

/// Adds one line of the text, broken where it is too wide.
void addBroken(std::string_view line, std::vector<std::string>& lines) {
  std::string current;
  double width = 0;
  const double blank = widthOf(" ");
  const auto close = [&] {
    lines.push_back(std::move(current));
    current.clear();
    width = 0;
  };
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    if (word.empty()) continue;
    const double wordWidth = widthOf(word);
    if (!current.empty() && width + blank + wordWidth > kNoteWidth) close();
    while (current.empty() && widthOf(word) > kNoteWidth) {
      const std::size_t fits = fittingBytes(word);
      lines.emplace_back(word.substr(0, fits));
      word.remove_prefix(fits);
    }
    if (word.empty()) continue;
    if (!current.empty()) {
      current += ' ';
      width += blank;
    }
    current += word;
    width += widthOf(word);
  }
  close();
}

}  // namespace

std::vector<std::string> noteLines(std::string_view text) {
  std::vector<std::string> lines;
  while (true) {
    const std::size_t end = text.find('\n');
    addBroken(text.substr(0, end), lines);
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

std::vector<NotePlace> placedNotes(const std::vector<CanvasNote>& notes) {
  std::vector<NotePlace> places;
  places.reserve(notes.size());
  for (const CanvasNote& note : notes) places.push_back({note.id, noteLines(note.text), onSheet(note.at)});
  return places;
}

Extent noteExtent(const NotePlace& place) {
  double widest = 0;
  for (const std::string& line : place.lines) widest = std::max(widest, widthOf(line));
  return {place.center, widest / 2 + kPadding,
          static_cast<double>(place.lines.size()) * kLinePitch / 2 + kPadding / 2};
}

DisplayList noteDrawing(const NotePlace& place, const Emphasis& emphasis) {
  DisplayList list;
  Pen pen(list, place.note);
  const Extent box = noteExtent(place);
  if (emphasis.any()) {
    pen.put(MarkRole::halo, kHaloDepth,
            Fill{Box{box.grown(kHaloGrowth), kCorner + kHaloGrowth}, ColorRole::halo});
  }
  pen.put(MarkRole::label, kNoteDepth, Fill{Box{box, kCorner}, ColorRole::panel});
  const Tint border = emphasis.selected ? ColorRole::accent : ColorRole::control;
  pen.put(MarkRole::label, kNoteDepth,
          Stroke{Box{box, kCorner}, border, emphasis.selected ? 1.6 : 1, Dash::solid});
  double y = place.center.y - static_cast<double>(place.lines.size() - 1) * kLinePitch / 2;
  for (const std::string& line : place.lines) {
    if (!line.empty())
      pen.put(MarkRole::name, kNoteDepth,
              Text{line, {place.center.x, y}, kNoteTextSize, false, ColorRole::ink});
    y += kLinePitch;
  }
  list.outlines.push_back({place.note, kNoteDepth, Box{box, 0}, 0});
  return list;
}

}  // namespace geargraph
