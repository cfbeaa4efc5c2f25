#include "core/presentation/manual/manual_site.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/text_lists.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/manual/manual.h"
#include "core/presentation/manual/manual_picture.h"
#include "core/presentation/manual/markdown.h"
#include "core/presentation/report/mathml.h"

namespace geargraph {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #23272e; --soft: #6b7380; --rule: #d9dde3; --ground: #ffffff; --panel: #f5f6f8;
        --accent: #2a68e4; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ee; --soft: #98a1ae; --rule: #3a414b; --ground: #1e2227;
        --panel: #262b31; --accent: #6c9bff; } }
body { margin: 0; color: var(--ink); background: var(--ground);
       font: 16px/1.6 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; }
nav { padding: 1rem 1.5rem; background: var(--panel); }
nav ul { list-style: none; margin: 0; padding: 0; }
nav [aria-current] { font-weight: 600; color: var(--ink); text-decoration: none; }
main { padding: 0.5rem 1.5rem 4rem; max-width: 46rem; }
@media (min-width: 62rem) { body { display: grid; grid-template-columns: 17rem 1fr; min-height: 100vh; }
        main { padding-left: 2.5rem; } }
a { color: var(--accent); }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin-top: 2.2rem; } h3 { font-size: 1.05rem; }
kbd { padding: 0.05em 0.4em; border: 1px solid var(--rule); border-radius: 4px; background: var(--panel);
      font: 0.88em "DejaVu Sans Mono", monospace; }
code, pre { font: 0.9em/1.5 "DejaVu Sans Mono", monospace; }
pre { padding: 0.7rem 0.9rem; background: var(--panel); border-radius: 4px; overflow-x: auto; }
table { border-collapse: collapse; } th, td { text-align: left; vertical-align: top; padding: 0.3rem 1.2rem 0.3rem 0;
      border-bottom: 1px solid var(--rule); } th { color: var(--soft); font-weight: normal; }
img { max-width: 100%; max-height: 26rem; height: auto; } picture { display: block; text-align: center; margin: 1rem 0; }
.formula { display: block; overflow: auto hidden; margin: 0.6rem 0; padding: 0.3rem 0; }
mtd { padding: 0.15em 0.45em; } mtd.r { text-align: right; } mtd.l { text-align: left; }
mtd.c { text-align: center; } mtd.bar { border-left: 1px solid; } mtd.rule { border-top: 1px solid; }
@media print { nav { display: none; } body { display: block; } }
)";

/// Shell-safe, and one file for one picture.
std::string fileNameOf(std::string_view picture) {
  return "pictures/" + slugOf(picture);
}

class SiteWriter {
 public:
  explicit SiteWriter(const std::set<std::string>& windowPictures) : m_windowPictures(windowPictures) {}

  std::vector<ManualFile> all() {
    for (const ManualPage& page : manualPages()) m_files.push_back({page.id + ".html", document(page)});
    m_files.push_back({"index.html", document(manualPages().front())});
    for (const std::string& picture : m_pictures) addPicture(picture);
    return std::move(m_files);
  }

 private:
  std::string document(const ManualPage& page) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self'; "
           "style-src 'unsafe-inline'\">\n<title>" +
           escapedXml(page.title) + " - GearGraph</title>\n<style>" + std::string(kStyle) +
           "</style>\n</head>\n<body>\n" + contents(page) + "<main>\n" + body(page) +
           "</main>\n</body>\n</html>\n";
  }

  static std::string contents(const ManualPage& current) {
    std::string text = "<nav aria-label=\"Contents\">\n<ul>\n";
    for (const ManualPage& page : manualPages()) {
      const std::string here = page.id == current.id ? " aria-current=\"page\"" : "";
      text += "<li><a href=\"" + page.id + ".html\"" + here + ">" + escapedXml(page.title) + "</a></li>\n";
    }
    return text + "</ul>\n</nav>\n";
  }

  std::string body(const ManualPage& page) {
    std::string html = withElements(page.html, "x-equation", [](auto attributes, auto tex) {
      const bool isOwnLine = attributeOf(attributes, "type") == "display";
      const std::string math = "<math" + std::string(isOwnLine ? " display=\"block\"" : "") + ">" +
                               mathMl(unescapedTex(tex)) + "</math>";
      return isOwnLine ? "<span class=\"formula\">" + math + "</span>" : math;
    });
    html = withElements(html, "img", [this](auto attributes, auto) { return image(attributes); });
    return withElements(html, "a", [](auto attributes, auto inside) {
      return "<a href=\"" + target(attributeOf(attributes, "href")) + "\">" + std::string(inside) + "</a>";
    });
  }

  static std::string unescapedTex(std::string_view tex) { return plainTextOf(tex); }

  /// Links of the manual as those of the files; all others as they are.
  static std::string target(const std::string& link) {
    static constexpr std::string_view kLesson = "lesson:";
    if (link.substr(0, kLesson.size()) == kLesson) return "lessons-and-exercises.html#the-course";
    const std::size_t hash = link.find('#');
    if (manualPage(link.substr(0, hash)) == nullptr) return escapedXml(link);
    return link.substr(0, hash) + ".html" + (hash == std::string::npos ? "" : link.substr(hash));
  }

  std::string image(std::string_view attributes) {
    const std::string source = attributeOf(attributes, "src");
    const std::string alt = escapedXml(attributeOf(attributes, "alt"));
    const std::string name = source.substr(source.find(':') + 1);
    std::string file = fileNameOf(name);
    std::string ending = ".svg";
    if (source.rfind("window:", 0) == 0) {
      if (!m_windowPictures.contains(name)) return {};
      file = "pictures/window-" + name;
      ending = ".png";
    } else {
      m_pictures.insert(name);
    }
    return "<picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"" + file + "-dark" + ending +
           "\"><img src=\"" + file + "-light" + ending + "\" alt=\"" + alt + "\"></picture>";
  }

  void addPicture(const std::string& name) {
    const auto drawing = manualPicture(name);
    GEARGRAPH_REQUIRE(drawing.has_value());  // a test walks all pages
    for (const Theme theme : {Theme::light, Theme::dark}) {
      SheetStyle style;
      style.theme = theme;
      style.transparent = true;
      m_files.push_back(
          {fileNameOf(name) + (theme == Theme::light ? "-light.svg" : "-dark.svg"), svgOf(*drawing, style)});
    }
  }

  const std::set<std::string>& m_windowPictures;
  std::set<std::string> m_pictures;
  std::vector<ManualFile> m_files;
};

}  // namespace

std::vector<ManualFile> manualSite(const std::set<std::string>& windowPictures) {
  return SiteWriter(windowPictures).all();
}

}  // namespace geargraph
