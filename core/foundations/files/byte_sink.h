#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace geargraph {

/// Receives bytes, for a file, a pipe or a text. Failures are stored by the sink instead of being returned by
/// each call, so that writers need not handle them; the owner of the sink checks failed() at the end.
class ByteSink {
 public:
  ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;
  virtual ~ByteSink() = default;

  virtual void write(std::string_view bytes) = 0;
  /// True if nothing more can be written; a long writer may stop.
  [[nodiscard]] virtual bool failed() const { return false; }
};

/// Collects all bytes in a string.
class TextSink final : public ByteSink {
 public:
  void write(std::string_view bytes) override { m_text += bytes; }
  [[nodiscard]] const std::string& text() const { return m_text; }
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

/// Collects small pieces into chunks for another sink. The last one is passed on by flush() or the
/// destructor.
class BufferedSink final {
 public:
  static constexpr std::size_t kChunk = std::size_t{256} * 1024;

  explicit BufferedSink(ByteSink& sink) : m_sink(sink) { m_buffer.reserve(kChunk); }
  BufferedSink(const BufferedSink&) = delete;
  BufferedSink& operator=(const BufferedSink&) = delete;
  ~BufferedSink() { flush(); }

  void put(char c) {
    m_buffer += c;
    if (m_buffer.size() >= kChunk) flush();
  }
  void write(std::string_view bytes) {
    m_buffer += bytes;
    if (m_buffer.size() >= kChunk) flush();
  }
  void flush() {
    if (!m_buffer.empty()) m_sink.write(m_buffer);
    m_buffer.clear();
  }
  [[nodiscard]] bool failed() const { return m_sink.failed(); }

 private:
  ByteSink& m_sink;
  std::string m_buffer;
};

}  // namespace geargraph
