#pragma once

#include "app/editor/command_line.h"

namespace geargraph {

/// Writes an image of a window with the first document, or with the start page if there is none, once the
/// current analysis and stage are shown and everything is painted. The user's settings and history are
/// neither read nor written. Returns the exit status of the program: 1, with a message, if the image cannot
/// be written, 2 if the document cannot be opened or the drawing does not exist.
[[nodiscard]] int screenshot(const CommandLine& line);

}  // namespace geargraph
