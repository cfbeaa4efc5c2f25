#pragma once

#include <filesystem>
#include <string>

namespace geargraph {

/// Installs a handler for crashes of this process (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT with violated
/// contracts, std::terminate), which writes a text report into `folder` before the process ends as usual:
/// `details`, time, signal, thread, last actions (actionLog()) and backtrace, but nothing of a document and
/// no names of the user's files.
///
/// The handler does not allocate or take locks of the program; it gives up after ten seconds. It has a stack
/// of its own for the calling thread, so that a stack overflow there is reported too. To be called once,
/// before other threads start.
/// @pre no report is being written
void installCrashHandler(const std::filesystem::path& folder, const std::string& details);

}  // namespace geargraph
