#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/derivation/glossary.h"

namespace geargraph {

/// A section of a page.
struct ManualSection {
  int level = 1;       ///< 1: the page itself
  std::string title;   ///< plain text
  std::string anchor;  ///< within the page: "the-3d-view"; for the page itself its id
  std::string words;   ///< the whole text below the heading, for search
};

/// A page of the manual: an immutable value from which the help window and the web pages are made.
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

/// All pages in reading order; the last is the glossary. Made on first use; thread-safe.
[[nodiscard]] const std::vector<ManualPage>& manualPages();
/// Null if there is no page with this id.
[[nodiscard]] const ManualPage* manualPage(std::string_view id);
/// The anchor of the term in the page "glossary": "cycle-basis-matrix".
[[nodiscard]] std::string anchorOf(Term term);

/// A title as a page id or anchor: lower-case ASCII letters, digits, and single hyphens for everything else.
[[nodiscard]] std::string slugOf(std::string_view title);

}  // namespace geargraph
