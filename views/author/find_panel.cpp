// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/find_panel.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QToolButton>

#include <algorithm>

namespace cradle {

namespace {

constexpr int listHeight = 150; ///< px
constexpr int soon = 150;       ///< ms after a key
constexpr int around = 40;      ///< letters that a row shows before the place
constexpr int longestRow = 160; ///< letters

/// The text of a hit, from near the place.
QString excerptOf(const LabHit &hit)
{
    const int from = std::max(hit.at - around, 0);
    QString text = hit.text.mid(from, longestRow).simplified();
    if (from > 0)
        text.prepend(QStringLiteral("…"));
    return from + longestRow < hit.text.size() ? text + QStringLiteral("…") : text;
}

QString placeOf(const LabHit &hit)
{
    return hit.line > 0 ? QStringLiteral("%1:%2").arg(hit.path).arg(hit.line)
                        : hit.path + QLatin1Char(' ') + hit.pointer.mid(1);
}

/// The line of a hit where the window shows it: differences are shown as whole programs.
int shownLineOf(const LabFiles &files, const LabHit &hit)
{
    if (!hit.path.endsWith(QLatin1String(".diff")))
        return hit.line;
    const Result<QString> whole = programText(files, hit.path.chopped(5) + QStringLiteral(".lua"));
    const QStringList lines = whole ? whole->split(QLatin1Char('\n')) : QStringList();
    for (int i = 0; i < lines.size(); ++i) {
        if (lines[i].endsWith(hit.text)) // the diagnosis is a comment there
            return i + 1;
    }
    return 0;
}

} // namespace

FindPanel::FindPanel(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(soon);
    makeLayout();
    keepTranslated(this, &FindPanel::retranslate);
    wire();
    hide();
}

void FindPanel::makeLayout()
{
    m_find = new QLineEdit(this);
    m_with = new QLineEdit(this);
    m_case = new QCheckBox(this);
    m_words = new QCheckBox(this);
    m_where = new ChoiceBox(this);
    m_count = new QLabel(this);
    m_replace = new QPushButton(this);
    m_close = makeIconButton(QStringLiteral("close"), this);
    m_list = new RowsList(QStringLiteral("findHits"), this);
    m_find->setObjectName(QStringLiteral("findText"));
    m_with->setObjectName(QStringLiteral("replaceText"));
    m_case->setObjectName(QStringLiteral("findCase"));
    m_words->setObjectName(QStringLiteral("findWords"));
    m_where->setObjectName(QStringLiteral("findWhere"));
    m_count->setObjectName(QStringLiteral("findCount"));
    setKind(m_count, "muted");
    setKind(m_replace, "small");
    m_list->setFixedHeight(listHeight);
    auto *row = makeRow({12, 6, 12, 6}, 8,
                        {makeCaption(m_find),
                         {m_find, 2},
                         makeCaption(m_with),
                         {m_with, 2},
                         m_replace,
                         m_case,
                         m_words,
                         m_where,
                         m_count,
                         m_close});
    layOutColumn(this, {}, 0, {row, m_list});
}

void FindPanel::wire()
{
    const auto later = [this] { m_soon.start(); };
    connect(m_find, &QLineEdit::textChanged, this, later);
    connect(m_case, &QCheckBox::toggled, this, &FindPanel::find);
    connect(m_words, &QCheckBox::toggled, this, &FindPanel::find);
    connect(m_where, &QComboBox::currentIndexChanged, this, &FindPanel::find);
    connect(&m_soon, &QTimer::timeout, this, &FindPanel::find);
    connect(&m_document, &AuthorDocument::changed, this, later);
    connect(&m_document, &AuthorDocument::stepChanged, this, later);
    connect(m_replace, &QPushButton::clicked, this, &FindPanel::replaceAll);
    connect(m_with, &QLineEdit::returnPressed, this, &FindPanel::replaceAll);
    connect(m_find, &QLineEdit::returnPressed, this, [this] {
        find();
        goTo(m_list->currentRow() + 1 < m_list->count() ? m_list->currentRow() + 1 : 0);
    });
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    connect(m_list, &RowsList::chosen, this, &FindPanel::goTo);
}

void FindPanel::open(const QString &text)
{
    show();
    if (!text.isEmpty())
        m_find->setText(text);
    m_find->setFocus();
    m_find->selectAll();
    find();
}

LabSearch FindPanel::search() const
{
    return {.text = m_find->text(),
            .matchCase = m_case->isChecked(),
            .wholeWords = m_words->isChecked(),
            .step = m_where->currentIndex() == 1 ? m_document.step() : QString()};
}

void FindPanel::find()
{
    m_soon.stop();
    if (!isVisible())
        return;
    const int row = m_list->currentRow();
    m_hits = findInLab(m_document.files(), search());
    m_list->clear();
    for (const LabHit &hit : m_hits)
        m_list->addItem(QStringLiteral("%1   %2").arg(placeOf(hit), excerptOf(hit)));
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    m_replace->setEnabled(!m_hits.empty() && !m_document.isReadOnly());
    showCount();
}

void FindPanel::showCount()
{
    int count = 0;
    QSet<QString> files;
    for (const LabHit &hit : m_hits) {
        count += hit.count;
        files.insert(hit.path);
    }
    m_count->setText(m_find->text().isEmpty() ? QString()
                     : count == 0             ? tr("Found nowhere")
                                              : tr("%n place(s)", nullptr, count) + QLatin1Char(' ')
                                        + tr("in %n file(s)", nullptr, int(files.size())));
}

void FindPanel::goTo(int row)
{
    if (row < 0 || row >= m_list->count())
        return;
    m_list->setCurrentRow(row);
    const LabHit &hit = m_hits[static_cast<std::size_t>(row)];
    emit chosen({.message = {},
                 .file = hit.path,
                 .pointer = hit.pointer,
                 .line = shownLineOf(m_document.files(), hit)});
}

void FindPanel::replaceAll()
{
    find();
    if (m_hits.empty() || m_document.isReadOnly())
        return;
    int count = 0;
    for (const LabHit &hit : m_hits)
        count += hit.count;
    const Result<LabFiles> files = replacedInLab(m_document.files(), search(), m_with->text());
    if (m_document.edit(tr("Replace “%1”").arg(m_find->text()), files))
        emit said(tr("%n place(s) replaced; Undo brings them back", nullptr, count));
    find();
}

void FindPanel::retranslate()
{
    nameField(m_find, tr("Find"), {}, tr("Text to find in the lab"));
    nameField(m_with, tr("Replace with"), {}, tr("Text to put there"));
    m_replace->setText(tr("Replace all"));
    m_replace->setToolTip(tr("In all places of the list, as one edit"));
    m_case->setText(tr("Match case"));
    m_words->setText(tr("Whole words"));
    m_where->setTexts({tr("In the whole lab"), tr("In this step")});
    m_where->setAccessibleName(tr("Where to look"));
    nameButton(m_close, tr("Close the search"), tr("Esc"));
    m_list->setAccessibleName(tr("Places that were found"));
    showCount();
}

void FindPanel::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QWidget::keyPressEvent(event);
}

} // namespace cradle
