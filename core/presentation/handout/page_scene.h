#pragma once

#include <string>

#include "core/foundations/files/json_writer.h"
#include "core/mechanism/graph/digraph.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// The solids of a scene for a page, one after the other, each in blocks padded to four bytes: positions
/// (three uint16 a vertex, 0 to 65535 from the least to the largest coordinate of its box), normals (two int8
/// a vertex, octahedral, -127 to 127) and triangles (three uint16, or uint32 where there are more than 65536
/// vertices). Little endian, gzipped, in base64.
///
/// `tolerance`: chordal error, in modules. Largest error of a position: 1/131,070 of the box. Cost:
/// O(vertices + triangles), and that of making finer solids.
[[nodiscard]] std::string pageGeometry(const Scene& scene, double tolerance);

/// The other data of the scene for the page's script: the sizes and boxes of the solids; the parts with their
/// links, poses (rotation by rows, then the place), colours and elements; the labels of links. One value of
/// JSON.
void writePageScene(JsonWriter& json, const MechanismScene& stage, const Digraph& graph, double tolerance);

}  // namespace geargraph
