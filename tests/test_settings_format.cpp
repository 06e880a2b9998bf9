// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_format.h"

#include "full_disk.h"
#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// How the window looks is kept, on a full disk as it was.
class TestSettingsFormat final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void keepsEveryKindOfValue();
    void fullDiskLeavesTheOldOnes();
    void brokenFileIsBegunAnew();
    void olderSettingsAreTakenOnce();

private:
    [[nodiscard]] QString path() const { return m_folder->filePath(QStringLiteral("s.json")); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSettingsFormat::keepsEveryKindOfValue()
{
    const QMap<QString, QVariant> values{
        {QStringLiteral("yes"), true},
        {QStringLiteral("number"), 7},
        {QStringLiteral("text"), QString::fromUtf8("Größe = \"1\"\n")},
        {QStringLiteral("window/geometry"), QByteArray("\0\xff\x01", 3)},
        {QStringLiteral("sizes"), QVariantList{1, 2.5, QStringLiteral("x")}},
        {QStringLiteral("names"), QStringList{QStringLiteral("a, b"), QString()}}};
    {
        QSettings settings(path(), settingsFormat());
        for (auto it = values.begin(); it != values.end(); ++it)
            settings.setValue(it.key(), *it);
    }
    const QSettings settings(path(), settingsFormat());
    QCOMPARE(settings.allKeys().size(), values.size());
    for (auto it = values.begin(); it != values.end(); ++it)
        QCOMPARE(settings.value(it.key()), *it);
}

void TestSettingsFormat::fullDiskLeavesTheOldOnes()
{
    {
        QSettings settings(path(), settingsFormat());
        settings.setValue(QStringLiteral("theme"), 2);
    }
    const auto before = readFile(path(), 1 << 20);
    QVERIFY(before && !before->isEmpty());
    QSettings settings(path(), settingsFormat());
    settings.setValue(QStringLiteral("layout"), QByteArray(9000, 'x'));
    {
        const FullDisk full(512);
        settings.sync();
    }
    QCOMPARE(settings.status(), QSettings::AccessError);
    const auto after = readFile(path(), 1 << 20);
    QVERIFY(after);
    QCOMPARE(*after, *before);
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    // There is room again.
    settings.sync();
    const QSettings again(path(), settingsFormat());
    QCOMPARE(again.value(QStringLiteral("layout")).toByteArray().size(), 9000);
}

void TestSettingsFormat::brokenFileIsBegunAnew()
{
    QVERIFY(!writeFile(path(), "[[["));
    {
        QSettings settings(path(), settingsFormat());
        QVERIFY(settings.allKeys().isEmpty());
        settings.setValue(QStringLiteral("theme"), 1);
    }
    const QSettings settings(path(), settingsFormat());
    QCOMPARE(settings.value(QStringLiteral("theme")).toInt(), 1);
}

void TestSettingsFormat::olderSettingsAreTakenOnce()
{
    QSettings older(m_folder->filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    older.setValue(QStringLiteral("language"), QStringLiteral("de"));
    QSettings settings(path(), settingsFormat());
    takeOlderSettings(settings, older);
    QCOMPARE(settings.value(QStringLiteral("language")).toString(), QStringLiteral("de"));
    older.setValue(QStringLiteral("language"), QStringLiteral("en"));
    takeOlderSettings(settings, older);
    QCOMPARE(settings.value(QStringLiteral("language")).toString(), QStringLiteral("de"));
}

QTEST_GUILESS_MAIN(TestSettingsFormat)
#include "test_settings_format.moc"
