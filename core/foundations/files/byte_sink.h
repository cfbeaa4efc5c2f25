#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace geargraph::inline files {

/// Takes bytes: a file, a pipe, a text. Failures are remembered by the sink, not returned on each call, so
/// that writers stay free of them; whoever owns the sink asks at the end.
class ByteSink {
 public:
  ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;
  virtual ~ByteSink() = default;

  virtual void write(std::string_view bytes) = 0;
  /// Nothing more can be written; a long writer may stop.
  [[nodiscard]] virtual bool failed() const { return false; }
};

/// Gathers everything in a text.
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

}  // namespace geargraph::inline files
