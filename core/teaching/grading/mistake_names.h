#pragma once

#include <span>
#include <string_view>

namespace geargraph {

/// A known mistake with a short title. Names are stable: tables of results and scripts depend on them.
struct MistakeName {
  std::string_view name;
  std::string_view title;
};

/// All of them, in the order of the page in resources/schema/README.md.
[[nodiscard]] std::span<const MistakeName> mistakeNames();

/// @pre there is such a mistake
[[nodiscard]] std::string_view mistakeTitle(std::string_view name);

}  // namespace geargraph
