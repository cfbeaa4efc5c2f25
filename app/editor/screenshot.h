#pragma once

#include "app/editor/command_line.h"

namespace geargraph {

/// Writes a picture of a window with the first document, or with the start page where there is none, as soon
/// as its newest analysis and stage are shown and everything is painted. Nothing that this user did before
/// shows on it, and nothing of it is remembered.
/// The exit status of the program: 1, and a sentence, where the picture cannot be written, 2 where the
/// document cannot be opened.
[[nodiscard]] int screenshot(const CommandLine& line);

}  // namespace geargraph
