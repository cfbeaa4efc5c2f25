#pragma once

#include "ui/tools/tool.h"

/// Draws in the section drawing, where the program lays links out: shafts on axes, shafts that a link
/// carries, and gear meshes. Drags axes.
///
///     Idle --press, Link--------------------> Shaft ----release--> Idle + AddShaft
///     Idle --press link, Turning joint------> Carried --release--> Idle + AddShaft with its carrier
///     Idle --press link, Gear mesh----------> Meshing --release--> Idle + MeshLinks
///     Idle --press axis, Select--> Grabbed --move--> Dragging + DragAxis --move--> Dragging + DragAxis
///                                     |                 |--release--> Idle + AxisDropped
///                                     +--release--> Idle +--Esc-----> Idle + AxisPutBack
///     any --Esc--> Idle
///
/// A mesh that is released on no link is meant with the ground. A click with Turning joint or Gear mesh leads
/// nowhere.
namespace geargraph::inline tools::section_tool {

struct AddShaft {
  SheetPoint from;
  SheetPoint to;
  LinkId carrier;  ///< empty: what holds the axis
  friend bool operator==(const AddShaft&, const AddShaft&) = default;
};
struct MeshLinks {
  LinkId tail;
  LinkId head;  ///< empty: the ground
  SheetPoint from;
  SheetPoint to;
  friend bool operator==(const MeshLinks&, const MeshLinks&) = default;
};

/// The axis goes along with the mouse; many of them make one gesture, which one of the next two closes.
struct DragAxis {
  AxisId axis;
  SheetPoint from;
  SheetPoint to;
  bool unsnapped = false;
  friend bool operator==(const DragAxis&, const DragAxis&) = default;
};
struct AxisDropped {
  friend bool operator==(const AxisDropped&, const AxisDropped&) = default;
};
struct AxisPutBack {
  friend bool operator==(const AxisPutBack&, const AxisPutBack&) = default;
};

struct Idle {};
struct Shaft {
  SheetPoint from;
  SheetPoint to;
};
struct Carried {
  LinkId carrier;
  SheetPoint from;
  SheetPoint to;
};
struct Meshing {
  LinkId tail;
  SheetPoint from;
  SheetPoint to;
};
struct Grabbed {
  AxisId axis;
  SheetPoint from;
};
struct Dragging {
  AxisId axis;
  SheetPoint from;
  SheetPoint to;
};
using State = std::variant<Idle, Shaft, Carried, Meshing, Grabbed, Dragging>;

struct Step {
  State next;
  std::optional<std::variant<AddShaft, MeshLinks, DragAxis, AxisDropped, AxisPutBack>> proposal;
};

/// `tool`: select, link, turningJoint or gearMesh; any other stays idle.
[[nodiscard]] Step on(const State& state, const ToolEvent& event, ToolKind tool);

/// What the tool expects next, a sentence for the status bar.
[[nodiscard]] std::string_view hint(const State& state, ToolKind tool);

/// The line that is being drawn; nothing while idle.
struct Draft {
  SheetPoint from;
  SheetPoint to;
  enum class Look { shaft, wish, axis } look = Look::wish;
};
[[nodiscard]] std::optional<Draft> draft(const State& state);

}  // namespace geargraph::inline tools::section_tool
