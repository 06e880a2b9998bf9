// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/theme.h"

#include "tests/patience.h"
#include "tests/wcag.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QTest>

using namespace cradle;

namespace {

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

/// One theme for the whole program: it grows with the texts, and changes at once.
class TestTheme final : public QObject
{
    Q_OBJECT
private slots:
    void textsGrow();
    void switchingRepaintsEverything();
    void systemChoiceFollowsTheDesktop();
    void circlesDifferByDash();
    void whatOpensHasAnEdge_data();
    void whatOpensHasAnEdge();
};

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
    QVERIFY(QTest::qWaitForWindowExposed(&box, patience));
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
