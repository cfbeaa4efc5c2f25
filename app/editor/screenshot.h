#pragma once

#include <QString>

namespace geargraph {

class MainWindow;

/// Writes a picture of the window as soon as its newest analysis and stage are shown and everything is
/// painted, then ends the program: with 0, or with 1 and a sentence where the file cannot be written.
void screenshotWhenReady(MainWindow& window, const QString& file);

}  // namespace geargraph
