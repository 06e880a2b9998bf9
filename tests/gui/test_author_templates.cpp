// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/arrangement_dialog.h"
#include "views/menu.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QSpinBox>

#include <cmath>

using namespace cradle;
using namespace cradle::windows;

/// Racks, grids and rings of circles, put into a step's scene by keyboard.
class TestAuthorTemplates : public QObject
{
    Q_OBJECT
private slots:
    void circlesStandInPatterns_data();
    void circlesStandInPatterns();
    void whatFindsNoPlaceIsRefused();
    void rackIsPutIntoTheSceneByKeys();
};

namespace {

using Pattern = Arrangement::Pattern;

double gapOf(const PresetCircle &a, const PresetCircle &b)
{
    return std::hypot(a.body.position.x - b.body.position.x, a.body.position.y - b.body.position.y)
           - a.body.radius - b.body.radius;
}

} // namespace

void TestAuthorTemplates::circlesStandInPatterns_data()
{
    QTest::addColumn<Arrangement>("asked");
    QTest::addColumn<int>("circles");
    QTest::addColumn<int>("neighbours"); // pairs with the least gap
    QTest::newRow("rack of six, hit")
        << Arrangement{.pattern = Pattern::Rack, .rows = 3, .hasStriker = true} << 7 << 9;
    QTest::newRow("grid") << Arrangement{.pattern = Pattern::Grid,
                                         .rows = 2,
                                         .columns = 4,
                                         .radius = 0.1,
                                         .gap = 0.3,
                                         .hasStriker = false}
                          << 8 << 10;
    QTest::newRow("ring") << Arrangement{.pattern = Pattern::Ring, .rows = 9, .hasStriker = false}
                          << 9 << 9;
    QTest::newRow("one") << Arrangement{.pattern = Pattern::Ring, .rows = 1, .hasStriker = false}
                         << 1 << 0;
}

void TestAuthorTemplates::circlesStandInPatterns()
{
    QFETCH(Arrangement, asked);
    QFETCH(int, circles);
    QFETCH(int, neighbours);
    const Result<Preset> made = presetOf(asked);
    QVERIFY(made);
    QCOMPARE(static_cast<int>(made->circles.size()), circles);
    QCOMPARE(countOf(asked), circles);
    int near = 0;
    for (std::size_t i = 0; i < made->circles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = gapOf(made->circles[i], made->circles[j]);
            QVERIFY2(gap > asked.gap - 1e-5, qPrintable(QString::number(gap)));
            near += std::abs(gap - asked.gap) < 1e-5 ? 1 : 0;
        }
    }
    QCOMPARE(near, neighbours);
}

void TestAuthorTemplates::whatFindsNoPlaceIsRefused()
{
    // 14 · 15 / 2 = 105 circles; a row of 20 with 0.42 m each is 8.4 m wide.
    const Result<Preset> many = presetOf({.pattern = Pattern::Rack, .rows = 14, .radius = 0.01});
    QVERIFY(!many && many.error().message.contains(QLatin1String("106 circles are too many")));
    const Result<Preset> wide = presetOf({.pattern = Pattern::Grid, .rows = 1, .columns = 20});
    QVERIFY(!wide && wide.error().message.contains(QLatin1String("do not fit")));
    ArrangementDialog dialog(Pattern::Ring, nullptr);
    dialog.show();
    auto *rows = dialog.findChild<QSpinBox *>(QStringLiteral("arrangementRows"));
    const auto *said = dialog.findChild<QLabel *>(QStringLiteral("arrangementResult"));
    const auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    QVERIFY(ok->isEnabled());
    rows->setValue(60);
    QVERIFY(!ok->isEnabled());
    QVERIFY(said->text().contains(QLatin1String("do not fit")));
    dialog.findChild<QDoubleSpinBox *>(QStringLiteral("arrangementRadius"))->setValue(0.05);
    QVERIFY(ok->isEnabled());
}

void TestAuthorTemplates::rackIsPutIntoTheSceneByKeys()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Billiards"));
    const LabFiles before = author.files();
    author.window.panes().showTab(AuthorWindow::Scene);
    OpenAuthor::inDialog<ArrangementDialog>([](ArrangementDialog *dialog) {
        dialog->activateWindow();
        auto *rows = dialog->findChild<QSpinBox *>(QStringLiteral("arrangementRows"));
        if (!rows->hasFocus())
            return false;                            // not yet
        QTest::keyClicks(rows, QStringLiteral("4")); // in place of what is there
        QTest::keyClick(rows, Qt::Key_Tab);
        QTest::keyClick(rows, Qt::Key_Return);
        return true;
    });
    QMenu &menu = author.window.sceneTab().templates();
    menu.popup({});
    QTest::keyClick(&menu, Qt::Key_R);
    QCOMPARE(author.window.sceneTab().preset().own().circles.size(), std::size_t(11));
    QCOMPARE(presetOf(author.files(), author.document().step())->circles.size(), std::size_t(11));
    author.undo();
    QCOMPARE(author.files(), before);
}

QTEST_MAIN(TestAuthorTemplates)
#include "test_author_templates.moc"
