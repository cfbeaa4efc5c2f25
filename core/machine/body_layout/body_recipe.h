#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <variant>
#include <vector>

#include "core/machine/solids/deferred_solid.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/solid.h"

namespace geargraph {

// The parts of bodies, as arguments for the functions of part_solids.h.

/// tube()
struct TubePart {
  double outer = 0;
  double inner = 0;
  double from = 0;
  double to = 0;
  friend bool operator==(const TubePart&, const TubePart&) = default;
};

/// revolved()
struct RevolvedPart {
  std::vector<ProfileVertex> profile;
  friend bool operator==(const RevolvedPart&, const RevolvedPart&) = default;
};

/// spider()
struct SpiderPart {
  Boss hub;
  std::vector<Boss> ends;
  double from = 0;
  double to = 0;
  friend bool operator==(const SpiderPart&, const SpiderPart&) = default;
};

/// tubeSector()
struct BarPart {
  double outer = 0;
  double inner = 0;
  double from = 0;
  double to = 0;
  double half = 0;
  friend bool operator==(const BarPart&, const BarPart&) = default;
};

/// plate()
struct PlatePart {
  std::vector<Boss> corners;
  double from = 0;
  double to = 0;
  friend bool operator==(const PlatePart&, const PlatePart&) = default;
};

/// A part in its own frame with its place in the body.
struct BodyPart {
  std::variant<TubePart, RevolvedPart, SpiderPart, BarPart, PlatePart> shape;
  double module = 1;                                         ///< the unit of the tolerance
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();  ///< its own frame to the body's

  friend bool operator==(const BodyPart& a, const BodyPart& b) {
    return a.shape == b.shape && a.module == b.module && a.placed.matrix() == b.placed.matrix();
  }
};

/// Everything that the solid of a body depends on except the tolerance: equal recipes give bitwise equal
/// solids.
using BodyRecipe = std::vector<BodyPart>;

/// The solid with all parts as separate shells, chordal error at most `tolerance` modules. Cost:
/// O(triangles).
[[nodiscard]] Solid madeBy(const BodyRecipe& recipe, double tolerance);

/// A cache of solids by recipe, so that a body that an edit does not change keeps its solid. The least
/// recently used are dropped above `capacity`; shared pointers of callers stay valid. Not thread-safe.
class BodyCache {
 public:
  explicit BodyCache(std::size_t capacity = 512) : m_capacity(capacity) {}

  /// Raises the capacity to at least `solids`.
  void makeRoomFor(std::size_t solids) { m_capacity = std::max(m_capacity, solids); }
  /// The solid of this recipe, made on first use.
  [[nodiscard]] std::shared_ptr<const DeferredSolid> deferred(const BodyRecipe& recipe, double tolerance);

 private:
  struct Key {
    BodyRecipe recipe;
    double tolerance = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  struct Entry {
    std::shared_ptr<const DeferredSolid> solid;
    std::size_t used = 0;  ///< number of the last call that returned it
  };

  std::unordered_map<Key, Entry, Hash> m_solids;
  std::size_t m_capacity;
  std::size_t m_calls = 0;
};

}  // namespace geargraph
