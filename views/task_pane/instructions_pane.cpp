// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/instructions_pane.h"

#include "views/focus_ring.h"
#include "views/formula_renderer.h"
#include "views/icons.h"
#include "views/markdown_view.h"
#include "views/on_change.h"
#include "views/task_pane/growing_text.h"
#include "views/task_pane/prediction_card.h"
#include "views/task_pane/questions_card.h"
#include "views/theme.h"

#include <QAbstractButton>
#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

/// Where the first section of \p markdown begins, behind its title and introduction; its length
/// if it has none.
qsizetype firstSection(const QString &markdown)
{
    static const QString fence = QStringLiteral("```");
    bool code = false;
    for (qsizetype start = 0; start < markdown.size();) {
        const qsizetype newline = markdown.indexOf(QLatin1Char('\n'), start);
        const qsizetype end = newline < 0 ? markdown.size() : newline + 1;
        const QStringView line = QStringView(markdown).mid(start, end - start);
        if (line.trimmed().startsWith(fence))
            code = !code;
        if (!code && line.startsWith(u"## "))
            return start;
        start = end;
    }
    return markdown.size();
}

/// The title of a step stands above, with its number, and is not said twice.
QString withoutTitle(const Task &task)
{
    const QString title = QStringLiteral("# ") + task.title;
    const qsizetype end = task.instructions.indexOf(QLatin1Char('\n'));
    const bool repeats = !task.id.isEmpty() && task.instructions.left(end).trimmed() == title;
    return repeats ? task.instructions.mid(end < 0 ? task.instructions.size() : end + 1)
                   : task.instructions;
}

} // namespace

InstructionsPane::InstructionsPane(QWidget *parent, FormulaRenderer *renderer)
    : QWidget(parent)
    , m_renderer(renderer ? renderer : new FormulaRenderer(this))
{
    makeLayout();
    keepTranslated(this, &InstructionsPane::retranslate);
}

InstructionsPane::~InstructionsPane()
{
    delete m_scroll; // the views before the renderer that they share
}

void InstructionsPane::makeLayout()
{
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(0);
    m_instructions = new MarkdownView(content, m_renderer);
    m_prediction = new PredictionCard(m_renderer, content);
    m_rest = new MarkdownView(content, m_renderer);
    m_questions = new QuestionsCard(m_renderer, content);
    m_hints = new MarkdownView(content, m_renderer);
    m_nextHint = new QPushButton(this);
    setKind(m_nextHint, "link");
    m_nextHint->setIcon(icon(u"hint", IconTint::Accent));
    column->addWidget(m_instructions);
    auto *card = new QHBoxLayout; // its frame stands where the texts begin
    card->setContentsMargins(12, 0, 12, 0);
    card->addWidget(m_prediction);
    column->addLayout(card);
    column->addWidget(m_rest);
    column->addWidget(m_questions);
    column->addWidget(m_hints);
    column->addStretch(1);
    for (MarkdownView *view : {m_instructions, m_rest, m_hints})
        addView(view);
    m_scroll = new QScrollArea(this);
    ringFocus(m_scroll);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(content);
    auto *outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->setSpacing(0);
    outer->addWidget(m_scroll, 1);
    // Below what scrolls, so that it is in sight however long the text is.
    auto *footer = new QHBoxLayout;
    footer->setContentsMargins(8, 2, 8, 2);
    footer->addWidget(m_nextHint, 0, Qt::AlignLeft);
    outer->addLayout(footer);
    // Also when the focus comes from another pane.
    connect(qApp, &QApplication::focusChanged, this, [this, content](QWidget *, QWidget *now) {
        if (qobject_cast<QAbstractButton *>(now) && content->isAncestorOf(now))
            m_scroll->ensureWidgetVisible(now, 0, 8);
    });
    connect(m_prediction, &PredictionCard::answered, this, &InstructionsPane::predicted);
    connect(m_prediction, &PredictionCard::outcomeRequested, this,
            &InstructionsPane::outcomeRequested);
    connect(m_questions, &QuestionsCard::answered, this, &InstructionsPane::answered);
    connect(m_nextHint, &QPushButton::clicked, this, [this] {
        setHintsOpened(m_opened + 1);
        emit hintOpened(m_opened);
        QTimer::singleShot(0, this, &InstructionsPane::revealHints);
    });
}

void InstructionsPane::addView(MarkdownView *view)
{
    growWithText(view);
    view->installEventFilter(this);
    connect(view, &MarkdownView::stepRequested, this, &InstructionsPane::stepRequested);
}

void InstructionsPane::showTask(const Task &task, int hintsOpened)
{
    followTask(task);
    m_scroll->verticalScrollBar()->setValue(0);
    m_opened = -1;
    setHintsOpened(hintsOpened);
}

void InstructionsPane::followTask(const Task &task)
{
    m_task = task;
    const QUrl folder = QUrl::fromLocalFile(task.folder);
    const QString text = withoutTitle(task);
    const qsizetype start = task.prediction ? firstSection(text) : -1;
    m_instructions->setMarkdown(text.left(start), folder);
    m_rest->setMarkdown(start < 0 ? QString() : text.mid(start), folder);
    m_rest->setVisible(start >= 0);
    m_prediction->setPrediction(task.prediction);
    m_questions->setQuestions(task.questions, folder);
    m_revealed = true; // only what is revealed before the student's eyes comes in sight
    m_opened = -1;
    setHintsOpened(0);
}

void InstructionsPane::setHintsOpened(int count)
{
    const int bounded = std::clamp(count, 0, static_cast<int>(m_task.hints.size()));
    if (bounded == m_opened)
        return;
    m_opened = bounded;
    showHints();
}

void InstructionsPane::setAnswers(const QJsonObject &answers)
{
    m_questions->setAnswers(answers);
}

void InstructionsPane::setGuess(const Guess &guess)
{
    m_prediction->setGuess(guess);
    if (guess.revealed && !m_revealed)
        QTimer::singleShot(0, this, &InstructionsPane::revealPrediction);
    m_revealed = guess.revealed;
}

void InstructionsPane::revealPrediction()
{
    m_scroll->ensureWidgetVisible(m_prediction, 0, 8);
}

void InstructionsPane::showHints()
{
    QString text;
    for (int i = 0; i < m_opened; ++i)
        text += QStringLiteral("**%1**\n\n%2\n\n").arg(tr("Hint %1").arg(i + 1), m_task.hints[i]);
    m_hints->setMarkdown(text, QUrl::fromLocalFile(m_task.folder));
    m_hints->setVisible(m_opened > 0);
    const auto all = static_cast<int>(m_task.hints.size());
    m_nextHint->setVisible(m_opened < all);
    m_nextHint->setText(tr("Hint %1 of %2 ▸").arg(m_opened + 1).arg(all));
    m_nextHint->setAccessibleName(tr("Show hint %1 of %2").arg(m_opened + 1).arg(all));
}

void InstructionsPane::revealHints()
{
    m_scroll->verticalScrollBar()->setValue(m_scroll->verticalScrollBar()->maximum());
}

void InstructionsPane::retranslate()
{
    m_instructions->setAccessibleName(tr("Instructions"));
    m_scroll->setAccessibleName(tr("Instructions"));
    m_rest->setAccessibleName(tr("Instructions"));
    m_hints->setAccessibleName(tr("Hints"));
    showHints();
}

/// The keys and the wheel that scroll a text scroll the pane, which holds the scroll bar.
bool InstructionsPane::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        QScrollBar *bar = m_scroll->verticalScrollBar();
        switch (static_cast<QKeyEvent *>(event)->key()) {
        case Qt::Key_Down:
            bar->triggerAction(QAbstractSlider::SliderSingleStepAdd);
            return true;
        case Qt::Key_Up:
            bar->triggerAction(QAbstractSlider::SliderSingleStepSub);
            return true;
        case Qt::Key_PageDown:
            bar->triggerAction(QAbstractSlider::SliderPageStepAdd);
            return true;
        case Qt::Key_PageUp:
            bar->triggerAction(QAbstractSlider::SliderPageStepSub);
            return true;
        default:
            break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace cradle
