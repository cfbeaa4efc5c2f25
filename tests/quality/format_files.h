#pragma once

#include <string>

#include "core/mechanism/model/member_info.h"

namespace geargraph::test {

// Files that follow from the description of the document (core/mechanism/model/fields.h).

/// resources/schema/geargraph.schema.json.
[[nodiscard]] std::string documentSchema();

/// The tables of members in resources/schema/README.md, in Markdown.
[[nodiscard]] std::string memberTables();

/// The properties of a class of app/python/geargraph/_elements.py for the members of this kind of object, but
/// for those that the rest of the class, `written`, has by hand.
[[nodiscard]] std::string pythonProperties(DocumentPart part, const std::string& written);

}  // namespace geargraph::test
