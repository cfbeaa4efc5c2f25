#pragma once

#include <QString>

namespace geargraph {

class MainWindow;

/// Offers the crash reports of earlier runs in a folder in the notice bar of a window: to be shown, copied or
/// deleted. A report that was shown or copied is not offered again.
void offerCrashReports(const QString& folder, MainWindow& window);

}  // namespace geargraph
