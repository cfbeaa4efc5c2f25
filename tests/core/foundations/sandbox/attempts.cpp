#include "tests/core/foundations/sandbox/attempts.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace geargraph::test {
namespace {

/// A descriptor that a test leaves open in the process, as a careless parent would.
constexpr int kInherited = 7;

class Attempts {
 public:
  explicit Attempts(const std::string& folder)
      : m_new(folder + "/new"), m_other(folder + "/other"), m_socket(folder + "/socket") {}

  std::string all() {
    files();
    processes();
    network();
    memory();
    m_lines += "end\n";
    return std::move(m_lines);
  }

 private:
  /// `result`: as system calls answer, below 0 with errno. True where it was allowed.
  bool report(const char* name, long result) {
    const int error = errno;
    m_lines += name;
    m_lines += ' ';
    m_lines += result >= 0 ? "allowed" : strerrorname_np(error);
    m_lines += '\n';
    return result >= 0;
  }
  void reportOpened(const char* name, long descriptor) {
    if (report(name, descriptor)) ::close(static_cast<int>(descriptor));
  }
  /// A child ends at once; the parent waits for it.
  void reportChild(const char* name, long pid) {
    if (pid == 0) ::_exit(0);
    if (report(name, pid)) ::waitpid(static_cast<pid_t>(pid), nullptr, 0);
  }

  void files() {
    reportOpened("open", ::syscall(SYS_open, "/etc/passwd", O_RDONLY));
    reportOpened("openat", ::open("/etc/passwd", O_RDONLY | O_CLOEXEC));
    reportOpened("list", ::open("/", O_RDONLY | O_DIRECTORY));
    reportOpened("create", ::open(m_new.c_str(), O_WRONLY | O_CREAT, 0600));
    report("truncate", ::truncate(m_new.c_str(), 9));
    report("rename", ::rename(m_new.c_str(), m_other.c_str()));
    report("chmod", ::chmod(m_other.c_str(), 0700));
    report("link", ::link(m_other.c_str(), m_new.c_str()));
    report("unlink", ::unlink(m_other.c_str()));
    ::unlink(m_new.c_str());
    if (report("mkdir", ::mkdir(m_new.c_str(), 0700))) ::rmdir(m_new.c_str());
    if (report("symlink", ::symlink("/etc", m_new.c_str()))) ::unlink(m_new.c_str());
    char byte = 0;
    report("read-inherited", ::pread(kInherited, &byte, 1, 0));
    report("write-inherited", ::write(kInherited, "x", 1));
    report("pass-on", ::dup(STDOUT_FILENO));
    report("chdir", ::chdir("/"));
    struct stat what {};
    report("stat", ::stat("/etc/passwd", &what));
  }

  void processes() {
    reportChild("fork", ::syscall(SYS_fork));
    reportChild("clone", ::syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr));
    struct {
      unsigned long long flags, pidfd, child, parent, signal, stack, size,
          tls;  // NOLINT: the kernel's layout
    } arguments{0, 0, 0, 0, SIGCHLD, 0, 0, 0};
    reportChild("clone3", ::syscall(SYS_clone3, &arguments, sizeof arguments));
    // Outside of a sandbox it replaces this process, so it runs in a child there.
    const long child = ::syscall(SYS_fork);
    if (child <= 0) {
      char* const words[] = {const_cast<char*>("true"), nullptr};  // NOLINT: not written to
      const long result = ::execve("/bin/true", words, nullptr);
      if (child == 0) ::_exit(1);
      report("execve", result);
    } else {
      int status = 0;
      ::waitpid(static_cast<pid_t>(child), &status, 0);
      errno = EACCES;
      report("execve", status == 0 ? 0 : -1);
    }
    report("kill-parent", ::kill(::getppid() > 0 ? ::getppid() : 1, 0));
    report("signal-all", ::kill(0, 0));
    report("ptrace", ::ptrace(PTRACE_PEEKUSER, 0, nullptr, nullptr) == -1 && errno == ESRCH ? 0 : -1);
    report("prctl", ::prctl(PR_SET_NAME, "other", 0, 0, 0));
    rlimit most{};
    report("prlimit", ::getrlimit(RLIMIT_CPU, &most));
    report("setuid", ::setuid(::getuid()));
    report("unshare", ::unshare(0));
    iovec none{};
    report("other-memory", ::process_vm_readv(::getpid(), &none, 0, &none, 0, 0));
  }

  void network() {
    reportOpened("socket", ::socket(AF_INET, SOCK_STREAM, 0));
    reportOpened("socket-local", ::socket(AF_UNIX, SOCK_STREAM, 0));
    // A listener of its own to reach, so that the control succeeds without a network.
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0), caller = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);  // NOLINT: what the call takes
    const bool isListening = ::bind(listener, any, size) == 0 && ::listen(listener, 1) == 0 &&
                             ::getsockname(listener, any, &size) == 0;
    errno = isListening ? 0 : errno;
    report("bind", isListening ? 0 : -1);
    // Without a socket the call comes first all the same: the filter decides before the kernel looks at it.
    report("connect", ::connect(caller >= 0 ? caller : STDIN_FILENO, any, size));
    if (caller >= 0) ::close(caller);
    if (listener >= 0) ::close(listener);
    int pair[2];  // NOLINT: what the call takes
    if (report("socketpair", ::socketpair(AF_UNIX, SOCK_STREAM, 0, pair))) {
      ::close(pair[0]);
      ::close(pair[1]);
    }
    report("connect-local", connectLocal());
  }

  long connectLocal() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, m_socket.c_str(), sizeof address.sun_path - 1);
    auto* const any = reinterpret_cast<sockaddr*>(&address);  // NOLINT: what the call takes
    const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0), caller = ::socket(AF_UNIX, SOCK_STREAM, 0);
    if (listener >= 0) (void)(::bind(listener, any, sizeof address) + ::listen(listener, 1));
    const int result = ::connect(caller >= 0 ? caller : STDIN_FILENO, any, sizeof address);
    const int error = errno;
    ::unlink(m_socket.c_str());
    if (caller >= 0) ::close(caller);
    if (listener >= 0) ::close(listener);
    errno = error;
    return result;
  }

  void memory() {
    constexpr std::size_t kPage = 4096;
    void* plain = ::mmap(nullptr, kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    report("plain-memory", plain == MAP_FAILED ? -1 : 0);  // the one that has to work
    report("make-executable", ::mprotect(plain, kPage, PROT_READ | PROT_EXEC));
    report("executable-memory",
           ::mmap(nullptr, kPage, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED
               ? -1
               : 0);
    reportOpened("memory-file", ::memfd_create("code", 0));
    const int shared = ::shmget(IPC_PRIVATE, kPage, IPC_CREAT | 0600);
    if (report("shared-memory", shared)) ::shmctl(shared, IPC_RMID, nullptr);
    if (plain != MAP_FAILED) ::munmap(plain, kPage);
  }

  std::string m_new, m_other, m_socket;
  std::string m_lines;
};

}  // namespace

std::string hostileAttempts(const std::string& folder) {
  return Attempts(folder).all();
}

}  // namespace geargraph::test
