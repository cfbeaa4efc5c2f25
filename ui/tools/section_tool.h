#pragma once

#include "ui/tools/tool.h"

/// Draws in the section drawing, where the program lays links out: shafts on axes, shafts that a link
/// carries, and gear meshes.
///
///     Idle --press, Link--------------------> Shaft ----release--> Idle + AddShaft
///     Idle --press link, Turning joint------> Carried --release--> Idle + AddShaft with its carrier
///     Idle --press link, Gear mesh----------> Meshing --release--> Idle + MeshLinks
///     any --Esc--> Idle
///
/// A mesh that is released on no link is meant with the ground. A click with Turning joint or Gear mesh leads
/// nowhere.
namespace geargraph::section_tool {

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
using State = std::variant<Idle, Shaft, Carried, Meshing>;

struct Step {
  State next;
  std::optional<std::variant<AddShaft, MeshLinks>> proposal;
};

/// `tool`: link, turningJoint or gearMesh; any other stays idle.
[[nodiscard]] Step on(const State& state, const ToolEvent& event, ToolKind tool);

/// What the tool expects next, a sentence for the status bar.
[[nodiscard]] std::string_view hint(const State& state, ToolKind tool);

/// The line that is being drawn; nothing while idle.
struct Draft {
  SheetPoint from;
  SheetPoint to;
  bool isShaft = false;
};
[[nodiscard]] std::optional<Draft> draft(const State& state);

}  // namespace geargraph::section_tool
