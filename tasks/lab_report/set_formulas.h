// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <map>
#include <tuple>
#include <vector>

namespace cradle {

struct LabReport;

/// A formula of a report: its TeX, and how it is set; a plain value.
struct ReportFormula {
    QString tex{};
    bool display = false; ///< on a line of its own

    friend bool operator==(const ReportFormula &, const ReportFormula &) = default;
    friend bool operator<(const ReportFormula &a, const ReportFormula &b)
    {
        return std::tie(a.tex, a.display) < std::tie(b.tex, b.display);
    }
};

/// What became of it; lengths in ex, the height of an x in the text around it.
struct SetFormula {
    QByteArray svg{}; ///< one picture, drawn in currentColor
    double width = 0.0;
    double height = 0.0; ///< from the lowest to the highest point
    double depth = 0.0;  ///< the part of it below the baseline

    friend bool operator==(const SetFormula &, const SetFormula &) = default;
};

using SetFormulas = std::map<ReportFormula, SetFormula>;

/// All that the Markdown of a report asks for, each once; no more than a reader of a report bears.
[[nodiscard]] std::vector<ReportFormula> formulasOf(const LabReport &report);

// As JSON, for the way to the process that sets them. What cannot be read is left out.
[[nodiscard]] QByteArray textOf(const std::vector<ReportFormula> &formulas);
[[nodiscard]] std::vector<ReportFormula> formulasFrom(const QByteArray &text);
[[nodiscard]] QByteArray textOf(const SetFormulas &formulas);
[[nodiscard]] SetFormulas setFormulasFrom(const QByteArray &text);

} // namespace cradle
