// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_search.h"

#include "tasks/authoring/json_patch.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/lab_json.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QRegularExpression>

#include <functional>

namespace cradle {

namespace {

struct SearchText {
    Q_DECLARE_TR_FUNCTIONS(LabSearch)
};

QRegularExpression patternOf(const LabSearch &search)
{
    QString pattern = QRegularExpression::escape(search.text);
    if (search.wholeWords)
        pattern = QStringLiteral("(?<![\\p{L}\\p{N}_])%1(?![\\p{L}\\p{N}_])").arg(pattern);
    return QRegularExpression(pattern, search.matchCase
                                           ? QRegularExpression::NoPatternOption
                                           : QRegularExpression::CaseInsensitiveOption);
}

bool isIn(const QString &path, const LabSearch &search)
{
    return search.step.isEmpty() || path.startsWith(search.step + QLatin1Char('/'));
}

bool isJson(const QString &path)
{
    return path.endsWith(QLatin1String(".json"));
}

bool isProgram(const QString &path)
{
    return path.endsWith(QLatin1String(".lua"));
}

bool isDifference(const QString &path)
{
    return path.endsWith(QLatin1String(".diff"));
}

/// Whether the members of that name are words of the format and no text of the author.
bool isWord(const QString &key)
{
    static const QStringList words{
        QStringLiteral("id"),         QStringLiteral("kind"),    QStringLiteral("colour"),
        QStringLiteral("integrator"), QStringLiteral("laws"),    QStringLiteral("integrators"),
        QStringLiteral("compare"),    QStringLiteral("preset"),  QStringLiteral("script"),
        QStringLiteral("language"),   QStringLiteral("version"), QStringLiteral("moves"),
        QStringLiteral("locked"),     QStringLiteral("steps"),   QStringLiteral("edition"),
        QStringLiteral("draw"),       QStringLiteral("unit")};
    return words.contains(key);
}

/// Every text of the author in a value of JSON, as \p make leaves it.
QJsonValue withTexts(const QJsonValue &value, const QString &place,
                     const std::function<QString(const QString &, const QString &)> &make)
{
    if (value.isString())
        return make(value.toString(), place);
    if (value.isArray()) {
        QJsonArray list = value.toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            list[i] = withTexts(list.at(i), QStringLiteral("%1/%2").arg(place).arg(i), make);
        return list;
    }
    if (!value.isObject())
        return value;
    QJsonObject object = value.toObject();
    for (const QString &key : object.keys()) {
        if (!isWord(key))
            object.insert(key, withTexts(object.value(key), place + QLatin1Char('/') + key, make));
    }
    return object;
}

const char *schemaOf(const QString &path)
{
    const QString name = path.section(QLatin1Char('/'), -1);
    if (name == QLatin1String("lab.json"))
        return labSchema;
    if (name == QLatin1String("task.json"))
        return taskSchema;
    return name.startsWith(QLatin1String("lab.")) || name.startsWith(QLatin1String("task."))
               ? translationSchema
               : nullptr; // a scene, whose numbers may be expressions
}

/// Finds, in order of the files.
class LabFinder
{
public:
    explicit LabFinder(const LabSearch &search)
        : m_pattern(patternOf(search))
    {
    }

    void look(const QString &path, const QByteArray &content)
    {
        if (isJson(path))
            lookAtJson(path, content);
        else if (isProgram(path) || isDifference(path) || path.endsWith(QLatin1String(".md")))
            lookAtLines(path, QString::fromUtf8(content));
    }
    [[nodiscard]] std::vector<LabHit> hits() && { return std::move(m_hits); }

private:
    void lookAtJson(const QString &path, const QByteArray &content)
    {
        const QJsonDocument json = QJsonDocument::fromJson(content);
        if (!json.isObject()) { // broken, which is when one looks for something in it
            lookAtLines(path, QString::fromUtf8(content));
            return;
        }
        (void)withTexts(json.object(), {}, [&](const QString &text, const QString &place) {
            add({.path = path, .pointer = place, .text = text});
            return text;
        });
    }

    void lookAtLines(const QString &path, const QString &text)
    {
        const QStringList lines = text.split(QLatin1Char('\n'));
        bool isHead = true; // of a difference: what the student reads
        for (qsizetype i = 0; i < lines.size(); ++i) {
            isHead = isHead && !lines[i].startsWith(QLatin1String("--- "));
            const bool isOwn = !isDifference(path) || isHead
                               || (lines[i].startsWith(QLatin1Char('+'))
                                   && !lines[i].startsWith(QLatin1String("+++ ")));
            const bool isMarked = isDifference(path) && !isHead;
            if (isOwn)
                add({.path = path,
                     .line = static_cast<int>(i) + 1,
                     .text = isMarked ? lines[i].mid(1) : lines[i]});
        }
    }

    void add(LabHit hit)
    {
        hit.count = 0;
        for (auto match = m_pattern.globalMatch(hit.text); match.hasNext();) {
            const auto at = static_cast<int>(match.next().capturedStart());
            if (hit.count++ == 0)
                hit.at = at;
        }
        if (hit.count > 0)
            m_hits.push_back(hit);
    }

    QRegularExpression m_pattern;
    std::vector<LabHit> m_hits{};
};

/// Not QString::replace(), for which "\1" in \p by means something.
QString replaced(const QString &text, const QRegularExpression &pattern, const QString &by)
{
    QString result;
    qsizetype from = 0;
    for (auto each = pattern.globalMatch(text); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        result += text.mid(from, match.capturedStart() - from) + by;
        from = match.capturedEnd();
    }
    return from == 0 ? text : result + text.mid(from);
}

/// One of the JSON files with the texts replaced.
Result<LabFiles> withJsonReplaced(const LabFiles &files, const QString &path,
                                  const std::function<QString(const QString &)> &put)
{
    const QByteArray content = files.contents.value(path);
    const QJsonDocument json = QJsonDocument::fromJson(content);
    if (!json.isObject()) {
        const QString text = QString::fromUtf8(content);
        if (put(text) == text)
            return files;
        return Error{.message = SearchText::tr("this file is broken, so nothing can be replaced "
                                               "in it, and nothing was replaced elsewhere; mend "
                                               "it first"),
                     .file = path};
    }
    const QJsonObject before = json.object();
    const QJsonObject after = withTexts(before, {}, [&](const QString &text, const QString &) {
                                  return put(text);
                              }).toObject();
    if (const char *schema = schemaOf(path))
        return withPatch(files, path, schema, before, after);
    return before == after
               ? files
               : withFile(files, path, patchJson(files.contents.value(path), before, after));
}

} // namespace

std::vector<LabHit> findInLab(const LabFiles &files, const LabSearch &search)
{
    if (search.text.isEmpty())
        return {};
    LabFinder finding(search);
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (isIn(it.key(), search))
            finding.look(it.key(), *it);
    }
    return std::move(finding).hits();
}

Result<LabFiles> replacedInLab(const LabFiles &files, const LabSearch &search,
                               const QString &replacement)
{
    if (search.text.isEmpty())
        return files;
    const QRegularExpression pattern = patternOf(search);
    const auto put = [&](const QString &text) { return replaced(text, pattern, replacement); };
    Result<LabFiles> result = files;
    QMap<QString, QString> known; // whole programs, from before the solutions are changed
    for (auto it = files.contents.begin(); result && it != files.contents.end(); ++it) {
        const QString &path = it.key();
        if (!isIn(path, search))
            continue;
        if (isJson(path)) {
            result = withJsonReplaced(*result, path, put);
        } else if (isDifference(path)) {
            const QString solution = textOf(files, path.section(QLatin1Char('/'), 0, 0)
                                                       + QStringLiteral("/solution.lua"));
            const QString kept = textOf(files, path);
            if (put(solution) == solution && put(kept) == kept)
                continue;
            const QString program = path.chopped(5) + QStringLiteral(".lua");
            const Result<QString> whole = programText(files, program);
            if (!whole)
                return whole.error();
            known.insert(program, put(*whole));
        } else if (isProgram(path) || path.endsWith(QLatin1String(".md"))) {
            result = withText(*result, path, put(textOf(files, path)));
        }
    }
    for (auto it = known.begin(); result && it != known.end(); ++it)
        result = withProgramText(*result, it.key(), *it);
    return result;
}

} // namespace cradle
