#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// Writes mechanisms down: a link, joint or mesh a line. Ids are whole numbers, so that a test reads like the
/// paper's labels where links come first, then joints, then meshes.
class TrainSketch {
 public:
  /// `links` moving links 1..links beside the ground 0.
  explicit TrainSketch(int links);

  /// An axis with its place; text holds fractions: {"0", "1/2", "3"}.
  TrainSketch& axis(const std::string& id, const std::vector<std::string>& point,
                    const std::vector<std::string>& direction = {"0", "0", "1"});
  /// A joint; an axis that is not known yet is left open.
  TrainSketch& joint(int tail, int head, const std::string& axis, const std::string& offset = "0");
  TrainSketch& mesh(int tail, int head, int tailTeeth, int headTeeth, std::optional<MeshKind> kind = {},
                    const std::vector<std::string>& pitchPoint = {});
  TrainSketch& inputs(const std::vector<std::pair<int, std::string>>& speedsByLabel);
  [[nodiscard]] Mechanism build() const { return m_mechanism; }

 private:
  Mechanism m_mechanism;
};

/// Sun 1, ring 2, carrier 3 on axis a, planets 4.. on axes of their own on the carrier, each meshing with sun
/// and ring; axes left open. Joints in link order.
[[nodiscard]] Mechanism planetary(int sunTeeth, int planetTeeth, int planets = 1);

/// A random epicyclic train of `n` moving links: axes nested on random carriers, parallel to or at right
/// angles with a neighbouring axis, placed at whole coordinates, joints of either direction, axes of either
/// sense; `meshes` meshes between neighbouring axes, with pitch points left open. Every mesh has a carrier
/// and fits its geometry.
[[nodiscard]] Mechanism randomTrain(std::uint64_t seed, int n, int meshes);

}  // namespace geargraph::test
