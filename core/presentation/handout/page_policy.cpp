#include "core/presentation/handout/page_policy.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/files/base64.h"
#include "core/presentation/handout/page_files.h"

namespace geargraph {
namespace {

std::string_view pageFile(std::size_t position) {
  const std::span<const unsigned char> bytes = handoutPageFiles()[position];
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// "'sha256-...'" of a hash in hexadecimal digits.
std::string source(std::string_view hash) {
  GEARGRAPH_REQUIRE(hash.size() == 64);
  std::string bytes;
  for (std::size_t i = 0; i < hash.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hash.substr(i, 2)), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

}  // namespace

std::string_view pageStyle() {
  return pageFile(0);
}

std::string_view pageScript(PageKind kind) {
  return pageFile(kind == PageKind::handout ? 1 : 4);
}

std::string_view pageLibrary() {
  return pageFile(2);
}

std::string_view pageReporter() {
  return pageFile(3);
}

std::string pagePolicy(PageKind kind, bool reports) {
  const std::string scripts = kind == PageKind::handout
                                  ? source(GEARGRAPH_SCRIPT_SHA256) + " " + source(GEARGRAPH_LIBRARY_SHA256)
                                  : source(GEARGRAPH_LESSON_SHA256);
  return "default-src 'none'; script-src " + scripts +
         (reports ? " " + source(GEARGRAPH_REPORTER_SHA256) : std::string()) + "; style-src " +
         source(GEARGRAPH_STYLE_SHA256) + "; img-src data:; base-uri 'none'; form-action 'none'";
}

}  // namespace geargraph
