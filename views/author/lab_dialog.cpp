// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/lab_dialog.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/form_rows.h"
#include "views/author/text_languages.h"
#include "views/boxes.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace cradle {

namespace {

constexpr int leastWidth = 460;  ///< px
constexpr int longestText = 200; ///< characters, as in lab.schema.json
constexpr int longestId = 64;    ///< characters, as well

} // namespace

LabDialog::LabDialog(AuthorDocument &document, Purpose purpose, QWidget *parent)
    : QDialog(parent)
    , m_document(document)
    , m_purpose(purpose)
    , m_ownLanguage(languagesOf(document.files()).front())
{
    const bool copies = purpose == Purpose::Copy;
    setWindowTitle(copies ? tr("A copy of the lab") : tr("Properties of the lab"));
    setMinimumWidth(leastWidth);
    QFormLayout *form = makeFormRows();
    makeTitles(form);
    makeFields(form);
    QLabel *note = makeMutedText(this);
    // Plain text that goes from the right is drawn a space too far to the left, and cut there.
    note->setTextFormat(isRightToLeft() ? Qt::RichText : Qt::PlainText);
    note->setText(
        copies ? tr("The copy is a lab of its own, so it has an id of its own: who has "
                    "passed a step of the original has not passed that of the copy.")
               : tr("The progress of students is kept by the id. A corrected lab keeps its id and "
                    "gets a higher version; a new lab gets a new id."));
    m_refusal = makeRefusal(this);
    const bool readOnly = document.isReadOnly() && !copies;
    auto *buttons = new QDialogButtonBox(
        readOnly ? QDialogButtonBox::Close : QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &LabDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &LabDialog::reject);
    layOutColumn(this, {16, 16, 16, 12}, 12, {form, note, m_refusal, buttons});
    for (QLineEdit *line : findChildren<QLineEdit *>())
        line->setReadOnly(readOnly);
    m_language->setEnabled(!readOnly);
    if (copies)
        nameCopy();
}

void LabDialog::makeTitles(QFormLayout *form)
{
    const LabFiles &files = m_document.files();
    for (const QString &language : offeredLanguages(files)) {
        auto *line = new QLineEdit(this);
        line->setObjectName(QStringLiteral("labTitle.") + language);
        line->setMaxLength(longestText);
        const bool own = language == m_ownLanguage;
        if (const Result<LabForm> lab = labForm(files, language))
            line->setText(own || hasTitle(files, language) ? lab->title : QString());
        if (!own)
            line->setPlaceholderText(labForm(files)->title);
        addField(form, line);
        nameField(line, tr("Title, %1").arg(languageWithCode(language)));
        m_titles.push_back({language, line});
    }
}

void LabDialog::makeFields(QFormLayout *form)
{
    m_version = new QLineEdit(this);
    m_id = new QLineEdit(this);
    m_language = new QComboBox(this);
    m_version->setObjectName(QStringLiteral("labVersion"));
    m_id->setObjectName(QStringLiteral("labId"));
    m_language->setObjectName(QStringLiteral("labLanguage"));
    m_version->setMaxLength(longestText);
    for (const Title &title : m_titles)
        m_language->addItem(languageWithCode(title.language), title.language);
    m_language->setCurrentIndex(m_language->findData(m_ownLanguage));
    if (const Result<LabForm> lab = labForm(m_document.files())) {
        m_version->setText(lab->version);
        m_id->setText(lab->id);
    }
    for (QWidget *field : std::initializer_list<QWidget *>{m_version, m_id, m_language})
        addField(form, field);
    nameField(m_version, tr("Version"));
    nameField(m_id, tr("Id"), tr("Letters, digits, dots and dashes"));
    nameField(m_language, tr("Written in"),
              tr("The language of task.json and instructions.md; texts in others have files of "
                 "their own"));
}

void LabDialog::nameCopy()
{
    m_oldId = m_id->text();
    m_id->setText(m_oldId.left(longestId - 5) + QStringLiteral("-copy"));
    for (const Title &title : m_titles) {
        if (!title.line->text().isEmpty())
            title.line->setText(tr("%1 (copy)").arg(title.line->text()).left(longestText));
    }
}

Result<LabFiles> LabDialog::edited() const
{
    Result<LabFiles> files = m_document.files();
    for (const Title &title : m_titles) {
        const bool own = title.language == m_ownLanguage;
        Result<LabForm> lab = labForm(*files, title.language);
        if (!lab)
            return lab.error();
        lab->title = title.line->text().trimmed();
        if (own) {
            lab->id = m_id->text().trimmed();
            lab->version = m_version->text().trimmed();
        }
        if (own && lab->title.isEmpty())
            return Error{.message = tr("A title of 1 to 200 characters is right")};
        files = withLab(*files, *lab, title.language);
        if (!files)
            return files;
    }
    return withOwnLanguage(*files, m_language->currentData().toString());
}

void LabDialog::accept()
{
    const Result<LabFiles> files = edited();
    if (!files) {
        showRefusal(m_refusal, files.error().toString());
    } else if (m_purpose == Purpose::Copy) {
        if (m_id->text().trimmed() == m_oldId) {
            showRefusal(m_refusal, tr("Another id than that of the original is right"));
            return;
        }
        m_copy = *files;
        QDialog::accept();
    } else if (m_document.edit(tr("Edit the properties of the lab"), files)) {
        QDialog::accept();
    }
}

} // namespace cradle
