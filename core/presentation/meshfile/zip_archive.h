#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace geargraph {

/// Writes a ZIP archive into memory, piece by piece, compressed by zlib. Every entry has the format's first
/// date (1980-01-01), so that equal contents give equal bytes. Entries and archive must be smaller than 4
/// GiB.
class ZipArchive {
 public:
  ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;
  ~ZipArchive();

  /// @pre no entry is open
  void beginEntry(std::string_view name);
  void write(std::string_view bytes);
  void endEntry();

  [[nodiscard]] std::size_t size() const { return m_bytes.size(); }
  /// Closes the archive. @pre no entry is open
  [[nodiscard]] std::string finish();

 private:
  struct Entry {
    std::string name;
    std::uint32_t offset = 0;
    std::uint32_t checksum = 0;
    std::uint32_t packedSize = 0;
    std::uint32_t plainSize = 0;
  };
  struct Deflater;

  void deflateInput(int flush);

  std::string m_bytes;
  std::vector<Entry> m_entries;
  std::unique_ptr<Deflater> m_deflater;  ///< while an entry is open
};

}  // namespace geargraph
