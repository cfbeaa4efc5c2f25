#include "app/cli/mass_options.h"

#include <algorithm>

#include "core/foundations/base/words.h"
#include "core/mechanism/model/mass_edits.h"

namespace geargraph::cli {

std::variant<Mechanism, UsageError> withMassOptions(Mechanism mechanism, const Arguments& arguments) {
  if (const auto word = arguments.value("--density")) {
    const auto density = Number::fromText(*word);
    auto next = density ? withDensity(mechanism, *density) : Expected<Mechanism>(Diagnostic{});
    if (!next) return UsageError{translated("--density is above 0, in kg/m³, not \"%1\".", {*word})};
    mechanism = *std::move(next);
  }
  const auto word = arguments.value("--gravity");
  if (!word) return mechanism;
  NumberTriple gravity;
  std::string_view rest = *word;
  for (std::size_t i = 0; i < gravity.size(); ++i) {
    const std::size_t comma = i + 1 < gravity.size() ? rest.find(',') : rest.size();
    const auto number =
        comma == std::string_view::npos ? std::nullopt : Number::fromText(rest.substr(0, comma));
    if (!number) return UsageError{translated("--gravity is like 0,0,-9.81, in m/s², not \"%1\".", {*word})};
    gravity.at(i) = *number;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  auto next = withGravity(std::move(mechanism), gravity);
  if (!next) return UsageError{next.error().front().message};
  return *std::move(next);
}

}  // namespace geargraph::cli
