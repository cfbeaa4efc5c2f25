#include "ui/reading/formula_label.h"

#include <QEvent>
#include <QFontInfo>
#include <QtMath>

#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {
namespace {
constexpr int kFormulaMargin = 3;  // px
}

FormulaLabel::FormulaLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void FormulaLabel::setTex(const std::string& tex) {
  if (tex == m_tex) return;
  m_tex = tex;
  m_box = tex.empty() ? FormulaBox() : typesetFormula(formulaOf(tex), FormulaPlace::ownLine);
  setAccessibleName(QString::fromStdString(tex));
  updateGeometry();
  update();
}

double FormulaLabel::em() const {
  return QFontInfo(font()).pixelSize() + 2;  // larger than body type: its indices have to be read
}

QSize FormulaLabel::sizeHint() const {
  return {qCeil(em() * m_box.width) + 2 * kFormulaMargin,
          qCeil(em() * (m_box.height + m_box.depth)) + 2 * kFormulaMargin};
}

void FormulaLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor ink = palette().color(QPalette::WindowText);
  m_painter.paint(painter, m_box, QPointF(kFormulaMargin, kFormulaMargin + em() * m_box.height), em(),
                  {ink, ink});
}

void FormulaLabel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
}

}  // namespace geargraph

#include "moc_formula_label.cpp"
