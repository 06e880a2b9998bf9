// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_name.h"

#include "tests/gui/open_inspector.h"
#include "views/circle_edits.h"
#include "views/inspector/circle_table_model.h"

#include <QTest>
#include <QTranslator>

#include <cstring>
#include <memory>

using namespace cradle;

/// Circles without a name of their own, in a window that speaks another language.
class TestCircleName final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void plainNamesAreShownInTheLanguage_data();
    void plainNamesAreShownInTheLanguage();
    void typedNamesAreKeptWithoutTheLanguage_data();
    void typedNamesAreKeptWithoutTheLanguage();
    void addedCirclesAreKeptWithoutTheLanguage();
    void tableShowsAndTakesTheNameOfTheLanguage();

private:
    std::unique_ptr<QTranslator> m_translator;
};

namespace {

class Kreis final : public QTranslator
{
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char *, const char *source, const char *,
                                    int) const override
    {
        return std::strcmp(source, "circle %1") == 0 ? QStringLiteral("Kreis %1") : QString();
    }
};

} // namespace

void TestCircleName::init()
{
    m_translator = std::make_unique<Kreis>();
    QVERIFY(QCoreApplication::installTranslator(m_translator.get()));
}

void TestCircleName::cleanup()
{
    m_translator.reset();
}

void TestCircleName::plainNamesAreShownInTheLanguage_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("shown");
    const auto row = [](const QString &name, const QString &shown) {
        QTest::newRow(qPrintable(name)) << name << shown;
    };
    row(QStringLiteral("circle 1"), QStringLiteral("Kreis 1"));
    row(QStringLiteral("circle 1000"), QStringLiteral("Kreis 1000"));
    for (const char *own : {"", "circle", "circle ", "circle 0", "circle 01", "circle x",
                            "Circle 1", "my circle 1", "circle 1 ", "circle 1b", "sun"})
        row(QLatin1String(own), QLatin1String(own));
}

void TestCircleName::plainNamesAreShownInTheLanguage()
{
    QFETCH(QString, name);
    QFETCH(QString, shown);
    QCOMPARE(shownCircleName(name), shown);
    QCOMPARE(keptCircleName(shown), name);
    cleanup(); // in English every name is shown as it is
    QCOMPARE(shownCircleName(name), name);
    QCOMPARE(keptCircleName(name), name);
}

void TestCircleName::typedNamesAreKeptWithoutTheLanguage_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("kept");
    QTest::newRow("plain") << QStringLiteral("Kreis 7") << QStringLiteral("circle 7");
    QTest::newRow("own") << QStringLiteral("Kreissäge") << QStringLiteral("Kreissäge");
}

void TestCircleName::typedNamesAreKeptWithoutTheLanguage()
{
    QFETCH(QString, typed);
    QFETCH(QString, kept);
    QCOMPARE(keptCircleName(typed), kept);
}

void TestCircleName::addedCirclesAreKeptWithoutTheLanguage()
{
    Preset preset = withAddedCircle(Preset{}, std::nullopt);
    preset = withDuplicate(preset, 0);
    QCOMPARE(preset.circles[0].name, plainCircleName(1));
    QCOMPARE(preset.circles[1].name, plainCircleName(2));
}

void TestCircleName::tableShowsAndTakesTheNameOfTheLanguage()
{
    OpenInspector open;
    QVERIFY(open.show());
    QAbstractItemModel *model = open.table()->model();
    const QModelIndex cell = model->index(0, CircleTableModel::Name);
    QCOMPARE(model->data(cell, Qt::DisplayRole).toString(), QStringLiteral("Kreis 1"));
    QCOMPARE(model->data(cell, Qt::EditRole).toString(), QStringLiteral("Kreis 1"));
    // To leave the name as it is shown is no edit.
    QVERIFY(model->setData(cell, QStringLiteral("Kreis 1")));
    QVERIFY(!open.document.undoStack().canUndo());
    QVERIFY(model->setData(cell, QStringLiteral("Sonne")));
    QCOMPARE(open.preset().circles[0].name, QStringLiteral("Sonne"));
    QVERIFY(model->setData(cell, QStringLiteral("Kreis 5")));
    QCOMPARE(open.preset().circles[0].name, QStringLiteral("circle 5"));
}

QTEST_MAIN(TestCircleName)
#include "test_circle_name.moc"
