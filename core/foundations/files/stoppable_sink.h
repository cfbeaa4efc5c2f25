#pragma once

#include <stop_token>
#include <utility>

#include "core/foundations/files/byte_sink.h"

namespace geargraph {

/// Forwards bytes to another sink until a stop is requested. The owner of the other sink then discards what
/// was written.
class StoppableSink final : public ByteSink {
 public:
  StoppableSink(ByteSink& sink, std::stop_token stop) : m_sink(sink), m_stop(std::move(stop)) {}
  void write(std::string_view bytes) override {
    if (!failed()) m_sink.write(bytes);
  }
  [[nodiscard]] bool failed() const override { return m_stop.stop_requested() || m_sink.failed(); }

 private:
  ByteSink& m_sink;
  std::stop_token m_stop;
};

}  // namespace geargraph
