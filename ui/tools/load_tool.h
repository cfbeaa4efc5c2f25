#pragma once

#include <string_view>

#include "ui/tools/tool.h"

/// Sets torques of loads: a drag to the right or upwards makes one greater, the other way smaller; a click
/// leaves it to be typed. Select does the same with a load that is drawn.
///
///     Idle --press joint, link--> Grabbed --move--> Pulling + PullTorque --move--> Pulling + PullTorque
///                                   |                  |--release--> Idle + TorqueSet
///                                   |                  +--Esc------> Idle + TorquePutBack
///                                   +--release--> Idle + TypeTorque
///                                   +--Esc------> Idle
namespace geargraph::inline tools::load_tool {

/// The torque is that many steps from where it was when the mouse was pressed. Many of them make one gesture,
/// which one of the next two closes.
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
/// A click: its torque is to be typed.
struct TypeTorque {
  ElementId element;
  friend bool operator==(const TypeTorque&, const TypeTorque&) = default;
};

struct Idle {};
struct Grabbed {
  ElementId element;
  SheetPoint from;
};
struct Pulling {
  ElementId element;
  SheetPoint from;
};
using State = std::variant<Idle, Grabbed, Pulling>;

struct Step {
  State next;
  std::optional<std::variant<PullTorque, TorqueSet, TorquePutBack, TypeTorque>> proposal;
};

/// One step of the torque for each Pointer::slop that the mouse goes. Joints and links only.
[[nodiscard]] Step on(const State& state, const ToolEvent& event);

/// What the tool expects next, a sentence for the status bar.
[[nodiscard]] std::string_view hint(const State& state);

}  // namespace geargraph::inline tools::load_tool
