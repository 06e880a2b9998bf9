// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/icons.h"
#include "views/theme.h"

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

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
    void linesCanBeSeenOnScene();
    void anyColourBecomesReadable();
    void switchingRepaintsEverything();
    void systemChoiceFollowsTheDesktop();
    void everyIconIsDrawnInTheTextColour();
    void paintedAsTheyAreIconsCanBeSeen_data();
    void paintedAsTheyAreIconsCanBeSeen();
    void unknownIconIsNull();
    void circlesDifferByDash();
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
    for (const Theme *t : {&Theme::lightTheme(), &Theme::darkTheme()}) {
        const std::pair<const char *, QColor> texts[] = {
            {"text", t->text},       {"muted", t->mutedText}, {"accent", t->accent},
            {"success", t->success}, {"warning", t->warning},
        };
        const std::pair<const char *, QColor> backgrounds[] = {
            {"window", t->window}, {"panel", t->panel},           {"scene", t->scene},
            {"hover", t->hover},   {"accentSoft", t->accentSoft}, {"warningSoft", t->warningSoft},
        };
        const char *mode = t->dark ? "dark" : "light";
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

void TestTheme::linesCanBeSeenOnScene()
{
    for (const Theme *t : {&Theme::lightTheme(), &Theme::darkTheme()}) {
        for (const QColor &line : {t->square, t->kinetic, t->potential, t->dissipated, t->across})
            QVERIFY2(wcag(line, t->scene) >= 2.8, qPrintable(line.name()));
        QVERIFY(wcag(t->along, t->scene) >= 2.2); // an orange that is still orange; it is labelled
    }
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
    const QStringList untinted{QStringLiteral("chevron-down"), QStringLiteral("close"),
                               QStringLiteral("float"), QStringLiteral("tick-dark"),
                               QStringLiteral("tick-light")};
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

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
