#include "core/teaching/grading/read_answer.h"

#include <algorithm>
#include <optional>

#include "core/foundations/base/contract.h"

namespace geargraph::inline grading {
namespace {

constexpr std::string_view kMinusSign = "\u2212";

/// Without blanks at the ends, with the minus sign of ASCII.
std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  std::string word(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
  for (auto at = word.find(kMinusSign); at != std::string::npos; at = word.find(kMinusSign)) {
    word.replace(at, kMinusSign.size(), "-");
  }
  return word;
}

bool isSeparator(char c) {
  return std::string_view(" \t\r\n,;{}").find(c) != std::string_view::npos;
}

/// Which of the options the text names from here on, the longest of them: names may hold blanks and commas.
std::optional<std::size_t> optionAt(const AnswerField& field, std::string_view text) {
  std::optional<std::size_t> found;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < field.options.size(); ++i) {
    const std::string option = trimmed(field.options[i]);
    const bool isNamed = !option.empty() && text.starts_with(option) &&
                         (text.size() == option.size() || isSeparator(text[option.size()]));
    if (!isNamed || option.size() <= longest) continue;
    found = i;
    longest = option.size();
  }
  return found;
}

ReadField readSet(const AnswerField& field, const std::string& text) {
  ReadField read;
  std::vector<char> isIn(field.options.size(), 0);
  for (std::size_t at = 0; at < text.size();) {
    const auto option = optionAt(field, std::string_view(text).substr(at));
    if (option) {
      isIn[*option] = 1;
      at += trimmed(field.options[*option]).size();
    } else if (isSeparator(text[at])) {
      ++at;
    } else {
      read.fault = AnswerFault::notAChoice;
      break;
    }
  }
  for (std::size_t i = 0; i < isIn.size(); ++i) {
    if (isIn[i] != 0) read.elements.push_back(field.options[i]);
  }
  return read;
}

}  // namespace

std::string setText(const std::vector<std::string>& elements) {
  std::string text;
  for (const std::string& element : elements) text += (text.empty() ? "" : ",") + element;
  return text;
}

ReadField readField(const AnswerField& field, const std::string& text) {
  const std::string word = trimmed(text);
  ReadField read;
  if (field.kind == FieldKind::set) {
    read = readSet(field, word);
    read.isEmpty = read.fault == AnswerFault::none && read.elements.empty();
  } else if (word.empty()) {
    read.isEmpty = true;
  } else if (field.kind == FieldKind::choice) {
    const auto option = std::find_if(field.options.begin(), field.options.end(),
                                     [&](const std::string& name) { return trimmed(name) == word; });
    if (option == field.options.end()) {
      read.fault = AnswerFault::notAChoice;
    } else {
      read.text = *option;
    }
  } else {
    read.number = readNumber(word);
    if (field.kind == FieldKind::integer) read.number.slack = 0;
    if (read.number.fault == NumberFault::notANumber) read.fault = AnswerFault::notANumber;
    if (read.number.fault == NumberFault::ambiguous) read.fault = AnswerFault::ambiguousNumber;
  }
  if (read.isEmpty && !field.mayBeEmpty) read.fault = AnswerFault::empty;
  read.kind = field.kind;
  return read;
}

ReadAnswer readAnswer(const Question& question, const std::vector<std::string>& answer) {
  GEARGRAPH_REQUIRE(answer.size() == question.fields.size());
  ReadAnswer read;
  read.reserve(answer.size());
  for (std::size_t i = 0; i < answer.size(); ++i) read.push_back(readField(question.fields[i], answer[i]));
  return read;
}

bool ReadField::readsLike(const std::string& value) const {
  if (fault != AnswerFault::none) return false;
  if (kind == FieldKind::set) return setText(elements) == value;
  if (isEmpty || value.empty()) return isEmpty && value.empty();
  if (kind == FieldKind::choice) return text == value;
  const auto expected = Rational::fromText(value);
  return expected && number.agreesWith(*expected);
}

}  // namespace geargraph::inline grading
