#include "core/presentation/meshfile/foreign_mesh.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/foundations/files/utf8.h"

namespace geargraph::inline meshfile {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kLookAround = 50;                // ms between two looks at the stop token
constexpr std::size_t kLongestReport = 4096;   // bytes that the reader writes about what went wrong
constexpr std::size_t kLongestSentence = 300;  // characters of it that are shown

/// A file descriptor that is closed again.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : m_number(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] bool isOpen() const { return m_number >= 0; }
  void close() {
    if (m_number >= 0) ::close(m_number);
    m_number = -1;
  }

 private:
  int m_number;
};

MeshFileError refused(const std::string& why, MeshFileError::Kind kind = MeshFileError::Kind::file) {
  return {kind, why};
}

MeshFileError tooSlow(const ForeignLimits& limits) {
  return refused(
      "Reading it took longer than " + std::to_string(static_cast<int>(limits.mostSeconds)) + " s.",
      MeshFileError::Kind::limit);
}

/// Opens it without waiting for anybody (a pipe without a writer would), and only where it is a file.
std::variant<Descriptor, MeshFileError> openRegular(const fs::path& path, const ForeignLimits& limits) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.isOpen()) {
    return refused(errno == ENOENT ? "It is not there." : "It cannot be opened.");
  }
  struct stat what {};
  if (::fstat(file.number(), &what) != 0 || !S_ISREG(what.st_mode)) return refused("It is no file.");
  if (static_cast<std::size_t>(what.st_size) > limits.mostBytes) {
    return refused("It has " + std::to_string(what.st_size) + " bytes, more than the limit of " +
                       std::to_string(limits.mostBytes) + ".",
                   MeshFileError::Kind::limit);
  }
  return file;
}

/// The reader's process; killed and buried when it goes.
class ReaderProcess {
 public:
  ReaderProcess() = default;
  ~ReaderProcess() {
    if (m_pid <= 0) return;
    ::kill(m_pid, SIGKILL);
    (void)wait();
  }
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  bool start(const fs::path& program, const std::vector<std::string>& words, int input, int output,
             int errors) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::vector<char*> arguments = {const_cast<char*>(program.c_str())};  // NOLINT: they are only read
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    std::array<char*, 1> environment = {nullptr};
    const int failed =
        ::posix_spawn(&m_pid, program.c_str(), &actions, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) m_pid = 0;
    return failed == 0;
  }

  /// How it ended.
  int wait() {
    int status = 0;
    while (::waitpid(m_pid, &status, 0) < 0 && errno == EINTR) continue;
    m_pid = 0;
    return status;
  }

 private:
  pid_t m_pid = 0;
};

struct Answer {
  std::string output;
  std::string errors;
  bool isWhole = false;  ///< both ends were closed in time
  bool isStopped = false;
};

/// Takes what is there; false where the other side has closed.
bool take(int descriptor, std::string& text, std::size_t most) {
  std::array<char, 1 << 16> piece{};
  const ssize_t count = ::read(descriptor, piece.data(), piece.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const std::size_t room = most > text.size() ? most - text.size() : 0;
  text.append(piece.data(), std::min(room, static_cast<std::size_t>(count)));
  return count > 0;
}

Answer listen(Descriptor output, Descriptor errors, std::size_t mostBytes, Clock::time_point deadline,
              const std::stop_token& stop) {
  Answer answer;
  while (output.isOpen() || errors.isOpen()) {
    answer.isStopped = stop.stop_requested();
    if (answer.isStopped || Clock::now() >= deadline) return answer;
    std::array<pollfd, 2> ends = {pollfd{output.number(), POLLIN, 0}, pollfd{errors.number(), POLLIN, 0}};
    if (::poll(ends.data(), ends.size(), kLookAround) <= 0) continue;
    if (ends[0].revents != 0 && !take(output.number(), answer.output, mostBytes)) output.close();
    if (ends[1].revents != 0 && !take(errors.number(), answer.errors, kLongestReport)) errors.close();
  }
  answer.isWhole = true;
  return answer;
}

/// What the reader wrote, as one line that is safe to show: the file decides what is in it.
std::string sentenceOf(std::string_view report) {
  std::string sentence;
  std::size_t characters = 0;
  for (std::size_t i = 0; i < report.size() && characters < kLongestSentence; ++characters) {
    const std::size_t length = utf8Length(report, i);
    const auto first = static_cast<unsigned char>(report[i]);
    const bool isShown = length > 1 ? first != 0xC2 || static_cast<unsigned char>(report[i + 1]) >= 0xA0
                                    : length == 1 && first >= 0x20 && first != 0x7F;
    if (isShown) {
      sentence.append(report, i, length);
    } else if (!sentence.empty() && sentence.back() != ' ') {
      sentence += ' ';
    }
    i += std::max<std::size_t>(length, 1);
  }
  if (characters == kLongestSentence) sentence += "...";
  return sentence;
}

/// Why the reader, which ended with this status, gave no solid.
MeshFileError failureOf(int status, const std::string& report, const ForeignLimits& limits) {
  constexpr int kBeyondLimit = 3;  // geargraph-mesh's exit status
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return tooSlow(limits);
  if (WIFSIGNALED(status))
    return refused("It is damaged, or made to do harm: the program that reads it crashed, and was confined.");
  const std::string sentence = sentenceOf(report);
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0 && !sentence.empty()) {
    return refused(sentence, WEXITSTATUS(status) == kBeyondLimit ? MeshFileError::Kind::limit
                                                                 : MeshFileError::Kind::file);
  }
  return refused("It is damaged, or made to do harm: what the program that reads it answers is no solid.");
}

std::optional<std::pair<Descriptor, Descriptor>> pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

}  // namespace

std::optional<MeshFormat> foreignFormat(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::obj, MeshFormat::ply, MeshFormat::glb}) {
    if (ending == "." + std::string(meshFormatName(format))) return format;
  }
  return std::nullopt;
}

std::variant<Solid, MeshFileError> readForeignMesh(const fs::path& reader, const fs::path& path,
                                                   const ForeignLimits& limits, const std::stop_token& stop) {
  const auto format = foreignFormat(path);
  if (!format) return refused("It is none of STL, OBJ, PLY and GLB.");
  if (reader.empty()) return refused("The program geargraph-mesh, which reads 3D files, is missing.");
  auto opened = openRegular(path, limits);
  if (const auto* error = std::get_if<MeshFileError>(&opened)) return *error;
  auto output = pipe(), errors = pipe();
  if (!output || !errors) return refused("There are too many open files.");
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(limits.mostSeconds));
  ReaderProcess process;
  const std::vector<std::string> words = {
      std::string(meshFormatName(*format)), std::to_string(limits.mostBytes),
      std::to_string(limits.mostTriangles), std::to_string(limits.mostMemory),
      std::to_string(static_cast<long>(limits.mostSeconds) + 1)};
  if (!process.start(reader, words, std::get<Descriptor>(opened).number(), output->second.number(),
                     errors->second.number()))
    return refused("The program geargraph-mesh cannot be run.");
  output->second.close();
  errors->second.close();
  // A triangle has at most three vertices of its own.
  const std::size_t mostAnswer = 64 + limits.mostTriangles * (6 * sizeof(Float3) + sizeof(Triangle));
  const Answer answer =
      listen(std::move(output->first), std::move(errors->first), mostAnswer, deadline, stop);
  if (answer.isStopped) return refused("Reading it was stopped.", MeshFileError::Kind::stopped);
  if (!answer.isWhole) return tooSlow(limits);
  const int status = process.wait();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    if (auto solid = unpackedSolid(answer.output, limits.mostTriangles)) return *std::move(solid);
  }
  return failureOf(status, answer.errors, limits);
}

fs::path foreignMeshReader() {
  if (const char* named = std::getenv("GEARGRAPH_MESH_READER"))
    return named;  // NOLINT: nobody sets it meanwhile
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place :
       {"geargraph-mesh", "../mesh/geargraph-mesh", "../libexec/geargraph/geargraph-mesh"}) {
    const fs::path program = (here / place).lexically_normal();
    if (!here.empty() && fs::is_regular_file(program, error)) return program;
  }
  return {};
}

}  // namespace geargraph::inline meshfile
