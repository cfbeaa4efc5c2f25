#include "core/teaching/grading/read_answer.h"

#include <algorithm>
#include <optional>

#include "core/foundations/base/contract.h"

namespace geargraph {
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

/// A word without its case: letters of ASCII and Latin-1, Ğ and Ş, in UTF-8. The i of Turkish, with and
/// without its dot, is one letter.
std::string folded(std::string_view text) {
  std::string word;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const std::string_view letter = text.substr(at, 2);
    if (c >= 'A' && c <= 'Z') {
      word += static_cast<char>(c - 'A' + 'a');
    } else if (letter == "\u0130" || letter == "\u0131") {  // İ ı
      word += 'i';
      ++at;
    } else if (letter >= "\u00c0" && letter <= "\u00de" && letter.size() == 2 && letter != "\u00d7") {
      word += c;
      word += static_cast<char>(static_cast<unsigned char>(text[++at]) + 0x20U);
    } else if (letter == "\u011e" || letter == "\u015e") {  // Ğ Ş
      word += c;
      word += static_cast<char>(static_cast<unsigned char>(text[++at]) + 1U);
    } else {
      word += c;
    }
  }
  return word;
}

/// Which of the options the text begins with, the longest of them: names may hold blanks and commas.
std::optional<std::size_t> optionAt(const std::vector<std::string>& options, std::string_view text) {
  std::optional<std::size_t> found;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string& option = options[i];
    const bool isNamed = !option.empty() && text.starts_with(option) &&
                         (text.size() == option.size() || isSeparator(text[option.size()]));
    if (!isNamed || option.size() <= longest) continue;
    found = i;
    longest = option.size();
  }
  return found;
}

/// The options trimmed, and without their case if they then still differ.
struct OptionTexts {
  std::vector<std::string> exact;
  std::vector<std::string> anyCase;  ///< empty if two options differ in case only

  explicit OptionTexts(const AnswerField& field) {
    for (const std::string& option : field.options) {
      exact.push_back(trimmed(option));
      anyCase.push_back(folded(exact.back()));
    }
    std::vector<std::string> sorted = anyCase;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) anyCase.clear();
  }
};

ReadField readSet(const AnswerField& field, const std::string& word) {
  ReadField read;
  const OptionTexts options(field);
  const bool isCaseKept = options.anyCase.empty();
  const std::vector<std::string>& names = isCaseKept ? options.exact : options.anyCase;
  const std::string text = isCaseKept ? word : folded(word);
  std::vector<char> isIn(field.options.size(), 0);
  for (std::size_t at = 0; at < text.size();) {
    const auto option = optionAt(names, std::string_view(text).substr(at));
    if (option) {
      isIn[*option] = 1;
      at += names[*option].size();
    } else if (isSeparator(text[at])) {
      ++at;
    } else {
      read.fault = AnswerFault::notAChoice;
      read.place = text.substr(at);
      break;
    }
  }
  for (std::size_t i = 0; i < isIn.size(); ++i) {
    if (isIn[i] != 0) read.elements.push_back(field.options[i]);
  }
  return read;
}

void readChoice(ReadField& read, const AnswerField& field, const std::string& word) {
  const OptionTexts options(field);
  auto found = std::find(options.exact.begin(), options.exact.end(), word) - options.exact.begin();
  if (found == std::ssize(options.exact) && !options.anyCase.empty())
    found = std::find(options.anyCase.begin(), options.anyCase.end(), folded(word)) - options.anyCase.begin();
  if (found == std::ssize(options.exact)) {
    read.fault = AnswerFault::notAChoice;
  } else {
    read.text = field.options[static_cast<std::size_t>(found)];
  }
}

AnswerFault answerFault(NumberFault fault) {
  switch (fault) {
    case NumberFault::none:
      return AnswerFault::none;
    case NumberFault::notANumber:
      return AnswerFault::notANumber;
    case NumberFault::ambiguous:
      return AnswerFault::ambiguousNumber;
    case NumberFault::unknownName:
      return AnswerFault::unknownName;
    case NumberFault::otherUnit:
      break;
  }
  return AnswerFault::otherUnit;
}

}  // namespace

std::string setText(const std::vector<std::string>& elements) {
  std::string text;
  for (const std::string& element : elements) text += (text.empty() ? "" : ",") + element;
  return text;
}

ReadField readField(const AnswerField& field, const std::string& text, const NumberNotation& notation) {
  const std::string word = trimmed(text);
  ReadField read;
  if (field.kind == FieldKind::set) {
    read = readSet(field, word);
    read.isEmpty = read.fault == AnswerFault::none && read.elements.empty();
  } else if (word.empty()) {
    read.isEmpty = true;
  } else if (field.kind == FieldKind::choice) {
    readChoice(read, field, word);
  } else {
    read.number = readNumber(word, notation);
    if (field.kind == FieldKind::integer) read.number.slack = 0;
    read.fault = answerFault(read.number.fault);
    read.place = read.number.place;
  }
  if (read.isEmpty && !field.mayBeEmpty) read.fault = AnswerFault::empty;
  read.kind = field.kind;
  return read;
}

ReadAnswer readAnswer(const Question& question, const std::vector<std::string>& answer) {
  GEARGRAPH_REQUIRE(answer.size() == question.fields.size());
  NumberNotation notation{question.comma, {}, question.symbols};
  ReadAnswer read;
  read.reserve(answer.size());
  for (std::size_t i = 0; i < answer.size(); ++i) {
    notation.unit = question.fields[i].unit;
    read.push_back(readField(question.fields[i], answer[i], notation));
  }
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

}  // namespace geargraph
