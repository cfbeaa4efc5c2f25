#include "core/presentation/exporters/mass_options.h"

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/presentation/exporters/number_options.h"

namespace geargraph {

std::variant<Mechanism, UsageError> withMassOptions(Mechanism mechanism, const OptionValues& given) {
  if (const auto word = given.value("--density")) {
    const auto density = typedNumber(*word);
    auto next = density ? withDensity(mechanism, *density) : Expected<Mechanism>(Diagnostic{});
    if (!next) return UsageError{translated("--density is above 0, in kg/m³, not \"%1\".", {*word})};
    mechanism = *std::move(next);
  }
  const auto word = given.value("--gravity");
  if (!word) return mechanism;
  const auto gravity = tripleFrom(*word);
  if (!gravity) return UsageError{translated("--gravity is like 0,0,-9.81, in m/s², not \"%1\".", {*word})};
  auto next = withGravity(std::move(mechanism), gravity);
  if (!next) return UsageError{next.error().front().message};
  return *std::move(next);
}

}  // namespace geargraph
