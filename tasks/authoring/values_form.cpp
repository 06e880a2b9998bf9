// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/values_form.h"

#include "model/world/shortest_number.h"
#include "tasks/authoring/lab_json.h"
#include "tasks/values/lab_values.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

const QString valuesKey = QStringLiteral("values");
const QString drawKey = QStringLiteral("draw");

QString pathOf(const QString &step)
{
    return step.isEmpty() ? indexFile : taskPath(step);
}

const char *valuesSchema(const QString &step)
{
    return step.isEmpty() ? labSchema : taskSchema;
}

ValueForm formOf(const QString &name, const QJsonValue &json)
{
    ValueForm value{.name = name};
    if (json.isObject()) {
        const QJsonObject range = json.toObject();
        value.drawn = true;
        value.from = range.value(QStringLiteral("from")).toDouble();
        value.to = range.value(QStringLiteral("to")).toDouble();
        value.step = range.value(QStringLiteral("step")).toDouble();
    } else {
        value.expression = json.isDouble() ? shortestNumber(json.toDouble()) : json.toString();
    }
    return value;
}

QJsonValue writtenOf(const ValueForm &value)
{
    if (value.drawn)
        return QJsonObject{{QStringLiteral("from"), value.from},
                           {QStringLiteral("to"), value.to},
                           {QStringLiteral("step"), value.step}};
    bool plain = false;
    const double number = value.expression.toDouble(&plain);
    return plain && std::isfinite(number) ? QJsonValue(number) : QJsonValue(value.expression);
}

/// Whether an expression in \p text names the value: in a text between braces, in a scene or among
/// other values in any string of JSON.
bool names(const QString &path, const QString &text, const QString &name)
{
    const QString word = QStringLiteral("(?<![A-Za-z0-9_])%1(?![A-Za-z0-9_])").arg(name);
    const QRegularExpression marked(QStringLiteral("\\{\\{[^{}\\n]*%1[^{}\\n]*\\}\\}").arg(word));
    if (marked.match(text).hasMatch())
        return true;
    const QString file = path.section(QLatin1Char('/'), -1);
    if (!file.contains(QLatin1String("preset")) || !file.endsWith(QLatin1String(".json")))
        return false;
    // A scene's own names and words are followed by a colon, or follow one of these keys.
    const QRegularExpression expression(
        QStringLiteral("(?<!\"name\": )(?<!\"name\":)\"[^\"\\n]*%1[^\"\\n]*\"(?!\\s*:)").arg(word));
    return expression.match(text).hasMatch();
}

bool hasValue(const LabFiles &files, const QString &step, const QString &name)
{
    const std::vector<ValueForm> values = valueForms(files, step);
    return std::any_of(values.begin(), values.end(),
                       [&](const ValueForm &value) { return value.name == name; });
}

/// Whether another value of that file is made of it.
bool makesOthers(const LabFiles &files, const QString &step, const QString &name)
{
    const QRegularExpression word(QStringLiteral("(?<![A-Za-z0-9_])%1(?![A-Za-z0-9_])").arg(name));
    const std::vector<ValueForm> values = valueForms(files, step);
    return std::any_of(values.begin(), values.end(), [&](const ValueForm &value) {
        return value.name != name && !value.drawn && word.match(value.expression).hasMatch();
    });
}

} // namespace

std::vector<ValueForm> valueForms(const LabFiles &files, const QString &step)
{
    std::vector<ValueForm> values;
    const Result<QJsonObject> json = jsonOf(files, pathOf(step), valuesSchema(step));
    if (!json)
        return values;
    const QJsonObject written = json->value(valuesKey).toObject();
    for (auto it = written.begin(); it != written.end(); ++it)
        values.push_back(formOf(it.key(), it.value()));
    return values;
}

Result<LabFiles> withValueForms(const LabFiles &files, const QString &step,
                                const std::vector<ValueForm> &values)
{
    QJsonObject written;
    for (const ValueForm &value : values)
        written.insert(value.name, writtenOf(value));
    return withMember(files, pathOf(step), valuesSchema(step), valuesKey,
                      written.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(written));
}

QString faultOfValue(const LabFiles &files, const QString &step, const QString &name)
{
    std::vector<Error> faults;
    (void)valuesOf(files, step, {}, &faults);
    for (const Error &fault : faults) {
        if (fault.file == pathOf(step) && fault.pointer == QStringLiteral("/values/") + name)
            return fault.message;
    }
    return {};
}

int countOf(const ValueForm &value)
{
    const double steps = std::floor((value.to - value.from) / value.step + 1e-9);
    const bool right = value.drawn && value.step > 0.0 && steps >= 0.0 && steps < 1e6;
    return right ? static_cast<int>(steps) + 1 : 0;
}

std::vector<double> numbersOf(const ValueForm &value, int most)
{
    std::vector<double> numbers;
    const int count = std::min(countOf(value), most);
    numbers.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) // as they are drawn, see valuesOf()
        numbers.push_back(QString::number(value.from + i * value.step, 'g', 12).toDouble());
    return numbers;
}

QStringList filesUsing(const LabFiles &files, const QString &step, const QString &name)
{
    QStringList paths;
    QMap<QString, bool> hidden; ///< steps with one of that name themselves
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        const auto slash = it.key().indexOf(QLatin1Char('/'));
        const QString folder = slash < 0 ? QString() : it.key().left(slash);
        if (!step.isEmpty() && folder != step)
            continue;
        if (step.isEmpty() && !folder.isEmpty()) {
            if (!hidden.contains(folder))
                hidden.insert(folder, hasValue(files, folder, name));
            if (hidden.value(folder))
                continue;
        }
        const bool isValues = it.key() == pathOf(folder);
        if (names(it.key(), QString::fromUtf8(*it), name)
            || (isValues && makesOthers(files, folder, name)))
            paths.append(it.key());
    }
    return paths;
}

QString drawOf(const LabFiles &files)
{
    const Result<QJsonObject> json = jsonOf(files, indexFile, labSchema);
    return json ? json->value(drawKey).toString() : QString();
}

Result<LabFiles> withDraw(const LabFiles &files, const QString &draw)
{
    return withMember(files, indexFile, labSchema, drawKey,
                      draw.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(draw));
}

} // namespace cradle
