// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/values/lab_values.h"

#include "model/files/expression.h"
#include "tasks/values/put_values.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMessageAuthenticationCode>
#include <QtEndian>

#include <cmath>

namespace cradle {

namespace {

struct ValuesText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

const QString labPath = QStringLiteral("lab.json");
constexpr double mostDraws = 10'000; ///< numbers in a range
const QString fromKey = QStringLiteral("from");
const QString stepKey = QStringLiteral("step");

/// An object whatever is wrong with it: the reader tells of that.
QJsonObject objectIn(const LabFiles &files, const QString &path)
{
    return QJsonDocument::fromJson(files.contents.value(path)).object();
}

QString taskPath(const QString &step)
{
    return step + QStringLiteral("/task.json");
}

QJsonObject valuesIn(const LabFiles &files, const QString &path)
{
    return objectIn(files, path).value(QStringLiteral("values")).toObject();
}

/// Works out the values of one file; used once for each.
class Working
{
public:
    Working(const LabFiles &files, const QString &student, std::vector<Error> *faults)
        : m_lab(objectIn(files, labPath))
        , m_student(plainNumber(student))
        , m_faults(faults)
    {
    }

    void add(const QJsonObject &specs, const QString &path, Values &values)
    {
        QJsonObject open = specs;
        for (auto it = specs.begin(); it != specs.end(); ++it) {
            if (!isValueName(it.key()))
                fail(path, it.key(),
                     ValuesText::tr("a name of letters, digits and underscores that means nothing "
                                    "else is right"));
            else if (it->isDouble())
                values.insert(it.key(), it->toDouble());
            else if (it->isObject())
                values.insert(it.key(), drawn(it.key(), it->toObject(), path));
            else
                continue;
            open.remove(it.key());
        }
        addExpressions(open, path, values);
    }

private:
    /// One may be made of another, in any order.
    void addExpressions(QJsonObject open, const QString &path, Values &values)
    {
        for (bool found = true; found && !open.isEmpty();) {
            found = false;
            for (const QString &name : open.keys()) {
                if (const auto number = evaluated(open.value(name).toString(), values)) {
                    values.insert(name, *number);
                    open.remove(name);
                    found = true;
                }
            }
        }
        for (const QString &name : open.keys())
            fail(path, name, evaluated(open.value(name).toString(), values).error().message);
    }

    double drawn(const QString &name, const QJsonObject &range, const QString &path)
    {
        const int count = countOfRange(range);
        if (count == 0) {
            fail(path, name,
                 ValuesText::tr("a range from the least to the most, with a step that "
                                "is greater than 0, is right"));
            return range.value(fromKey).toDouble();
        }
        if (m_student.isEmpty())
            return range.value(fromKey).toDouble();
        const QByteArray key = (m_lab.value(QStringLiteral("id")).toString() + QLatin1Char('\n')
                                + m_lab.value(QStringLiteral("draw")).toString())
                                   .toUtf8();
        const QByteArray code = QMessageAuthenticationCode::hash(
            (path + QLatin1Char('\n') + name + QLatin1Char('\n') + m_student).toUtf8(), key,
            QCryptographicHash::Sha256);
        const quint64 number = qFromBigEndian<quint64>(code.constData());
        return numberOfRange(range, static_cast<int>(number % static_cast<quint64>(count)));
    }

    void fail(const QString &path, const QString &name, const QString &message)
    {
        if (m_faults)
            m_faults->push_back(
                {.message = message, .file = path, .pointer = QStringLiteral("/values/") + name});
    }

    QJsonObject m_lab;
    QString m_student;
    std::vector<Error> *m_faults;
};

/// A file with its values in it, or what is wrong with them.
Result<QByteArray> put(const QString &path, const QByteArray &bytes, const Values &values)
{
    const auto fail = [&](Error error) {
        error.file = path;
        return error;
    };
    const bool isJson = path.endsWith(QLatin1String(".json"));
    const bool isProgram =
        path.endsWith(QLatin1String(".lua")) || path.endsWith(QLatin1String(".diff"));
    const bool isText = path.endsWith(QLatin1String(".md"));
    if (!isJson && (values.isEmpty() || !bytes.contains("{{")))
        return bytes;
    if (isJson) {
        const QString name = path.section(QLatin1Char('/'), -1);
        const bool ofTexts = name == labPath || name.startsWith(QLatin1String("task."))
                             || name.startsWith(QLatin1String("lab."));
        if (ofTexts && values.isEmpty() && !bytes.contains("{{"))
            return bytes;
        const QJsonDocument json = QJsonDocument::fromJson(bytes);
        if (!json.isObject())
            return bytes; // told by the reader, with its line
        if (!ofTexts && !json.object().contains(QStringLiteral("circles")))
            return bytes; // answers, perhaps: no scene
        const auto result = ofTexts ? taskWithNumbers(json.object(), values)
                                    : sceneWithNumbers(json.object(), values);
        if (!result)
            return fail(result.error());
        return *result == json.object() ? bytes : QJsonDocument(*result).toJson();
    }
    if (!isProgram && !isText)
        return bytes;
    const auto text = withNumbers(QString::fromUtf8(bytes), values, isProgram);
    return text ? Result<QByteArray>(text->toUtf8()) : fail(text.error());
}

} // namespace

int countOfRange(const QJsonObject &range)
{
    const double from = range.value(fromKey).toDouble();
    const double to = range.value(QStringLiteral("to")).toDouble();
    const double step = range.value(stepKey).toDouble();
    const double steps = std::floor((to - from) / step + 1e-9);
    return step > 0.0 && steps >= 0.0 && steps < mostDraws ? static_cast<int>(steps) + 1 : 0;
}

double numberOfRange(const QJsonObject &range, int index)
{
    const double number = range.value(fromKey).toDouble() + index * range.value(stepKey).toDouble();
    return QString::number(number, 'g', 12).toDouble();
}

bool drawsValues(const LabFiles &files)
{
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (it.key() != labPath && !it.key().endsWith(QLatin1String("/task.json")))
            continue;
        const QJsonObject values = valuesIn(files, it.key());
        for (const QJsonValue &value : values) {
            if (value.isObject())
                return true;
        }
    }
    return false;
}

QString plainNumber(const QString &number)
{
    QString plain;
    for (const QChar letter : number.normalized(QString::NormalizationForm_KC).toCaseFolded()) {
        if (letter.isLetterOrNumber() && (letter != u'0' || !plain.isEmpty()))
            plain += letter;
    }
    return plain.isEmpty() ? number.simplified() : plain;
}

Values valuesOf(const LabFiles &files, const QString &step, const QString &student,
                std::vector<Error> *faults)
{
    Values values;
    Working working(files, student, faults);
    working.add(valuesIn(files, labPath), labPath, values);
    if (!step.isEmpty())
        working.add(valuesIn(files, taskPath(step)), taskPath(step), values);
    return values;
}

LabFiles withValues(const LabFiles &files, const QString &student, std::vector<Error> *faults)
{
    LabFiles result;
    QMap<QString, Values> steps;
    steps.insert(QString(), valuesOf(files, {}, student, faults));
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        const auto slash = it.key().indexOf(QLatin1Char('/'));
        const QString step = slash < 0 ? QString() : it.key().left(slash);
        if (!steps.contains(step)) {
            std::vector<Error> own; // those of lab.json are told
            steps.insert(step, valuesOf(files, step, student, &own));
            for (const Error &fault : own) {
                if (faults && fault.file != labPath)
                    faults->push_back(fault);
            }
        }
        const Result<QByteArray> bytes = put(it.key(), *it, steps.value(step));
        if (!bytes && faults)
            faults->push_back(bytes.error());
        // A text is readable all the same; a scene without its numbers is none.
        if (bytes || !it.key().endsWith(QLatin1String(".json")))
            result.contents.insert(it.key(), bytes ? *bytes : *it);
    }
    return result;
}

} // namespace cradle
