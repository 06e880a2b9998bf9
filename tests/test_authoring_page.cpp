// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "authoring_page.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/reading/lab_reader.h"
#include "tests/test_paths.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

using namespace cradle;

/// docs/authoring.md says of kinds of checks and scenes what the catalogue says, and shows the
/// files of the shipped lab as they are.
class TestAuthoringPage : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void everyKindIsDescribed_data();
    void everyKindIsDescribed();
    void nothingElseIsDescribed();
    void filesShownAreThoseOfTheLab();
    void linksLeadSomewhere();

private:
    QString m_page;
};

namespace {

QString shapeOf(const ParameterInfo &info)
{
    switch (info.type) {
    case ParameterInfo::Type::Number:
        return QStringLiteral("number");
    case ParameterInfo::Type::Count:
        return QStringLiteral("whole number");
    case ParameterInfo::Type::Flag:
        return QStringLiteral("`true` or `false`");
    case ParameterInfo::Type::Choice:
        return QStringLiteral("one of `") + info.choices.join(QStringLiteral("`, `"))
               + QLatin1Char('`');
    case ParameterInfo::Type::Choices:
        return QStringLiteral("list of `") + info.choices.join(QStringLiteral("`, `"))
               + QLatin1Char('`');
    case ParameterInfo::Type::Vector:
        return QStringLiteral("`[x, y]`");
    case ParameterInfo::Type::Vectors:
        return QStringLiteral("list of `[x, y]`");
    case ParameterInfo::Type::Range:
        return QStringLiteral("`[least, most]`");
    case ParameterInfo::Type::Numbers:
        return QStringLiteral("list of numbers");
    case ParameterInfo::Type::Script:
        break;
    }
    return QStringLiteral("file in `checks/`");
}

QString boundsOf(const ParameterInfo &info)
{
    if (!info.least || !info.most)
        return {};
    // Ten digits, so that a million is written out.
    return QStringLiteral(", %1 to %2").arg(*info.least, 0, 'g', 10).arg(*info.most, 0, 'g', 10);
}

/// Behind the bounds; one that begins with a number is set apart from them.
QString unitOf(const ParameterInfo &info)
{
    if (info.unit.isEmpty())
        return {};
    return (info.unit.front().isDigit() ? QStringLiteral(", in ") : QStringLiteral(" "))
           + info.unit;
}

/// The row of a parameter in the page's tables.
QString rowOf(const ParameterInfo &info)
{
    QString usual = info.required ? QStringLiteral("needed") : QString();
    if (!info.standard.isUndefined())
        usual = QLatin1Char('`') + jsonText(info.standard) + QLatin1Char('`');
    return QStringLiteral("| `%1` | %2: %3 | %4%5%6 | %7 |\n")
        .arg(info.name, info.label, info.help, shapeOf(info), boundsOf(info), unitOf(info), usual);
}

/// The section of a kind.
QString sectionOf(const KindInfo &kind)
{
    QString text = QStringLiteral("#### `%1`: %2\n%3.\n").arg(kind.name, kind.title, kind.purpose);
    if (kind.circles > 1)
        text.insert(text.size() - 1, QStringLiteral(" Needs %1 circles.").arg(kind.circles));
    if (kind.parameters.empty())
        return text;
    text +=
        QStringLiteral("\n| parameter | what it says | form | if left out |\n|---|---|---|---|\n");
    for (const ParameterInfo &info : kind.parameters)
        text += rowOf(info);
    return text;
}

std::vector<KindInfo> allKinds()
{
    std::vector<KindInfo> kinds = checkKinds();
    for (KindInfo &kind : sceneKinds())
        kinds.push_back(std::move(kind));
    return kinds;
}

} // namespace

void TestAuthoringPage::initTestCase()
{
    m_page = authoringPage();
    QVERIFY(!m_page.isEmpty());
}

void TestAuthoringPage::everyKindIsDescribed_data()
{
    QTest::addColumn<QString>("section");
    for (const KindInfo &kind : allKinds())
        QTest::newRow(qPrintable(kind.name)) << sectionOf(kind);
}

void TestAuthoringPage::everyKindIsDescribed()
{
    QFETCH(QString, section);
    if (!m_page.contains(section))
        qWarning().noquote() << QStringLiteral("docs/authoring.md should say:\n") + section;
    QVERIFY(m_page.contains(section));
}

void TestAuthoringPage::nothingElseIsDescribed()
{
    QStringList names;
    for (const KindInfo &kind : allKinds())
        names.append(kind.name);
    static const QRegularExpression heading(QStringLiteral("^#### `([^`]+)`"),
                                            QRegularExpression::MultilineOption);
    qsizetype sections = 0;
    for (auto found = heading.globalMatch(m_page); found.hasNext(); ++sections) {
        const QString name = found.next().captured(1);
        QVERIFY2(names.contains(name), qPrintable(name));
    }
    QCOMPARE(sections, names.size());
}

/// A block of code after a line "`FILE`:" is that file, or lines of it.
void TestAuthoringPage::filesShownAreThoseOfTheLab()
{
    static const QRegularExpression block(
        QStringLiteral("^ *`(BALL[^`]+|lab[^`]*)`:\\n\\n```\\w*\\n(.*?)^```"),
        QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
    int blocks = 0;
    for (auto found = block.globalMatch(m_page); found.hasNext(); ++blocks) {
        const QRegularExpressionMatch match = found.next();
        const QString file =
            textOf(QLatin1String(bouncingBallLab) + QLatin1Char('/') + match.captured(1));
        QVERIFY2(!file.isEmpty(), qPrintable(match.captured(1)));
        QVERIFY2(file.contains(match.captured(2)), qPrintable(match.captured(0)));
    }
    QVERIFY2(blocks >= 8, QByteArray::number(blocks));
}

void TestAuthoringPage::linksLeadSomewhere()
{
    static const QRegularExpression link(QStringLiteral("[^!]\\[[^\\]]*\\]\\(([^)#:]+)[^)]*\\)"));
    int links = 0;
    for (auto found = link.globalMatch(m_page); found.hasNext(); ++links) {
        const QString file = found.next().captured(1);
        QVERIFY2(QFile::exists(sourcePath("docs/") + file), qPrintable(file));
    }
    QVERIFY(links > 0);
}

QTEST_GUILESS_MAIN(TestAuthoringPage)
#include "test_authoring_page.moc"
