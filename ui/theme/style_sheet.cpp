#include "ui/theme/style_sheet.h"

#include "ui/theme/theme_colors.h"

namespace geargraph::inline theme {
namespace {

/// @role@ stands for a colour of the palette.
const char* const kSheet = R"(
QMenuBar { background: @panel@; padding: 1px 4px; }
QMenuBar::item { padding: 4px 10px; border-radius: 4px; }
QMenuBar::item:selected { background: @halo@; color: @ink@; }
QMenu { background: @sheet@; border: 1px solid @hairline@; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: @halo@; color: @ink@; }
QMenu::item:disabled { color: @disabled@; }
QMenu::separator { height: 1px; background: @hairline@; margin: 4px 6px; }

QToolBar { background: @sheet@; border: none; border-bottom: 1px solid @hairline@; padding: 2px 8px;
           spacing: 4px; }
QToolBar::separator { width: 1px; background: @hairline@; margin: 4px 6px; }
QToolBar QToolButton { border: 1px solid transparent; border-radius: 5px; padding: 4px 9px; }
QToolBar QToolButton:hover { background: @panel@; border-color: @hairline@; }
QToolBar QToolButton:checked { background: @chosen@; border-color: @accent@; color: @accent@; }
QToolBar QToolButton:disabled { color: @disabled@; }

QTabBar { background: @panel@; qproperty-drawBase: 0; }
QTabBar::tab { background: transparent; color: @secondary@; padding: 6px 13px; border: none;
               border-top: 2px solid transparent; }
QTabBar::tab:selected { background: @sheet@; color: @ink@; border-top: 2px solid @accent@; }
QTabBar::tab:hover:!selected { color: @ink@; }
QTabWidget::pane { border: none; }
QDockWidget { color: @ink@; }
QDockWidget::title { background: @panel@; padding: 6px 16px; border-bottom: 1px solid @hairline@; }

QStatusBar { background: @panel@; border-top: 1px solid @hairline@; }
QStatusBar::item { border: none; }
QLabel[look="hint"] { color: @secondary@; }
QLabel[look="title"] { font-weight: bold; }
QLabel[look="heading"] { font-size: 17px; font-weight: bold; }
QLabel[look="problem"] { color: @error@; }
QLabel[look="empty"] { color: @secondary@; padding: 24px; }
QFrame[look="card"] { background: @sheet@; border: 1px solid @hairline@; border-radius: 6px; }
QFrame[look="card"] QLabel { border: none; background: transparent; }
QLabel[look="note3d"] { background: @sheet@; color: @warning@; border: 1px solid @hairline@; border-radius: 5px;
                        padding: 5px 10px; }
QLabel[look="toast"] { background: @ink@; color: @sheet@; border-radius: 8px; padding: 10px 18px; }
QFrame[look="rule"] { background: @hairline@; border: none; }
QFrame[look="banner"] { background: @chosen@; border: 1px solid @hairline@; border-radius: 6px; }

QToolButton[look="chip"], QToolButton[look="symbol"] { background: @sheet@; border: 1px solid @hairline@; border-radius: 11px;
                           padding: 2px 9px; min-height: 17px; }
QToolButton[look="symbol"] { padding: 2px 5px; min-width: 18px; }
QToolButton[look="chip"]:hover, QToolButton[look="symbol"]:hover { border-color: @accent@; }
QToolButton[look="chip"]:checked, QToolButton[look="symbol"]:checked { background: @chosen@; border-color: @accent@; color: @accent@; }
QToolButton[look="count"], QToolButton[look="strongCount"] { background: @sheet@; border: 1px solid @hairline@; border-radius: 10px;
                            padding: 1px 12px; font-weight: bold; font-size: @small@px; }
QToolButton[look="count"]:hover { border-color: @accent@; }
QToolButton[look="strongCount"] { background: @chosen@; color: @accent@; border-color: @halo@; }
QToolButton[look="flat"] { border: none; background: transparent; color: @secondary@; padding: 3px 5px;
                           border-radius: 4px; }
QToolButton[look="flat"]:hover { background: @panel@; color: @ink@; }
QToolButton[look="flat"]:checked { color: @accent@; }
QToolButton[look="control"] { background: @sheet@; border: 1px solid @hairline@; border-radius: 4px;
                              color: @ink@; padding: 2px 6px; }
QToolButton[look="control"]:hover { border-color: @accent@; }
QToolButton[look="control"]:checked { color: @accent@; border-color: @accent@; }
QToolButton[look="control"]:disabled { color: @disabled@; }
QWidget#view3dButtons, QWidget#view3dStrip, QLabel#view3dPainter { background: @veil@; border-radius: 5px; }
QLabel#view3dPainter { padding: 2px 6px; }
QToolButton#view3dMore::menu-indicator { image: none; width: 0px; }
QToolButton[look="flat"]::menu-indicator, QToolButton[look="control"]::menu-indicator { image: none; width: 0px; }

QLineEdit, QAbstractSpinBox[look="number"] { background: @sheet@; border: 1px solid @control@; border-radius: 4px;
            padding: 3px 6px; selection-background-color: @accent@; selection-color: @sheet@; }
QLineEdit:focus, QAbstractSpinBox[look="number"]:focus { border-color: @accent@; }
QLineEdit[look="cell"] { padding: 3px 0px; }
QLineEdit[mark="wrong"] { border: 2px solid @error@; }
QLineEdit[mark="right"] { border-color: @fine@; }
QLineEdit:disabled, QAbstractSpinBox[look="number"]:disabled { background: @panel@; color: @disabled@; }
QLineEdit[look="cell"]:disabled { color: @ink@; }
QAbstractSpinBox[look="number"] { padding-right: 16px; }
QAbstractSpinBox[look="number"] QLineEdit { border: none; padding: 0px; }
QAbstractSpinBox[wrong="true"] { border-color: @error@; color: @error@; }
QAbstractSpinBox[look="number"]::up-button { subcontrol-origin: border; subcontrol-position: top right; width: 16px;
            border: none; }
QAbstractSpinBox[look="number"]::down-button { subcontrol-origin: border; subcontrol-position: bottom right; width: 16px;
            border: none; }
QAbstractSpinBox[look="number"]::up-arrow, QAbstractSpinBox[look="number"]::down-arrow { image: none; width: 0px;
            height: 0px; }
QPushButton { background: @sheet@; border: 1px solid @hairline@; border-radius: 4px; padding: 4px 16px; }
QPushButton:hover { border-color: @accent@; }
QPushButton:pressed, QPushButton:default { background: @chosen@; }
QPushButton:disabled { background: @panel@; color: @disabled@; }
QPushButton[look="fix"] { padding: 1px 11px; border-radius: 11px; }
QPushButton[look="fix"]:focus { border-color: @accent@; color: @accent@; }
QComboBox { background: @sheet@; border: 1px solid @control@; border-radius: 4px; padding: 3px 6px; }
QComboBox:focus { border-color: @accent@; }
QComboBox:disabled { background: @panel@; color: @disabled@; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/icons/chevron.svg); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: @sheet@; border: 1px solid @hairline@; selection-background-color: @halo@;
                              selection-color: @ink@; }
QScrollArea, QScrollArea > QWidget > QWidget#page { background: @sheet@; border: none; }
QTableView, QListView { background: @sheet@; border: none; outline: none; }
QWidget#startPage { background: @panel@; }
QWidget#lessonPanel, QWidget#lessonPanel QScrollArea, QWidget#lessonPanel QWidget#page { background: @sheet@; }
QListView[look="cards"] { background: transparent; }
QToolBar#noticeBar { background: @chosen@; }
QHeaderView { background: @sheet@; border: none; }
QTableCornerButton::section { background: @sheet@; border: none; }

QSlider:horizontal { min-height: 16px; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @control@; }
QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: @accent@; }
QSlider::sub-page:horizontal:disabled { background: @control@; }
QSlider::handle:horizontal { width: 12px; margin: -6px 0px; border: 2px solid @accent@; border-radius: 8px;
                             background: @sheet@; }
QSlider::handle:horizontal:hover, QSlider::handle:horizontal:focus { background: @accent@; }
QSlider::handle:horizontal:disabled { border-color: @control@; }

QScrollBar:vertical { background: transparent; width: 10px; margin: 0px; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0px; }
QScrollBar::handle { background: @control@; border-radius: 4px; margin: 1px; }
QScrollBar::handle:vertical { min-height: 24px; }
QScrollBar::handle:horizontal { min-width: 24px; }
QScrollBar::handle:hover { background: @secondary@; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0px; height: 0px; }
QAbstractScrollArea::corner { background: transparent; border: none; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

struct NamedColor {
  const char* name;
  ColorRole role;
};

constexpr NamedColor kNames[] = {
    {"@sheet@", ColorRole::sheet},         {"@ink@", ColorRole::ink},
    {"@secondary@", ColorRole::secondary}, {"@hairline@", ColorRole::hairline},
    {"@control@", ColorRole::control},     {"@panel@", ColorRole::panel},
    {"@accent@", ColorRole::accent},       {"@halo@", ColorRole::halo},
    {"@error@", ColorRole::error},         {"@warning@", ColorRole::warning},
    {"@fine@", ColorRole::fine},
};

}  // namespace

QString styleSheetOf(Theme theme) {
  QString sheet = QString::fromUtf8(kSheet);
  for (const NamedColor& named : kNames) {
    sheet.replace(QLatin1String(named.name), qColor(named.role, theme).name());
  }
  // At high contrast, the secondary colour is hardly darker than the ink.
  const ColorRole disabled = theme == Theme::highContrast ? ColorRole::hairline : ColorRole::secondary;
  sheet.replace(QLatin1String("@disabled@"), qColor(disabled, theme).name());
  sheet.replace(QLatin1String("@small@"), QString::number(smallPixels()));
  // What is chosen stands on the halo, thinned with the sheet so that type on it stays readable.
  const QColor sheetColor = qColor(ColorRole::sheet, theme);
  const QColor halo = qColor(ColorRole::halo, theme);
  const auto thinned = [](int sheetPart, int haloPart) { return (3 * sheetPart + haloPart) / 4; };
  const QColor chosen(thinned(sheetColor.red(), halo.red()), thinned(sheetColor.green(), halo.green()),
                      thinned(sheetColor.blue(), halo.blue()));
  // Over the 3D picture: type stays readable whatever turns behind it.
  sheet.replace(QLatin1String("@veil@"), QStringLiteral("rgba(%1, %2, %3, 72%)")
                                             .arg(sheetColor.red())
                                             .arg(sheetColor.green())
                                             .arg(sheetColor.blue()));
  return sheet.replace(QLatin1String("@chosen@"), chosen.name());
}

}  // namespace geargraph::inline theme
