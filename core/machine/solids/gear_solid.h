#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "core/foundations/base/expected.h"
#include "core/machine/solids/deferred_solid.h"
#include "core/machine/solids/solid.h"
#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// Chordal tolerances in modules: for export and close-up views, for some wheels on screen, for a train, and
/// for a train in a small window.
constexpr double kExportTolerance = 0.002;
constexpr double kScreenTolerance = 0.01;
constexpr double kFarTolerance = 0.03;
constexpr double kMaxTolerance = 0.1;
/// For shafts and arms, whose surfaces are simpler than teeth.
constexpr double kBodyTolerance = 0.02;

/// The solid of a gear in its own frame (gear_spec.h), in the unit of the spec's lengths. No chord of the
/// surface is farther than `tolerance` modules (of a worm: axial ones) from the exact form; points on flanks
/// and roots are exact.
///
/// Fails with specDiagnostics().
/// Cost: O(triangles); about 60 microseconds for 40 teeth at 0.002 (tests/bench/bench_gears.cpp), 20
/// milliseconds for the wheel of a worm.
[[nodiscard]] Expected<Solid> gearSolid(const GearSpec& spec, double tolerance);

/// A cache of solids by parameters, so that equal planets, or a slider moved back, need one solid only. The
/// least recently used are dropped above `capacity`; shared pointers of callers stay valid.
///
/// Thread-safe.
class GearCache {
 public:
  explicit GearCache(std::size_t capacity = 256) : m_capacity(capacity) {}

  /// The solid for these parameters, made on the first call.
  [[nodiscard]] Expected<std::shared_ptr<const Solid>> solid(const GearSpec& spec, double tolerance);
  /// The same solid, made on first use only.
  [[nodiscard]] Expected<std::shared_ptr<const DeferredSolid>> deferred(const GearSpec& spec,
                                                                        double tolerance);

  [[nodiscard]] std::size_t size() const;
  /// Raises the capacity to at least `solids`: all levels of detail of a train, twice to keep those before
  /// the edit.
  void makeRoomFor(std::size_t solids);

 private:
  struct Key {
    GearSpec spec;
    double tolerance = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Entry {
    std::shared_ptr<const DeferredSolid> solid;
    std::size_t used = 0;  ///< number of the last call that returned it
  };

  void dropOldest();

  mutable std::mutex m_mutex;
  std::unordered_map<Key, Entry, KeyHash> m_solids;
  std::size_t m_capacity;
  std::size_t m_calls = 0;
};

}  // namespace geargraph
