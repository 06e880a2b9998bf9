// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/reading/lab_reader.h"
#include "tests/test_paths.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

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
    void everyKeyOfASceneIsDescribed_data();
    void everyKeyOfASceneIsDescribed();
    void filesShownAreThoseOfTheLab();
    void linksLeadSomewhere();

private:
    QString m_page;
};

namespace {

QString textOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A value as it stands in task.json.
QString jsonText(const QJsonValue &value)
{
    const QByteArray text = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(text.mid(1, text.size() - 2))
        .replace(QLatin1Char(','), QLatin1String(", "))
        .replace(QLatin1Char(':'), QLatin1String(": "));
}

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

QJsonObject jsonOf(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

/// A key of preset.json as its schema has it, and what it is if left out.
struct SceneKey {
    QString place; ///< "circle/radius"
    QJsonObject schema{};
    QJsonValue standard{QJsonValue::Undefined}; ///< undefined: needed
};

/// Adds the keys of an object of the schema.
void addKeys(std::vector<SceneKey> &keys, const QString &place, const QJsonObject &object,
             const QJsonObject &definitions, const QJsonObject &standards)
{
    const QJsonArray needed = object.value(QStringLiteral("required")).toArray();
    const QJsonObject properties = object.value(QStringLiteral("properties")).toObject();
    for (auto it = properties.begin(); it != properties.end(); ++it) {
        QJsonObject schema = it->toObject();
        const QString other = schema.value(QStringLiteral("$ref")).toString();
        if (!other.isEmpty())
            schema = definitions.value(other.section(QLatin1Char('/'), -1)).toObject();
        SceneKey key{.place = place + QLatin1Char('/') + it.key(), .schema = schema};
        if (!needed.contains(it.key()))
            key.standard = standards.value(it.key());
        keys.push_back(key);
    }
}

/// All keys of a scene, but for those of laws the object alone.
std::vector<SceneKey> keysOfScenes()
{
    const QString path = sourcePath("resources/schemas/preset.schema.json");
    const QJsonObject schema = jsonOf(textOf(path).toUtf8());
    const QJsonObject definitions = schema.value(QStringLiteral("definitions")).toObject();
    // What a scene with as little as possible comes to.
    const auto standards = [](const char *circles) {
        const QByteArray text = QByteArray("{\"format\": 1, \"circles\": ") + circles + "}";
        return jsonOf(writePreset(*parsePreset(text, QString())));
    };
    const QJsonObject one = standards("[{\"position\": [0, 0]}]");
    const QJsonObject crowd = standards("{\"fill\": {\"count\": 1, \"radius\": 1}}");
    const auto inside = [](const QJsonObject &object, const char *key) {
        return object.value(QLatin1String(key)).toObject();
    };
    const QJsonObject properties = inside(schema, "properties");
    std::vector<SceneKey> keys;
    addKeys(keys, QStringLiteral("scene"), schema, definitions, one);
    addKeys(keys, QStringLiteral("square"), inside(properties, "square"), definitions, {});
    addKeys(keys, QStringLiteral("laws"), inside(properties, "laws"), definitions,
            inside(one, "laws"));
    addKeys(keys, QStringLiteral("circle"), inside(definitions, "circle"), definitions,
            one.value(QStringLiteral("circles")).toArray().at(0).toObject());
    addKeys(keys, QStringLiteral("fill"), inside(definitions, "fill"), definitions,
            inside(inside(crowd, "circles"), "fill"));
    return keys;
}

/// What the row of \p key must say: its bounds, its words and what it is if left out.
QStringList saidOf(const SceneKey &key)
{
    QStringList said;
    QJsonObject bounds = key.schema;
    if (bounds.contains(QStringLiteral("items")))
        bounds = bounds.value(QStringLiteral("items")).toObject();
    if (bounds.contains(QStringLiteral("minimum")))
        said.append(QStringLiteral(", %1 to %2")
                        .arg(bounds.value(QStringLiteral("minimum")).toDouble(), 0, 'g', 10)
                        .arg(bounds.value(QStringLiteral("maximum")).toDouble(), 0, 'g', 10));
    QStringList words;
    for (const QJsonValue &word : key.schema.value(QStringLiteral("enum")).toArray())
        words.append(QLatin1Char('`') + word.toVariant().toString() + QLatin1Char('`'));
    said.append(words.join(QStringLiteral(", ")));
    if (key.standard.isUndefined())
        said.append(QStringLiteral("| needed"));
    else if (!key.place.endsWith(QLatin1String("/laws"))) // its keys have rows of their own
        said.append(QStringLiteral("| `") + jsonText(key.standard) + QLatin1Char('`'));
    return said;
}

} // namespace

void TestAuthoringPage::initTestCase()
{
    m_page = textOf(sourcePath("docs/authoring.md"));
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

void TestAuthoringPage::everyKeyOfASceneIsDescribed_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QStringList>("said");
    for (const SceneKey &key : keysOfScenes())
        QTest::newRow(qPrintable(key.place))
            << key.place.section(QLatin1Char('/'), -1) << saidOf(key);
}

void TestAuthoringPage::everyKeyOfASceneIsDescribed()
{
    QFETCH(QString, key);
    QFETCH(QStringList, said);
    const QString section = m_page.section(QStringLiteral("\n## preset.json\n"), 1)
                                .section(QStringLiteral("\n## "), 0, 0);
    const QStringList rows =
        section.split(QLatin1Char('\n'))
            .filter(QRegularExpression(QStringLiteral("^\\| `%1` \\|").arg(key)));
    const bool isSaid = std::any_of(rows.begin(), rows.end(), [&](const QString &row) {
        return std::all_of(said.begin(), said.end(),
                           [&](const QString &part) { return row.contains(part); });
    });
    QVERIFY2(isSaid, qPrintable(said.join(QStringLiteral("; "))));
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
