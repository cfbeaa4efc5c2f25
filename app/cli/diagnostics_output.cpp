#include "app/cli/diagnostics_output.h"

#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

using Layout = JsonWriter::Layout;

/// Which part of the motion a complete check covers.
std::string extentOf(const MotionCheck& check) {
  if (check.from == 0 && check.to == 0)
    return translated("motion checked: the distance of no two parts changes, so that nothing can collide");
  const std::string from = secondsText(check.from);
  const std::string to = secondsText(check.to);
  if (!check.coversAll)
    return translated("motion checked from %1 to %2; it does not repeat sooner", {from, to});
  return check.isLimited
             ? translated("motion checked from %1 to %2, between the limits of the joints", {from, to})
             : translated("motion checked for %1, until the motion of every two links repeats", {to});
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
    return text + ": " +
           translated(
               "motion not checked: nothing moves, the mechanism has errors, or it has more than %1 links",
               {std::to_string(kMaxCheckedLinks)}) +
           '\n';
  const MotionCheck& check = report->check;
  if (!check.isComplete)
    return text + ": " + translated("motion checked in part only: too many parts come close to each other") +
           '\n';
  return text + ": " + extentOf(check) + '\n';
}

}  // namespace geargraph::cli
