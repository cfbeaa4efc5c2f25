// For builds with libc++ (GEARGRAPH_LIBCXX) only: the distribution's Qt is built with libstdc++, and these
// two of its functions take or give a std::string, which is another type there.

#include <QByteArray>
#include <string>

std::string QByteArray::toStdString() const {
  return {constData(), static_cast<std::size_t>(size())};
}

QByteArray QByteArray::fromStdString(const std::string& text) {
  return {text.data(), static_cast<qsizetype>(text.size())};
}
