#include "core/presentation/diagrams/lever_words.h"

#include <flint/fmpz.h>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// The whole number nearest to a fraction, ties to even, as text.
std::string nearestWhole(const Rational& value) {
  fmpz_t doubled;
  fmpz_t whole;
  fmpz_t rest;
  fmpz_init(doubled);
  fmpz_init(whole);
  fmpz_init(rest);
  const fmpz* const denominator = fmpq_denref(value.flint());
  fmpz_fdiv_qr(whole, rest, fmpq_numref(value.flint()), denominator);
  fmpz_mul_ui(doubled, rest, 2);
  const int side = fmpz_cmp(doubled, denominator);
  if (side > 0 || (side == 0 && fmpz_is_odd(whole) != 0)) fmpz_add_ui(whole, whole, 1);
  char* const digits = fmpz_get_str(nullptr, 10, whole);
  std::string text(digits);
  flint_free(digits);
  fmpz_clear(doubled);
  fmpz_clear(whole);
  fmpz_clear(rest);
  return text;
}

}  // namespace

std::string threeDecimals(const Rational& value) {
  constexpr std::size_t kDecimals = 3;
  constexpr double kMaxPlain = 1e6;
  const double size = value.abs().toDouble();
  if (!value.isZero() && (size < 5e-4 || size >= kMaxPlain)) return readableNumber(size * value.sign());
  std::string digits;
  if (value.isInteger()) {
    digits = value.abs().toString();
  } else {
    digits = nearestWhole(value.abs() * Rational(1000));
    if (digits.size() <= kDecimals) digits.insert(0, kDecimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - kDecimals, ".");
    digits = localizedNumber(digits);
  }
  return (value.sign() < 0 ? "−" : "") + digits;
}

std::string labelsOf(const std::vector<LinkOrdinal>& links) {
  std::string text;
  for (const LinkOrdinal link : links) text += (text.empty() ? "" : ", ") + std::to_string(int{link});
  return text;
}

std::string turnsAsOne(const std::vector<LinkOrdinal>& links, bool isByMeshes) {
  return isByMeshes ? translated("Links %1 turn as one.", {labelsOf(links)})
                    : translated("Links %1 turn as one by these tooth counts only.", {labelsOf(links)});
}

std::string setsOf(const Lever& lever) {
  if (lever.groups.empty()) return {};
  std::vector<std::string> numbers;
  for (const int group : lever.groups) numbers.push_back(std::to_string(group + 1));
  return numbers.size() == 1 ? translated("set %1", {numbers.front()})
                             : translated("sets %1", {listed(numbers, kAllNames)});
}

std::string teethOf(const LeverPlan& plan, const Lever& lever) {
  std::string text;
  for (const int group : lever.groups)
    text += (text.empty() ? "" : ", ") + plan.groups[static_cast<std::size_t>(group)].teethText();
  return text;
}

std::string absenceSentence(const Mechanism& mechanism, const LeverPlan& plan) {
  switch (plan.absence) {
    case LeverAbsence::none:
      return {};
    case LeverAbsence::unsolvable:
      return translated("No lever: the train is not finished. Problems tells what is missing.");
    case LeverAbsence::noMesh:
      return translated("No lever: no mesh joins two links on the ground's axis.");
    case LeverAbsence::locked:
      return translated("No lever: no link on the ground's axis can turn.");
    case LeverAbsence::directions: {
      const GearMesh& mesh = mechanism.gearMeshes[*plan.turningAway];
      const auto label = labelOf(mechanism, mesh.id);
      return translated(
          "No lever: mesh %1 leads to an axis of another direction. Bevel pinions have no place on a lever, "
          "and "
          "their side gears are not joined to another link on the ground's axis.",
          {label ? *label : mesh.id.text()});
    }
    case LeverAbsence::tooLarge:
      return translated("No lever: the train has more links and freedoms than levers are drawn for.");
  }
  return {};
}

}  // namespace geargraph
