#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/foundations/base/kind_table.h"

namespace geargraph {

/// The kinds of gear pairs. Whatever differs between them is asked of the kind: of its PairKind, or of its
/// facet in the table of a layer that adds something (core/README.md, Kinds). Nothing else compares kinds.
enum class MeshKind : std::uint8_t {
  external,
  internal,
  bevel,
  belt,
  pins,
  rack,
  screw,
  crossedHelical,
  worm,
  faceGear,
  hypoid,
};

}  // namespace geargraph

template <>
inline constexpr std::size_t geargraph::kNamedKinds<geargraph::MeshKind> = 11;

namespace geargraph {

/// The relative position of two lines.
enum class LinePosition : std::uint8_t { parallel, intersecting, skew };

/// The numbers of teeth of a pair make its centre distance, in half modules, as `sign` times those of one
/// wheel plus `rest`.
struct DistanceForm {
  int sign = 1;
  int rest = 0;
};

/// Teeth for a second central gear beside a first one, on the same planet.
struct SecondCentral {
  MeshKind kind;
  int teeth = 0;
};

/// The most starts of a worm.
constexpr int kMaxStarts = 8;

/// What every layer may know of a kind of gear pair.
struct PairKind {
  std::string_view name;                       ///< the word in documents and in what programs read
  const char* word = "";                       ///< the word in sentences, marked by toTranslate()
  const char* makeIt = "";                     ///< the text of a fix that makes mesh %1 so, marked likewise
  LinePosition axes = LinePosition::parallel;  ///< of its two axes
  /// Parallel axes: +1 if both gears turn in the same direction in space, seen from the carrier, -1 if in
  /// opposite ones. 0: where the pitch point lies decides.
  int sense = -1;
  bool hasRing = false;  ///< the wheel with more teeth surrounds the other
  /// Its wheels touch in a pitch point, which with the axes makes their radii. False: their sense does not
  /// depend on where the axes are, and their distance is free (belts, pins).
  bool touches = true;
  bool hasTeeth = true;   ///< false: it turns 1 : 1, and documents leave its teeth out
  bool canCross = false;  ///< a strand may cross over, which reverses the sense (GearMesh::crossed)
  /// One of its sides slides along a line, the other one turns: its weights tie a travel to an angle
  /// (weightsOf()). Else both turn.
  bool slides = false;
  bool isThreaded = false;  ///< the wheel with fewer teeth is a worm: they are its starts, at most kMaxStarts
  bool isSquare = false;    ///< its axes cross at right angles
  /// Documents may state helix angle and hand of its teeth; else these are straight, or follow from the rest.
  bool statesHelix = true;
  /// The wheel with fewer teeth is a spur pinion, the other one carries its teeth on a plane face.
  bool hasFace = false;
  /// Its wheels are cones that touch in the pitch point, on skew axes.
  bool isOffset = false;
  /// The centre distance of pitch radii. Unused where axes intersect.
  double (*distance)(double tailRadius, double headRadius) = nullptr;
  /// The same for teeth of one wheel, by those of its partner; `isLarger`: it has more teeth.
  DistanceForm (*distanceForm)(int partnerTeeth, bool isLarger) = nullptr;
  /// What to draw between a planet and a second central gear where the first pair is of this kind; none where
  /// nothing is likely.
  std::optional<SecondCentral> (*secondCentral)(int planetTeeth, int centralTeeth) = nullptr;
  /// The kind that a pair between the same axes can be made instead; none where there is none.
  std::optional<MeshKind> other;
  int since = 1;  ///< version of the format whose documents have it
};

/// By kind, in the order in which they are offered.
[[nodiscard]] KindTable<MeshKind, PairKind>& pairKinds();
[[nodiscard]] const PairKind& pairKind(MeshKind kind);
/// All kinds: those of the enumeration, then any that were added.
[[nodiscard]] std::span<const MeshKind> meshKinds();

[[nodiscard]] std::string_view meshKindName(MeshKind kind);
/// Its word in the language in use.
[[nodiscard]] std::string kindWord(MeshKind kind);
/// By its name; std::nullopt where no kind has it.
[[nodiscard]] std::optional<MeshKind> meshKindFrom(std::string_view name);

/// The kind of a pair of which the document says none, on axes in this position and with this sense (as that
/// of a PairKind; 0: any): the first that fits. @pre there is one: the axes are not skew
[[nodiscard]] MeshKind usualKind(LinePosition axes, int sense = 0);
/// The kind that is meant where neither the document nor a geometry says one.
constexpr MeshKind kUsualKind = MeshKind::external;
/// The first kind with a ring.
[[nodiscard]] MeshKind ringKind();

/// On parallel axes that its wheels hold apart.
[[nodiscard]] bool hasParallelAxes(MeshKind kind);
[[nodiscard]] bool hasIntersectingAxes(MeshKind kind);
/// On axes that cross without meeting.
[[nodiscard]] bool hasSkewAxes(MeshKind kind);
/// On parallel axes, without a ring.
[[nodiscard]] bool isBesideEachOther(MeshKind kind);
[[nodiscard]] bool hasRing(MeshKind kind);
/// Do its wheels touch (PairKind::touches)?
[[nodiscard]] bool touches(MeshKind kind);
/// Do both gears turn in the same direction, whatever their pitch point (PairKind::sense)?
[[nodiscard]] bool turnsAlike(MeshKind kind);
/// Does one of its sides slide (PairKind::slides)?
[[nodiscard]] bool slides(MeshKind kind);
/// Teeth whose half is the centre distance in modules; 0 where no pair has such teeth.
[[nodiscard]] int distanceTeeth(MeshKind kind, int tailTeeth, int headTeeth);

}  // namespace geargraph
