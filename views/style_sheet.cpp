// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/style_sheet.h"

#include "views/icons.h"

#include <utility>

namespace cradle {

namespace {

const QString frames = QStringLiteral(R"(
QMainWindow { background: @window; }
QMainWindow::separator { background: @window; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: @accent; }
QDockWidget { color: @mutedText; titlebar-close-icon: url(:/icons/close.svg);
    titlebar-normal-icon: url(:/icons/float.svg); }
QDockWidget::title { background: @panel; padding: 6px 12px; text-align: left; }
QDockWidget::close-button, QDockWidget::float-button {
    border: 1px solid transparent; border-radius: 4px; background: transparent; padding: 1px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: @hover; }
QSplitter::handle { background: @panel; }
QSplitter::handle:vertical { height: 5px; border-bottom: 1px solid @border; }
QSplitter::handle:horizontal { width: 5px; border-right: 1px solid @border; }
QSplitter::handle:hover { background: @accentSoft; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QStatusBar { background: @window; color: @mutedText; }
QToolTip { background: @text; color: @panel; border: 1px solid @text; padding: 4px 6px; }
QFrame[kind="card"] { border: 1px solid @border; border-radius: 6px; background: @window; }
QFrame[kind="warningCard"] {
    border: 1px solid @warningBorder; border-radius: 6px; background: @warningSoft; }
QLabel[kind="heading"], QLabel[kind="muted"] { color: @mutedText; }
QLabel[kind="warning"] { color: @warning; }
QLabel[kind="warningTitle"] { color: @warning; font-weight: 600; }
QLabel[kind="cardTitle"] { font-weight: 600; }
QLabel[kind="successTitle"] { color: @success; font-weight: 600; }
QLabel[kind="success"] { color: @success; }
QProgressBar { border: none; border-radius: 2px; background: @border; max-height: 4px; }
QProgressBar::chunk { border-radius: 2px; background: @accent; }
)");

const QString menus = QStringLiteral(R"(
QMenuBar { background: @window; border-bottom: 1px solid @border; padding: 0 4px; }
QMenuBar::item { padding: 5px 10px; background: transparent; border-radius: 4px; }
QMenuBar::item:selected { background: @accentSoft; }
QMenu { background: @panel; border: 1px solid @controlBorder; padding: 4px; }
QMenu::item { padding: 6px 24px 6px 8px; border-radius: 4px; }
QMenu::item:selected { background: @accentSoft; color: @text; }
QMenu::item:disabled { color: @disabled; }
QMenu::icon { padding-left: 8px; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
QToolBar { background: @panel; border: none; border-bottom: 1px solid @border; spacing: 8px; }
)");

// A focus ring is a border of 2 px; the padding gives way so that nothing moves. The frame that the
// style would draw around the text besides is left out.
const QString buttons = QStringLiteral(R"(
QPushButton, QToolButton, QTabBar, QRadioButton[kind="answer"], QCheckBox[kind="answer"] {
    outline: none; }
QPushButton, QToolButton {
    min-height: 30px; padding: 0 11px; border: 1px solid @controlBorder; border-radius: 6px;
    background: @panel; color: @text; }
QToolButton { padding: 0 7px; }
QToolButton[autoRaise="true"] { border-color: transparent; background: transparent; }
QPushButton:hover, QToolButton:hover { background: @hover; }
QPushButton:pressed, QToolButton:pressed, QPushButton:checked, QToolButton:checked {
    background: @accentSoft; color: @accent; }
QPushButton:checked, QToolButton:checked { border-color: @accent; }
QToolButton[kind="tiny"]:checked { border-color: transparent; }
QPushButton:disabled, QToolButton:disabled { color: @disabled; border-color: @border; }
QToolButton[autoRaise="true"]:disabled { border-color: transparent; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accent; min-height: 28px; }
QPushButton:focus { padding: 0 10px; }
QToolButton:focus { padding: 0 6px; }
QPushButton[kind="primary"] {
    background: @accent; border-color: @accent; color: @onAccent; font-weight: 600; }
QPushButton[kind="success"] {
    background: @success; border-color: @success; color: @onAccent; font-weight: 600; }
QPushButton[kind="primary"]:hover, QPushButton[kind="primary"]:pressed { background: @accentHover; }
QPushButton[kind="success"]:hover, QPushButton[kind="success"]:pressed { background: @successHover; }
QPushButton[kind="primary"]:focus, QPushButton[kind="success"]:focus { border-color: @text; }
QPushButton[kind="primary"]:disabled, QPushButton[kind="success"]:disabled {
    background: @border; border-color: @border; color: @mutedText; }
QPushButton[kind="link"] {
    min-height: 22px; padding: 0 3px; border: 1px solid transparent; border-radius: 4px;
    background: transparent; color: @accent; text-align: left; }
QPushButton[kind="link"]:hover { text-decoration: underline; }
QPushButton[kind="link"]:focus { border: 2px solid @accent; padding: 0 2px; min-height: 20px; }
QPushButton[kind="link"]:disabled { color: @mutedText; }
QPushButton[kind="small"] { min-height: 24px; padding: 0 8px; }
QPushButton[kind="small"]:focus { min-height: 22px; padding: 0 7px; }
QToolButton[kind="tiny"] { min-height: 18px; padding: 0; }
QToolButton[kind="tiny"]:focus { min-height: 16px; padding: 0; }
QPushButton[kind="segment"] { border-radius: 0; }
QPushButton[kind="menu"] { min-height: 24px; padding: 0 @menuSide 0 8px; }
QPushButton[kind="menu"]:focus { min-height: 22px; padding: 0 @menuFocus 0 7px; }
QPushButton::menu-indicator { image: url(:/icons/chevron-down.svg); width: @chevron; height: @chevron;
    subcontrol-origin: border; subcontrol-position: right center; right: 5px; }
)");

const QString fields = QStringLiteral(R"(
QLineEdit, QComboBox, QAbstractSpinBox {
    min-height: 24px; padding: 0 6px; border: 1px solid @controlBorder; border-radius: 6px;
    background: @panel; selection-background-color: @accent; selection-color: @onAccent; }
QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus {
    border: 2px solid @accent; padding: 0 5px; min-height: 22px; }
QLineEdit:disabled, QComboBox:disabled, QLineEdit:read-only {
    background: @window; color: @mutedText; border-color: @border; }
QLineEdit[refused="true"] { border: 2px solid @warning; background: @warningSoft; padding: 0 5px;
    min-height: 22px; }
QPlainTextEdit[kind="field"] { border: 1px solid @controlBorder; border-radius: 6px;
    background: @panel; padding: 1px; }
QPlainTextEdit[kind="field"]:focus { border: 2px solid @accent; padding: 0; }
QPlainTextEdit:read-only { background: @window; border-color: @border; }
QLineEdit[cell="true"], QComboBox[cell="true"] { min-height: 0; border: 2px solid @accent;
    border-radius: 4px; padding: 0 3px; }
QLineEdit[cell="true"][refused="true"] { border-color: @warning; padding: 0 3px; min-height: 0; }
QComboBox::drop-down { border: none; width: @dropDown; }
QComboBox::down-arrow { image: url(:/icons/chevron-down.svg); width: @chevron; height: @chevron; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { border: none; width: @spinButton; }
QAbstractSpinBox::up-arrow { image: url(:/icons/chevron-up.svg); width: @littleChevron; height: @littleChevron; }
QAbstractSpinBox::down-arrow { image: url(:/icons/chevron-down.svg); width: @littleChevron; height: @littleChevron; }
QComboBox QAbstractItemView, QComboBox QAbstractItemView:focus {
    background: @panel; border: 1px solid @controlBorder; padding: 2px;
    selection-background-color: @accentSoft; selection-color: @text; outline: none; }
QRadioButton::indicator { width: @plain; height: @plain; border: 1px solid @mutedText;
    border-radius: @round; background: @panel; }
QRadioButton::indicator:hover { background: @accentSoft; }
QRadioButton::indicator:checked { width: @dot; height: @dot; border: @rim solid @accent; }
QRadioButton::indicator:focus { width: @ringed; height: @ringed; border: 2px solid @accent;
    background: @accentSoft; }
QRadioButton::indicator:checked:focus { width: @small; height: @small; border: @thick solid @accent; }
QCheckBox::indicator { width: @plain; height: @plain; border: 1px solid @mutedText;
    border-radius: 3px; background: @panel; }
QCheckBox::indicator:hover { background: @accentSoft; }
QCheckBox::indicator:checked { border-color: @accent; background: @accent;
    image: url(:/icons/tick-@tick.svg); }
QCheckBox::indicator:disabled { border-color: @border; }
QCheckBox::indicator:checked:disabled { background: @disabled; border-color: @disabled; }
QCheckBox::indicator:focus { width: @ringed; height: @ringed; border: 2px solid @accent; }
QSlider { min-height: 22px; }
QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @controlBorder; }
QSlider::handle:horizontal { width: 12px; margin: -6px 0; border-radius: 8px;
    border: 2px solid @square; background: @panel; }
QSlider::handle:horizontal:hover { background: @accentSoft; }
QSlider::handle:horizontal:focus { border-color: @accent; background: @accent; }
)");

const QString lists = QStringLiteral(R"(
QTabWidget::pane { border: none; border-top: 1px solid @border; background: @panel; }
QTabBar { background: @window; }
QTabBar QToolButton { min-height: 0; padding: 0; border: none; border-radius: 0;
    background: @window; }
QTabBar::tab { background: transparent; color: @mutedText; padding: 8px @tabAside 7px @tabAside;
    border: none; border-top: 2px solid transparent; }
QTabBar[kind="narrow"]::tab { padding: 8px @tabNear 7px @tabNear; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected { background: @panel; color: @text; border-top-color: @square; }
QTabBar::tab:focus { color: @accent; border: 2px solid @accent; }
QTableView, QTreeView, QListView { border: none; background: @panel; gridline-color: @border;
    selection-background-color: @accentSoft; selection-color: @text; }
QListView[kind="rows"], QListView[kind="rows"]:focus {
    outline: none; border: none; border-left: 2px solid transparent; }
QListView[kind="rows"]:focus { border-left-color: @accent; }
QListView[kind="rows"]::item { padding: 5px 6px 5px 8px; border: none; }
QListView[kind="rows"]::item:hover { background: @hover; }
QListView[kind="rows"]::item:selected { background: @accentSoft; color: @text; }
QTableView:focus, QTreeView:focus, QListView:focus { border: none; }
QTableView[kind="matrix"] QHeaderView::section { padding: 2px 8px; }
QHeaderView { background: @panel; border: none; }
QHeaderView::section { background: @panel; color: @mutedText; border: none;
    border-bottom: 1px solid @border; padding: 2px 6px; }
QScrollArea { border: none; background: transparent; }
QAbstractScrollArea::corner { background: transparent; }
QScrollBar:vertical { width: 10px; background: transparent; margin: 0; }
QScrollBar:horizontal { height: 10px; background: transparent; margin: 0; }
QScrollBar::handle { background: @controlBorder; border-radius: 3px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; }
QScrollBar::handle:hover { background: @mutedText; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)");

/// Indicators of choices are as large as the text beside them, with any border; what opens grows as
/// icons do.
void setSizes(QString &sheet)
{
    const int chevron = iconSquare(14).width(); // px
    const int little = iconSquare(12).width();
    const int size = scaledByText(14); // px, with the border
    const int rim = scaledByText(4);   // around the dot
    const std::pair<const char *, int> sizes[] = {
        {"@plain", size - 2},
        {"@ringed", size - 4},
        {"@round", size / 2},
        {"@rim", rim},
        {"@dot", size - 2 * rim},
        {"@thick", rim + 1},
        {"@small", size - 2 * (rim + 1)},
        {"@chevron", chevron},
        {"@dropDown", chevron + 6},
        {"@menuSide", chevron + 10},
        {"@menuFocus", chevron + 9},
        {"@littleChevron", little},
        {"@spinButton", little + 6},
        {"@tabAside", tabPadding},
        {"@tabNear", narrowTabPadding},
    };
    for (const auto &[name, pixels] : sizes)
        sheet.replace(QLatin1String(name), QStringLiteral("%1px").arg(pixels));
}

} // namespace

QString styleSheetOf(const Theme &theme)
{
    const auto hovered = [&](const QColor &c) {
        return theme.dark ? c.lighter(112) : c.darker(112);
    };
    const QColor disabled = paletteOf(theme).color(QPalette::Disabled, QPalette::Text);
    // Longer names first: @accentSoft before @accent.
    const std::pair<const char *, QColor> colours[] = {
        {"@accentHover", hovered(theme.accent)},
        {"@successHover", hovered(theme.success)},
        {"@accentSoft", theme.accentSoft},
        {"@warningBorder", theme.warningBorder},
        {"@warningSoft", theme.warningSoft},
        {"@controlBorder", theme.controlBorder},
        {"@mutedText", theme.mutedText},
        {"@onAccent", theme.onAccent},
        {"@disabled", disabled},
        {"@warning", theme.warning},
        {"@success", theme.success},
        {"@window", theme.window},
        {"@accent", theme.accent},
        {"@border", theme.border},
        {"@square", theme.square},
        {"@panel", theme.panel},
        {"@hover", theme.hover},
        {"@text", theme.text},
    };
    QString sheet = frames + menus + buttons + fields + lists;
    setSizes(sheet);
    sheet.replace(QLatin1String("@tick"), QLatin1String(theme.dark ? "dark" : "light"));
    for (const auto &[name, colour] : colours)
        sheet.replace(QLatin1String(name), colour.name());
    return sheet;
}

} // namespace cradle
