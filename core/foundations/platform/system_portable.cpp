#define BOOST_DLL_USE_STD_FS  // for headers alone
#include <boost/dll/runtime_symbol_info.hpp>
#include <chrono>
#include <limits>
#include <random>

#include "core/foundations/platform/open_file.h"
#include "core/foundations/platform/system.h"

namespace geargraph {

namespace fs = std::filesystem;

std::string_view platformName() {
  return "portable";
}

int processId() {
  static const int id = [] {
    std::random_device device;
    return std::uniform_int_distribution<int>(1, std::numeric_limits<int>::max())(device);
  }();
  return id;
}

bool isProcessRunning(int id) {
  return id == processId();
}

fs::path programPath() {
  boost::dll::fs::error_code error;
  const boost::dll::fs::path path = boost::dll::program_location(error);
  return error ? fs::path() : fs::path(path.native());
}

void lowerThreadPriority() {}

bool isWritable(const fs::path& path, std::error_code& error) {
  return OpenFile(path, OpenMode::change, error).isOpen();
}

void syncFolder(const fs::path& folder) {
  (void)folder;
}

std::optional<FileStamp> fileStamp(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  FileStamp stamp;
  if (const std::uintmax_t size = fs::file_size(path, error); !error) stamp.size = size;
  if (const auto time = fs::last_write_time(path, error); !error)
    stamp.modified = std::chrono::nanoseconds(time.time_since_epoch()).count();
  return stamp;
}

}  // namespace geargraph
