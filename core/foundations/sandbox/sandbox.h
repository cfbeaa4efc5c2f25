#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace geargraph {

// A process that reads an untrusted file drops its rights before the first byte. Linux only: elsewhere it
// keeps them, and only its parent limits its time and its output (platform/child_process.h).

/// The resource limits of the process.
struct SandboxLimits {
  std::size_t mostMemory = 0;  ///< address space, bytes; not set under a sanitizer, which reserves more
  long mostSeconds = 0;        ///< CPU time; SIGXCPU beyond
};

/// Restricts the calling process to reading standard input, writing standard output and standard error, and
/// allocating memory. It cannot open files (those beyond the three standard ones are closed), start
/// processes, threads or programs, create sockets, send signals or make memory executable; such calls fail
/// with EPERM. This cannot be undone, and applies to all code that the process runs afterwards, injected code
/// included.
///
/// Three layers of defence: a filter of system calls with an allow-list (seccomp), an empty list of
/// accessible files (Landlock, if the kernel has it), and resource limits.
///
/// std::nullopt on success. Else what the system cannot enforce, and why ("seccomp: Invalid argument"); the
/// process must then not continue. Only Landlock may be missing. Portable version: never fails; a thread ends
/// the process after `mostSeconds` of wall-clock time, and nothing else is enforced. @pre the process has one
/// thread
[[nodiscard]] std::optional<std::string> enterSandbox(const SandboxLimits& limits);

// The single layers, for tests. @pre NO_NEW_PRIVS is set

/// Sets NO_NEW_PRIVS: set-user-ID programs do not restore rights. False with errno on failure.
[[nodiscard]] bool renouncePrivileges();
/// False with errno if a resource limit could not be set.
[[nodiscard]] bool limitResources(const SandboxLimits& limits);
/// 0 if the kernel has no Landlock or it is disabled.
[[nodiscard]] int landlockVersion();
/// Forbids all files and, if this version of Landlock supports it, all TCP ports, abstract Unix sockets and
/// signals to other processes. True without Landlock; false with errno on failure.
[[nodiscard]] bool forbidFiles();
/// Allows the system calls listed in its source, with the arguments listed there; all others fail with EPERM.
/// Returns 0, or the error.
[[nodiscard]] int filterCalls();

}  // namespace geargraph
