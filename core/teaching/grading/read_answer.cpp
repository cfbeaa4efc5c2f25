#include "core/teaching/grading/read_answer.h"

#include <algorithm>

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

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + ',') {
    if (std::string_view(" \t\r\n,;{}").find(c) == std::string_view::npos) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  return words;
}

/// Options whose names hold blanks or commas can be named only on their own.
ReadField readSet(const AnswerField& field, const std::string& text) {
  ReadField read;
  const auto isOption = [&](const std::string& word) {
    return std::find(field.options.begin(), field.options.end(), word) != field.options.end();
  };
  const std::vector<std::string> words = isOption(text) ? std::vector{text} : wordsOf(text);
  for (const std::string& option : field.options) {
    if (std::find(words.begin(), words.end(), option) != words.end()) read.elements.push_back(option);
  }
  if (!std::all_of(words.begin(), words.end(), isOption)) read.fault = AnswerFault::notAChoice;
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
    read.text = word;
    if (std::find(field.options.begin(), field.options.end(), word) == field.options.end())
      read.fault = AnswerFault::notAChoice;
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
