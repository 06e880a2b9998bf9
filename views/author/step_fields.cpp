// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/step_fields.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/form_rows.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace cradle {

namespace {

constexpr int idWidth = 110; ///< px
constexpr int fieldGap = 8;  ///< px

} // namespace

StepFields::StepFields(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_id(new QLineEdit(this))
    , m_title(new QLineEdit(this))
    , m_commit(new QLineEdit(this))
    , m_extra(new QCheckBox(this))
    , m_moves(new ChoiceBox(this))
{
    m_moves->setObjectName(QStringLiteral("stepMoves"));
    for (const char *who : {"either", "program", "laws"})
        m_moves->addItem(QString(), QString::fromLatin1(who));
    m_id->setObjectName(QStringLiteral("stepId"));
    m_title->setObjectName(QStringLiteral("stepTitle"));
    m_commit->setObjectName(QStringLiteral("stepCommit"));
    m_id->setMaximumWidth(idWidth);
    m_first = makeRow({}, fieldGap, {makeCaption(m_id), m_id, makeCaption(m_title), {m_title, 1}});
    m_second = makeRow({}, fieldGap, {makeCaption(m_commit), {m_commit, 1}, m_moves, m_extra});
    m_rows = new QBoxLayout(QBoxLayout::LeftToRight, this);
    m_rows->setSpacing(fieldGap);
    m_rows->setContentsMargins(12, 8, 12, 8);
    m_rows->addLayout(m_first, 1);
    m_rows->addLayout(m_second, 2);
    keepTranslated(this, &StepFields::retranslate);
    connect(m_id, &QLineEdit::editingFinished, this, &StepFields::takeId);
    connect(m_title, &QLineEdit::textEdited, this, [this] { takeFields(QStringLiteral("title")); });
    connect(m_commit, &QLineEdit::textEdited, this,
            [this] { takeFields(QStringLiteral("commit")); });
    connect(m_moves, &QComboBox::activated, this, [this] { takeFields(QStringLiteral("moves")); });
    connect(m_extra, &QCheckBox::clicked, this, [this] { takeFields(QStringLiteral("extra")); });
}

/// Side by side, where that fits.
void StepFields::arrange()
{
    const QMargins margins = m_rows->contentsMargins();
    const int oneRow = m_first->minimumSize().width() + fieldGap + m_second->minimumSize().width()
                       + margins.left() + margins.right();
    const auto wanted = oneRow <= width() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
    if (m_rows->direction() != wanted)
        m_rows->setDirection(wanted);
}

QSize StepFields::minimumSizeHint() const
{
    const QMargins margins = m_rows->contentsMargins();
    return {std::max(m_first->minimumSize().width(), m_second->minimumSize().width())
                + margins.left() + margins.right(),
            m_rows->minimumSize().height()};
}

bool StepFields::event(QEvent *event)
{
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        arrange();
    return done;
}

void StepFields::reload()
{
    for (QLineEdit *line : {m_id, m_title, m_commit})
        line->setReadOnly(m_document.isReadOnly());
    m_extra->setEnabled(!m_document.isReadOnly());
    m_moves->setEnabled(!m_document.isReadOnly());
    const Result<TaskForm> form = m_document.form();
    if (!form)
        return;
    if (m_shownStep != m_document.step() || !m_id->isModified())
        m_id->setText(m_document.step());
    m_shownStep = m_document.step();
    for (const auto &[line, text] :
         {std::pair(m_title, form->title), std::pair(m_commit, form->commit)}) {
        if (line->text() == text)
            continue;
        line->setText(text);
        line->setCursorPosition(0); // a long one is read from its beginning
    }
    m_extra->setChecked(form->extra);
    m_moves->setCurrentIndex(std::max(0, m_moves->findData(form->moves)));
}

void StepFields::takeId()
{
    const QString name = m_id->text().trimmed();
    if (!m_id->isModified() || name == m_document.step() || m_document.step().isEmpty())
        return;
    if (!m_document.editStep(tr("Rename the step's folder"),
                             withStepRenamed(m_document.files(), m_document.step(), name), name))
        m_id->setText(m_document.step());
}

void StepFields::takeFields(const QString &field)
{
    const auto take = [this](TaskForm &form) {
        form.title = m_title->text();
        form.commit = m_commit->text();
        form.extra = m_extra->isChecked();
        const QString moves = m_moves->currentData().toString();
        if (moves != form.moves && (m_moves->currentIndex() != 0 || !form.moves.isEmpty()))
            form.moves = moves;
    };
    m_document.editTask(tr("Edit the step"), take,
                        QStringLiteral("%1:%2").arg(field, m_document.step()));
}

void StepFields::retranslate()
{
    nameField(m_id, tr("Id"), tr("Letters, digits, dots and dashes; also the name of the folder"),
              tr("Id of the step, and its folder"));
    nameField(m_title, tr("Title"),
              tr("In the language that is open; also in the list of steps (F2)"),
              tr("Title of the step"));
    nameField(m_commit, tr("Commit message"),
              tr("What a student writes into the history after passing"));
    const QStringList movers{tr("Moved by program or laws"), tr("Moved by a program"),
                             tr("Moved by the laws")};
    m_moves->setTexts(movers);
    m_moves->setAccessibleName(tr("Who may move the circles"));
    m_moves->setToolTip(tr("What passes the step: a program of the student, the laws of the scene, "
                           "or either"));
    m_extra->setText(tr("Extra step"));
    m_extra->setToolTip(tr("Outside the lab's own count"));
}

} // namespace cradle
