#pragma once

#include "ui/tools/tool.h"

/// Draws in the schematic, where the program lays out the links: shafts on axes, shafts carried by a link,
/// and gear meshes. Drags axes.
///
///     Idle --press, Link--------------------> Shaft ----release--> Idle + AddShaft
///     Idle --press link, Turning joint------> Carried --release--> Idle + AddShaft with its carrier
///     Idle --press link, Gear mesh----------> Meshing --release--> Idle + MeshLinks
///     Idle --press axis, Select--> Grabbed --move--> Dragging + DragAxis --move--> Dragging + DragAxis
///                                     |                 |--release--> Idle + AxisDropped
///                                     +--release--> Idle +--Esc-----> Idle + AxisPutBack
///     any --Esc--> Idle
///
/// A mesh released on no link is one with the ground. A click with Turning joint or Gear mesh adds nothing.
namespace geargraph::section_tool {

struct AddShaft {
  CanvasPoint from;
  CanvasPoint to;
  LinkId carrier;  ///< empty: the link that carries the axis
  friend bool operator==(const AddShaft&, const AddShaft&) = default;
};
struct MeshLinks {
  LinkId tail;
  LinkId head;  ///< empty: the ground
  CanvasPoint from;
  CanvasPoint to;
  friend bool operator==(const MeshLinks&, const MeshLinks&) = default;
};

/// The axis follows the mouse. A sequence of these is one gesture, ended by AxisDropped or AxisPutBack.
struct DragAxis {
  AxisId axis;
  CanvasPoint from;
  CanvasPoint to;
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
  CanvasPoint from;
  CanvasPoint to;
};
struct Carried {
  LinkId carrier;
  CanvasPoint from;
  CanvasPoint to;
};
struct Meshing {
  LinkId tail;
  CanvasPoint from;
  CanvasPoint to;
};
struct Grabbed {
  AxisId axis;
  CanvasPoint from;
};
struct Dragging {
  AxisId axis;
  CanvasPoint from;
  CanvasPoint to;
};
using State = std::variant<Idle, Shaft, Carried, Meshing, Grabbed, Dragging>;

struct Step {
  State next;
  std::optional<std::variant<AddShaft, MeshLinks, DragAxis, AxisDropped, AxisPutBack>> proposal;
};

/// The transition function. `tool`: select, link, turningJoint or gearMesh; with any other the state stays
/// Idle.
[[nodiscard]] Step on(const State& state, const ToolEvent& event, ToolKind tool);

/// What the user can do next, as a sentence for the status bar.
[[nodiscard]] std::string_view hint(const State& state, ToolKind tool);

/// The line being drawn; draft() returns std::nullopt while idle.
struct Draft {
  CanvasPoint from;
  CanvasPoint to;
  enum class Style { shaft, connection, axis } style = Style::connection;
};
[[nodiscard]] std::optional<Draft> draft(const State& state);

}  // namespace geargraph::section_tool
