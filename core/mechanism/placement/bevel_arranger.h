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

namespace geargraph::inline placement {

/// The module of a derived bevel pair is counted in halves of the placement's.
constexpr int kUsualBevelSize = 2;

/// On which half of the inner axis a wheel of a bevel pair lies that says nothing about it: on the negative
/// one, from where shafts come; wheels of two links that mesh with the same one, as a differential's, on
/// both.
class SideNumbers {
 public:
  int side(int axisClass, int carrier, int link, int partner) {
    const auto [known, isNew] = m_sides.try_emplace({axisClass, carrier, link}, -1);
    std::set<int>& taken = m_taken[{axisClass, carrier, partner}];
    if (isNew && taken.contains(-1) && !taken.contains(1)) known->second = 1;
    taken.insert(known->second);
    return known->second;
  }

 private:
  std::map<std::array<int, 3>, int> m_sides;
  std::map<std::array<int, 3>, std::set<int>> m_taken;  ///< by the partner
};

/// Finds room for the bevels of axes that the program places: how far along its neighbour's line an axis
/// meets it, and how large the pairs about one apex are, so that no two wheels take up the same room, in the
/// reference pose and while carriers between them turn. Wheels are the hulls of their tips and bodies.
/// Cost: O(bevel wheels) a pair and place that is tried.
class BevelArranger {
 public:
  /// `words` by mesh, none where a mesh has no carrier; no tree: no words. All outlive this object.
  BevelArranger(const Mechanism& mechanism, const JointTree* tree, const AxisClasses& classes,
                std::span<const std::optional<MeshWord>> words);

  /// A line has its place. `direction` is a unit vector.
  void setLine(int axis, const Vector3& point, const Vector3& direction) {
    m_lines[static_cast<std::size_t>(axis)] = Line{point, direction};
  }
  /// The steps along `from`, a line that has its place, from its point to where axis `to` may meet it; tried
  /// first is `first`, then places farther and farther off 0. Its wheels stand there from now on.
  int place(int from, int to, const Vector3& direction, double module, int first);
  /// The wheels between two lines that have their places stand there.
  void stand(int from, int to, double module);

  /// By mesh: the module of the pair in halves of the placement's.
  [[nodiscard]] const std::vector<int>& sizes() const { return m_sizes; }

  static constexpr int kStep = 2;  ///< modules

 private:
  struct Line {
    Vector3 point{};
    Vector3 direction{};
  };
  struct Wheel {
    int link = 0;
    int axisClass = 0;
    int teeth = 0;
    DiscHull hull;
    int partner = -1;  ///< in a pair's list
  };
  using Wheels = std::vector<Wheel>;

  [[nodiscard]] const std::vector<int>& meshesBetween(int from, int to) const;
  void addPair(Wheels& wheels, int mesh, int size, const Vector3& apex, const Line& from, const Line& to,
               int fromAxis, double module);
  [[nodiscard]] Wheels wheelsBetween(int from, int to, const Vector3& apex, const Line& a, const Line& b,
                                     double module);
  void setSizes(int from, int to, const Line& a, const Line& b, double module);
  [[nodiscard]] bool fits(const Wheels& wheels) const;
  [[nodiscard]] bool meet(const Wheel& wheel, const Wheel& other) const;
  void add(Wheels wheels);

  const Mechanism& m_mechanism;
  const JointTree* m_tree;
  const AxisClasses& m_classes;
  std::span<const std::optional<MeshWord>> m_words;
  std::vector<std::optional<Line>> m_lines;  ///< by axis
  std::set<int> m_rooted;                    ///< axes whose wheels stand on their positive half
  std::map<std::pair<int, int>, std::vector<int>> m_between;  ///< meshes by their axes, the smaller first
  std::vector<std::pair<int, int>> m_sides;                   ///< by mesh: of tail and head
  std::vector<int> m_sizes;
  Wheels m_standing;
  double m_margin = 0;
};

}  // namespace geargraph::inline placement
