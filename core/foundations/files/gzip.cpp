#include "core/foundations/files/gzip.h"

#include <zlib.h>

#include <limits>

#include "core/foundations/base/contract.h"

namespace geargraph {

std::string gzip(std::string_view bytes) {
  constexpr int kGzip = 16;  // added to the size of the window: this header instead of zlib's
  constexpr int kMemory = 9;
  GEARGRAPH_REQUIRE(bytes.size() < std::numeric_limits<uInt>::max());
  z_stream stream{};
  GEARGRAPH_REQUIRE(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzip, kMemory,
                                 Z_DEFAULT_STRATEGY) == Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  GEARGRAPH_REQUIRE(status == Z_STREAM_END);  // the bound is enough for one call
  return packed;
}

}  // namespace geargraph
