#include "core/presentation/meshfile/zip_archive.h"

#include <zlib.h>

#include <array>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::uint16_t kVersion = 20;  // deflate
constexpr std::uint16_t kUtf8Names = 1U << 11U;
constexpr std::uint16_t kDeflated = 8;
constexpr std::uint16_t kNoTime = 0;
constexpr std::uint16_t kFirstDate = (1U << 5U) | 1U;  // 1980-01-01

void put16(std::string& bytes, std::uint16_t value) {
  bytes += static_cast<char>(value & 0xFFU);
  bytes += static_cast<char>(value >> 8U);
}

void put32(std::string& bytes, std::uint32_t value) {
  put16(bytes, static_cast<std::uint16_t>(value & 0xFFFFU));
  put16(bytes, static_cast<std::uint16_t>(value >> 16U));
}

}  // namespace

struct ZipArchive::Deflater {
  Deflater() {
    const int rawDeflate = -MAX_WBITS;
    const int memoryLevel = 8;
    GEARGRAPH_REQUIRE(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, rawDeflate, memoryLevel,
                                   Z_DEFAULT_STRATEGY) == Z_OK);
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream); }

  z_stream stream{};
};

ZipArchive::ZipArchive() = default;
ZipArchive::~ZipArchive() = default;

void ZipArchive::beginEntry(std::string_view name) {
  GEARGRAPH_REQUIRE(m_deflater == nullptr);
  m_deflater = std::make_unique<Deflater>();
  Entry& entry = m_entries.emplace_back();
  entry.name = name;
  entry.offset = static_cast<std::uint32_t>(m_bytes.size());
  entry.checksum = static_cast<std::uint32_t>(crc32(0, nullptr, 0));
  put32(m_bytes, 0x04034B50);
  put16(m_bytes, kVersion);
  put16(m_bytes, kUtf8Names);
  put16(m_bytes, kDeflated);
  put16(m_bytes, kNoTime);
  put16(m_bytes, kFirstDate);
  m_bytes.append(12, '\0');  // checksum and sizes, known at the end
  put16(m_bytes, static_cast<std::uint16_t>(name.size()));
  put16(m_bytes, 0);
  m_bytes += name;
}

void ZipArchive::write(std::string_view bytes) {
  GEARGRAPH_REQUIRE(m_deflater != nullptr);
  Entry& entry = m_entries.back();
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  entry.checksum = static_cast<std::uint32_t>(crc32(entry.checksum, data, static_cast<uInt>(bytes.size())));
  entry.plainSize += static_cast<std::uint32_t>(bytes.size());
  m_deflater->stream.next_in = const_cast<Bytef*>(data);  // zlib only reads it
  m_deflater->stream.avail_in = static_cast<uInt>(bytes.size());
  deflateInput(Z_NO_FLUSH);
}

void ZipArchive::deflateInput(int flush) {
  std::array<char, 65536> chunk{};
  z_stream& stream = m_deflater->stream;
  do {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    const int result = deflate(&stream, flush);
    GEARGRAPH_REQUIRE(result == Z_OK || result == Z_STREAM_END || result == Z_BUF_ERROR);
    m_bytes.append(chunk.data(), chunk.size() - stream.avail_out);
  } while (stream.avail_out == 0);
}

void ZipArchive::endEntry() {
  GEARGRAPH_REQUIRE(m_deflater != nullptr);
  deflateInput(Z_FINISH);
  Entry& entry = m_entries.back();
  entry.packedSize = static_cast<std::uint32_t>(m_deflater->stream.total_out);
  m_deflater.reset();
  std::string sizes;
  put32(sizes, entry.checksum);
  put32(sizes, entry.packedSize);
  put32(sizes, entry.plainSize);
  m_bytes.replace(entry.offset + 14, sizes.size(), sizes);
}

std::string ZipArchive::finish() {
  GEARGRAPH_REQUIRE(m_deflater == nullptr);
  const auto directory = static_cast<std::uint32_t>(m_bytes.size());
  for (const Entry& entry : m_entries) {
    put32(m_bytes, 0x02014B50);
    put16(m_bytes, kVersion);
    put16(m_bytes, kVersion);
    put16(m_bytes, kUtf8Names);
    put16(m_bytes, kDeflated);
    put16(m_bytes, kNoTime);
    put16(m_bytes, kFirstDate);
    put32(m_bytes, entry.checksum);
    put32(m_bytes, entry.packedSize);
    put32(m_bytes, entry.plainSize);
    put16(m_bytes, static_cast<std::uint16_t>(entry.name.size()));
    m_bytes.append(12, '\0');  // no extra field, no comment, first disk, no attributes
    put32(m_bytes, entry.offset);
    m_bytes += entry.name;
  }
  const auto directorySize = static_cast<std::uint32_t>(m_bytes.size()) - directory;
  put32(m_bytes, 0x06054B50);
  put32(m_bytes, 0);  // disks
  put16(m_bytes, static_cast<std::uint16_t>(m_entries.size()));
  put16(m_bytes, static_cast<std::uint16_t>(m_entries.size()));
  put32(m_bytes, directorySize);
  put32(m_bytes, directory);
  put16(m_bytes, 0);
  return std::move(m_bytes);
}

}  // namespace geargraph
