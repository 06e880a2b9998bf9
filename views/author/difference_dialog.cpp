// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/difference_dialog.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/text/unified_diff.h"
#include "views/boxes.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>

namespace cradle {

namespace {

constexpr QSize firstSize{720, 480}; ///< px

} // namespace

QString differenceOf(const LabFiles &mine, const LabFiles &theirs)
{
    QStringList paths = mine.contents.keys() + theirs.contents.keys();
    paths.sort();
    paths.removeDuplicates();
    QString text;
    for (const QString &path : std::as_const(paths)) {
        const bool isMine = mine.contents.contains(path);
        const bool isTheirs = theirs.contents.contains(path);
        if (isMine && isTheirs && mine.contents.value(path) == theirs.contents.value(path))
            continue;
        text += QStringLiteral("--- %1\n+++ %2\n")
                    .arg(isMine ? path : DifferenceDialog::tr("(not in mine)"),
                         isTheirs ? path : DifferenceDialog::tr("(not in theirs)"));
        const bool binary =
            mine.contents.value(path).contains('\0') || theirs.contents.value(path).contains('\0');
        text += binary ? DifferenceDialog::tr("no text") + QLatin1Char('\n')
                       : unifiedDiff(textOf(mine, path), textOf(theirs, path));
    }
    return text;
}

DifferenceDialog::DifferenceDialog(const QString &question, const LabFiles &mine,
                                   const LabFiles &theirs, QWidget *parent)
    : QDialog(parent)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel, this))
{
    setWindowTitle(tr("Changed by another program"));
    resize(firstSize);
    auto *label = new QLabel(question, this);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    auto *caption = new QLabel(tr("From mine (−) to theirs (+):"), this);
    auto *text = new QPlainTextEdit(differenceOf(mine, theirs), this);
    text->setObjectName(QStringLiteral("difference"));
    text->setReadOnly(true);
    text->setFont(codeFont());
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setAccessibleName(tr("Difference of the two versions"));
    caption->setBuddy(text);
    layOutColumn(this, {16, 16, 16, 12}, 8, {label, caption, {text, 1}, m_buttons});
    QPushButton *cancel = m_buttons->button(QDialogButtonBox::Cancel);
    cancel->setDefault(true);
    cancel->setFocus();
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void DifferenceDialog::addChoice(const QString &text, int code)
{
    QPushButton *button = m_buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, code] { done(code); });
}

} // namespace cradle
