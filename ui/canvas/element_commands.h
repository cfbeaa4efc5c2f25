#pragma once

#include <QString>

#include <functional>

#include "core/mechanism/geometry_edits/axis_choice.h"
#include "core/presentation/drawing/planar.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"

namespace geargraph {

/// Sets the torque in a joint or on a link, N m, replacing an existing one.
/// @pre the element is one of either kind
[[nodiscard]] Expected<Mechanism> withTorque(const Mechanism& before, const ElementId& element,
                                             const Number& torque);
/// The given torque there, N m; 0 if there is none.
[[nodiscard]] Number givenTorque(const Mechanism& mechanism, const ElementId& element);

/// The commands of keys and menus on elements, for any drawing: one undo step each.
class ElementCommands {
 public:
  /// Both arguments outlive it.
  ElementCommands(Document& document, Selection& selection) : m_document(document), m_selection(selection) {}

  /// Sets what tells the part of the digraph's sheet that is in sight, where new nodes are placed if there is
  /// room; empty or none: anywhere.
  void setSight(std::function<Extent()> sight) { m_sight = std::move(sight); }

  void selectAll(bool notes);       ///< `notes`: also notes; only the views know if they show these
  void removeSelected(bool notes);  ///< the ground is kept if other elements are selected too
  void flipSelected();              ///< tail and head of the selected arrows exchanged
  /// Makes these joints, or those that carry these links, inputs, or removes the inputs. Returns the reason
  /// if that is not possible, else an empty text.
  QString toggleInputs(const std::set<ElementId>& elements);
  void rename(LinkId link, const QString& name);
  void makeGround(LinkId link);
  /// Makes the two selected links one, and selects it. Returns the reason if that is not possible, else an
  /// empty text.
  QString weldSelected();
  /// Divides the selected link, and selects the new one; the same.
  QString splitSelected();
  /// Adds a link on the same carrier that meshes with this one, and selects it. Returns the reason if that is
  /// not possible, else an empty text.
  QString attachGear(LinkId link);
  void pin(const ElementId& element,
           bool pinned);  ///< an axis, a link for the teeth of its gears, or a mesh for its module
  void placeAxis(AxisId axis, const AxisChoice& choice);  ///< guessed kinds of its meshes are adapted
  void setMeshKind(MeshId mesh, MeshKind kind);           ///< axes and pitch points follow
  void flipSide(MeshId mesh, bool ofTail);                ///< of a bevel: to the other side of the apex
  void addBrake(LinkId link);                             ///< with a new brake that is engaged
  void addClutch(LinkId one, LinkId other);               ///< with a new clutch that is engaged
  void addFreewheel(LinkId one, LinkId other);            ///< `one` may not turn faster than `other`
  void engage(ShiftElementId coupling, bool engaged);
  /// Engages or releases the brake of the link; adds one if it has none.
  void toggleBrake(LinkId link);
  void removeCoupling(const ElementId& coupling);
  /// Sets the torque in a joint or on a link, "10 Nm"; an empty text removes it. Returns the reason if that
  /// is not possible, else an empty text.
  QString setTorque(const ElementId& element, const QString& text);
  /// The torque in the format of setTorque(); empty if none acts there.
  [[nodiscard]] QString torqueOf(const ElementId& element) const;
  /// Is there a given torque?
  [[nodiscard]] bool hasTorque(const ElementId& element) const;

 private:
  void apply(const QString& text, Reduce reduce);

  /// A place for a new node beside that of a link.
  [[nodiscard]] std::optional<CanvasPoint> placeBeside(LinkId link) const;

  Document& m_document;
  Selection& m_selection;
  std::function<Extent()> m_sight;
};

}  // namespace geargraph
