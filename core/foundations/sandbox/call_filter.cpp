// The system calls that a process in the sandbox may make.

#include <linux/futex.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <initializer_list>
#include <memory>

#include "core/foundations/sandbox/sandbox.h"

namespace geargraph {
namespace {

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

scmp_arg_cmp equals(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}

/// The bits of `mask` are those of `value`.
scmp_arg_cmp masked(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

/// Gathers rules; the first error stays.
class Rules {
 public:
  explicit Rules(scmp_filter_ctx filter) : m_filter(filter) {}

  void allow(int call, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    if (m_error != 0) return;
    m_error = -seccomp_rule_add_array(m_filter, SCMP_ACT_ALLOW, call, static_cast<unsigned>(arguments.size()),
                                      arguments.begin());
  }
  [[nodiscard]] int error() const { return m_error; }

 private:
  scmp_filter_ctx m_filter;
  int m_error = 0;
};

}  // namespace

int filterCalls() {
  // EPERM instead of a killed process: assimp asks for the materials of an OBJ and does without.
  const Filter filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release);
  if (!filter) return ENOMEM;
  Rules rules(filter.get());

  rules.allow(SCMP_SYS(read), {equals(0, STDIN_FILENO)});
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    rules.allow(SCMP_SYS(write), {equals(0, static_cast<scmp_datum_t>(output))});
    rules.allow(SCMP_SYS(writev), {equals(0, static_cast<scmp_datum_t>(output))});
  }
  // Memory that no file backs and no processor executes.
  rules.allow(SCMP_SYS(mmap), {masked(2, PROT_EXEC, 0), masked(3, MAP_ANONYMOUS, MAP_ANONYMOUS)});
  rules.allow(SCMP_SYS(mprotect), {masked(2, PROT_EXEC, 0)});
  for (const int call :
       {SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(brk), SCMP_SYS(getrandom)})
    rules.allow(call);
  // std::call_once wakes, whether or not another thread waits.
  for (const scmp_datum_t operation : {FUTEX_WAIT | FUTEX_PRIVATE_FLAG, FUTEX_WAKE | FUTEX_PRIVATE_FLAG})
    rules.allow(SCMP_SYS(futex), {equals(1, operation)});
  for (const int call :
       {SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(sched_yield), SCMP_SYS(rt_sigreturn),
        SCMP_SYS(restart_syscall), SCMP_SYS(exit), SCMP_SYS(exit_group)})
    rules.allow(call);

  if (rules.error() != 0) return rules.error();
  return -seccomp_load(filter.get());
}

}  // namespace geargraph
