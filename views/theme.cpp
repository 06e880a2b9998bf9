// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/theme.h"

#include "views/theme_override.h"

#include "views/icons.h"
#include "views/style_sheet.h"

#include <QAbstractButton>
#include <QApplication>
#include <QPointer>
#include <QStyle>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace cradle {

namespace {

constexpr double textPoints = 10.0;
constexpr int headingPixels = 11;

const Theme *current = nullptr;
double scaleOfText = 1.0;

/// Whether the desktop is dark: asked before we set a palette of our own.
bool systemIsDark()
{
    static const bool dark = [] {
        const QPalette original = QApplication::palette();
        return original.color(QPalette::Window).lightness()
               < original.color(QPalette::WindowText).lightness();
    }();
    return dark;
}

double luminance(const QColor &colour)
{
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF())
           + 0.0722 * linear(colour.blueF());
}

QColor mix(const QColor &a, const QColor &b, double share)
{
    const auto part = [share](float x, float y) {
        return static_cast<float>((1.0 - share) * x + share * y);
    };
    return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()),
                            part(a.blueF(), b.blueF()));
}

/// \p colour, mixed with black or white until its contrast to \p background is reached.
QColor findContrast(const QColor &colour, const QColor &background, double wanted)
{
    const bool darken = luminance(background) > 0.18;
    const QColor end = darken ? QColor(Qt::black) : QColor(Qt::white);
    for (int percent = 0; percent < 100; percent += 4) {
        const QColor mixed = mix(colour, end, percent / 100.0);
        if (contrast(mixed, background) >= wanted)
            return mixed;
    }
    return end;
}

/// The same, remembered: every frame asks for the same few colours, a crowd for hundreds of times.
QColor withContrast(const QColor &colour, const QColor &background, double wanted)
{
    constexpr std::size_t mostKept = 1000;
    using Question = std::tuple<quint64, quint64, double>;
    thread_local std::map<Question, QColor> answers;
    const Question question{colour.rgba64(), background.rgba64(), wanted};
    const auto known = answers.find(question);
    if (known != answers.end())
        return known->second;
    if (answers.size() >= mostKept)
        answers.clear();
    return answers.emplace(question, findContrast(colour, background, wanted)).first->second;
}

QFont textFont()
{
    QFont font;
    font.setFamilies({QStringLiteral("Inter"), QStringLiteral("Noto Sans"),
                      QStringLiteral("DejaVu Sans"), QStringLiteral("sans-serif")});
    font.setPointSizeF(textPoints * scaleOfText);
    return font;
}

/// What was \p pixels at the scale \p before, at the scale \p now: there and back changes nothing.
int rescaled(int pixels, double before, double now)
{
    return static_cast<int>(std::lround(now * static_cast<double>(std::lround(pixels / before))));
}

void rescaleIcon(QAbstractButton &button, double before)
{
    const auto scaled = [from = iconScale(before)](int pixels) {
        return rescaled(pixels, from, iconScale(scaleOfText));
    };
    if (!button.icon().isNull())
        button.setIconSize({scaled(button.iconSize().width()), scaled(button.iconSize().height())});
}

/// Sets font and style sheet of the application. Widgets with a font of their own keep it, at the
/// new scale: they do not follow the application's, and a new style sheet puts back what it found
/// when they were made. \param before  the scale of texts so far
void styleAnew(double before)
{
    std::vector<std::pair<QPointer<QWidget>, QFont>> own;
    for (QWidget *widget : QApplication::allWidgets()) {
        if (auto *button = qobject_cast<QAbstractButton *>(widget); button && before != scaleOfText)
            rescaleIcon(*button, before);
        if (!widget->testAttribute(Qt::WA_SetFont))
            continue;
        QFont font = widget->font();
        if (font.pixelSize() > 0)
            font.setPixelSize(rescaled(font.pixelSize(), before, scaleOfText));
        else
            font.setPointSizeF(scaleOfText / before * font.pointSizeF());
        own.emplace_back(widget, font);
    }
    QApplication::setFont(textFont());
    qApp->setStyleSheet(styleSheetOf(*current)); // else it keeps the fonts that it has resolved
    for (const auto &[widget, font] : own) {
        if (widget)
            widget->setFont(font);
    }
}

} // namespace

ThemeOverride::ThemeOverride(const Theme &other)
    : m_before(std::exchange(current, &other))
{
}

ThemeOverride::~ThemeOverride()
{
    current = m_before;
}

const Theme &theme()
{
    return current ? *current : Theme::lightTheme();
}

QPalette paletteOf(const Theme &theme)
{
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, const QColor &colour) {
        palette.setColor(role, colour);
    };
    set(QPalette::Window, theme.panel);
    set(QPalette::WindowText, theme.text);
    set(QPalette::Base, theme.panel);
    set(QPalette::AlternateBase, theme.window);
    set(QPalette::Text, theme.text);
    set(QPalette::PlaceholderText, theme.mutedText);
    set(QPalette::Button, theme.panel);
    set(QPalette::ButtonText, theme.text);
    set(QPalette::BrightText, theme.onAccent);
    set(QPalette::ToolTipBase, theme.text);
    set(QPalette::ToolTipText, theme.panel);
    set(QPalette::Highlight, theme.accent);
    set(QPalette::HighlightedText, theme.onAccent);
    set(QPalette::Link, theme.accent);
    set(QPalette::LinkVisited, theme.accent);
    set(QPalette::Light, theme.panel.lighter(120));
    set(QPalette::Midlight, theme.hover);
    set(QPalette::Mid, theme.controlBorder);
    set(QPalette::Dark, theme.controlBorder.darker(120));
    set(QPalette::Shadow, QColor(Qt::black));
    const QColor disabled = mix(theme.mutedText, theme.panel, 0.35);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, disabled);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, theme.border);
    return palette;
}

void applyTheme(ThemeChoice choice)
{
    const bool system = systemIsDark(); // asked always: before the first palette is set
    const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && system);
    const Theme *previous = current;
    current = choice == ThemeChoice::HighContrast ? &Theme::highContrastTheme()
              : dark                              ? &Theme::darkTheme()
                                                  : &Theme::lightTheme();
    if (previous == current)
        return;
    if (!previous)
        QApplication::setStyle(QStringLiteral("fusion"));
    QApplication::setPalette(paletteOf(*current));
    styleAnew(scaleOfText);
}

void setTextScale(double scale)
{
    const double before = std::exchange(scaleOfText, std::clamp(scale, 1.0, 2.0));
    if (before != scaleOfText && current)
        styleAnew(before);
}

double textScale()
{
    return scaleOfText;
}

int scaledByText(int pixels)
{
    return static_cast<int>(std::lround(scaleOfText * pixels));
}

QFont numericFont()
{
    QFont font = QApplication::font();
    font.setFamilies({QStringLiteral("JetBrains Mono"), QStringLiteral("DejaVu Sans Mono"),
                      QStringLiteral("monospace")});
    font.setStyleHint(QFont::Monospace);
    font.setFixedPitch(true);
    return font;
}

QFont codeFont()
{
    constexpr int codePixels = 13;
    QFont font = numericFont();
    font.setPixelSize(scaledByText(codePixels));
    font.setStyleStrategy(QFont::PreferNoShaping); // <!-- is no arrow, != two signs
    return font;
}

QFont headingFont()
{
    QFont font = QApplication::font();
    font.setPixelSize(scaledByText(headingPixels));
    font.setWeight(QFont::DemiBold);
    font.setCapitalization(QFont::AllUppercase);
    if (!QGuiApplication::isRightToLeft()) // Arabic letters would come apart
        font.setLetterSpacing(QFont::PercentageSpacing, 106.0);
    return font;
}

void setKind(QWidget *widget, const char *kind)
{
    const QString name = QString::fromLatin1(kind);
    if (widget->property("kind").toString() == name)
        return;
    widget->setProperty("kind", name);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
    widget->update();
}

double contrast(const QColor &a, const QColor &b)
{
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

QColor readableOn(const QColor &colour, const QColor &background)
{
    return withContrast(colour, background, theme().textContrast);
}

QColor visibleOn(const QColor &colour, const QColor &background)
{
    return withContrast(colour, background, theme().shapeContrast);
}

QColor circleColour(const QString &presetColour)
{
    const QColor colour(presetColour);
    return visibleOn(colour.isValid() ? colour : theme().square, theme().scene);
}

Qt::PenStyle circleDash(int index)
{
    static constexpr std::array dashes{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine,
                                       Qt::DashDotDotLine};
    return dashes[static_cast<std::size_t>(std::max(index, 0)) % dashes.size()];
}

} // namespace cradle
