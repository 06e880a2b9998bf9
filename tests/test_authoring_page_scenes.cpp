// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "authoring_page.h"
#include "model/files/preset_json.h"
#include "tests/test_paths.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace cradle;

/// The page for authors describes every key of a scene.
class TestAuthoringPageScenes : public QObject
{
    Q_OBJECT
private slots:
    void everyKeyOfASceneIsDescribed_data();
    void everyKeyOfASceneIsDescribed();
};

namespace {

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

void TestAuthoringPageScenes::everyKeyOfASceneIsDescribed_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QStringList>("said");
    for (const SceneKey &key : keysOfScenes())
        QTest::newRow(qPrintable(key.place))
            << key.place.section(QLatin1Char('/'), -1) << saidOf(key);
}

void TestAuthoringPageScenes::everyKeyOfASceneIsDescribed()
{
    QFETCH(QString, key);
    QFETCH(QStringList, said);
    const QString section = authoringPage()
                                .section(QStringLiteral("\n## preset.json\n"), 1)
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

QTEST_GUILESS_MAIN(TestAuthoringPageScenes)
#include "test_authoring_page_scenes.moc"
