#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace geargraph::inline sandbox {

// A process that reads a file of unknown origin gives up its rights before the first byte. Linux only:
// elsewhere it keeps them, and only its parent limits its time and its answer (platform/child_process.h).

/// What the process may use in total.
struct SandboxLimits {
  std::size_t mostMemory =
      0;                 ///< of its address space, bytes; not set under a sanitizer, which reserves more
  long mostSeconds = 0;  ///< of the processor; SIGXCPU beyond
};

/// Leaves the calling process only standard input to read, standard output and standard error to write, and
/// memory to compute in. No file can be opened (those beyond the three standard ones are closed), no process,
/// thread or program started, no socket made, no signal sent, no memory made executable; such a call fails
/// with EPERM. It cannot be undone, and holds for all that the process loads or is made to run afterwards.
///
/// Three walls, the inner ones in case the outer has a gap: a filter of system calls that lists what is
/// allowed (seccomp), an empty list of files (Landlock, where the kernel has it), resource limits.
///
/// The reason where the system cannot enforce it; the process must not go on then. Landlock alone may be
/// missing. Portable: a thread ends the process after
/// mostSeconds of the clock, nothing else. @pre one thread
[[nodiscard]] std::optional<std::string> enterSandbox(const SandboxLimits& limits);

// The walls by themselves, for tests. @pre NO_NEW_PRIVS is set

/// Sets NO_NEW_PRIVS: no set-user-ID program gives rights back. False with errno where it failed.
[[nodiscard]] bool renouncePrivileges();
/// False with errno where a resource limit could not be set.
[[nodiscard]] bool limitResources(const SandboxLimits& limits);
/// 0 where the kernel has no Landlock or has it switched off.
[[nodiscard]] int landlockVersion();
/// Forbids every file and, where this version of Landlock can, every TCP port, every abstract Unix socket and
/// signals to other processes. True where there is no Landlock; false with errno where it failed.
[[nodiscard]] bool forbidFiles();
/// Allows the system calls listed in its source, with the arguments listed there; all others fail with EPERM.
/// 0, or the error.
[[nodiscard]] int filterCalls();

}  // namespace geargraph::inline sandbox
