#include "core/mechanism/document_format/graph_parts.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"

namespace geargraph {

void GraphAttributes::set(std::string_view name, AttributePtr value) {
  for (auto& [known, text] : m_all) {
    if (known != name) continue;
    text = std::move(value);
    return;
  }
  m_all.emplace_back(name, std::move(value));
}

const AttributeText* GraphAttributes::find(std::string_view name) const {
  for (const auto& [known, text] : m_all) {
    if (known == name) return text.get();
  }
  return nullptr;
}

void GraphParts::set(AttributeOwner owner, GraphAttributes& into, std::string_view attribute,
                     AttributePtr value) {
  if (const auto known = knownAttribute(owner, attribute)) {
    into.set(*known, std::move(value));
  } else {
    addUnread(attribute);
  }
}

void GraphParts::addUnread(std::string_view attribute) {
  if (attribute == "id" || attribute == "key") return;  // NetworkX' names of edges
  constexpr std::size_t kMaxNames = 20;
  constexpr std::size_t kMaxLength = 100;  // bytes
  if (unread.size() < kMaxNames && attribute.size() <= kMaxLength) unread.emplace(attribute);
}

void GraphDiagnostics::add(Code code, std::string message, std::size_t offset,
                           std::vector<ElementId> elements) {
  if (isFull()) return;
  m_diagnostics.emplace_back(offset, Diagnostic{code, std::move(message), std::move(elements), {}, 0, 0});
}

Diagnostics GraphDiagnostics::inOrder() const {
  std::vector<std::pair<std::size_t, Diagnostic>> sorted = m_diagnostics;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Diagnostics result;
  std::size_t at = 0;
  int line = 1, column = 1;
  for (auto& [offset, diagnostic] : sorted) {
    for (; at < std::min(offset, m_text.size()); ++at) {
      const bool continues = (static_cast<unsigned char>(m_text[at]) & 0xC0U) == 0x80U;
      if (m_text[at] == '\n') {
        ++line;
        column = 1;
      } else if (!continues) {
        ++column;
      }
    }
    diagnostic.line = line;
    diagnostic.column = column;
    result.push_back(std::move(diagnostic));
  }
  return result;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kMaxBytes = 60;
  std::string shown = "\"";
  std::size_t at = 0;
  while (at < text.size() && at < kMaxBytes) {
    const std::size_t length = std::max<std::size_t>(utf8Length(text, at), 1);
    const bool isControl = static_cast<unsigned char>(text[at]) < 0x20;
    shown += isControl ? " " : std::string(text.substr(at, length));
    at += length;
  }
  return shown + (at < text.size() ? "...\"" : "\"");
}

Diagnostics undirectedGraph(std::string_view text, std::size_t offset) {
  GraphDiagnostics diagnostics(text);
  diagnostics.add(
      Code::format,
      translated("The graph is undirected, so that it does not say which link of a joint or mesh is tail and "
                 "which is head: the signs and the teeth of each gear depend on it. Make it directed."),
      offset);
  return diagnostics.inOrder();
}

}  // namespace geargraph
