#pragma once

#include <string_view>

#include "ui/tools/tool.h"

/// Sets the torques of loads: a drag to the right or upwards increases one, to the left or downwards
/// decreases it; a click lets the user type it. The Select tool does the same with a drawn load.
///
///     Idle --press joint, link--> Grabbed --move--> Pulling + PullTorque --move--> Pulling + PullTorque
///                                   |                  |--release--> Idle + TorqueSet
///                                   |                  +--Esc------> Idle + TorquePutBack
///                                   +--release--> Idle + TypeTorque
///                                   +--Esc------> Idle
namespace geargraph::load_tool {

/// The torque is to be this many steps from its value when the mouse was pressed. A sequence of these is one
/// gesture, ended by TorqueSet or TorquePutBack.
struct PullTorque {
  ElementId element;
  int steps = 0;
  bool fine = false;  ///< tenths of a step
  friend bool operator==(const PullTorque&, const PullTorque&) = default;
};
struct TorqueSet {
  friend bool operator==(const TorqueSet&, const TorqueSet&) = default;
};
struct TorquePutBack {
  friend bool operator==(const TorquePutBack&, const TorquePutBack&) = default;
};
/// After a click: the user is to type the torque.
struct TypeTorque {
  ElementId element;
  friend bool operator==(const TypeTorque&, const TypeTorque&) = default;
};

struct Idle {};
struct Grabbed {
  ElementId element;
  CanvasPoint from;
};
struct Pulling {
  ElementId element;
  CanvasPoint from;
};
using State = std::variant<Idle, Grabbed, Pulling>;

struct Step {
  State next;
  std::optional<std::variant<PullTorque, TorqueSet, TorquePutBack, TypeTorque>> proposal;
};

/// The transition function: one torque step for each Pointer::slop of mouse movement. Only for joints and
/// links.
[[nodiscard]] Step on(const State& state, const ToolEvent& event);

/// What the user can do next, as a sentence for the status bar.
[[nodiscard]] std::string_view hint(const State& state);

}  // namespace geargraph::load_tool
