#include "core/presentation/handout/page_frame.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

std::string pageHead(const std::string& title, PageKind kind, bool reports) {
  return "<!DOCTYPE html>\n<html lang=\"" + escapedXml(translated("en")) +
         "\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         pagePolicy(kind, reports) + "\">\n<title>" + title +
         "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<style>" +
         std::string(pageStyle()) + "</style>\n</head>\n";
}

std::string pageFooter(bool reports, const std::string& note) {
  const std::string promise =
      reports ? translated(
                    "Tells the learning platform which parts were seen, and points; loads nothing and sends "
                    "nothing else.")
              : translated("Works offline: this file loads nothing and sends nothing.");
  return "<footer>" + escapedXml(promise) + (note.empty() ? "" : " " + escapedXml(note)) + " " +
         escapedXml(translated("Made by GearGraph.")) + "</footer>\n";
}

std::string pageScriptElement(std::string_view script) {
  return "<script>" + std::string(script) + "</script>\n";
}

}  // namespace geargraph
