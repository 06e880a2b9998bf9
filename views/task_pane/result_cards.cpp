// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/result_cards.h"

#include "views/markdown_view.h"
#include "views/task_pane/growing_text.h"
#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>

namespace cradle {

namespace {

struct CardText {
    Q_DECLARE_TR_FUNCTIONS(ResultPane)
};

QString headlineOf(const ProgramError &error)
{
    switch (error.kind) {
    case ProgramError::Kind::Syntax:
        return CardText::tr("The program cannot be read");
    case ProgramError::Kind::Time:
        return CardText::tr("The program takes too long");
    case ProgramError::Kind::Memory:
        return CardText::tr("The program needs too much memory");
    case ProgramError::Kind::Machine:
        return CardText::tr("Not judged");
    case ProgramError::Kind::Runtime:
        break;
    }
    return CardText::tr("The program stopped");
}

} // namespace

HeadedText splitHeadline(const QString &markdown)
{
    const auto end = markdown.indexOf(QLatin1Char('\n'));
    if (end < 0)
        return {markdown.trimmed(), {}};
    return {markdown.left(end).trimmed(), markdown.mid(end).trimmed()};
}

QVBoxLayout *addCard(QVBoxLayout *column, const char *kind, const QString &headline)
{
    auto *card = new QFrame;
    setKind(card, kind);
    auto *inner = new QVBoxLayout(card);
    inner->setContentsMargins(12, 8, 12, 8);
    inner->setSpacing(4);
    auto *title = new QLabel(headline);
    title->setWordWrap(true);
    title->setTextFormat(Qt::PlainText);
    setKind(title, qstrcmp(kind, "warningCard") == 0 ? "warningTitle" : "cardTitle");
    inner->addWidget(title);
    column->addWidget(card);
    return inner;
}

void addMarkdown(QVBoxLayout *column, const HeadedText &text, FormulaRenderer *renderer)
{
    if (text.body.isEmpty())
        return;
    auto *body = new MarkdownView(nullptr, renderer);
    body->setAccessibleName(text.headline);
    body->setEmbedded(true);
    growWithText(body);
    body->setMarkdown(text.body, {});
    column->addWidget(body);
}

HeadedText describeError(const ProgramError &error)
{
    QString where;
    if (error.line > 0)
        where = CardText::tr("Line %1").arg(error.line);
    if (error.step > 0) {
        const QString when = CardText::tr("in step %1, at %2 s")
                                 .arg(error.step)
                                 .arg(QString::number(error.time, 'g', 5));
        where += (where.isEmpty() ? QString() : QStringLiteral(", ")) + when;
    }
    const QString body = asSentence(error.message);
    return {headlineOf(error),
            where.isEmpty() ? body : CardText::tr("%1: %2", "place, message").arg(where, body)};
}

} // namespace cradle
