#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/expected.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

// What only views use of a document: "camera" of its view and "shapes" of its links. No analysis knows them:
// a Mechanism keeps them as the unknown members that they are to it, and only who shows them reads them.

/// Where the viewer of the 3D view stands: it looks at `target` from so far away, from this azimuth about +z
/// and this elevation. Lengths in the document's unit, angles in degrees, as in the file:
/// "camera": {"target": [0, 0, 0], "azimuth": -26, "elevation": 20, "distance": 400}
struct ViewCamera {
  std::array<double, 3> target{};
  double azimuth = 0;
  double elevation = 0;
  double distance = 1;
  friend bool operator==(const ViewCamera&, const ViewCamera&) = default;
};

/// Nothing where there is none, or one of another kind, which is kept as it stands until another takes its
/// place.
[[nodiscard]] std::optional<ViewCamera> viewCamera(const View& view);
[[nodiscard]] View withCamera(View view, const ViewCamera& camera);

/// A 3D file (STL, OBJ, PLY, GLB) that a link wears beside its gears. `file` is a path from the folder of the
/// document, with slashes; it stays in that folder, so that a document from elsewhere reaches no other files.
/// A point p of the file lies at position + R (scale p) in the base frame, in the reference pose; R turns by
/// `orientation` (degrees) about x, then y, then z of the base frame: "shapes": [{"file": "parts/arm.stl",
/// "position": [0, 0, 12], "orientation": [90, 0, 0], "scale": 1}]
struct LinkShape {
  std::string file;
  std::optional<NumberTriple> position = {};
  std::optional<NumberTriple> orientation = {};
  std::optional<Number> scale = {};
  UnknownMembers unknown = {};
  friend bool operator==(const LinkShape&, const LinkShape&) = default;
};

/// The files that a link wears; empty where it wears none. Fails with schema: all that is wrong with them.
[[nodiscard]] Expected<std::vector<LinkShape>> linkShapes(const Link& link);

/// The files that a link wears, in place of those it wore: a pure function, as in core/mechanism/edits.h.
/// Refuses unknown-id, and schema for a path that leads out of the folder or a scale that is not above 0.
[[nodiscard]] Expected<Mechanism> withShapes(Mechanism mechanism, LinkId link,
                                             const std::vector<LinkShape>& shapes);

/// A path that stays in the folder that it starts from, by its words: not empty, not from the root of a disk
/// or of an address, and no ".." that leads out. "parts/../arm.stl" stays.
[[nodiscard]] bool staysInFolder(std::string_view path);

}  // namespace geargraph
