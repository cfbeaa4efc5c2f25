#include "core/presentation/result_json/diagnostics_json.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

void writeElements(JsonWriter& json, const std::vector<ElementId>& elements) {
  std::map<ElementKind, std::vector<std::string>> lists;
  for (const ElementId& element : elements) {
    std::vector<std::string>& ids = lists[element.kind];  // an element may play two parts in a diagnostic
    if (std::find(ids.begin(), ids.end(), element.id.text()) == ids.end()) ids.push_back(element.id.text());
  }
  json.beginObject(Layout::row);
  for (const auto& [kind, ids] : lists) {
    json.key(listName(kind));
    json.beginArray(Layout::row);
    for (const std::string& id : ids) json.string(id);
    json.endArray();
  }
  json.endObject();
}

}  // namespace

void writeDiagnostics(JsonWriter& json, const Diagnostics& diagnostics) {
  json.beginArray();
  for (const Diagnostic& diagnostic : diagnostics) {
    json.beginObject(Layout::row);
    json.member("severity", severityName(diagnostic.severity()));
    json.member("code", codeName(diagnostic.code));
    if (diagnostic.detail != Detail::none) json.member("detail", detailName(diagnostic.detail));
    json.member("message", diagnostic.message);
    json.key("elements");
    writeElements(json, diagnostic.elements);
    if (diagnostic.time) json.member("time", *diagnostic.time);
    if (!diagnostic.pointer.empty()) json.member("pointer", diagnostic.pointer);
    if (diagnostic.line > 0) {
      json.member("line", diagnostic.line);
      json.member("column", diagnostic.column);
    }
    json.endObject();
  }
  json.endArray();
}

}  // namespace geargraph
