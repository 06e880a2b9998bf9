// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/set_formulas.h"

#include "tasks/lab_report/lab_report.h"
#include "tasks/text/formula_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <set>

namespace cradle {

namespace {

constexpr std::size_t mostFormulas = 500;
constexpr qsizetype longestFormula = 2000; ///< letters

const QString texKey = QStringLiteral("tex");
const QString displayKey = QStringLiteral("display");

QJsonObject jsonOf(const ReportFormula &formula)
{
    return {{texKey, formula.tex}, {displayKey, formula.display}};
}

ReportFormula formulaFrom(const QJsonObject &json)
{
    return {.tex = json.value(texKey).toString(), .display = json.value(displayKey).toBool()};
}

} // namespace

std::vector<ReportFormula> formulasOf(const LabReport &report)
{
    std::set<ReportFormula> formulas;
    for (const StepReport &step : report.steps) {
        for (const QString &markdown : {step.note, step.question}) {
            for (const FormulaSource &source : findFormulas(markdown).formulas) {
                if (formulas.size() < mostFormulas && source.tex.size() <= longestFormula)
                    formulas.insert({source.tex, source.display});
            }
        }
    }
    return {formulas.begin(), formulas.end()};
}

QByteArray textOf(const std::vector<ReportFormula> &formulas)
{
    QJsonArray list;
    for (const ReportFormula &formula : formulas)
        list.append(jsonOf(formula));
    return QJsonDocument(list).toJson();
}

std::vector<ReportFormula> formulasFrom(const QByteArray &text)
{
    std::vector<ReportFormula> formulas;
    const QJsonArray list = QJsonDocument::fromJson(text).array();
    for (const QJsonValue &value : list)
        formulas.push_back(formulaFrom(value.toObject()));
    return formulas;
}

QByteArray textOf(const SetFormulas &formulas)
{
    QJsonArray list;
    for (const auto &[formula, set] : formulas) {
        QJsonObject one = jsonOf(formula);
        one.insert(QStringLiteral("svg"), QString::fromUtf8(set.svg));
        one.insert(QStringLiteral("width"), set.width);
        one.insert(QStringLiteral("height"), set.height);
        one.insert(QStringLiteral("depth"), set.depth);
        list.append(one);
    }
    return QJsonDocument(list).toJson();
}

SetFormulas setFormulasFrom(const QByteArray &text)
{
    SetFormulas formulas;
    const QJsonArray list = QJsonDocument::fromJson(text).array();
    for (const QJsonValue &value : list) {
        const QJsonObject one = value.toObject();
        const SetFormula set{.svg = one.value(QStringLiteral("svg")).toString().toUtf8(),
                             .width = one.value(QStringLiteral("width")).toDouble(),
                             .height = one.value(QStringLiteral("height")).toDouble(),
                             .depth = one.value(QStringLiteral("depth")).toDouble()};
        if (set.svg.startsWith("<svg ") && set.width > 0.0 && set.height > 0.0)
            formulas[formulaFrom(one)] = set;
    }
    return formulas;
}

} // namespace cradle
