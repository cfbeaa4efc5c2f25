#pragma once

#include <set>
#include <string>
#include <vector>

namespace geargraph {

struct ManualFile {
  std::string name;  ///< within the folder: "first-steps.html", "pictures/..."
  std::string bytes;
};

/// The manual as web pages with their pictures, light and dark: no scripts, no external resources.
/// `windowPictures`: names of screenshots in the folder ("robot" for pictures/window-robot-light.png and
/// -dark.png); other screenshots are left out.
/// Cost: that of all drawings, some hundred milliseconds.
[[nodiscard]] std::vector<ManualFile> manualSite(const std::set<std::string>& windowPictures);

}  // namespace geargraph
