// Files by the standard library alone: no owners, no extended attributes, and what was written is given to
// the system, not to the disk.

#include <cerrno>
#include <cstdio>
#include <utility>

#include "core/foundations/platform/open_file.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

void report(bool isFine, std::error_code& error) {
  const int number = errno != 0 ? errno : EIO;
  error = isFine ? std::error_code() : std::error_code(number, std::generic_category());
}

const char* modeOf(OpenMode mode) {
  switch (mode) {
    case OpenMode::read:
      return "rb";
    case OpenMode::write:
      return "ab";
    case OpenMode::change:
      return "r+b";
    case OpenMode::createNew:
      return "w+bx";
  }
  return "rb";
}

std::FILE* opened(const fs::path& path, const char* mode) {
#ifdef _WIN32
  const std::wstring wide(mode, mode + std::char_traits<char>::length(mode));
  return ::_wfopen(path.c_str(), wide.c_str());
#else
  return std::fopen(path.c_str(), mode);
#endif
}

}  // namespace

struct OpenFile::State {
  std::FILE* file = nullptr;
  bool isKeptOpen = false;
  fs::path path{};
};

std::optional<FileAttributes> attributesOf(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error || !fs::exists(status)) return std::nullopt;
  const std::uintmax_t links = fs::hard_link_count(path, error);
  return FileAttributes{0, 0, static_cast<unsigned>(status.permissions() & fs::perms::mask),
                        error ? 1 : links};
}

OpenFile::OpenFile() = default;
OpenFile::OpenFile(std::unique_ptr<State> state) : m_state(std::move(state)) {}
OpenFile::OpenFile(OpenFile&& other) noexcept = default;

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
  std::swap(m_state, other.m_state);
  return *this;
}

OpenFile::OpenFile(const fs::path& path, OpenMode mode, std::error_code& error) {
  errno = 0;
  std::FILE* const file = opened(path, modeOf(mode));
  report(file != nullptr, error);
  if (file == nullptr) return;
  std::setvbuf(file, nullptr, _IONBF, 0);  // callers write in large pieces
  m_state = std::make_unique<State>(State{file, false, path});
}

OpenFile::~OpenFile() {
  if (m_state && !m_state->isKeptOpen) std::fclose(m_state->file);
}

OpenFile OpenFile::standardInput() {
  return OpenFile(std::make_unique<State>(State{stdin, true, {}}));
}

OpenFile OpenFile::standardOutput() {
  return OpenFile(std::make_unique<State>(State{stdout, true, {}}));
}

std::size_t OpenFile::read(char* to, std::size_t most, std::error_code& error) {
  errno = 0;
  const std::size_t count = std::fread(to, 1, most, m_state->file);
  report(count > 0 || std::ferror(m_state->file) == 0, error);
  return count;
}

void OpenFile::write(std::string_view bytes, std::error_code& error) {
  errno = 0;
  const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), m_state->file) == bytes.size();
  report(isWritten && std::fflush(m_state->file) == 0, error);
}

void OpenFile::sync(std::error_code& error) {
  errno = 0;
  report(std::fflush(m_state->file) == 0, error);
}

void OpenFile::close(std::error_code& error) {
  error.clear();
  errno = 0;
  const auto state = std::exchange(m_state, nullptr);
  if (state && !state->isKeptOpen) report(std::fclose(state->file) == 0, error);
}

std::string OpenFile::contents(std::error_code& error) {
  errno = 0;
  std::FILE* const file = m_state->file;  // which may have another name by now
  const long position = std::ftell(file);
  bool isFine = position >= 0 && std::fseek(file, 0, SEEK_END) == 0;
  const long size = isFine ? std::ftell(file) : -1;
  isFine = size >= 0 && std::fseek(file, 0, SEEK_SET) == 0;
  std::string bytes(static_cast<std::size_t>(isFine ? size : 0), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  isFine = isFine && std::ferror(file) == 0;
  isFine = position >= 0 && std::fseek(file, position, SEEK_SET) == 0 && isFine;
  report(isFine, error);
  return isFine ? bytes : std::string();
}

void OpenFile::setContents(std::string_view bytes, std::error_code& error) {
  errno = 0;
  const long position = std::ftell(m_state->file);
  report(position >= 0 && std::fseek(m_state->file, 0, SEEK_SET) == 0, error);
  if (!error) write(bytes, error);
  if (!error) truncate(bytes.size(), error);
  if (!error) report(std::fseek(m_state->file, position, SEEK_SET) == 0, error);
}

void OpenFile::reserve(std::size_t from, std::size_t to, std::error_code& error) {
  error.clear();
  (void)from;
  (void)to;
}

void OpenFile::truncate(std::size_t size, std::error_code& error) {
  errno = 0;
  report(std::fflush(m_state->file) == 0, error);
  if (!error) fs::resize_file(m_state->path, size, error);
}

bool OpenFile::takeOwner(const FileAttributes& wanted) {
  (void)wanted;
  return true;
}

void OpenFile::setMode(unsigned mode, std::error_code& error) {
  fs::permissions(m_state->path, static_cast<fs::perms>(mode), error);
}

void OpenFile::takeExtendedAttributes(const fs::path& from) {
  (void)from;
}

}  // namespace geargraph
