// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/broken_file.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QTextBlock>

namespace cradle {

BrokenFile::BrokenFile(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_heading(makeHeading(this))
    , m_reason(new QLabel(this))
    , m_note(makeMutedText(this))
    , m_text(makeFileText(QStringLiteral("brokenText"), this))
{
    m_reason->setWordWrap(true);
    m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setKind(m_reason, "warning");
    layOutColumn(this, {16, 12, 16, 12}, 8, {m_heading, m_reason, m_note, {m_text, 1}});
    retranslate();
    connect(m_text, &QPlainTextEdit::textChanged, this, &BrokenFile::takeText);
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        follow();
    });
}

bool BrokenFile::follow()
{
    const std::optional<Error> fault =
        brokenFile(m_document.files(), m_document.step(), m_document.language());
    if (!fault) {
        m_fault = {};
        return false;
    }
    const bool another = fault->file != m_fault.file;
    m_fault = *fault;
    const bool ofLab = fault->file == QLatin1String("lab.json");
    m_note->setText(ofLab ? tr("Until it can be read, nothing of the lab can be edited. Mend it "
                               "here; the steps come back by themselves.")
                          : tr("Until it can be read, nothing else of this step can be edited. "
                               "Mend it here; the tabs come back by themselves."));
    m_heading->setText(fault->file);
    m_reason->setText(fault->toString());
    m_text->setReadOnly(m_document.isReadOnly());
    const QString text = textOf(m_document.files(), fault->file);
    if (m_text->toPlainText() != text) {
        const QSignalBlocker blocker(m_text);
        m_text->setPlainText(text);
    }
    if (another && fault->line > 0) {
        QTextCursor cursor(m_text->document()->findBlockByNumber(fault->line - 1));
        m_text->setTextCursor(cursor);
        m_text->centerCursor();
    }
    return true;
}

void BrokenFile::takeText()
{
    if (m_fault.file.isEmpty())
        return;
    m_document.edit(tr("Mend %1").arg(m_fault.file),
                    withText(m_document.files(), m_fault.file, m_text->toPlainText()),
                    QStringLiteral("mend:") + m_fault.file);
}

void BrokenFile::retranslate()
{
    m_text->setAccessibleName(tr("Text of the file that cannot be read"));
}

} // namespace cradle
