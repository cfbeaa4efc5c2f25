#include <QByteArray>
#include <QTest>

#include "core/foundations/files/base64.h"

using namespace geargraph;

class Base64Test : public QObject {
  Q_OBJECT
 private slots:
  /// The examples of RFC 4648, section 10.
  void theExamplesOfTheStandard() {
    QCOMPARE(base64(""), std::string());
    QCOMPARE(base64("f"), std::string("Zg=="));
    QCOMPARE(base64("fo"), std::string("Zm8="));
    QCOMPARE(base64("foo"), std::string("Zm9v"));
    QCOMPARE(base64("foob"), std::string("Zm9vYg=="));
    QCOMPARE(base64("fooba"), std::string("Zm9vYmE="));
    QCOMPARE(base64("foobar"), std::string("Zm9vYmFy"));
  }
  /// Every byte, in every place, as Qt has it.
  void allBytesAsAnother() {
    std::string bytes;
    for (int length = 0; length < 3; ++length) {
      bytes += 'x';
      for (int value = 0; value < 256; ++value) bytes += static_cast<char>(value);
      QCOMPARE(base64(bytes), QByteArray::fromStdString(bytes).toBase64().toStdString());
    }
  }
};

QTEST_APPLESS_MAIN(Base64Test)
#include "test_base64.moc"
