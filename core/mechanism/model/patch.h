#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// What is different between two texts: all but what they begin and end with alike.
struct TextPatch {
  std::size_t at = 0;  ///< bytes that both begin with
  std::string before;
  std::string after;
};

/// Elements of a list in place of others, at a position of either list.
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

/// Both values of what is replaced whole; none where they are equal.
template <class Value>
using ValuePatch = std::optional<std::pair<Value, Value>>;

/// Members of other programs: the texts that changed, by position, where both have the same members; else
/// all.
struct MemberPatch {
  std::vector<std::pair<std::size_t, TextPatch>> changed;
  ValuePatch<UnknownMembers> replaced;
};

/// The difference between two versions of a document, from which either gives the other. The history keeps
/// these instead of documents: an edit of one element costs some hundred bytes, whatever the size of the
/// document.
class MechanismPatch {
 public:
  /// Cost: O(n + t + c) comparisons.
  MechanismPatch(const Mechanism& before, const Mechanism& after);

  /// The document after the edit from the one before it, and the other way round.
  /// Cost: O(n + t + c). @pre the document is the one that the patch was made of
  [[nodiscard]] Mechanism forward(Mechanism before) const;
  [[nodiscard]] Mechanism back(Mechanism after) const;

  [[nodiscard]] bool isEmpty() const { return m_isEmpty; }
  /// Memory that the patch holds, counted from its contents.
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }

 private:
  using Node = std::pair<LinkId, SheetPoint>;
  struct NodePatch {
    std::vector<Node> before;  ///< gone or moved
    std::vector<Node> after;   ///< new or moved
  };
  static NodePatch nodePatch(const std::map<LinkId, SheetPoint>& before,
                             const std::map<LinkId, SheetPoint>& after);
  static void apply(const NodePatch& patch, std::map<LinkId, SheetPoint>& nodes, bool forward);

  void apply(Mechanism& mechanism, bool forward) const;
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
  ValuePatch<std::optional<Number>> m_density;
  ValuePatch<std::optional<NumberTriple>> m_gravity;
  NodePatch m_nodes;
  NodePatch m_ttNodes;
  ListPatch<SheetNote> m_sheetNotes;
  ValuePatch<std::optional<ViewCamera>> m_camera;
  MemberPatch m_viewMembers;
  MemberPatch m_members;
  bool m_isEmpty = true;
  std::size_t m_bytes = 0;
};

}  // namespace geargraph::inline model
