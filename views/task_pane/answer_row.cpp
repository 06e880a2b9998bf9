// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/answer_row.h"

#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QAbstractButton>
#include <QLabel>
#include <QVBoxLayout>

namespace cradle {

namespace {

class AnswerLabel final : public QLabel
{
public:
    explicit AnswerLabel(QAbstractButton *button)
        : m_button(button)
    {
        setWordWrap(true);
        setTextFormat(Qt::PlainText);
        setKind(this, "plain");
        setBuddy(button);
    }

protected:
    void mouseReleaseEvent(QMouseEvent *) override
    {
        m_button->setFocus(Qt::MouseFocusReason);
        m_button->click();
    }

private:
    QAbstractButton *m_button;
};

} // namespace

void addAnswerRow(QVBoxLayout *column, QAbstractButton *button, const QString &text)
{
    button->setAccessibleName(text);
    auto *label = new AnswerLabel(button);
    label->setText(withUnits(text));
    auto *row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(button, 0, Qt::AlignTop);
    row->addWidget(label, 1);
    column->addLayout(row);
}

} // namespace cradle
