#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/byte_sink.h"

namespace geargraph {

/// Writes readable JSON piece by piece into a sink: containers with Layout::lines have each member on its own
/// line, indented by two spaces, containers with Layout::row are on one line.
class JsonWriter {
 public:
  enum class Layout { lines, row };

  explicit JsonWriter(ByteSink& sink) : m_out(sink) {}

  void beginObject(Layout layout = Layout::lines) { begin('{', layout); }
  void endObject() { end('}'); }
  void beginArray(Layout layout = Layout::lines) { begin('[', layout); }
  void endArray() { end(']'); }
  void key(std::string_view name);

  void string(std::string_view text);
  void number(std::int64_t value);
  /// The shortest decimal that reads back as the same double; 0 for -0. @pre finite
  void number(double value);
  /// The same, but null if the value is not finite, as for an exact ratio beyond the range of doubles.
  void numberOrNull(double value);
  void boolean(bool value) { json(value ? "true" : "false"); }
  void null() { json("null"); }
  /// Writes a value that is JSON already.
  void json(std::string_view text);

  /// Writes a key with its value.
  template <class Value>
  void member(std::string_view name, const Value& value) {
    key(name);
    if constexpr (std::is_same_v<Value, bool>) {
      boolean(value);
    } else if constexpr (std::is_floating_point_v<Value>) {
      number(static_cast<double>(value));
    } else if constexpr (std::is_convertible_v<const Value&, std::int64_t>) {
      number(static_cast<std::int64_t>(value));
    } else {
      string(value);
    }
  }

 private:
  struct Container {
    Layout layout = Layout::lines;
    bool isEmpty = true;
  };
  void begin(char bracket, Layout layout);
  void end(char bracket);
  void beforeElement();
  void newLine();

  BufferedSink m_out;
  std::vector<Container> m_open;
  bool m_afterKey = false;
};

}  // namespace geargraph
