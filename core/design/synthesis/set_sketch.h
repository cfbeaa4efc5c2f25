#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// Writes a set down, link by link: ids are whole numbers in order of links, joints and meshes; link 0 is the
/// ground. The members of a set are built with it, and then go into documents (insertion.h).
class SetSketch {
 public:
  explicit SetSketch(std::string name);

  /// A new link that turns about the axis on `parent`; an axis that is not known yet is left open. Returns
  /// its number.
  int link(int parent, const std::string& axis, std::string name);
  /// Where along its axis a link's bearing on its parent stands; at the axis's point where nothing is said.
  void bearing(int link, std::int64_t offset);
  /// An axis with a place.
  void axis(const std::string& id, const NumberTriple& point, const NumberTriple& direction);
  GearMesh& mesh(int tail, int head, int tailTeeth, int headTeeth, MeshKind kind);
  /// A wheel on a link, for meshes to name: meshes that name several do not share one.
  WheelId wheel(const std::string& id, int link);
  void input(int link, const Number& speed);
  void brake(const std::string& id, int link);
  /// Engages a coupling now.
  void engage(const std::string& id);
  void clutch(const std::string& id, int link, int other);
  void state(const std::string& name, const std::vector<std::string>& engaged, int drive, int driven);

  /// With places for the nodes: the ground, the links on it in a column, the rest in another.
  [[nodiscard]] Mechanism build() &&;

 private:
  Mechanism m_mechanism;
  std::vector<int> m_parents{-1};  ///< by link
};

}  // namespace geargraph::inline synthesis
