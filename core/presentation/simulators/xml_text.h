#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace geargraph {

/// The shortest decimal that reads back as the same double, with a point; 0 for -0. @pre finite
[[nodiscard]] std::string xmlNumber(double value);
/// "x y z"
[[nodiscard]] std::string xmlVector(const Eigen::Vector3d& vector);
/// " name=\"value\"", escaped.
[[nodiscard]] std::string xmlAttribute(std::string_view name, std::string_view value);
/// "<!-- text -->"; two hyphens, which end a comment, are set apart.
[[nodiscard]] std::string xmlComment(std::string_view text);

}  // namespace geargraph
