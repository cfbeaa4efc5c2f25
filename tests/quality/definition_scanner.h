#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace geargraph::test {

/// A definition with external linkage at namespace scope: a class, struct, union or enumeration, an inline or
/// constexpr function (with its parameter types), a function template, or an inline variable.
struct Definition {
  std::string name;  ///< qualified: "geargraph::Link", "geargraph::at(int)"
  int line = 0;      ///< 1-based
};

/// The definitions in C++ source text, in its order. Unnamed namespaces, bodies of functions and members of
/// classes are left out, as are declarations. It reads tokens, not C++: macros are not expanded, and both
/// branches of an #if count.
[[nodiscard]] std::vector<Definition> definitionsIn(std::string_view source);

/// "name: file:line, file:line" for every name that is defined more than once, in the order of the names.
[[nodiscard]] std::vector<std::string> repeatedDefinitions(const std::map<std::string, std::string>& sources);

}  // namespace geargraph::test
