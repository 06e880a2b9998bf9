// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/programs_tab.h"

#include "tasks/known_scripts.h"
#include "tasks/script/student_script.h"
#include "views/author/markdown_editor.h"
#include "views/author/tool_buttons.h"
#include "views/code/code_editor.h"
#include "views/icons.h"
#include "views/markdown_view.h"
#include "views/theme.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QSplitter>
#include <QToolButton>

#include <optional>

namespace cradle {

namespace {

constexpr int fileRole = Qt::UserRole;
constexpr int listWidth = 230; ///< px

/// The kind of the program in that file; none for starter and solution.
std::optional<KnownKind> kindOf(const QString &file)
{
    if (file.startsWith(QLatin1String("mistakes/")))
        return KnownKind::Mistake;
    return file.startsWith(QLatin1String("remarks/")) ? std::optional(KnownKind::Remark)
                                                      : std::nullopt;
}

QString nameOf(const QString &file)
{
    return QFileInfo(file).completeBaseName();
}

QString fileOf(KnownKind kind, const QString &name)
{
    return knownPath(QString(), kind, name).mid(1);
}

QString freeName(const QStringList &taken, const QString &wish)
{
    QString name = wish;
    for (int number = 2; taken.contains(name); ++number)
        name = QStringLiteral("%1-%2").arg(wish).arg(number);
    return name;
}

} // namespace

ProgramsTab::ProgramsTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    retranslate();
    wire();
    reload();
}

void ProgramsTab::makeLayout()
{
    m_heading = new QLabel(this);
    m_heading->setFont(headingFont());
    setKind(m_heading, "heading");
    m_list = new QListWidget(this);
    m_list->setObjectName(QStringLiteral("programs"));
    m_list->setFrameShape(QFrame::NoFrame);
    setKind(m_list, "rows");
    m_list->setIconSize({14, 14});
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->installEventFilter(this);
    m_add = makeIconButton(QStringLiteral("add"), this);
    m_addMenu = new QMenu(m_add);
    m_add->setMenu(m_addMenu);
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_rename = makeIconButton(QStringLiteral("settings"), this);
    m_remove = makeIconButton(QStringLiteral("remove"), this);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(12, 6, 6, 4);
    row->setSpacing(0);
    row->addWidget(m_heading, 1);
    for (QToolButton *button : {m_add, m_rename, m_remove})
        row->addWidget(button);
    auto *side = new QWidget(this);
    auto *left = new QVBoxLayout(side);
    left->setContentsMargins(0, 0, 0, 0);
    left->setSpacing(0);
    left->addLayout(row);
    left->addWidget(m_list, 1);

    m_note = new QLabel(this);
    m_note->setWordWrap(true);
    m_note->setContentsMargins(12, 8, 12, 6);
    setKind(m_note, "muted");
    m_editor = new CodeEditor(this);
    m_messagePane = new QWidget(this);
    m_messageHeading = new QLabel(m_messagePane);
    m_messageHeading->setContentsMargins(12, 6, 12, 2);
    setKind(m_messageHeading, "muted");
    m_translation = new MarkdownEditor(m_messagePane);
    m_translation->setObjectName(QStringLiteral("translation"));
    m_message = new MarkdownView(m_messagePane);
    auto *texts = new QHBoxLayout;
    texts->setSpacing(0);
    texts->addWidget(m_translation, 1);
    texts->addWidget(m_message, 1);
    auto *below = new QVBoxLayout(m_messagePane);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(0);
    below->addWidget(m_messageHeading);
    below->addLayout(texts, 1);
    m_splitter = new QSplitter(Qt::Vertical, this);
    m_splitter->addWidget(m_editor);
    m_splitter->addWidget(m_messagePane);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setSizes({420, 170});
    auto *main = new QWidget(this);
    auto *right = new QVBoxLayout(main);
    right->setContentsMargins(0, 0, 0, 0);
    right->setSpacing(0);
    right->addWidget(m_note);
    right->addWidget(m_splitter, 1);

    auto *halves = new QSplitter(Qt::Horizontal, this);
    halves->addWidget(side);
    halves->addWidget(main);
    halves->setChildrenCollapsible(false);
    halves->setStretchFactor(1, 1);
    halves->setSizes({listWidth, 800});
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(halves);
}

void ProgramsTab::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &ProgramsTab::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &ProgramsTab::reload);
    connect(&m_document, &AuthorDocument::languageChanged, this, &ProgramsTab::reload);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) {
        if (m_loading || !item)
            return;
        m_program = item->data(fileRole).toString();
        showText();
    });
    connect(m_list, &QListWidget::itemChanged, this, &ProgramsTab::takeName);
    connect(m_editor, &CodeEditor::textEdited, this, &ProgramsTab::takeSource);
    connect(m_translation, &MarkdownEditor::edited, this, &ProgramsTab::takeTranslation);
    connect(m_rename, &QToolButton::clicked, this, &ProgramsTab::renameProgram);
    connect(m_remove, &QToolButton::clicked, this, &ProgramsTab::removeProgram);
}

QString ProgramsTab::path() const
{
    return m_document.step() + QLatin1Char('/') + m_program;
}

bool ProgramsTab::isTranslation() const
{
    const Result<LabForm> form = labForm(m_document.files());
    return form && form->language != m_document.language();
}

void ProgramsTab::reload()
{
    setEnabled(!m_document.step().isEmpty());
    fillList();
    showText();
}

void ProgramsTab::fillList()
{
    const LabFiles &files = m_document.files();
    const QString &step = m_document.step();
    QStringList programs{QStringLiteral("starter.lua"), QStringLiteral("solution.lua")};
    for (const KnownKind kind : {KnownKind::Mistake, KnownKind::Remark}) {
        for (const QString &name : knownNames(files, step, kind))
            programs.append(fileOf(kind, name));
    }
    if (!programs.contains(m_program))
        m_program = QStringLiteral("solution.lua");
    m_loading = true;
    const QString listed = step + programs.join(QLatin1Char('\n'));
    if (listed != m_listed) {
        m_listed = listed;
        m_list->clear();
        for (const QString &program : programs) {
            auto *item = new QListWidgetItem(kindOf(program) ? nameOf(program) : program);
            item->setData(fileRole, program);
            item->setToolTip(program);
            if (kindOf(program))
                item->setFlags(item->flags() | Qt::ItemIsEditable);
            const bool remark = kindOf(program) == KnownKind::Remark;
            if (kindOf(program))
                item->setIcon(remark ? icon(u"hint", IconTint::Accent)
                                     : icon(u"failed", IconTint::Warning));
            m_list->addItem(item);
        }
    }
    m_list->setCurrentRow(static_cast<int>(programs.indexOf(m_program)));
    m_loading = false;
}

void ProgramsTab::showText()
{
    const bool writable = !m_document.isReadOnly();
    const bool known = kindOf(m_program).has_value();
    m_add->setEnabled(writable);
    m_rename->setEnabled(writable && known);
    m_remove->setEnabled(writable && (known || m_document.files().contents.contains(path())));
    const QString text = textOf(m_document.files(), path());
    m_editor->setReadOnly(false); // a read-only area takes no text at all
    if (m_shownPath != path())
        m_editor->setText(text);
    else
        m_editor->replaceText(text);
    m_editor->setReadOnly(!writable);
    m_shownPath = path();
    checkSyntax();
    showMessage();
    retranslate();
}

void ProgramsTab::checkSyntax()
{
    const auto error = findSyntaxError(m_editor->text());
    if (error)
        m_editor->setError(error->line, error->message);
    else
        m_editor->clearError();
}

void ProgramsTab::showMessage()
{
    const auto kind = kindOf(m_program);
    m_messagePane->setVisible(kind.has_value());
    if (!kind)
        return;
    QString message = firstCommentBlock(m_editor->text());
    m_translation->setVisible(isTranslation());
    m_translation->setReadOnly(m_document.isReadOnly());
    if (isTranslation()) {
        const QString own = knownText(m_document.files(), m_document.step(), *kind,
                                      nameOf(m_program), m_document.language());
        m_translation->showText(own);
        m_translation->setPlaceholderText(message);
        if (!own.isEmpty())
            message = own;
    }
    // The first line is the headline, as in the result.
    const QString headline = message.section(QLatin1Char('\n'), 0, 0);
    m_message->setMarkdown(
        QStringLiteral("**%1**\n%2").arg(headline, message.section(QLatin1Char('\n'), 1)), {});
}

void ProgramsTab::takeSource()
{
    checkSyntax();
    m_document.edit(tr("Edit a program"), withText(m_document.files(), path(), m_editor->text()),
                    QStringLiteral("program:") + path());
}

void ProgramsTab::takeTranslation(const QString &text)
{
    if (const auto kind = kindOf(m_program))
        m_document.edit(tr("Edit what the student reads"),
                        withKnownText(m_document.files(), m_document.step(), *kind,
                                      nameOf(m_program), m_document.language(), text),
                        QStringLiteral("message:") + path());
}

void ProgramsTab::addMistake()
{
    addKnown(KnownKind::Mistake);
}

void ProgramsTab::addRemark()
{
    addKnown(KnownKind::Remark);
}

void ProgramsTab::addKnown(KnownKind kind)
{
    const LabFiles &files = m_document.files();
    const bool mistake = kind == KnownKind::Mistake;
    const QString name = freeName(knownNames(files, m_document.step(), kind),
                                  mistake ? QStringLiteral("mistake") : QStringLiteral("remark"));
    const QString comment =
        mistake ? tr("-- What went wrong, in a few words\n--\n-- What was observed, what it means, "
                     "and where to look.\n")
                : tr("-- What is good about it, in a few words\n--\n-- What it does otherwise than "
                     "most, and what that is worth.\n");
    const QString solution = textOf(files, m_document.step() + QStringLiteral("/solution.lua"));
    m_program = fileOf(kind, name);
    if (m_document.edit(mistake ? tr("Add a mistake") : tr("Add a remark"),
                        withKnownAdded(files, m_document.step(), kind, name, comment + solution)))
        renameProgram();
}

void ProgramsTab::removeProgram()
{
    const auto kind = kindOf(m_program);
    if (kind)
        m_document.edit(
            tr("Remove a program"),
            withKnownRemoved(m_document.files(), m_document.step(), *kind, nameOf(m_program)));
    else
        m_document.edit(tr("Remove a program"), withoutFile(m_document.files(), path()));
}

void ProgramsTab::renameProgram()
{
    QListWidgetItem *item = m_list->currentItem();
    if (!item || m_document.isReadOnly() || !kindOf(m_program))
        return;
    m_list->setFocus();
    m_list->editItem(item);
}

void ProgramsTab::takeName(QListWidgetItem *item)
{
    const QString file = item->data(fileRole).toString();
    const auto kind = kindOf(file);
    const QString name = item->text().trimmed();
    if (m_loading || !kind || name == nameOf(file))
        return;
    // Queued: the list is filled anew by the edit, and its editor is still at work.
    QMetaObject::invokeMethod(
        this, [this, file, name] { renameTo(file, name); }, Qt::QueuedConnection);
}

void ProgramsTab::renameTo(const QString &file, const QString &name)
{
    const auto kind = kindOf(file);
    const Result<LabFiles> renamed =
        withKnownRenamed(m_document.files(), m_document.step(), *kind, nameOf(file), name);
    if (renamed && m_program == file)
        m_program = fileOf(*kind, name);
    m_listed.clear();
    if (!m_document.edit(tr("Rename a program"), renamed))
        reload();
}

void ProgramsTab::showProgram(const QString &file, int line)
{
    m_program = file;
    reload();
    if (line > 0)
        m_editor->goToLine(line);
    m_editor->setFocus();
}

bool ProgramsTab::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Delete && m_remove->isEnabled()) {
            removeProgram();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ProgramsTab::retranslate()
{
    m_heading->setText(tr("Programs"));
    m_list->setAccessibleName(tr("Programs of the step"));
    m_editor->setAccessibleName(tr("Program %1").arg(m_program));
    nameButton(m_add, tr("Add a program"));
    nameButton(m_rename, tr("Rename the program"), QStringLiteral("F2"));
    nameButton(m_remove, tr("Remove the program"), tr("Delete"));
    m_addMenu->clear();
    m_addMenu->addAction(tr("A &mistake that students make"), this, &ProgramsTab::addMistake);
    m_addMenu->addAction(tr("A &remark on work that passes"), this, &ProgramsTab::addRemark);
    m_messageHeading->setText(tr("What the student reads: the comment that the program begins "
                                 "with, or its translation"));
    m_translation->setAccessibleName(tr("What the student reads, translated"));
    const bool there = m_document.files().contents.contains(path());
    if (m_program == QLatin1String("starter.lua"))
        m_note->setText(there ? tr("What a student's program starts from in this step.")
                              : tr("None of its own: students go on from the solution of the step "
                                   "before. Write here to start from something else."));
    else if (m_program == QLatin1String("solution.lua"))
        m_note->setText(tr("The reference: it passes every check, with every seed."));
    else if (kindOf(m_program) == KnownKind::Mistake)
        m_note->setText(tr("A whole program with one mistake: it fails by a check, and who wrote "
                           "the same reads the comment that it begins with."));
    else
        m_note->setText(tr("A whole program that passes and deserves a word."));
}

void ProgramsTab::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace cradle
