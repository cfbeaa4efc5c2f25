#pragma once

#include <functional>
#include <optional>
#include <set>

#include "core/mechanism/geometry_edits/axis_choice.h"
#include "core/mechanism/model/mechanism.h"

class QMenu;

namespace geargraph {

/// The actions of a context menu, implemented by the view. Entries for adding links and tidying appear only
/// if their actions are set.
struct ContextActions {
  std::set<ElementId> selected;                           ///< including the menu's element
  std::function<std::optional<MeshKind>(MeshId)> kindOf;  ///< as shownKind()
  std::function<void()> rename;
  std::function<void()> toggleInput;
  std::function<void()> makeGround;
  std::function<void()> attachGear;
  std::function<void()> flip;
  std::function<void()> weld;                       ///< the two selected links
  std::function<void()> split;                      ///< the selected link
  std::function<void(const ElementId&, bool)> pin;  ///< an axis, a link or a mesh
  std::function<void(AxisId, const AxisChoice&)> placeAxis;
  std::function<void(MeshKind)> setMeshKind;             ///< of the mesh
  std::function<void(bool)> flipSide;                    ///< of a bevel mesh: its tail or its head
  std::function<void()> addBrake;                        ///< the link, with a new brake
  std::function<void(LinkId, LinkId)> addClutch;         ///< two links, with a new clutch
  std::function<void(LinkId, LinkId)> addFreewheel;      ///< the first may not overtake the second
  std::function<void(ShiftElementId, bool)> engage;      ///< or release a brake or a clutch
  std::function<void(const ElementId&)> removeCoupling;  ///< removes a brake or a clutch
  std::function<void()> remove;
  std::function<void()> open;  ///< opens the in-place editor of the note
  std::function<void()> addLink;
  std::function<void()> addNote;
  std::function<void()> selectAll;
  std::function<void()> tidy;
  std::function<void()> fit;
};

/// Fills a menu for an element, or for the empty sheet. An unavailable entry is disabled, with the reason in
/// its text.
void fillContextMenu(QMenu& menu, const Mechanism& mechanism, const std::optional<ElementId>& element,
                     const ContextActions& actions);

}  // namespace geargraph
