// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/checker.h"
#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QComboBox;
class QLabel;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

/// Tries one check of the open step on one of its programs, and says how that went. What it says
/// goes with the next edit: it is never older than the lab.
class CheckTrial final : public QWidget
{
    Q_OBJECT
public:
    explicit CheckTrial(AuthorDocument &document, QWidget *parent = nullptr);

    void setCheck(const QString &id); ///< empty: none, and the button is disabled
    /// Whether a field of it holds what is no value: then it is tried as it was before.
    void setRefused(bool refused);
    void setProgram(const QString &file); ///< "mistakes/NAME.lua", if the step has it

private:
    void wire();
    void retranslate();
    void reload();
    void forget();
    void attempt();
    void tell(const CheckReport &report);
    [[nodiscard]] QString wordsOf(const CheckReport &report) const;

    AuthorDocument &m_document;
    Checker m_checker;
    QString m_check;
    bool m_refused = false;
    QPushButton *m_try = nullptr;
    QComboBox *m_program = nullptr;
    QLabel *m_result = nullptr;
};

} // namespace cradle
