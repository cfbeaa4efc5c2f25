#pragma once

#include <QSize>
#include <QStringList>
#include <optional>

#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// What the editor was asked to do.
struct CommandLine {
  QStringList documents;
  std::optional<QString> screenshot;  ///< render the window to this file and exit
  std::optional<QString> drawing;     ///< of a screenshot: the drawing in front
  std::optional<Theme> theme;
  std::optional<QSize> size;
  std::optional<QString> language;  ///< one of languageCodes()
};

/// Help or version are asked for, which needs no display. @pre the words are those of main
[[nodiscard]] bool onlyPrints(int count, char** words);

/// Reads the arguments; prints help, version or what is wrong with them and exits where that was asked.
[[nodiscard]] CommandLine readCommandLine(const QStringList& arguments);

}  // namespace geargraph
