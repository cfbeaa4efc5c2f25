#pragma once

#include <span>
#include <string_view>

namespace geargraph::cli {

// The catalogues of resources/translations, compiled in by tools/translations/embed.cmake: this program has
// no Qt.

struct CompiledText {
  const char* source;
  const char* translation;
};

struct CompiledCatalogue {
  std::string_view language;  ///< "de"
  std::span<const CompiledText> texts;
};

/// Those of all languages but English.
[[nodiscard]] std::span<const CompiledCatalogue> catalogues();

}  // namespace geargraph::cli
