#include "app/cli/diagnostics_output.h"

#include <algorithm>
#include <map>
#include <vector>

namespace geargraph::cli {
namespace {

using Layout = JsonWriter::Layout;

void writeElements(JsonWriter& json, const std::vector<ElementId>& elements) {
  std::map<ElementKind, std::vector<std::string>> lists;
  for (const ElementId& element : elements) {
    std::vector<std::string>& ids = lists[element.kind];  // an element may play two parts in a finding
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

std::string diagnosticLines(std::string_view file, const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    text += file;
    if (diagnostic.line > 0) {
      text += ':' + std::to_string(diagnostic.line) + ':' + std::to_string(diagnostic.column);
    }
    text += ": " + std::string(severityName(diagnostic.severity())) + ": " + diagnostic.message + " [" +
            std::string(codeName(diagnostic.code)) + "]\n";
  }
  return text;
}

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

void writeMotionCheck(JsonWriter& json, const std::optional<MotionReport>& report) {
  json.key("motion");
  if (!report) return json.null();
  const MotionCheck& check = report->check;
  json.beginObject(Layout::row);
  json.member("from", check.from);
  json.member("to", check.to);
  json.member("coversAll", check.coversAll);
  json.member("isComplete", check.isComplete);
  json.key("collisions");
  json.beginArray(Layout::row);
  for (const MotionCollision& collision : check.collisions) {
    json.beginObject(Layout::row);
    json.key("links");
    json.beginArray(Layout::row);
    for (const int link : {collision.one, collision.other}) json.number(std::int64_t{link});
    json.endArray();
    json.member("time", collision.time);
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

std::string motionCheckLine(std::string_view file, const std::optional<MotionReport>& report) {
  std::string text(file);
  if (!report)
    return text + ": motion not checked: nothing moves, the mechanism has errors, or it has more than " +
           std::to_string(kMostCheckedLinks) + " links\n";
  const MotionCheck& check = report->check;
  if (!check.isComplete)
    return text + ": motion checked in part only: too many parts come close to each other\n";
  text += ": motion checked from " + secondsText(check.from) + " to " + secondsText(check.to);
  return text + (check.coversAll ? ", all of it\n" : "; it does not repeat sooner\n");
}

}  // namespace geargraph::cli
