#pragma once

#include <QSize>
#include <QStringList>
#include <optional>

#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// The arguments of the editor.
struct CommandLine {
  QStringList documents;
  std::optional<QString> screenshot;  ///< render the window to this file and exit
  std::optional<QString> drawing;     ///< drawing shown in the screenshot
  std::optional<Theme> theme;
  std::optional<QSize> size;
  std::optional<QString> language;  ///< one of languageCodes()
};

/// Are only help or version requested, which need no display? @pre the arguments are those of main()
[[nodiscard]] bool onlyPrints(int count, char** words);

/// Parses the arguments. Prints the help, the version or an error and exits the program in these cases.
[[nodiscard]] CommandLine readCommandLine(const QStringList& arguments);

}  // namespace geargraph
