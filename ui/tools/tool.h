#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The tools of the drawings, in the order of the tool bar.
enum class ToolKind { select, link, turningJoint, gearMesh, input, load, note, measure, pan };

constexpr int kToolCount = static_cast<int>(ToolKind::pan) + 1;

[[nodiscard]] std::string_view toolName(ToolKind tool);  ///< "Turning joint"
[[nodiscard]] char toolKey(ToolKind tool);               ///< shortcut key, 'T'

// --- what happens to a tool -------------------------------------------------------------------------------

/// The mouse as a tool sees it, in sheet coordinates. Tools know no widget and no zoom.
struct Pointer {
  CanvasPoint at;
  std::optional<ElementId> on;  ///< the topmost element under the mouse
  bool onSelected = false;      ///< that element is selected
  bool add = false;             ///< Shift or Ctrl: adds to the selection
  bool unsnapped = false;       ///< Alt: no snapping
  double slop = 4;              ///< largest movement of a click, in sheet units
};

struct Pressed {
  Pointer pointer;
};
struct Moved {
  Pointer pointer;
};
struct Released {
  Pointer pointer;
};
struct Escaped {};
using ToolEvent = std::variant<Pressed, Moved, Released, Escaped>;

// --- what a tool proposes ---------------------------------------------------------------------------------

struct SelectOnly {
  ElementId element;
  friend bool operator==(const SelectOnly&, const SelectOnly&) = default;
};
struct ToggleSelected {
  ElementId element;
  friend bool operator==(const ToggleSelected&, const ToggleSelected&) = default;
};
struct ClearSelection {
  friend bool operator==(const ClearSelection&, const ClearSelection&) = default;
};
/// Selects everything inside the rectangle; `add` keeps the current selection.
struct SelectInside {
  CanvasPoint from;
  CanvasPoint to;
  bool add = false;
  friend bool operator==(const SelectInside&, const SelectInside&) = default;
};
/// The selected nodes are to be displaced by this from their places when the mouse was pressed. A sequence of
/// these is one gesture, ended by MoveEnded or MoveCancelled.
struct MoveSelected {
  double dx = 0;
  double dy = 0;
  bool unsnapped = false;
  friend bool operator==(const MoveSelected&, const MoveSelected&) = default;
};
struct MoveEnded {
  friend bool operator==(const MoveEnded&, const MoveEnded&) = default;
};
struct MoveCancelled {
  friend bool operator==(const MoveCancelled&, const MoveCancelled&) = default;
};
struct AddLink {
  CanvasPoint at;
  friend bool operator==(const AddLink&, const AddLink&) = default;
};
/// A turning joint or a gear mesh.
struct AddJoint {
  ElementKind kind = ElementKind::turningJoint;
  LinkId tail;
  LinkId head;
  friend bool operator==(const AddJoint&, const AddJoint&) = default;
};
/// `element`: a turning joint, or the head link of one.
struct ToggleInput {
  ElementId element;
  friend bool operator==(const ToggleInput&, const ToggleInput&) = default;
};
/// Opens the editor for a new note centred at `at`, or for the note that was clicked.
struct WriteNote {
  CanvasPoint at;
  std::optional<NoteId> note;
  friend bool operator==(const WriteNote&, const WriteNote&) = default;
};
struct PanBy {
  double dx = 0;
  double dy = 0;
  friend bool operator==(const PanBy&, const PanBy&) = default;
};
using Proposal = std::variant<SelectOnly, ToggleSelected, ClearSelection, SelectInside, MoveSelected,
                              MoveEnded, MoveCancelled, AddLink, AddJoint, ToggleInput, WriteNote, PanBy>;

/// The effect of an event on a tool: its next state, and what it proposes.
template <class State>
struct Outcome {
  State next;
  std::vector<Proposal> proposals;
};

// --- what a tool shows meanwhile --------------------------------------------------------------------------

/// The rectangle that a rubber band spans.
struct RubberBand {
  CanvasPoint from;
  CanvasPoint to;
  friend bool operator==(const RubberBand&, const RubberBand&) = default;
};

/// An arrow being drawn from a link to another one, or to the mouse while there is none.
struct ArrowDraft {
  ElementKind kind = ElementKind::turningJoint;
  LinkId tail;
  LinkId head;  ///< empty while the mouse is over no other link
  CanvasPoint cursor;
  friend bool operator==(const ArrowDraft&, const ArrowDraft&) = default;
};

/// The joint of an arrow being drawn, for a preview of its column in the matrices. `valid`: releasing the
/// mouse now would add the joint; `head` is empty while the mouse is over no other link.
struct JointPreview {
  ElementKind kind = ElementKind::turningJoint;  ///< or gearMesh
  LinkId tail;
  LinkId head;
  bool valid = false;
  friend bool operator==(const JointPreview&, const JointPreview&) = default;
};

}  // namespace geargraph
