// `export FILE --to png --view 3d -o OUT`: the train as the 3D view shows it, without a display.

#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/export_forms.h"
#include "app/cli/load.h"
#include "core/analysis/analysis.h"
#include "core/scene/stage_picture.h"
#include "core/scene/train_stage.h"

namespace geargraph::cli {
namespace {

template <class Number>
std::optional<Number> wholeText(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<StandardView> viewNamed(std::string_view name) {
  constexpr std::array kViews = {
      std::pair{"front", StandardView::front},  std::pair{"back", StandardView::back},
      std::pair{"left", StandardView::left},    std::pair{"right", StandardView::right},
      std::pair{"top", StandardView::top},      std::pair{"bottom", StandardView::bottom},
      std::pair{"iso", StandardView::isometric}};
  for (const auto& [known, view] : kViews) {
    if (name == known) return view;
  }
  return std::nullopt;
}

std::variant<PictureOptions, UsageError> pictureOptions(const Arguments& arguments) {
  PictureOptions options;
  options.theme = arguments.has("--dark") ? Theme::dark : Theme::light;
  options.transparent = arguments.has("--transparent");
  if (const auto text = arguments.value("--size")) {
    const auto size = pictureSize(*text, kMostPictureSide);
    if (!size) return UsageError{wrongSize(*text, kMostPictureSide)};
    options.size = {size->first, size->second};
  }
  if (const auto text = arguments.value("--from")) {
    options.from = viewNamed(*text);
    if (!options.from) return UsageError{"--from is one of front, back, left, right, top, bottom, iso."};
  }
  if (const auto text = arguments.value("--time")) {
    const auto time = wholeText<double>(*text);
    if (!time || !std::isfinite(*time)) return UsageError{"--time takes seconds, not \"" + *text + "\"."};
    options.time = *time;
  }
  return options;
}

}  // namespace

std::optional<std::pair<int, int>> pictureSize(std::string_view text, int most) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = wholeText<int>(text.substr(0, cross)), height = wholeText<int>(text.substr(cross + 1));
  const auto fits = [most](const auto& side) { return side && *side >= kLeastPictureSide && *side <= most; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return std::pair(*width, *height);
}

std::string wrongSize(std::string_view text, int most) {
  return "--size takes WIDTHxHEIGHT, each from " + std::to_string(kLeastPictureSide) + " to " +
         std::to_string(most) + ", not \"" + std::string(text) + "\".";
}

int writePicture(std::string_view bytes, const std::string& path) {
  if (path == "-") {
    DescriptorSink out(STDOUT_FILENO);
    out.write(bytes);
    return out.failed() ? fileFailure("Standard output could not be written.") : kFine;
  }
  const auto error = writeFile(path, bytes);
  return error ? fileFailure(error->message) : kFine;
}

int exportPicture(const Arguments& arguments) {
  const auto options = pictureOptions(arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kExport, error->message);
  const std::string& file = arguments.files.front();
  auto document = loadOrSay(file);
  if (const int* status = std::get_if<int>(&document)) return *status;
  const SnapshotPtr snapshot =
      analyze(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(document))));
  std::cerr << diagnosticLines(file, snapshot->diagnostics);
  GearCache cache;
  const StagePtr stage = trainStage(*snapshot, cache);
  if (stage->scene.instances.empty()) {
    std::cerr << "geargraph-cli: There is nothing to show: the turning joints are no spanning tree.\n";
    return kMechanismErrors;
  }
  const auto image = stagePicture(*stage, std::get<PictureOptions>(options));
  if (!image) {
    std::cerr << "geargraph-cli: " << image.error().front().message << '\n';
    return kResourceLimit;
  }
  const std::vector<std::uint8_t> png = pngBytes(*image);
  const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());  // NOLINT
  const int written = writePicture(bytes, *arguments.value("-o"));
  if (written != kFine) return written;
  return hasErrors(snapshot->diagnostics) ? kMechanismErrors : kFine;
}

}  // namespace geargraph::cli
