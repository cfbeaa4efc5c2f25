#pragma once

#include <QString>

namespace geargraph::inline mainwindow {

class MainWindow;

/// Offers the crash reports in a folder, that earlier runs have left, in the notice bar of a window: to be
/// shown, copied or deleted. A report that was shown or copied is not offered again.
void offerCrashReports(const QString& folder, MainWindow& window);

}  // namespace geargraph::inline mainwindow
