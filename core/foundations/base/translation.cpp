#include "core/foundations/base/translation.h"

#include <atomic>
#include <memory>
#include <mutex>

#include "core/foundations/base/locale.h"

namespace geargraph {
namespace {

std::mutex g_mutex;
std::shared_ptr<const Catalogue> g_catalogue;  ///< guarded by g_mutex; null: English
std::atomic<char> g_decimalSign{'.'};
thread_local int t_inEnglish = 0;  ///< scopes of EnglishScope on this thread

std::shared_ptr<const Catalogue> catalogue() {
  if (t_inEnglish > 0) return nullptr;
  const std::lock_guard lock(g_mutex);
  return g_catalogue;
}

std::string lookedUp(const char* text, int n) {
  const auto now = catalogue();
  std::string found = now ? (*now)(text, n) : std::string();
  return found.empty() ? text : found;
}

}  // namespace

std::string translated(const char* text) {
  return lookedUp(text, -1);
}

std::string translated(std::string_view text) {
  return lookedUp(std::string(text).c_str(), -1);
}

std::string translated(const char* text, int n) {
  std::string form = lookedUp(text, n);
  if (const auto place = form.find("%n"); place != std::string::npos)
    form.replace(place, 2, std::to_string(n));
  return form;
}

std::string translated(const char* text, std::initializer_list<std::string_view> places) {
  return filled(translated(text), places);
}

std::string filled(std::string_view text, std::initializer_list<std::string_view> places) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isPlace = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
    const std::size_t place = isPlace ? static_cast<std::size_t>(text[i + 1] - '1') : places.size();
    if (place < places.size()) {
      result += *(places.begin() + place);
      ++i;
    } else {
      result += text[i];
    }
  }
  return result;
}

void setCatalogue(Catalogue next) {
  auto shared = next ? std::make_shared<const Catalogue>(std::move(next)) : nullptr;
  const std::lock_guard lock(g_mutex);
  g_catalogue.swap(shared);
}

EnglishScope::EnglishScope() {
  ++t_inEnglish;
}

EnglishScope::~EnglishScope() {
  --t_inEnglish;
}

bool isEnglish() {
  return catalogue() == nullptr;
}

std::string localizedNumber(std::string number) {
  if (const auto point = number.find('.'); point != std::string::npos) number[point] = decimalSign();
  return number;
}

std::string spokenTexNumber(std::string number) {
  if (const auto point = number.find('.'); point != std::string::npos && decimalSign() != '.')
    number.replace(point, 1, std::string{'{', decimalSign(), '}'});
  return number;
}

void setDecimalSign(char sign) {
  g_decimalSign = sign;
}

char decimalSign() {
  return t_inEnglish > 0 ? '.' : g_decimalSign.load();
}

}  // namespace geargraph
