// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/answer_row.h"

#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QAbstractButton>
#include <QEvent>
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
        fitButton();
    }

protected:
    void changeEvent(QEvent *event) override
    {
        QLabel::changeEvent(event);
        if (event->type() == QEvent::FontChange)
            fitButton();
    }
    void mouseReleaseEvent(QMouseEvent *) override
    {
        m_button->setFocus(Qt::MouseFocusReason);
        m_button->click();
    }

private:
    /// Its indicator stands at the middle of the first line.
    void fitButton() { m_button->setMinimumHeight(fontMetrics().height()); }

    QAbstractButton *m_button;
};

} // namespace

void addAnswerRow(QVBoxLayout *column, QAbstractButton *button, const QString &text)
{
    button->setAccessibleName(text);
    setKind(button, "answer"); // the focus is seen at the indicator: its own text is empty
    auto *label = new AnswerLabel(button);
    label->setText(withUnits(text));
    auto *row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(button, 0, Qt::AlignTop);
    row->addWidget(label, 1);
    column->addLayout(row);
}

} // namespace cradle
