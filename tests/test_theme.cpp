// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/icons.h"
#include "views/theme.h"
#include "views/theme_override.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace cradle;

namespace {

/// Contrast by the formula of WCAG 2.1, worked here anew.
double wcag(const QColor &a, const QColor &b)
{
    const auto luminance = [](const QColor &c) {
        const auto part = [](int byte) {
            const double s = byte / 255.0;
            return s <= 0.03928 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * part(c.red()) + 0.7152 * part(c.green()) + 0.0722 * part(c.blue());
    };
    const double x = luminance(a) + 0.05;
    const double y = luminance(b) + 0.05;
    return x > y ? x / y : y / x;
}

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

class Watcher final : public QWidget
{
public:
    int changes = 0;

protected:
    void changeEvent(QEvent *event) override
    {
        QWidget::changeEvent(event);
        if (event->type() == QEvent::PaletteChange)
            ++changes;
    }
};

} // namespace

class TestTheme final : public QObject
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
    void textsGrow();
    void anyColourBecomesReadable();
    void switchingRepaintsEverything();
    void systemChoiceFollowsTheDesktop();
    void everyIconIsDrawnInTheTextColour();
    void paintedAsTheyAreIconsCanBeSeen_data();
    void paintedAsTheyAreIconsCanBeSeen();
    void unknownIconIsNull();
    void circlesDifferByDash();
    void whatOpensHasAnEdge_data();
    void whatOpensHasAnEdge();
};

void TestTheme::contrastOfBlackOnWhiteIs21()
{
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-6);
    QVERIFY(std::abs(contrast(Qt::white, Qt::black) - 21.0) < 1e-6);
    const QColor blue(0x1e90ff);
    QVERIFY(std::abs(contrast(blue, Qt::white) - wcag(blue, Qt::white)) < 1e-3);
}

void TestTheme::textCanBeReadOnEveryBackground_data()
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

void TestTheme::textCanBeReadOnEveryBackground()
{
    QFETCH(QColor, text);
    QFETCH(QColor, background);
    const double found = wcag(text, background);
    QVERIFY2(found >= 4.5, qPrintable(QString::number(found)));
}

void TestTheme::shapesCanBeSeen_data()
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

void TestTheme::shapesCanBeSeen()
{
    QFETCH(QColor, shape);
    QFETCH(QColor, background);
    QFETCH(double, least);
    const double found = wcag(shape, background);
    // A colour is kept in bytes.
    QVERIFY2(found >= least - 0.02, qPrintable(QString::number(found)));
}

void TestTheme::colourBlindTellColoursApart_data()
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
void TestTheme::colourBlindTellColoursApart()
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

/// Also those that have a font of their own.
void TestTheme::textsGrow()
{
    applyTheme(ThemeChoice::Light);
    QLabel plain;
    QLabel heading;
    heading.setFont(headingFont());
    plain.show();
    heading.show();
    const double size = plain.font().pointSizeF();
    const int pixels = heading.font().pixelSize();
    setTextScale(2.0);
    QCoreApplication::processEvents();
    QCOMPARE(plain.font().pointSizeF(), 2.0 * size);
    QCOMPARE(heading.font().pixelSize(), 2 * pixels);
    QCOMPARE(headingFont().pixelSize(), 2 * pixels);
    QCOMPARE(scaledByText(22), 44);
    setTextScale(1.0);
    QCoreApplication::processEvents();
    QCOMPARE(plain.font().pointSizeF(), size);
    QCOMPARE(heading.font().pixelSize(), pixels);
}

void TestTheme::anyColourBecomesReadable()
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

void TestTheme::switchingRepaintsEverything()
{
    applyTheme(ThemeChoice::Light);
    Watcher watcher;
    QLabel label(&watcher);
    QCOMPARE(label.palette().color(QPalette::WindowText), Theme::lightTheme().text);
    watcher.show();
    watcher.changes = 0;
    applyTheme(ThemeChoice::Dark);
    QVERIFY(theme().dark);
    QVERIFY(watcher.changes > 0);
    QCOMPARE(label.palette().color(QPalette::WindowText), Theme::darkTheme().text);
    QVERIFY(qApp->styleSheet().contains(Theme::darkTheme().border.name()));
    QVERIFY2(!qApp->styleSheet().contains(QLatin1Char('@')), "a role was not filled in");
    applyTheme(ThemeChoice::Light);
    QVERIFY(!theme().dark);
    QCOMPARE(label.palette().color(QPalette::WindowText), Theme::lightTheme().text);
}

void TestTheme::systemChoiceFollowsTheDesktop()
{
    applyTheme(ThemeChoice::Dark);
    applyTheme(ThemeChoice::System);
    QVERIFY(!theme().dark); // the offscreen platform is light
}

void TestTheme::everyIconIsDrawnInTheTextColour()
{
    const QStringList files = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    QVERIFY(files.size() >= 22);
    // These are of the style sheet, which cannot tint.
    const QStringList untinted{QStringLiteral("chevron-down"), QStringLiteral("chevron-up"),
                               QStringLiteral("close"),        QStringLiteral("float"),
                               QStringLiteral("tick-dark"),    QStringLiteral("tick-light")};
    for (const QString &file : files) {
        const QString name = file.chopped(4);
        const QIcon drawn = icon(name);
        QVERIFY2(!drawn.isNull(), qPrintable(name));
        if (untinted.contains(name))
            continue;
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            applyTheme(choice);
            const QImage image = drawn.pixmap(48, 48).toImage();
            int inked = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (image.pixelColor(x, y).alpha() < 255)
                        continue;
                    ++inked;
                    QCOMPARE(image.pixelColor(x, y), theme().text);
                }
            }
            QVERIFY2(inked > 20, qPrintable(name));
        }
    }
}

void TestTheme::paintedAsTheyAreIconsCanBeSeen_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"chevron-down", "close", "float"})
        QTest::addRow("%s", name) << QString::fromLatin1(name);
}

/// What the style sheet cannot tint is seen on the panels of both themes.
void TestTheme::paintedAsTheyAreIconsCanBeSeen()
{
    QFETCH(QString, name);
    applyTheme(ThemeChoice::Light);
    QVERIFY(qApp->styleSheet().contains(QStringLiteral("url(:/icons/%1.svg)").arg(name)));
    const QImage image = icon(name).pixmap(48, 48).toImage();
    int inked = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (pixel.alpha() < 255)
                continue;
            ++inked;
            QVERIFY(wcag(pixel, Theme::lightTheme().panel) >= 3.0);
            QVERIFY(wcag(pixel, Theme::darkTheme().panel) >= 3.0);
        }
    }
    QVERIFY(inked > 20);
}

void TestTheme::unknownIconIsNull()
{
    QVERIFY(icon(u"no such icon").isNull());
}

void TestTheme::circlesDifferByDash()
{
    QCOMPARE(circleDash(0), Qt::SolidLine);
    QVERIFY(circleDash(1) != circleDash(0));
    applyTheme(ThemeChoice::Light);
    QCOMPARE(circleColour(QStringLiteral("#1e90ff")), QColor(0x1e90ff));
    QCOMPARE(circleColour(QStringLiteral("no colour")), QColor(0x1e90ff));
    applyTheme(ThemeChoice::Dark);
    QVERIFY(wcag(circleColour(QStringLiteral("#000000")), theme().scene) >= 2.9);
}

void TestTheme::whatOpensHasAnEdge_data()
{
    QTest::addColumn<ThemeChoice>("choice");
    QTest::newRow("light") << ThemeChoice::Light;
    QTest::newRow("dark") << ThemeChoice::Dark;
    QTest::newRow("high contrast") << ThemeChoice::HighContrast;
}

/// A list has the keyboard as it opens, over what is as white.
void TestTheme::whatOpensHasAnEdge()
{
    QFETCH(ThemeChoice, choice);
    applyTheme(choice);
    QComboBox box;
    box.addItems({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
    box.show();
    QVERIFY(QTest::qWaitForWindowExposed(&box));
    box.showPopup();
    QTRY_VERIFY(box.view()->hasFocus());
    const QImage list = box.view()->grab().toImage();
    QVERIFY(wcag(list.pixelColor(0, list.height() / 2), theme().panel) >= 3.0);
    box.hidePopup();

    QMenu menu;
    menu.addAction(QStringLiteral("one"));
    menu.popup({20, 20});
    const QImage opened = menu.grab().toImage();
    QVERIFY(wcag(opened.pixelColor(0, opened.height() / 2), theme().panel) >= 3.0);
    menu.hide();
}

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
