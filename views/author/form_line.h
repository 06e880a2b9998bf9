// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/shortest_number.h"

#include <QLineEdit>

#include <optional>

namespace cradle {

/// What a line of a form is about: a text of \p Form, or a number, beside which may stand the
/// expression that it was written as.
template <typename Form>
struct FormLine {
    const char *name;               ///< of the line as an object
    QString Form::*text = nullptr;  ///< of a number: the expression; empty: it is written as it is
    double Form::*number = nullptr; ///< nullptr: a text
    std::optional<double> usual{};  ///< the number that an empty line stands for

    /// What the line shows of \p form.
    [[nodiscard]] QString textIn(const Form &form) const
    {
        if (text && (!number || !(form.*text).isEmpty()))
            return form.*text;
        return form.*number == usual ? QString() : fractionOrNumber(form.*number);
    }
};

/// Makes the lines of a form; their captions are yet to be added.
template <typename Form, std::size_t count>
void makeLines(const FormLine<Form> (&lines)[count], QLineEdit *(&edits)[count], QWidget *parent)
{
    for (std::size_t i = 0; i < count; ++i) {
        edits[i] = new QLineEdit(parent);
        edits[i]->setObjectName(QLatin1String(lines[i].name));
    }
}

} // namespace cradle
