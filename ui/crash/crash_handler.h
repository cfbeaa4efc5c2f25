#pragma once

#include <filesystem>
#include <string>

namespace geargraph::inline crash {

/// From now on a crash of this process (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT with broken contracts,
/// std::terminate) writes a report as text into `folder` before it ends the process as it would have without:
/// `details`, time, signal, thread, last actions (actionLog()) and backtrace. Nothing of a document, no name
/// of a file that the user has.
///
/// The handler allocates nothing and takes no lock of the program; it gives up after ten seconds. It has a
/// stack of its own for the thread that calls this, so that a stack overflow there is reported, too. Call it
/// once, before other threads start.
/// @pre no report is being written
void installCrashHandler(const std::filesystem::path& folder, const std::string& details);

}  // namespace geargraph::inline crash
