// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/question_field.h"

#include "views/icons.h"
#include "views/task_pane/answer_row.h"
#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QJsonArray>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int textHeight = 84;      ///< px
constexpr int longestAnswer = 2000; ///< characters
constexpr int longestNumber = 80;   ///< characters

QVBoxLayout *makeColumn(QWidget *widget)
{
    auto *column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 2, 0, 2);
    column->setSpacing(4);
    return column;
}

class NumberField final : public QuestionField
{
public:
    explicit NumberField(const Question &question)
        : m_line(new QLineEdit)
    {
        m_line->setObjectName(QStringLiteral("answer-") + question.id);
        m_line->setAccessibleName(question.title);
        m_line->setMaxLength(longestNumber);
        m_line->setPlaceholderText(question.unit.isEmpty()
                                       ? QuestionField::tr("a number")
                                       : QuestionField::tr("a number with its unit"));
        makeColumn(this)->addWidget(m_line);
        connect(m_line, &QLineEdit::textEdited, this,
                [this](const QString &text) { emit answered(text.trimmed()); });
    }

    void showAnswer(const QJsonValue &answer) override
    {
        if (m_line->text().trimmed() != answer.toString())
            m_line->setText(answer.toString());
    }

private:
    QLineEdit *m_line;
};

class TextField final : public QuestionField
{
public:
    explicit TextField(const Question &question)
        : m_edit(new QPlainTextEdit)
    {
        m_edit->setObjectName(QStringLiteral("answer-") + question.id);
        setKind(m_edit, "field");
        m_edit->setAccessibleName(question.title);
        m_edit->setTabChangesFocus(true);
        m_edit->setFixedHeight(textHeight);
        m_edit->setPlaceholderText(QuestionField::tr("In a few sentences, for the teacher"));
        makeColumn(this)->addWidget(m_edit);
        connect(m_edit, &QPlainTextEdit::textChanged, this, [this] {
            if (!m_showing)
                emit answered(m_edit->toPlainText().trimmed().left(longestAnswer));
        });
    }

    void showAnswer(const QJsonValue &answer) override
    {
        if (m_edit->toPlainText().trimmed() == answer.toString())
            return;
        m_showing = true;
        m_edit->setPlainText(answer.toString());
        m_showing = false;
    }

private:
    QPlainTextEdit *m_edit;
    bool m_showing = false;
};

/// One or several of the answers.
class ChoiceField final : public QuestionField
{
public:
    explicit ChoiceField(const Question &question)
        : m_group(new QButtonGroup(this))
        , m_several(question.kind == Question::Kind::Several)
    {
        m_group->setExclusive(!m_several);
        QVBoxLayout *column = makeColumn(this);
        for (int i = 0; i < static_cast<int>(question.answers.size()); ++i) {
            QAbstractButton *button = m_several ? static_cast<QAbstractButton *>(new QCheckBox)
                                                : static_cast<QAbstractButton *>(new QRadioButton);
            button->setObjectName(QStringLiteral("answer-%1-%2").arg(question.id).arg(i + 1));
            addAnswerRow(column, button, question.answers[i]);
            m_group->addButton(button, i);
        }
        connect(m_group, &QButtonGroup::idClicked, this, [this] { emit answered(chosen()); });
    }

    void showAnswer(const QJsonValue &answer) override
    {
        const QJsonArray list = answer.isArray() ? answer.toArray() : QJsonArray{answer};
        m_group->setExclusive(false); // else none could be left unchecked
        for (QAbstractButton *button : m_group->buttons())
            button->setChecked(list.contains(m_group->id(button) + 1));
        m_group->setExclusive(!m_several);
    }

private:
    [[nodiscard]] QJsonValue chosen() const
    {
        if (!m_several)
            return m_group->checkedId() + 1;
        QJsonArray list;
        for (QAbstractButton *button : m_group->buttons()) {
            if (button->isChecked())
                list.append(m_group->id(button) + 1);
        }
        return list;
    }

    QButtonGroup *m_group;
    bool m_several;
};

/// The answers in a list that is put in order.
class OrderField final : public QuestionField
{
public:
    explicit OrderField(const Question &question)
        : m_question(question)
        , m_list(new QListWidget)
        , m_up(makeButton(u"up", QuestionField::tr("Move up"), QuestionField::tr("Alt+Up")))
        , m_down(makeButton(u"down", QuestionField::tr("Move down"), QuestionField::tr("Alt+Down")))
    {
        m_list->setObjectName(QStringLiteral("answer-") + question.id);
        m_list->setAccessibleName(question.title);
        m_list->setWordWrap(true);
        m_list->setDragDropMode(QAbstractItemView::InternalMove);
        m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        auto *row = new QHBoxLayout;
        row->addWidget(m_list, 1);
        auto *buttons = new QVBoxLayout;
        buttons->addWidget(m_up);
        buttons->addWidget(m_down);
        buttons->addStretch(1);
        row->addLayout(buttons);
        makeColumn(this)->addLayout(row);
        connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
        connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
        addKey(QKeySequence(Qt::ALT | Qt::Key_Up), -1);
        addKey(QKeySequence(Qt::ALT | Qt::Key_Down), 1);
        connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &OrderField::tell);
        showOrder(shownOrder(m_question));
    }

    void showAnswer(const QJsonValue &answer) override
    {
        std::vector<int> order;
        for (const QJsonValue &each : answer.toArray())
            order.push_back(each.toInt() - 1);
        std::vector<int> sorted = order;
        std::sort(sorted.begin(), sorted.end());
        bool whole = sorted.size() == static_cast<std::size_t>(m_question.answers.size());
        for (std::size_t i = 0; i < sorted.size(); ++i)
            whole = whole && sorted[i] == static_cast<int>(i);
        order = whole ? order : shownOrder(m_question);
        if (order != shown())
            showOrder(order);
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QuestionField::resizeEvent(event);
        m_list->doItemsLayout();
        int height = 2 * m_list->frameWidth();
        for (int i = 0; i < m_list->count(); ++i)
            height += m_list->sizeHintForRow(i);
        m_list->setFixedHeight(height + 4);
    }

private:
    static QToolButton *makeButton(QStringView name, const QString &text, const QString &keys)
    {
        auto *button = new QToolButton;
        button->setAutoRaise(true);
        button->setIcon(icon(name, IconTint::Muted));
        button->setAccessibleName(text);
        button->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys));
        return button;
    }

    void addKey(const QKeySequence &keys, int by)
    {
        auto *shortcut = new QShortcut(keys, m_list);
        shortcut->setContext(Qt::WidgetShortcut);
        connect(shortcut, &QShortcut::activated, this, [this, by] { move(by); });
    }

    [[nodiscard]] std::vector<int> shown() const
    {
        std::vector<int> order;
        for (int i = 0; i < m_list->count(); ++i)
            order.push_back(m_list->item(i)->data(Qt::UserRole).toInt());
        return order;
    }

    void showOrder(const std::vector<int> &order)
    {
        m_list->clear();
        for (const int index : order) {
            auto *item = new QListWidgetItem(withUnits(m_question.answers.value(index)), m_list);
            item->setData(Qt::UserRole, index);
        }
        m_list->setCurrentRow(0);
    }

    void move(int by)
    {
        const int at = m_list->currentRow();
        const int to = at + by;
        if (at < 0 || to < 0 || to >= m_list->count())
            return;
        m_list->insertItem(to, m_list->takeItem(at));
        m_list->setCurrentRow(to);
        tell();
    }

    void tell()
    {
        QJsonArray order;
        for (const int index : shown())
            order.append(index + 1);
        emit answered(order);
    }

    Question m_question;
    QListWidget *m_list;
    QToolButton *m_up;
    QToolButton *m_down;
};

} // namespace

std::unique_ptr<QuestionField> makeQuestionField(const Question &question)
{
    switch (question.kind) {
    case Question::Kind::Number:
        return std::make_unique<NumberField>(question);
    case Question::Kind::One:
    case Question::Kind::Several:
        return std::make_unique<ChoiceField>(question);
    case Question::Kind::Order:
        return std::make_unique<OrderField>(question);
    case Question::Kind::Text:
        break;
    }
    return std::make_unique<TextField>(question);
}

} // namespace cradle
