#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Builds a mechanism link by link: ids are whole numbers in order of links, joints and meshes; link 0 is the
/// ground. Sets are built with it and inserted into documents (insertion.h).
class SetSketch {
 public:
  explicit SetSketch(std::string name);

  /// Adds a link that turns about the axis on `parent`; a new axis is added without a place. Returns the
  /// link's number.
  LinkOrdinal link(LinkOrdinal parent, const std::string& axis, std::string name);
  /// The same for one that slides along the axis.
  LinkOrdinal slidingLink(LinkOrdinal parent, const std::string& axis, std::string name);
  /// Sets the offset of a link's bearing on its parent along its axis; 0 by default.
  void bearing(LinkOrdinal link, std::int64_t offset);
  /// Adds an axis with a place.
  void axis(const std::string& id, const NumberTriple& point, const NumberTriple& direction);
  GearMesh& mesh(int tail, int head, int tailTeeth, int headTeeth, MeshKind kind);
  /// Adds a wheel on a link, which meshes can name: meshes that name different wheels do not share one.
  WheelId wheel(const std::string& id, LinkOrdinal link);
  void input(LinkOrdinal link, const Number& speed);
  void brake(const std::string& id, LinkOrdinal link);
  /// Engages a coupling now.
  void engage(const std::string& id);
  void clutch(const std::string& id, LinkOrdinal link, int other);
  void state(const std::string& name, const std::vector<std::string>& engaged, int drive, int driven);

  /// The mechanism with places for the nodes: the ground, the links on it in a column, the rest in another.
  [[nodiscard]] Mechanism build() &&;

 private:
  Mechanism m_mechanism;
  ByLink<LinkOrdinal> m_parents{-1};
};

}  // namespace geargraph
