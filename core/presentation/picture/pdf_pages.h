#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/typeset/formula_box.h"

using cairo_surface_t = struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier): cairo's name
using cairo_t = struct _cairo;                  // NOLINT(bugprone-reserved-identifier)

namespace geargraph::inline picture {

class PageFonts;

/// A PDF of several pages, in points from each page's upper left corner. Words and formulas stay text that
/// can be selected and searched; the faces are embedded.
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
  /// From x on, with the baseline at y.
  void words(std::string_view utf8, double x, double y, const Words& look);
  /// With the em of `size`.
  void formula(const FormulaBox& box, double x, double y, double size, Color ink, Color label);
  /// A thin line.
  void rule(double x, double y, double width, Color color);
  /// A drawing without a ground, as large as it fits into a rectangle.
  void drawing(const DisplayList& list, double x, double y, double width, double height);
  /// An entry of the outline that leads to this place; level 1 or 2, and a 2 belongs to the 1 before it.
  void bookmark(int level, const std::string& title, double y);
  void endPage();

  /// The file. Nothing where memory did not suffice. No more is painted afterwards.
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

}  // namespace geargraph::inline picture
