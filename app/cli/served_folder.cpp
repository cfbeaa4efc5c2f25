#include "app/cli/served_folder.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <algorithm>
#include <system_error>

#include "app/cli/arguments.h"
#include "core/foundations/files/file.h"
#include "core/presentation/exporters/exporters.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

/// bytes; plates of a printer and frames of a check are some megabytes each.
constexpr std::size_t kLargestServedFile = std::size_t{256} << 20U;

}  // namespace

ServedFolder::ServedFolder() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  if (error) return;
  std::string name = (temporary / "geargraph-serve-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) m_place = name;
}

ServedFolder::~ServedFolder() {
  std::error_code error;
  if (isMade()) fs::remove_all(m_place, error);
}

std::optional<std::vector<std::pair<std::string, std::string>>> ServedFolder::files() const {
  const fs::path folder(path());
  std::error_code error;
  std::vector<std::pair<std::string, std::string>> files;
  fs::recursive_directory_iterator entry(folder, error);
  if (error) return std::nullopt;
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (error) return std::nullopt;
    if (!entry->is_regular_file(error)) continue;
    auto read = readFile(entry->path(), kLargestServedFile);
    auto* const bytes = std::get_if<std::string>(&read);
    if (bytes == nullptr || bytes->size() > kLargestServedFile) return std::nullopt;
    files.emplace_back(entry->path().lexically_relative(folder).generic_string(), std::move(*bytes));
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool asksForFolder(const std::vector<std::string>& words) {
  const auto parsed = parseArguments(words, exportOptionTexts());
  const auto* const given = std::get_if<Arguments>(&parsed);
  if (given == nullptr) return false;  // the command says what is wrong
  const Exporter* const exporter = exporterOf(given->value("--to").value_or(""), *given);
  return exporter != nullptr && exporter->files == ExportFiles::folder;
}

}  // namespace geargraph::cli
