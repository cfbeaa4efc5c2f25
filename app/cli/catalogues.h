#pragma once

#include <span>
#include <string_view>

namespace geargraph::cli {

// The catalogues of resources/translations, compiled in by tools/translations/embed.cmake because this
// program does not use Qt.

struct CompiledText {
  const char* source;
  const char* translation;
};

struct CompiledCatalogue {
  std::string_view language;  ///< "de"
  std::span<const CompiledText> texts;
};

/// The catalogues of all languages except English.
[[nodiscard]] std::span<const CompiledCatalogue> catalogues();

}  // namespace geargraph::cli
