// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/theme.h"
#include "views/theme_override.h"

#include "tests/wcag.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace cradle;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

/// Machado, Oliveira and Fernandes 2009, severity 1: protanopia, deuteranopia, tritanopia; of
/// linear RGB.
constexpr Matrix colourBlindness[] = {
    {{{0.152286, 1.052583, -0.204868},
      {0.114503, 0.786281, 0.099216},
      {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968},
      {0.280085, 0.672501, 0.047413},
      {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779},
      {-0.078411, 0.930809, 0.147602},
      {0.004733, 0.691367, 0.303900}}},
};

Triple times(const Matrix &m, const Triple &v)
{
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

Triple linearOf(const QColor &colour)
{
    const auto part = [](int byte) {
        const double s = byte / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    return {part(colour.red()), part(colour.green()), part(colour.blue())};
}

/// CIE L*a*b*, D65.
Triple labOf(const Triple &linear)
{
    constexpr Matrix toXyz{
        {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    Triple seen = linear;
    for (double &part : seen)
        part = std::clamp(part, 0.0, 1.0);
    const Triple xyz = times(toXyz, seen);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f(xyz[0] / 0.9505);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

std::array<std::pair<const char *, const Theme *>, 3> allThemes()
{
    return {{{"light", &Theme::lightTheme()},
             {"dark", &Theme::darkTheme()},
             {"high contrast", &Theme::highContrastTheme()}}};
}

} // namespace

/// What is shown can be read and told apart in every theme, also by the colour-blind.
class TestThemeContrast final : public QObject
{
    Q_OBJECT
private slots:
    void contrastOfBlackOnWhiteIs21();
    void textCanBeReadOnEveryBackground_data();
    void textCanBeReadOnEveryBackground();
    void shapesCanBeSeen_data();
    void shapesCanBeSeen();
    void colourBlindTellColoursApart_data();
    void colourBlindTellColoursApart();
    void anyColourBecomesReadable();
};

void TestThemeContrast::contrastOfBlackOnWhiteIs21()
{
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-6);
    QVERIFY(std::abs(contrast(Qt::white, Qt::black) - 21.0) < 1e-6);
    const QColor blue(0x1e90ff);
    QVERIFY(std::abs(contrast(blue, Qt::white) - wcag(blue, Qt::white)) < 1e-3);
}

void TestThemeContrast::textCanBeReadOnEveryBackground_data()
{
    QTest::addColumn<QColor>("text");
    QTest::addColumn<QColor>("background");
    for (const auto &[mode, t] : allThemes()) {
        const std::pair<const char *, QColor> texts[] = {
            {"text", t->text},       {"muted", t->mutedText}, {"accent", t->accent},
            {"success", t->success}, {"warning", t->warning},
        };
        const std::pair<const char *, QColor> backgrounds[] = {
            {"window", t->window}, {"panel", t->panel},           {"scene", t->scene},
            {"hover", t->hover},   {"accentSoft", t->accentSoft}, {"warningSoft", t->warningSoft},
        };
        for (const auto &[name, text] : texts) {
            for (const auto &[behind, background] : backgrounds)
                QTest::addRow("%s %s on %s", mode, name, behind) << text << background;
        }
        QTest::addRow("%s on accent", mode) << t->onAccent << t->accent;
        QTest::addRow("%s on success", mode) << t->onAccent << t->success;
        QTest::addRow("%s tool tip", mode) << t->panel << t->text;
    }
}

void TestThemeContrast::textCanBeReadOnEveryBackground()
{
    QFETCH(QColor, text);
    QFETCH(QColor, background);
    const double found = wcag(text, background);
    QVERIFY2(found >= 4.5, qPrintable(QString::number(found)));
}

void TestThemeContrast::shapesCanBeSeen_data()
{
    QTest::addColumn<QColor>("shape");
    QTest::addColumn<QColor>("background");
    QTest::addColumn<double>("least");
    for (const auto &[mode, t] : allThemes()) {
        const double least = t == &Theme::highContrastTheme() ? 4.5 : 3.0;
        const std::pair<const char *, QColor> shapes[] = {
            {"square", t->square},         {"along", t->along},         {"across", t->across},
            {"kinetic", t->kinetic},       {"potential", t->potential}, {"accent", t->accent},
            {"dissipated", t->dissipated}, {"success", t->success},     {"warning", t->warning},
        };
        for (const auto &[name, shape] : shapes) {
            QTest::addRow("%s %s on scene", mode, name) << shape << t->scene << least;
            QTest::addRow("%s %s on panel", mode, name) << shape << t->panel << least;
        }
        QTest::addRow("%s control on panel", mode) << t->controlBorder << t->panel << least;
        QTest::addRow("%s control on window", mode) << t->controlBorder << t->window << least;
        const ThemeOverride during(*t);
        for (const char *circle : {"#1e90ff", "#e03131", "#ffffff", "#000000", "#ffd43b"})
            QTest::addRow("%s circle %s", mode, circle)
                << circleColour(QLatin1String(circle)) << t->scene << least;
    }
}

void TestThemeContrast::shapesCanBeSeen()
{
    QFETCH(QColor, shape);
    QFETCH(QColor, background);
    QFETCH(double, least);
    const double found = wcag(shape, background);
    // A colour is kept in bytes.
    QVERIFY2(found >= least - 0.02, qPrintable(QString::number(found)));
}

void TestThemeContrast::colourBlindTellColoursApart_data()
{
    QTest::addColumn<QColor>("a");
    QTest::addColumn<QColor>("b");
    for (const auto &[mode, t] : allThemes()) {
        const ThemeOverride during(*t);
        const QColor circle1 = circleColour(QStringLiteral("#1e90ff"));
        const QColor circle2 = circleColour(QStringLiteral("#e03131"));
        QTest::addRow("%s circles", mode) << circle1 << circle2;
        QTest::addRow("%s parts", mode) << t->along << t->across;
        QTest::addRow("%s circle 1, along", mode) << circle1 << t->along;
        QTest::addRow("%s circle 1, across", mode) << circle1 << t->across;
        QTest::addRow("%s circle 2, along", mode) << circle2 << t->along;
        QTest::addRow("%s circle 2, across", mode) << circle2 << t->across;
        QTest::addRow("%s energies", mode) << t->kinetic << t->potential;
        QTest::addRow("%s potential, dissipated", mode) << t->potential << t->dissipated;
        QTest::addRow("%s kinetic, dissipated", mode) << t->kinetic << t->dissipated;
        QTest::addRow("%s across, dissipated", mode) << t->across << t->dissipated;
        QTest::addRow("%s verdicts", mode) << t->success << t->warning;
    }
}

/// At least four times what can just be noticed (2.3), as protanopes, deuteranopes, tritanopes see.
void TestThemeContrast::colourBlindTellColoursApart()
{
    QFETCH(QColor, a);
    QFETCH(QColor, b);
    for (const Matrix &eye : colourBlindness) {
        const Triple x = labOf(times(eye, linearOf(a)));
        const Triple y = labOf(times(eye, linearOf(b)));
        const double apart = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
        QVERIFY2(apart >= 9.2, qPrintable(QString::number(apart)));
    }
}

void TestThemeContrast::anyColourBecomesReadable()
{
    for (const Theme *t : {&Theme::lightTheme(), &Theme::darkTheme()}) {
        for (int hue = 0; hue < 360; hue += 30) {
            for (int value = 0; value <= 255; value += 51) {
                const QColor colour = readableOn(QColor::fromHsv(hue, 200, value), t->scene);
                QVERIFY2(wcag(colour, t->scene) >= 4.45, qPrintable(colour.name()));
            }
        }
    }
    QCOMPARE(readableOn(QColor(0x1a2332), Qt::white), QColor(0x1a2332));
}

QTEST_MAIN(TestThemeContrast)
#include "test_theme_contrast.moc"
