#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/typeset/formula_box.h"

using cairo_surface_t = struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier): cairo's name
using cairo_t = struct _cairo;                  // NOLINT(bugprone-reserved-identifier)

namespace geargraph {

class PageFonts;

/// A PDF of several pages, in points from each page's upper left corner. Words and formulas can be selected
/// and searched; the fonts are embedded.
class PdfPages {
 public:
  PdfPages(double width, double height, const std::string& title);
  ~PdfPages();
  PdfPages(const PdfPages&) = delete;
  PdfPages& operator=(const PdfPages&) = delete;

  struct Words {
    double size = 10;
    bool bold = false;
    Color color = {};
  };
  [[nodiscard]] double widthOf(std::string_view utf8, double size, bool bold) const;
  /// Paints words from x on, with the baseline at y.
  void words(std::string_view utf8, double x, double y, const Words& style);
  /// Paints a formula at x with its baseline at y; `size`: of the em.
  void formula(const FormulaBox& box, double x, double y, double size, Color ink, Color label);
  /// Paints a thin horizontal line.
  void rule(double x, double y, double width, Color color);
  /// Paints a drawing without background, as large as fits into the rectangle.
  void drawing(const DisplayList& list, double x, double y, double width, double height);
  /// Tells readers such as a screen reader what is painted until endPart(): a name of a structure element of
  /// PDF, "H1", "P", "TD". Parts may be nested, and end on the page where they begin. @pre nothing covers a
  /// whole page, or cairo forgets what is below it with its parts
  void beginPart(const char* name);
  void endPart(const char* name);
  /// Adds an entry of the outline for this place; level 1 or 2, where 2 is below the last entry of level 1.
  void bookmark(int level, const std::string& title, double y);
  void endPage();

  /// The file; std::nullopt if memory is exhausted. Nothing may be painted afterwards.
  [[nodiscard]] std::optional<std::string> finished();

 private:
  struct SurfaceEnd {
    void operator()(cairo_surface_t* surface) const;
  };
  struct ContextEnd {
    void operator()(cairo_t* context) const;
  };
  std::string m_bytes;  ///< written so far
  std::unique_ptr<PageFonts> m_fonts;
  std::unique_ptr<cairo_surface_t, SurfaceEnd> m_surface;
  std::unique_ptr<cairo_t, ContextEnd> m_context;
  int m_page = 1;
  int m_chapter = 0;  ///< of the outline
};

}  // namespace geargraph
