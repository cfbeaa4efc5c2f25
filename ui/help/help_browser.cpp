#include "ui/help/help_browser.h"

#include <QEvent>
#include <QFontInfo>
#include <QPainter>
#include <QScrollBar>
#include <QTimer>
#include <QUrl>
#include <QtMath>
#include <algorithm>

#include "core/presentation/manual/manual.h"
#include "core/presentation/manual/markdown.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kMargin = 24;
constexpr int kWidestPicture = 760;
constexpr int kFormulaMargin = 2;

QString shown(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

HelpBrowser::HelpBrowser(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("helpText"));
  setFrameShape(QFrame::NoFrame);
  setOpenLinks(false);
  document()->setDocumentMargin(kMargin);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // pages of any length have one width
  connect(this, &QTextBrowser::anchorClicked, this, &HelpBrowser::follow);
  connect(&m_pictures, &HelpPictures::drawn, this, [this](const QString& name) {
    const QUrl url(QStringLiteral("picture:") + name);
    document()->addResource(
        QTextDocument::ImageResource, url,
        m_pictures.drawing(name, themeOf(palette()), HelpPictures::drawingSize(roomForPictures()),
                           devicePixelRatioF()));
    viewport()->update();  // its size is as before
  });
}

void HelpBrowser::showPage(const ManualPage* page, const QString& anchor) {
  m_page = page;
  setPage();
  setAccessibleName(shown(page->title));
  if (anchor.isEmpty()) {
    verticalScrollBar()->setValue(0);
  } else {
    scrollToAnchor(anchor);
  }
}

int HelpBrowser::roomForPictures() const {
  return std::clamp(viewport()->width() - 2 * kMargin - 8, 200, kWidestPicture);
}

/// Sets the page anew at the same place: for other colours, other type, another width.
void HelpBrowser::setPage() {
  if (m_page == nullptr) return;
  m_laidOutFor = roomForPictures();
  const int place = verticalScrollBar()->value();
  document()->clear();  // with the pictures of other colours
  document()->setDefaultStyleSheet(sheet());
  setHtml(html());
  verticalScrollBar()->setValue(place);
}

QString HelpBrowser::sheet() const {
  const Theme theme = themeOf(palette());
  const auto color = [theme](ColorRole role) { return qColor(role, theme).name(); };
  return QStringLiteral(
             "a { color: %1; text-decoration: none; } h1 { font-size: %2px; } h2 { font-size: %3px; "
             "margin-top: %4px; }"
             "h3 { font-size: %5px; } kbd { background-color: %6; font-weight: bold; }"
             "code, pre { font-family: monospace; } pre { background-color: %6; }"
             "th { color: %7; font-weight: normal; text-align: left; } li { margin-bottom: 3px; }")
      .arg(color(ColorRole::accent))
      .arg(scaledPixels(22))
      .arg(scaledPixels(17))
      .arg(scaledPixels(18))
      .arg(scaledPixels(14))
      .arg(color(ColorRole::panel), color(ColorRole::secondary));
}

/// The page as Qt's rich text: formulas and pictures as images, commands of the menus as links, headings as
/// targets of links.
QString HelpBrowser::html() {
  m_formulas.clear();
  std::string html = withElements(m_page->html, "x-equation", [this](auto attributes, auto tex) {
    m_formulas.push_back(plainTextOf(tex));
    const std::string image = "<img src=\"formula:" + std::to_string(m_formulas.size() - 1) +
                              "\" style=\"vertical-align: middle\">";
    const bool isOwnLine = attributeOf(attributes, "type") == "display";
    return isOwnLine ? "<br>" + image + "<br>" : image;
  });
  html = withElements(html, "strong", [](auto, std::string_view inside) {
    std::string text(inside);
    std::replace(text.begin(), text.end(), '\n', ' ');  // where the source breaks its line
    if (inside.find(" &gt; ") == std::string_view::npos) return "<b>" + text + "</b>";
    return "<a href=\"command:" + text + "\"><b>" + text + "</b></a>";
  });
  html = withElements(html, "img", [this](std::string_view attributes, auto) {
    const QString source = shown(attributeOf(attributes, "src"));
    const bool isMissing = source.startsWith(QLatin1String("window:")) &&
                           HelpPictures::ofWindow(source.mid(7), themeOf(palette()), 100, 1).isNull();
    return isMissing ? std::string() : "<img" + std::string(attributes) + ">";
  });
  html = withElements(html, "table", [](auto, std::string_view inside) {
    return "<table cellpadding=\"5\" cellspacing=\"0\">" + std::string(inside) + "</table>";
  });
  for (const std::string tag : {"h1", "h2", "h3"}) {
    html = withElements(html, tag, [&tag](auto attributes, std::string_view inside) {
      return "<" + tag + "><a name=\"" + attributeOf(attributes, "id") + "\"></a>" + std::string(inside) +
             "</" + tag + ">";
    });
  }
  // A formula that is a paragraph needs no further lines.
  return shown(html)
      .replace(QStringLiteral("<p><br>"), QStringLiteral("<p>"))
      .replace(QStringLiteral("<br></p>"), QStringLiteral("</p>"));
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
  const Theme theme = themeOf(palette());
  const QString path = name.path();
  QImage image;
  if (name.scheme() == QLatin1String("formula")) {
    image = formula(path.toInt());
  } else if (name.scheme() == QLatin1String("picture")) {
    image =
        m_pictures.drawing(path, theme, HelpPictures::drawingSize(roomForPictures()), devicePixelRatioF());
  } else if (name.scheme() == QLatin1String("window")) {
    image = HelpPictures::ofWindow(path, theme, roomForPictures(), devicePixelRatioF());
  }
  // The document would ask again at every layout.
  document()->addResource(type, name, image);
  return image;
}

QImage HelpBrowser::formula(int position) {
  const FormulaBox box =
      typesetFormula(formulaOf(m_formulas[static_cast<std::size_t>(position)]), FormulaPlace::ownLine);
  const double em = QFontInfo(font()).pixelSize() + 2;  // its indices have to be read
  const QSize size(qCeil(em * box.width) + 2 * kFormulaMargin,
                   qCeil(em * (box.height + box.depth)) + 2 * kFormulaMargin);
  QImage image(size * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(devicePixelRatioF());
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor ink = qColor(ColorRole::ink, themeOf(palette()));
  m_painter.paint(painter, box, QPointF(kFormulaMargin, kFormulaMargin + em * box.height), em, {ink, ink});
  return image;
}

void HelpBrowser::follow(const QUrl& link) {
  if (link.scheme() == QLatin1String("command")) return emit commandWanted(link.path());
  if (link.scheme() == QLatin1String("lesson")) return emit lessonWanted(link.path());
  emit pageWanted(link.toString());
}

void HelpBrowser::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
    QTimer::singleShot(0, this, &HelpBrowser::setPage);  // after all that the change brings
}

void HelpBrowser::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  // Later: the size may change while a page is laid out.
  if (m_page != nullptr && m_laidOutFor != roomForPictures())
    QTimer::singleShot(0, this, &HelpBrowser::setPage);
}

}  // namespace geargraph

#include "moc_help_browser.cpp"
