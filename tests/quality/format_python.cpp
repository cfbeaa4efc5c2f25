#include <algorithm>
#include <cctype>

#include "core/foundations/base/contract.h"
#include "tests/quality/format_files.h"

namespace geargraph::test {
namespace {

/// "centerOfMass" as "center_of_mass".
std::string snakeCase(std::string_view name) {
  std::string snake;
  for (const char c : name) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0) snake += '_';
    snake += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return snake;
}

struct PythonType {
  std::string name;
  std::string expression;  ///< of a value that is there
  std::string without;     ///< the value where the member is missing
};

PythonType typeOf(const MemberInfo& info) {
  switch (info.value) {
    case MemberValue::text:
    case MemberValue::shortText:
      return {"str", "str(value)", "\"\""};
    case MemberValue::flag:
      return {"bool", "bool(value)", "False"};
    case MemberValue::teeth:
      return {"int", "int(value)", "0"};
    case MemberValue::number:
      return {"Optional[Fraction]", "exact(value)", "None"};
    case MemberValue::triple:
    case MemberValue::inertia:
      return {"Optional[Tuple[Fraction, ...]]", "exact_triple(value)", "None"};
    case MemberValue::reference:
      if (info.target == ElementKind::link) return {"Optional[Link]", "Link(self._mechanism, value)", "None"};
      if (info.target == ElementKind::axis) return {"Optional[Axis]", "Axis(self._mechanism, value)", "None"};
      return {"Optional[str]", "str(value)", "None"};
    case MemberValue::references:
      return {"Tuple[str, ...]", "tuple(value)", "()"};
    case MemberValue::objects:
      return {"Tuple[Dict[str, Any], ...]", "tuple(value)", "()"};
    default:
      return {"Any", "value", "None"};
  }
}

/// Words in lines of at most 99 characters.
std::string wrapped(const std::string& text, const std::string& indent) {
  constexpr std::size_t kWidth = 99;
  std::string lines;
  std::string line = indent;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    if (line.size() > indent.size() && line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + word;
  }
  return lines + line + "\n";
}

std::string documentation(const MemberInfo& info) {
  std::string text;
  for (const char c : info.meaning) text += c == '`' ? std::string("``") : std::string(1, c);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  const std::string_view unit = unitOf(info.measure);
  if (!unit.empty()) text += " (" + std::string(unit) + ")";
  return "\"\"\"" + text + ".\"\"\"";
}

}  // namespace

std::string pythonProperties(DocumentPart part, const std::string& written) {
  std::string text;
  for (const MemberInfo& info : membersOf(part)) {
    const std::string name = snakeCase(info.name);
    const bool isWritten = written.find("def " + name + "(") != std::string::npos;
    if (isWritten || info.value == MemberValue::id) continue;
    const PythonType type = typeOf(info);
    text += "\n    @property\n    def " + name + "(self) -> " + type.name + ":\n" +
            wrapped(documentation(info), "        ") + "        value = self._data.get(\"" +
            std::string(info.name) + "\")\n        return " + type.without + " if value is None else " +
            type.expression + "\n";
  }
  return text;
}

}  // namespace geargraph::test
