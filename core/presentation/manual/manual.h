#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/derivation/glossary.h"

namespace geargraph::inline manual {

/// What a heading of a page stands over.
struct ManualSection {
  int level = 1;       ///< 1: the page itself
  std::string title;   ///< plain text
  std::string anchor;  ///< within the page: "the-3d-view"; of the page itself, its id
  std::string words;   ///< all that stands below, to be searched
};

/// A page of the manual: an immutable value that the help window and the web pages are made from.
///
/// Its HTML is that of htmlOfMarkdown(), with these conventions of resources/help/README: pictures name what
/// they show ("picture:digraph/robot/link.4", "window:robot"), <strong>File &gt; Open</strong> is a command
/// of the menus, <kbd>Ctrl+K</kbd> a key, links to "page" or "page#anchor" lead to pages, "lesson:id" to
/// lessons.
struct ManualPage {
  std::string id;     ///< "first-steps": the title's slug
  std::string title;  ///< "First steps"
  std::string html;
  std::vector<ManualSection> sections;  ///< the first is the page itself
};

/// All pages in the order in which they are read; the last is the glossary. Made once, from any thread.
[[nodiscard]] const std::vector<ManualPage>& manualPages();
/// Null where there is no page of this id.
[[nodiscard]] const ManualPage* manualPage(std::string_view id);
/// Anchor of the term in the page "glossary": "cycle-basis-matrix".
[[nodiscard]] std::string anchorOf(Term term);

/// A title as the name of a page or anchor: small ASCII letters, digits, and single hyphens for all else.
[[nodiscard]] std::string slugOf(std::string_view title);

}  // namespace geargraph::inline manual
