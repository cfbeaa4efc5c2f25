#include "app/editor/command_line.h"

#include <QCommandLineParser>
#include <algorithm>
#include <array>
#include <string_view>

#include "ui/settings/languages.h"

namespace geargraph {
namespace {

std::optional<QSize> sizeFrom(const QString& text) {
  const QStringList parts = text.split(QLatin1Char('x'));
  if (parts.size() != 2) return std::nullopt;
  const QSize size(parts[0].toInt(), parts[1].toInt());
  const bool sensible =
      size.width() >= 320 && size.height() >= 240 && size.width() <= 16'384 && size.height() <= 16'384;
  return sensible ? std::optional(size) : std::nullopt;
}

}  // namespace

bool onlyPrints(int count, char** words) {
  constexpr std::array<std::string_view, 5> kPrinting = {"-h", "--help", "--help-all", "-v", "--version"};
  return std::any_of(words + 1, words + count, [&](std::string_view word) {
    return std::find(kPrinting.begin(), kPrinting.end(), word) != kPrinting.end();
  });
}

CommandLine readCommandLine(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QStringLiteral("Draw, analyse and see geared mechanisms. Without a document the windows of the last "
                     "time open, or the start page."));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                      QStringLiteral("Write a picture of the window to <file> and exit."),
                                      QStringLiteral("file"));
  const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("Size of the window, e.g. 1366x768."),
                                QStringLiteral("WxH"));
  const QCommandLineOption drawing(
      QStringLiteral("drawing"),
      QStringLiteral("Of a screenshot: the drawing in front, digraph, ttgraph, schematic or levers."),
      QStringLiteral("name"));
  const QCommandLineOption dark(QStringLiteral("dark"), QStringLiteral("Light on dark."));
  const QCommandLineOption light(QStringLiteral("light"), QStringLiteral("Dark on light."));
  const QCommandLineOption contrast(QStringLiteral("high-contrast"), QStringLiteral("Light on black."));
  const QCommandLineOption language(
      QStringLiteral("language"),
      QStringLiteral("Language of the window: en, de, tr or es. Screenshots are English without it."),
      QStringLiteral("code"));
  parser.addOptions({screenshot, size, drawing, dark, light, contrast, language});
  parser.addPositionalArgument(QStringLiteral("documents"),
                               QStringLiteral("Documents to open, a window each."),
                               QStringLiteral("[documents…]"));
  parser.process(arguments);

  CommandLine line;
  line.documents = parser.positionalArguments();
  if (parser.isSet(screenshot)) line.screenshot = parser.value(screenshot);
  if (parser.isSet(drawing)) line.drawing = parser.value(drawing);
  if (parser.isSet(dark)) line.theme = Theme::dark;
  if (parser.isSet(light)) line.theme = Theme::light;
  if (parser.isSet(contrast)) line.theme = Theme::highContrast;
  if (parser.isSet(language)) {
    const auto& known = languageCodes();
    line.language = parser.value(language);
    if (std::find(known.begin(), known.end(), *line.language) == known.end()) {
      qCritical("--language wants en, de, tr or es, not %s.", qPrintable(*line.language));
      ::exit(2);
    }
  }
  if (parser.isSet(size)) {
    line.size = sizeFrom(parser.value(size));
    if (!line.size) {
      qCritical("--size wants WIDTHxHEIGHT from 320x240 to 16384x16384, not %s.",
                qPrintable(parser.value(size)));
      ::exit(2);
    }
  }
  return line;
}

}  // namespace geargraph
