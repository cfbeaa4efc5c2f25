#include "core/presentation/manual/manual.h"

#include <algorithm>
#include <cctype>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/text_lists.h"
#include "core/presentation/manual/bundled_pages.h"
#include "core/presentation/manual/glossary_page.h"
#include "core/presentation/manual/markdown.h"

namespace geargraph {
namespace {

constexpr int kDeepestHeading = 3;

/// Gives every heading its anchor and notes the sections.
std::string withAnchors(std::string html, std::vector<ManualSection>& sections) {
  for (int level = 1; level <= kDeepestHeading; ++level) {
    const std::string tag = "h" + std::to_string(level);
    html = withElements(html, tag, [&tag](auto, std::string_view inside) {
      const std::string anchor = slugOf(plainTextOf(inside));
      return "<" + tag + " id=\"" + anchor + "\">" + std::string(inside) + "</" + tag + ">";
    });
  }
  for (std::size_t at = html.find("<h"); at != std::string::npos;) {
    const std::size_t next = html.find("<h", at + 1);
    const std::string_view part = std::string_view(html).substr(at, next - at);
    const char digit = part.size() > 2 ? part[2] : ' ';
    if (digit >= '1' && digit <= '0' + kDeepestHeading) {
      const std::size_t end = part.find("</h");
      const std::size_t inside = part.find('>') + 1;
      ManualSection section;
      section.level = digit - '0';
      section.title = plainTextOf(part.substr(inside, end - inside));
      section.anchor = attributeOf(part.substr(0, inside), "id");
      section.words = plainTextOf(part.substr(end));
      sections.push_back(std::move(section));
    }
    at = next;
  }
  return html;
}

ManualPage pageOf(std::string_view markdown) {
  ManualPage page;
  page.html = withAnchors(htmlOfMarkdown(markdown), page.sections);
  GEARGRAPH_REQUIRE(!page.sections.empty() && page.sections.front().level == 1);
  page.title = page.sections.front().title;
  page.id = page.sections.front().anchor;
  return page;
}

/// In a page's Markdown: the course as a list.
std::string withCourse(std::string markdown) {
  static constexpr std::string_view kPlace = "<!-- course -->";
  const std::size_t at = markdown.find(kPlace);
  return at == std::string::npos ? markdown : markdown.replace(at, kPlace.size(), courseMarkdown());
}

}  // namespace

const std::vector<ManualPage>& manualPages() {
  static const std::vector<ManualPage> pages = [] {
    std::vector<ManualPage> all;
    for (const auto& file : pageFiles()) {
      const std::string text(file.begin(), file.end());
      all.push_back(pageOf(withCourse(text)));
    }
    all.push_back(pageOf(glossaryMarkdown()));
    return all;
  }();
  return pages;
}

const ManualPage* manualPage(std::string_view id) {
  const auto& pages = manualPages();
  const auto found =
      std::find_if(pages.begin(), pages.end(), [id](const auto& page) { return page.id == id; });
  return found == pages.end() ? nullptr : &*found;
}

std::string anchorOf(Term term) {
  return slugOf(definitionOf(term).name);
}

std::string slugOf(std::string_view title) {
  std::string slug;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isKept = byte < 128 && std::isalnum(byte) != 0;
    if (isKept) slug += static_cast<char>(std::tolower(byte));
    if (!isKept && !slug.empty() && slug.back() != '-') slug += '-';
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug;
}

}  // namespace geargraph
