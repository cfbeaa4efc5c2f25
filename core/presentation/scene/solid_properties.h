#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "core/presentation/scene/feature_edges.h"
#include "core/presentation/scene/scene.h"

namespace geargraph {

/// A cache of derived data of solids, kept while the solid lives. Not thread-safe.
template <class Property>
class PropertyCache {
 public:
  /// The data of the solid, computed by `find(const Solid&)` on first use.
  template <class Find>
  [[nodiscard]] std::shared_ptr<const Property> of(const std::shared_ptr<const Solid>& solid,
                                                   const Find& find) {
    Known& known = m_known[solid.get()];
    if (known.solid.lock() != solid) known = {solid, std::make_shared<const Property>(find(*solid))};
    return known.property;
  }
  /// Drops the data of solids that no longer exist.
  void forgetOthers() {
    std::erase_if(m_known, [](const auto& entry) { return entry.second.solid.expired(); });
  }

 private:
  struct Known {
    std::weak_ptr<const Solid> solid;
    std::shared_ptr<const Property> property;
  };
  std::unordered_map<const Solid*, Known> m_known;
};

/// Precomputes data of the solids of a scene for the renderer, cached from one scene to the next. Ends early
/// if `stop` is requested. Not thread-safe.
class SolidProperties {
 public:
  /// Adds the bounding boxes of the scene's solids.
  void addBoxesTo(Scene& scene, const std::stop_token& stop = {});
  /// Adds the outlines of the scene's solids; none if `stop` was requested.
  void addOutlinesTo(Scene& scene, const std::stop_token& stop = {});
  /// Makes the levels of detail that a window needs to show the whole train, and adds their feature edges;
  /// otherwise a window that paints itself would freeze while they are computed.
  void addEdgesTo(Scene& scene, const std::stop_token& stop = {});
  /// Drops the data of solids that no longer exist.
  void forgetOthers();

 private:
  PropertyCache<std::vector<std::uint32_t>> m_edges;
  PropertyCache<Eigen::AlignedBox3d> m_boxes;
  PropertyCache<std::vector<Eigen::Vector3d>> m_outlines;  ///< chosen among m_samples vertices
  std::size_t m_samples = 0;
};

}  // namespace geargraph
