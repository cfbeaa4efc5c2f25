#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/gearboxes/layout_search.h"
#include "core/design/gearboxes/wanted_ratio.h"
#include "core/foundations/base/expected.h"

namespace geargraph {

constexpr std::size_t kMaxGears = 12;  ///< forward
constexpr int kMaxElements = 8;

/// Basic efficiencies with which the efficiency of a gear is computed.
struct EfficiencyWish {
  bool isOfSet = false;  ///< of a set with its carrier held; else of each mesh
  Rational basic = 1;
  std::optional<Rational> least;  ///< that every gear must have
};

/// Limits on whole teeth.
struct SetTeethWish {
  int fewest = 17;
  int mostRing = 120;
  int slack = 0;  ///< by which the centre sums of the meshes of one planet may differ
};

/// What a gearbox is wished to do, and of what it may be made.
struct GearboxWish {
  std::string canonical;  ///< the JSON in one line, which identifies the search
  std::vector<WantedRatio> forward;
  ReverseWish reverse = ReverseWish::any;
  std::optional<WantedRatio> reverseRatio;  ///< its size
  LayoutLimits limits;
  int elements = 4;
  std::array<int, 2> brakes{0, kMaxElements};  ///< fewest, most
  std::array<int, 2> clutches{0, kMaxElements};
  bool isSingleShift = true;
  Rational leastK = Rational(3, 2);
  Rational mostK = 4;
  int steps = 8;
  SetTeethWish teeth;
  std::optional<EfficiencyWish> efficiency;
  std::optional<Rational> torque;       ///< most torque in an element over the input torque, in every gear
  std::optional<Rational> speed;        ///< most speed of a member over that of the input
  std::optional<Rational> slip;         ///< most speed between the sides of an open element over the input's
  std::optional<Rational> circulating;  ///< most circulating power over the input's
  std::optional<Rational> spread;       ///< least first over last gear
  bool isBuildable = false;             ///< sections that can be drawn only
};

/// Reads a wish (resources/schema/README.md, gearbox). Everything that is wrong is a diagnostic `schema` or
/// `syntax` with its place in the JSON: unknown members and sets, ratios that are none, limits that
/// contradict each other, layouts that have no freedom for their elements.
[[nodiscard]] Expected<GearboxWish> readGearboxWish(std::string_view json);

/// The wish as the search in doubles takes it.
[[nodiscard]] SearchProblem searchProblem(const GearboxWish& wish);

}  // namespace geargraph
