#include "app/cli/language.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <unordered_map>

#include "app/cli/catalogues.h"
#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

constexpr std::string_view kOption = "--language";

bool isSpoken(std::string_view code) {
  const auto all = catalogues();
  return code == "en" || std::any_of(all.begin(), all.end(),
                                     [&](const CompiledCatalogue& each) { return each.language == code; });
}

std::string languageOfEnvironment() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): before any thread
    if (value != nullptr && *value != 0) return languageOfLocale(value);
  }
  return "en";
}

bool contains(const std::vector<std::string>& words, std::string_view wanted) {
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), end, wanted) != end;
}

void useCatalogue(const CompiledCatalogue& catalogue) {
  auto texts = std::make_shared<std::unordered_map<std::string_view, std::string_view>>();
  texts->reserve(catalogue.texts.size());
  for (const CompiledText& text : catalogue.texts) texts->emplace(text.source, text.translation);
  setCatalogue([texts](const char* text, int /*n*/) {
    const auto found = texts->find(text);
    return found == texts->end() ? std::string() : std::string(found->second);
  });
  setDecimalSign(',');  // in each of the languages that there are catalogues for
}

}  // namespace

std::string languageOfLocale(std::string_view locale) {
  const std::string_view code = locale.substr(0, locale.find_first_of("_.@-"));
  return isSpoken(code) ? std::string(code) : "en";
}

std::variant<std::optional<std::string>, UsageError> takeLanguage(std::vector<std::string>& words) {
  std::optional<std::string> named;
  const auto end = std::find(words.begin(), words.end(), "--") - words.begin();
  for (std::ptrdiff_t i = 0, last = end; i < last;) {
    std::string& word = words[static_cast<std::size_t>(i)];
    const bool isAlone = word == kOption;
    const std::string start = std::string(kOption) + '=';
    if (!isAlone && !word.starts_with(start)) {
      ++i;
      continue;
    }
    if (isAlone && i + 1 >= last)
      return UsageError{translated("The option %1 needs a value: %1 %2.", {kOption, "en|de|tr|es"})};
    named = isAlone ? words[static_cast<std::size_t>(i) + 1] : word.substr(start.size());
    const std::ptrdiff_t count = isAlone ? 2 : 1;
    words.erase(words.begin() + i, words.begin() + i + count);
    last -= count;
    if (!isSpoken(*named)) return UsageError{translated("%1 is one of %2.", {kOption, "en, de, tr, es"})};
  }
  return named;
}

void speakLanguage(const std::optional<std::string>& named, const std::vector<std::string>& words) {
  const std::string command = words.empty() ? std::string() : words.front();
  const bool asksExercises = command == "exercises" || contains(words, "--exercises");
  const bool isForPeople = contains(words, "--help") || (!contains(words, "--json") && command != "serve");
  if (!isForPeople || (asksExercises && !named && !contains(words, "--help"))) return;
  const std::string code = named ? *named : languageOfEnvironment();
  for (const CompiledCatalogue& catalogue : catalogues())
    if (catalogue.language == code) useCatalogue(catalogue);
}

}  // namespace geargraph::cli
