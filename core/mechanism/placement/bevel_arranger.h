#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/mechanism/placement/disc_hull.h"
#include "core/mechanism/placement/mesh_word.h"

namespace geargraph {

/// The default BevelArranger::sizes(): the module of a derived bevel pair in halves of the placement's
/// module.
constexpr int kUsualBevelSize = 2;

/// Chooses the half of the inner axis for a bevel wheel where the document does not determine it: the
/// negative half, from which shafts come; for the wheels of two links that mesh with the same wheel, as in a
/// differential, one on each half.
class SideNumbers {
 public:
  int side(AxisGroupOrdinal axisGroup, LinkOrdinal carrier, LinkOrdinal link, int partner) {
    const auto [known, isNew] = m_sides.try_emplace({axisGroup, carrier, link}, -1);
    std::set<int>& taken = m_taken[{axisGroup, carrier, partner}];
    if (isNew && taken.contains(-1) && !taken.contains(1)) known->second = 1;
    taken.insert(known->second);
    return known->second;
  }

 private:
  std::map<std::array<int, 3>, int> m_sides;
  std::map<std::array<int, 3>, std::set<int>> m_taken;  ///< by class, carrier and partner
};

/// Arranges bevel pairs on automatic axes without interference: how far along its neighbour's line an axis
/// intersects it, and how large the pairs about one apex are, so that no two wheels overlap in the reference
/// pose or while carriers between them turn. Wheels are represented by the hulls of their tips and bodies.
/// Cost: O(bevel wheels) per pair and place that is tried.
class BevelArranger {
 public:
  /// `words`: by mesh, none for a mesh without a carrier; empty without a tree. All arguments outlive this
  /// object.
  BevelArranger(const Mechanism& mechanism, const JointTree* tree, const AxisGroups& classes,
                SpanByMesh<const std::optional<MeshAxisPath>> words);

  /// Records the place of a line. `direction` is a unit vector.
  void setLine(AxisOrdinal axis, const Vector3& point, const Vector3& direction) {
    m_lines[axis] = Line{point, direction};
  }
  /// The number of steps (kStep modules each) along the placed line `from`, from its point to where axis `to`
  /// intersects it; `first` is tried first, then places farther and farther from 0. The wheels between the
  /// two are then recorded as placed.
  int place(int from, int to, const Vector3& direction, double module, int first);
  /// Records the wheels between two placed lines as placed.
  void stand(int from, int to, double module);

  /// By mesh: the module of the pair in halves of the placement's.
  [[nodiscard]] const ByMesh<int>& sizes() const { return m_sizes; }

  static constexpr int kStep = 2;  ///< modules

 private:
  struct Line {
    Vector3 point{};
    Vector3 direction{};
  };
  struct Wheel {
    LinkOrdinal link = 0;
    AxisGroupOrdinal axisGroup = 0;
    int teeth = 0;
    DiscHull hull;
    int partner = -1;  ///< index of the other wheel in a pair's list
  };
  using Wheels = std::vector<Wheel>;

  [[nodiscard]] const std::vector<int>& meshesBetween(int from, int to) const;
  void addPair(Wheels& wheels, MeshOrdinal mesh, int size, const Vector3& apex, const Line& from,
               const Line& to, AxisOrdinal fromAxis, double module);
  [[nodiscard]] Wheels wheelsBetween(int from, int to, const Vector3& apex, const Line& a, const Line& b,
                                     double module);
  void setSizes(int from, int to, const Line& a, const Line& b, double module);
  [[nodiscard]] bool fits(const Wheels& wheels) const;
  [[nodiscard]] bool meet(const Wheel& wheel, const Wheel& other) const;
  void add(Wheels wheels);

  const Mechanism& m_mechanism;
  const JointTree* m_tree;
  const AxisGroups& m_classes;
  SpanByMesh<const std::optional<MeshAxisPath>> m_words;
  ByAxis<std::optional<Line>> m_lines;
  std::set<int> m_rooted;  ///< axes whose wheels are on their positive half
  std::map<std::pair<int, int>, std::vector<int>> m_between;  ///< meshes by their axes, the smaller first
  ByMesh<std::pair<int, int>> m_sides;                        ///< of tail and head
  ByMesh<int> m_sizes;
  Wheels m_standing;
  double m_margin = 0;
};

}  // namespace geargraph
