#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "core/presentation/painting/feature_edges.h"
#include "core/presentation/painting/scene.h"

namespace geargraph::inline painting {

/// Something that follows from a solid, kept as long as the solid is. Not for two threads at once.
template <class Fact>
class KeptFact {
 public:
  /// The fact of the solid, by `find(const Solid&)` where it is not known yet.
  template <class Find>
  [[nodiscard]] std::shared_ptr<const Fact> of(const std::shared_ptr<const Solid>& solid, const Find& find) {
    Known& known = m_known[solid.get()];
    if (known.solid.lock() != solid) known = {solid, std::make_shared<const Fact>(find(*solid))};
    return known.fact;
  }
  /// Drops those of solids that are gone.
  void forgetOthers() {
    std::erase_if(m_known, [](const auto& entry) { return entry.second.solid.expired(); });
  }

 private:
  struct Known {
    std::weak_ptr<const Solid> solid;
    std::shared_ptr<const Fact> fact;
  };
  std::unordered_map<const Solid*, Known> m_known;
};

/// What is found of the solids of a scene ahead, so that who paints it need not look for it. Kept from one
/// scene to the next. Ends early when `stop` is requested. Not for two threads at once.
class SolidFacts {
 public:
  /// Finds the boxes of the scene's solids.
  void addBoxesTo(Scene& scene, const std::stop_token& stop = {});
  /// Finds the outlines of the scene's solids; none are added when `stop` was requested.
  void addOutlinesTo(Scene& scene, const std::stop_token& stop = {});
  /// Makes the details that a window shows of a train as a whole, and finds their feature edges: where the
  /// window itself paints, it would stand still for them.
  void addEdgesTo(Scene& scene, const std::stop_token& stop = {});
  /// Drops what is known of solids that are gone.
  void forgetOthers();

 private:
  KeptFact<std::vector<std::uint32_t>> m_edges;
  KeptFact<Eigen::AlignedBox3d> m_boxes;
  KeptFact<std::vector<Eigen::Vector3d>> m_outlines;  ///< by m_samples vertices
  std::size_t m_samples = 0;
};

}  // namespace geargraph::inline painting
