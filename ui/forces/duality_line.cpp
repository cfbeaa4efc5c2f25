#include "ui/forces/duality_line.h"

#include <QBuffer>
#include <QEvent>
#include <QFontInfo>
#include <QImage>
#include <QPainter>
#include <QTextDocument>
#include <QtMath>
#include <algorithm>
#include <utility>

#include "core/teaching/force_tables/dual_equations.h"
#include "ui/models/minus_sign.h"
#include "ui/panels/rate_label.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxMatrixColumns = 8;
constexpr std::size_t kMaxMatrixRows = 2;  ///< beside the equations there is room for no more
constexpr QChar kFrameBegins(0xE000);      ///< private use: no text has it
constexpr QChar kFrameEnds(0xE001);

QString signText(int factor) {
  return factor < 0 ? QStringLiteral("\u2212") : QString();
}

/// The symbol of a rate as a picture that stands on the base line of rich text: few text fonts place a
/// combining dot on a θ, most put it far above.
QString rateSymbol(const QFont& labelFont, const QColor& ink, double pixelRatio) {
  QFont font = labelFont;
  font.setPixelSize(QFontInfo(labelFont).pixelSize());
  const QSize size(qCeil(paintRate(nullptr, font, {}, {})), qCeil(QFontMetricsF(font).ascent()));
  QImage image(size * pixelRatio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(pixelRatio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setPen(ink);
  paintRate(&painter, font, QPointF(0, size.height()), {});
  painter.end();
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return QStringLiteral("<img src='data:image/png;base64,%1' width=%2 height=%3>")
      .arg(QString::fromLatin1(png.toBase64()))
      .arg(size.width())
      .arg(size.height());
}

/// Rich text of a pair of equations, in the colours of a theme.
class DualityText {
 public:
  /// `rate`: the symbol of a rate
  DualityText(const Mechanism& mechanism, const DualEquations& equations, Theme theme, QString rate)
      : m_mechanism(mechanism), m_equations(equations), m_theme(theme), m_rate(std::move(rate)) {}

  [[nodiscard]] QString html() const {
    return QStringLiteral(
               "<table cellspacing=0 cellpadding=0><tr><td valign=top>%1</td><td width=20></td><td>%2"
               "</td><td width=20></td><td valign=top>%3</td></tr></table>")
        .arg(rowSide(), matrix(), columnSide());
  }

 private:
  [[nodiscard]] QString color(ColorRole role) const { return qColor(role, m_theme).name(); }
  [[nodiscard]] QString jointLabel(int joint) const { return QString::number(m_mechanism.jointLabel(joint)); }
  [[nodiscard]] QString meshLabel(int mesh) const { return QString::number(m_mechanism.meshLabel(mesh)); }
  [[nodiscard]] QString quiet(const QString& text) const {
    return QStringLiteral("<span style='color:%1'>%2</span>").arg(color(ColorRole::secondary), text);
  }
  /// The frame of the entry that row and column have in common.
  [[nodiscard]] QString frame() const {
    return QStringLiteral(" style='border:2px solid %1; background:%2; padding:0px 4px; font-weight:bold'")
        .arg(color(ColorRole::accent), color(ColorRole::halo));
  }
  /// A link, to be clicked.
  [[nodiscard]] QString entry(const QString& text) const {
    return QStringLiteral("<a href='entry' style='color:%1; text-decoration:none'>%2</a>")
        .arg(color(ColorRole::ink), text);
  }
  [[nodiscard]] QString framed(const QString& text) const { return kFrameBegins + entry(text) + kFrameEnds; }
  /// A line whose framed parts are cells of their own, as only these can have a border.
  [[nodiscard]] QString line(QString html) const {
    html.replace(kFrameBegins, QStringLiteral("</td><td%1>").arg(frame()));
    html.replace(kFrameEnds, QStringLiteral("</td><td>&nbsp;"));
    return QStringLiteral("<table cellspacing=0 cellpadding=1><tr><td>%1</td></tr></table>").arg(html);
  }
  [[nodiscard]] int cell(int mesh, int joint) const {
    const auto row =
        std::find(m_equations.meshes.begin(), m_equations.meshes.end(), mesh) - m_equations.meshes.begin();
    const auto column =
        std::find(m_equations.joints.begin(), m_equations.joints.end(), joint) - m_equations.joints.begin();
    return m_equations.cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  }
  /// "60 x" or " − 60 x".
  [[nodiscard]] QString term(bool isFirst, int mesh, int joint, const QString& symbol) const {
    const int factor = cell(mesh, joint);
    const QString size = QString::number(std::abs(factor));
    if (mesh == m_equations.mesh && joint == m_equations.joint)
      return (isFirst ? QString() : QStringLiteral(" + ")) + framed(signText(factor) + size) + symbol;
    const QString sign = isFirst      ? signText(factor)
                         : factor < 0 ? QStringLiteral(" \u2212 ")
                                      : QStringLiteral(" + ");
    return sign + size + QLatin1Char(' ') + symbol;
  }

  [[nodiscard]] QString rowSide() const {
    QString sum;
    for (const int joint : m_equations.joints)
      if (cell(m_equations.mesh, joint) != 0)
        sum += term(sum.isEmpty(), m_equations.mesh, joint,
                    m_rate + QStringLiteral("<sub>%1</sub>").arg(jointLabel(joint)));
    const QString title = DualityLine::tr("Row %1: speeds of mesh %1").arg(meshLabel(m_equations.mesh));
    return quiet(title + QStringLiteral(" (17)")) + line(sum + QStringLiteral(" = 0")) +
           quiet(withMinusSign(m_equations.speeds));
  }

  [[nodiscard]] QString columnSide() const {
    QString sum;
    for (const int mesh : m_equations.meshes)
      if (cell(mesh, m_equations.joint) != 0)
        sum += term(sum.isEmpty(), mesh, m_equations.joint,
                    QStringLiteral("\u03BC<sub>%1</sub>").arg(meshLabel(mesh)));
    if (sum.isEmpty()) sum = QStringLiteral("0");
    const QString title = DualityLine::tr("Column %1: torque in joint %1").arg(jointLabel(m_equations.joint));
    const QString number = m_equations.torque.empty()
                               ? DualityLine::tr("shared in unknown parts, or not held")
                               : DualityLine::tr("here %1 N m").arg(withMinusSign(m_equations.torque));
    return quiet(title + QStringLiteral(" (17*)")) +
           line(QStringLiteral("\u03C4<sub>%1</sub> + \u2113<sub>%1</sub> = %2")
                    .arg(jointLabel(m_equations.joint), sum)) +
           quiet(number);
  }

  /// The mesh's row and another of the column, of wide rows the columns about the joint.
  [[nodiscard]] QString matrix() const {
    std::vector<int> meshes{m_equations.mesh};
    for (const int mesh : m_equations.meshes)
      if (mesh != m_equations.mesh && meshes.size() < kMaxMatrixRows) meshes.push_back(mesh);
    std::sort(meshes.begin(), meshes.end());
    std::vector<int> joints = m_equations.joints;
    while (joints.size() > kMaxMatrixColumns)
      joints.erase(joints.front() == m_equations.joint ? joints.end() - 1 : joints.begin());
    const QString tint = QStringLiteral(" bgcolor='%1'").arg(color(ColorRole::panel));
    QString rows = QStringLiteral("<tr><td></td>");
    for (const int joint : joints)
      rows += QStringLiteral("<td align=right%1>%2</td>")
                  .arg(joint == m_equations.joint ? tint : QString(),
                       joint == m_equations.joint ? QStringLiteral("<b>%1</b>").arg(jointLabel(joint))
                                                  : quiet(jointLabel(joint)));
    rows += QStringLiteral("</tr>");
    for (const int mesh : meshes) {
      const QString name = QLatin1Char('P') + meshLabel(mesh);
      rows += QStringLiteral("<tr><td>%1</td>")
                  .arg(mesh == m_equations.mesh ? QStringLiteral("<b>%1</b>").arg(name) : quiet(name));
      for (const int joint : joints) {
        const int factor = cell(mesh, joint);
        const QString text =
            factor == 0 ? QStringLiteral("\u00B7") : signText(factor) + QString::number(std::abs(factor));
        const bool isHighlighted = mesh == m_equations.mesh || joint == m_equations.joint;
        const bool isCommon = mesh == m_equations.mesh && joint == m_equations.joint;
        rows += QStringLiteral("<td align=right%1>%2</td>")
                    .arg(isCommon        ? frame()
                         : isHighlighted ? tint
                                         : QString(),
                         isCommon ? entry(text) : text);
      }
      rows += QStringLiteral("</tr>");
    }
    return QStringLiteral("<table cellspacing=0 cellpadding=2>%1</table>").arg(rows);
  }

  const Mechanism& m_mechanism;
  const DualEquations& m_equations;
  Theme m_theme;
  QString m_rate;
};

template <class Elements>
std::optional<int> firstSelected(const Elements& elements, const std::set<ElementId>& selected) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (selected.contains(ElementId(elements[i].id))) return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace

DualityLine::DualityLine(Selection* selection, QWidget* parent) : QLabel(parent), m_selection(selection) {
  setObjectName(QStringLiteral("twinLine"));
  setTextFormat(Qt::RichText);
  setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  setAccessibleName(tr("The entry that speeds and torques share"));
  setContentsMargins(12, 2, 12, 2);
  setToolTip(tr(
      "A row of P holds the speeds of a mesh, a column the torque in a joint: the framed entry is in both. "
      "Entries count teeth; μ is the force of a mesh for each tooth, ℓ what loads on links add. "
      "Select a joint or a mesh to see its own; click the framed entry to see it in Matrices."));
  constexpr int kQuarters = 15;  // of a line: three lines with dots above their letters
  setMinimumHeight(kQuarters * fontMetrics().lineSpacing() / 4);
  connect(selection, &Selection::selectionChanged, this, &DualityLine::renew);
  connect(selection, &Selection::hoverChanged, this, [this] {
    if (isVisible()) renew();
  });
  connect(this, &QLabel::linkActivated, this, [this] {
    tell(m_mesh, m_joint);
    emit entryWanted();
  });
}

void DualityLine::pointAt(const ElementId& row, const ElementId& column) {
  m_cell = {row, column};
  std::erase_if(m_cell, [](const ElementId& each) {
    return each.kind != ElementKind::gearMesh && each.kind != ElementKind::turningJoint;
  });
  if (m_cell.size() < 2) m_cell.clear();
  renew();
}

/// A cell, or one element: a cycle or a cutset that is highlighted would choose by chance.
std::set<ElementId> DualityLine::pointedAt() const {
  if (!m_cell.empty()) return m_cell;
  return m_selection->hovered().size() == 1 ? m_selection->hovered() : std::set<ElementId>();
}

void DualityLine::show(const ForcesPtr& forces) {
  m_forces = forces;
  renew();
}

void DualityLine::changeEvent(QEvent* event) {
  const bool isOtherFont = event->type() == QEvent::FontChange;
  if (isOtherFont) m_textSize = {};
  QLabel::changeEvent(event);
  if (!isOtherFont && event->type() != QEvent::PaletteChange) return;
  m_styleTurn.request();
}

QSize DualityLine::sizeHint() const {
  if (m_textSize.isEmpty()) {
    QTextDocument document;
    document.setDefaultFont(font());
    document.setDocumentMargin(0);
    document.setHtml(text());
    m_textSize = {qCeil(document.size().width()), qCeil(document.size().height())};
  }
  return m_textSize.grownBy(contentsMargins()).expandedTo(minimumSize());
}

void DualityLine::updateText(const QString& html) {
  if (html == text()) return;
  m_textSize = {};  // before the label asks for it
  setText(html);
}

void DualityLine::renew() {
  std::optional<DualEquations> equations;
  m_mesh = m_joint = {};
  bool isChosen = false;
  if (m_forces && m_forces->report && m_forces->report->isSolved) {
    const Mechanism& mechanism = *m_forces->solved->mechanism;
    const std::set<ElementId>& selected = m_selection->selected();
    const std::set<ElementId> pointed = pointedAt();
    auto joint = firstSelected(mechanism.turningJoints, pointed);
    auto mesh = firstSelected(mechanism.gearMeshes, pointed);
    if (!joint) joint = firstSelected(mechanism.turningJoints, selected);
    if (!mesh) mesh = firstSelected(mechanism.gearMeshes, selected);
    isChosen = joint || mesh;
    equations = dualEquations(mechanism, *m_forces->solved->kinematics->model,
                              m_forces->solved->kinematics->placement(), *m_forces->report, joint, mesh);
    if (equations) {
      const Theme theme = themeOf(palette());
      const QString rate = rateSymbol(font(), qColor(ColorRole::ink, theme), devicePixelRatioF());
      updateText(DualityText(mechanism, *equations, theme, rate).html());
      m_mesh = mechanism.gearMeshes[static_cast<std::size_t>(equations->mesh)].id;
      m_joint = mechanism.turningJoints[static_cast<std::size_t>(equations->joint)].id;
    }
  }
  if (!equations) updateText({});
  emit filled(equations.has_value());
  isChosen ? tell(m_mesh, m_joint) : tell({}, {});
}

void DualityLine::tell(const ElementId& mesh, const ElementId& joint) {
  std::set<ElementId> entry{mesh, joint};
  if (entry == m_entry) return;
  m_entry = std::move(entry);
  emit entryChanged(mesh, joint);
}

}  // namespace geargraph

#include "moc_duality_line.cpp"
