#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/print_kit/print_kit.h"

namespace geargraph {

/// The list of parts, what is bought, the plates as drawings, the order of assembly and which tooth goes into
/// which space: one page for any browser, offline, in the language in use.
[[nodiscard]] std::string kitPage(const PrintKit& kit, const Mechanism& mechanism, const GearTrain& train);

/// The files of a kit: `plate-1.3mf` and so on, `assembly.3mf` with every part in its place, and
/// `assembly.html`. `colourOfLink`: as for LinkSceneSource. An error where a file has more triangles than
/// 3D files may have, or `stop` was requested.
[[nodiscard]] std::variant<std::vector<std::pair<std::string, std::string>>, MeshFileError> kitFiles(
    const PrintKit& kit, const Mechanism& mechanism, const GearTrain& train,
    const std::function<Float3(int number)>& colourOfLink, const std::stop_token& stop = {});

/// The edges of the faces that look up, as seen from above: lines between points in mm, x to the right, y to
/// the back. Cost: O(triangles log triangles).
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> topLines(const Solid& solid);

}  // namespace geargraph
