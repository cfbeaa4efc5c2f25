#pragma once

#include <QString>

#include "core/mechanism/fitting/axis_choice.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"

namespace geargraph::inline canvas {

/// The mechanism with this torque in a joint or on a link, N m, in place of the one that acts there.
/// @pre the element is one of either kind
[[nodiscard]] Expected<Mechanism> withTorque(const Mechanism& before, const ElementId& element,
                                             const Number& torque);
/// The torque that is given there, N m; 0 where there is none.
[[nodiscard]] Number givenTorque(const Mechanism& mechanism, const ElementId& element);

/// What keys and menus do with elements in any drawing: an edit of one undo step each.
class ElementCommands {
 public:
  /// Refers to both.
  ElementCommands(Document& document, Selection& selection) : m_document(document), m_selection(selection) {}

  void selectAll(bool notes);       ///< of which views alone know whether they show them
  void removeSelected(bool notes);  ///< the ground stays, where other things are selected too
  void flipSelected();              ///< tail and head of the selected arrows exchanged
  /// Drives these joints, or those that carry these links, or stops driving them. Where that is not possible
  /// it answers why.
  QString toggleInputs(const std::set<ElementId>& elements);
  void rename(LinkId link, const QString& name);
  void makeGround(LinkId link);
  /// A new link beside this one on the same carrier, in mesh with it; it is selected then. Where that is not
  /// possible it answers why.
  QString attachGear(LinkId link);
  void pin(const ElementId& element,
           bool pinned);  ///< an axis, a link for the teeth of its gears, or a mesh for its module
  void layAxis(AxisId axis, const AxisChoice& choice);  ///< guesses about its meshes give way
  void makeKind(MeshId mesh, MeshKind kind);            ///< axes and pitch points follow
  void flipSide(MeshId mesh, bool ofTail);              ///< of a bevel: to the other side of the apex
  void hold(LinkId link);                               ///< with a new brake that is engaged
  void tie(LinkId one, LinkId other);                   ///< with a new clutch that is engaged
  void engage(CouplingId coupling, bool engaged);
  /// Engages the brake of the link, a new one where it has none, or releases it.
  void toggleBrake(LinkId link);
  void takeOff(const ElementId& coupling);
  /// The torque in a joint or on a link, "10 Nm"; an empty text removes it. Where that is not possible it
  /// answers why.
  QString setTorque(const ElementId& element, const QString& text);
  /// As setTorque() takes it; empty where no torque acts there.
  [[nodiscard]] QString torqueOf(const ElementId& element) const;
  /// Does a torque act there that is given?
  [[nodiscard]] bool hasTorque(const ElementId& element) const;

 private:
  void apply(const QString& text, Reduce reduce);

  Document& m_document;
  Selection& m_selection;
};

}  // namespace geargraph::inline canvas
