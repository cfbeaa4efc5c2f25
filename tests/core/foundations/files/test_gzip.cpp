#include <zlib.h>

#include <QTest>

#include "core/foundations/files/gzip.h"

namespace geargraph {

class GzipTest : public QObject {
  Q_OBJECT

  static std::string unpacked(const std::string& packed, std::size_t size) {
    z_stream stream{};
    inflateInit2(&stream, MAX_WBITS + 16);
    std::string bytes(size + 1, 'x');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    bytes.resize(stream.total_out);
    inflateEnd(&stream);
    return status == Z_STREAM_END ? bytes : std::string("not whole");
  }

 private slots:
  void whatIsPackedComesOutAgain() {
    std::string many;
    for (int i = 0; i < 300'000; ++i) many += static_cast<char>(i * i / 7);
    for (const std::string& bytes : {std::string(), std::string("gears"), std::string(5'000, '\0'), many})
      QVERIFY(unpacked(gzip(bytes), bytes.size()) == bytes);
  }

  void equalBytesGiveEqualFiles() {
    QCOMPARE(gzip("gears"), gzip("gears"));
    QCOMPARE(gzip("gears").substr(4, 4), std::string(4, '\0'));  // the time
    QVERIFY(gzip(std::string(5'000, 'a')).size() < 100);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::GzipTest)
#include "test_gzip.moc"
