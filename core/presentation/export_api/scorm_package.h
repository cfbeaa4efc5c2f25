#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// A handout for a learning platform (HandoutUse::learningPlatform) as a package of SCORM 1.2: a ZIP archive
/// with the page and the manifest that names it. `title`: as listed by the platform. Cost: O(bytes).
[[nodiscard]] std::string scormPackage(const std::string& title, std::string_view page);

}  // namespace geargraph
