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

namespace geargraph::inline bodies {

// The parts that bodies are made of, as the numbers that the functions of part_solids.h take.

struct TubePart {
  double outer = 0;
  double inner = 0;
  double from = 0;
  double to = 0;
  friend bool operator==(const TubePart&, const TubePart&) = default;
};

struct LathePart {
  std::vector<ProfileVertex> meridian;
  friend bool operator==(const LathePart&, const LathePart&) = default;
};

struct SpiderPart {
  Eye hub;
  std::vector<Eye> ends;
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
  std::vector<Eye> corners;
  double from = 0;
  double to = 0;
  friend bool operator==(const PlatePart&, const PlatePart&) = default;
};

struct BodyPart {
  std::variant<TubePart, LathePart, SpiderPart, BarPart, PlatePart> shape;
  double module = 1;                                         ///< the length that tolerances are counted in
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();  ///< its own frame to the body's

  friend bool operator==(const BodyPart& a, const BodyPart& b) {
    return a.shape == b.shape && a.module == b.module && a.placed.matrix() == b.placed.matrix();
  }
};

/// All that the solid of a body depends on beside its tolerance: equal recipes give equal solids, bit by bit.
using BodyRecipe = std::vector<BodyPart>;

/// The parts beside each other in one solid, chords within `tolerance` modules. Cost: O(triangles).
[[nodiscard]] Solid madeBy(const BodyRecipe& recipe, double tolerance);

/// Solids by their recipes, so that a body which an edit leaves as it is stays the same solid. Oldest out
/// when more than `capacity` are held; what a caller still holds stays alive. Not for two threads at once.
class BodyCache {
 public:
  explicit BodyCache(std::size_t capacity = 512) : m_capacity(capacity) {}

  /// Raises the capacity to at least `solids`.
  void makeRoomFor(std::size_t solids) { m_capacity = std::max(m_capacity, solids); }
  /// The solid of this recipe, made when it is asked for, if it ever is.
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
    std::size_t used = 0;  ///< number of the last call that asked for it
  };

  std::unordered_map<Key, Entry, Hash> m_solids;
  std::size_t m_capacity;
  std::size_t m_calls = 0;
};

}  // namespace geargraph::inline bodies
