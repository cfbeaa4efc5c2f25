#include "core/presentation/simulators/xml_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/text_lists.h"

namespace geargraph {

std::string xmlNumber(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0).ptr;
  return {buffer.data(), end};
}

std::string xmlVector(const Eigen::Vector3d& vector) {
  return xmlNumber(vector.x()) + ' ' + xmlNumber(vector.y()) + ' ' + xmlNumber(vector.z());
}

std::string xmlAttribute(std::string_view name, std::string_view value) {
  return ' ' + std::string(name) + "=\"" + escapedXml(value) + '"';
}

std::string xmlComment(std::string_view text) {
  std::string escaped = escapedXml(text);
  for (std::size_t at = escaped.find("--"); at != std::string::npos; at = escaped.find("--", at + 2))
    escaped.insert(at + 1, " ");
  if (!escaped.empty() && escaped.back() == '-') escaped += ' ';
  return "<!-- " + escaped + " -->";
}

}  // namespace geargraph
