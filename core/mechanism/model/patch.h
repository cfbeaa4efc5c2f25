#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// The difference between two texts: the part between their common prefix and suffix.
struct TextPatch {
  std::size_t at = 0;  ///< length of the common prefix in bytes
  std::string before;
  std::string after;
};

/// A run of elements of a list replaced by others, with its position in either list.
template <class Element>
struct ListRun {
  std::size_t beforeAt = 0;
  std::size_t afterAt = 0;
  std::vector<Element> before;
  std::vector<Element> after;
};

/// Ascending runs, with equal elements between them.
template <class Element>
using ListPatch = std::vector<ListRun<Element>>;

/// The old and the new value of what is replaced as a whole; none if they are equal.
template <class Value>
using ValuePatch = std::optional<std::pair<Value, Value>>;

/// Unknown members: the changed texts, by position, if both versions have the same members; else all of them.
struct MemberPatch {
  std::vector<std::pair<std::size_t, TextPatch>> changed;
  ValuePatch<UnknownMembers> replaced;
};

/// The difference between two versions of a document, from which either gives the other. The history stores
/// patches instead of documents: an edit of one element takes some hundred bytes, whatever the size of the
/// document.
class MechanismPatch {
 public:
  /// Cost: O(n + t + c) comparisons.
  MechanismPatch(const Mechanism& before, const Mechanism& after);

  /// The document after the edit from the one before it, and vice versa.
  /// Cost: O(n + t + c).
  /// @pre the document is the one that the patch was made from
  [[nodiscard]] Mechanism forward(Mechanism before) const;
  [[nodiscard]] Mechanism back(Mechanism after) const;

  [[nodiscard]] bool isEmpty() const { return m_isEmpty; }
  /// Memory that the patch holds, counted from its contents.
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }

 private:
  using Node = std::pair<LinkId, SheetPoint>;
  using LinkColor = std::pair<LinkId, int>;
  struct NodePatch {
    std::vector<Node> before;  ///< gone or moved
    std::vector<Node> after;   ///< new or moved
  };
  static NodePatch nodePatch(const std::map<LinkId, SheetPoint>& before,
                             const std::map<LinkId, SheetPoint>& after);
  static void apply(const NodePatch& patch, std::map<LinkId, SheetPoint>& nodes, bool forward);

  void apply(Mechanism& mechanism, bool forward) const;
  [[nodiscard]] bool hasNothing() const;
  void count();

  std::optional<TextPatch> m_name;
  std::optional<TextPatch> m_notes;
  std::optional<TextPatch> m_unit;
  ListPatch<Link> m_links;
  ListPatch<Axis> m_axes;
  ListPatch<TurningJoint> m_turningJoints;
  ListPatch<GearMesh> m_gearMeshes;
  ListPatch<Wheel> m_wheels;
  ListPatch<Coupling> m_couplings;
  ListPatch<Input> m_inputs;
  ListPatch<ShiftState> m_states;
  ValuePatch<std::vector<CouplingId>> m_engaged;
  ListPatch<Load> m_loads;
  bool m_inputsBefore = false;  ///< stated at all
  bool m_inputsAfter = false;
  ValuePatch<std::optional<GearDefaults>> m_gearDefaults;
  ValuePatch<std::optional<std::vector<Balance>>> m_balances;
  ValuePatch<std::optional<LoadSharing>> m_sharing;
  ValuePatch<std::optional<Number>> m_driveTorque;
  ValuePatch<std::optional<Number>> m_density;
  ValuePatch<std::optional<NumberTriple>> m_gravity;
  NodePatch m_nodes;
  NodePatch m_ttNodes;
  ListPatch<SheetNote> m_sheetNotes;
  ValuePatch<std::optional<ViewCamera>> m_camera;
  std::vector<LinkColor> m_colorsBefore;  ///< gone or another
  std::vector<LinkColor> m_colorsAfter;   ///< new or another
  MemberPatch m_viewMembers;
  MemberPatch m_members;
  bool m_isEmpty = true;
  std::size_t m_bytes = 0;
};

}  // namespace geargraph::inline model
