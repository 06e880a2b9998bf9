// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/versions_pane.h"

#include "tasks/text/line_diff.h"
#include "views/code/code_editor.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

enum Column { When, What, Change };
constexpr int leastPart = 120;    ///< px: a small window has no room for what it would like
constexpr int widthOfThree = 900; ///< px, in which the list and two programs lie side by side

struct PaneText {
    Q_DECLARE_TR_FUNCTIONS(VersionsPane)
};

QString whatOf(const VersionNote &note)
{
    switch (note.reason) {
    case VersionReason::Typed:
        return PaneText::tr("Written");
    case VersionReason::Before:
        return PaneText::tr("Before it was replaced");
    case VersionReason::Outside:
        return PaneText::tr("By another program");
    case VersionReason::Unsaved:
        return PaneText::tr("From another window");
    case VersionReason::Checked:
        break;
    }
    return note.passed == true ? PaneText::tr("✓ passed") : PaneText::tr("not passed");
}

/// Of today only the time: the column is narrow.
QString whenText(const QDateTime &when)
{
    const QDateTime local = when.toLocalTime();
    const QLocale locale;
    return local.date() == QDate::currentDate()
               ? locale.toString(local.time(), QLocale::ShortFormat)
               : locale.toString(local, QLocale::ShortFormat);
}

/// The first line that is new against the version before, or else the first that is gone.
QString changeOf(const QString &before, const QString &after)
{
    const std::vector<DiffLine> diff = lineDiff(before, after);
    for (const auto kind : {DiffLine::Kind::Added, DiffLine::Kind::Removed}) {
        for (const DiffLine &line : diff) {
            if (line.kind != kind || line.text.trimmed().isEmpty())
                continue;
            return kind == DiffLine::Kind::Added
                       ? PaneText::tr("line %1: %2").arg(line.after).arg(line.text.trimmed())
                       : PaneText::tr("without: %1").arg(line.text.trimmed());
        }
    }
    return diff.empty() ? QString() : PaneText::tr("the same program");
}

QWidget *titled(QLabel *title, QWidget *content)
{
    auto *whole = new QWidget;
    auto *column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    title->setWordWrap(true);
    title->setContentsMargins(12, 4, 6, 2);
    setKind(title, "heading");
    column->addWidget(title);
    column->addWidget(content, 1);
    whole->setMinimumWidth(leastPart);
    return whole;
}

} // namespace

VersionsPane::VersionsPane(QWidget *parent)
    : QWidget(parent)
    , m_parts(new QSplitter(Qt::Horizontal, this))
    , m_list(new QTreeWidget)
    , m_empty(new QLabel(this))
    , m_thenTitle(new QLabel)
    , m_nowTitle(new QLabel)
    , m_then(new CodeEditor)
    , m_now(new CodeEditor)
    , m_goBack(new QPushButton)
    , m_toPassed(new QPushButton)
{
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setColumnCount(3);
    m_list->header()->setStretchLastSection(true);
    m_empty->setWordWrap(true);
    m_empty->setMargin(12);
    m_then->setReadOnly(true);
    m_now->setReadOnly(true);
    auto *buttons = new QVBoxLayout; // side by side they do not fit, in German least of all
    buttons->setContentsMargins(8, 4, 8, 4);
    buttons->setSpacing(6);
    buttons->addWidget(m_goBack);
    buttons->addWidget(m_toPassed);
    buttons->addStretch();
    auto *choice = new QWidget;
    m_choice = new QBoxLayout(QBoxLayout::TopToBottom, choice);
    m_choice->setContentsMargins(0, 0, 0, 0);
    m_choice->setSpacing(0);
    m_choice->addWidget(m_empty, 1);
    m_choice->addWidget(m_list, 1);
    m_choice->addLayout(buttons);
    choice->setMinimumWidth(leastPart);
    auto *programs = new QSplitter(Qt::Horizontal);
    programs->addWidget(titled(m_thenTitle, m_then));
    programs->addWidget(titled(m_nowTitle, m_now));
    programs->setChildrenCollapsible(false);
    m_parts->addWidget(choice);
    m_parts->addWidget(programs);
    m_parts->setChildrenCollapsible(false);
    m_parts->setSizes({420, 720});
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_parts);
    setFocusProxy(m_list);
    m_list->viewport()->installEventFilter(this);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &VersionsPane::showChosen);
    connect(m_goBack, &QPushButton::clicked, this, [this] {
        if (const ShownVersion *version = chosen())
            emit goBackRequested(version->text);
    });
    connect(m_toPassed, &QPushButton::clicked, this, [this] {
        if (const ShownVersion *version = newestPassed())
            emit goBackRequested(version->text);
    });
    retranslate();
}

void VersionsPane::setVersions(const std::vector<ShownVersion> &versions)
{
    const QString before = chosen() ? chosen()->version.id : QString();
    m_versions = versions;
    fill();
    for (std::size_t i = 0; i < m_versions.size(); ++i) {
        if (m_versions[i].version.id == before)
            m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(i)));
    }
    if (!chosen() && !m_versions.empty())
        m_list->setCurrentItem(m_list->topLevelItem(0));
    showChosen();
}

void VersionsPane::fill()
{
    m_list->clear();
    for (std::size_t i = 0; i < m_versions.size(); ++i) {
        const auto &[version, text] = m_versions[i];
        const QString before = i + 1 < m_versions.size() ? m_versions[i + 1].text : QString();
        auto *row = new QTreeWidgetItem(m_list);
        row->setText(When, whenText(version.when));
        row->setText(What, whatOf(version.note));
        row->setText(Change, changeOf(before, text));
        row->setToolTip(Change, row->text(Change));
    }
    fitColumns();
    m_empty->setVisible(m_versions.empty());
    m_list->setVisible(!m_versions.empty());
}

/// The last column takes what is left, or else the list scrolls.
void VersionsPane::fitColumns()
{
    m_list->resizeColumnToContents(When);
    m_list->resizeColumnToContents(What);
    QHeaderView &header = *m_list->header();
    const int needed = header.sectionSizeHint(Change);
    const int left = m_list->viewport()->width() - header.sectionPosition(Change);
    header.setStretchLastSection(left >= needed);
    if (left < needed)
        header.resizeSection(Change, needed);
}

void VersionsPane::setPresent(const QString &text, bool mayChange)
{
    m_present = text;
    m_mayChange = mayChange;
    showChosen();
}

const ShownVersion *VersionsPane::chosen() const
{
    const int index = m_list->indexOfTopLevelItem(m_list->currentItem());
    return index >= 0 && index < static_cast<int>(m_versions.size())
               ? &m_versions[static_cast<std::size_t>(index)]
               : nullptr;
}

const ShownVersion *VersionsPane::newestPassed() const
{
    const auto found =
        std::find_if(m_versions.begin(), m_versions.end(),
                     [](const ShownVersion &each) { return each.version.note.passed == true; });
    return found == m_versions.end() ? nullptr : &*found;
}

void VersionsPane::showChosen()
{
    const ShownVersion *version = chosen();
    m_then->replaceText(version ? version->text : QString());
    m_now->replaceText(m_present);
    std::vector<int> gone;
    std::vector<int> come;
    if (version) {
        for (const DiffLine &line : lineDiff(version->text, m_present)) {
            if (line.kind == DiffLine::Kind::Removed)
                gone.push_back(line.before);
            else if (line.kind == DiffLine::Kind::Added)
                come.push_back(line.after);
        }
    }
    m_then->setChanged(gone);
    m_now->setChanged(come);
    if (!gone.empty())
        m_then->revealLine(gone.front());
    if (!come.empty())
        m_now->revealLine(come.front());
    showButtons();
}

void VersionsPane::showButtons()
{
    const ShownVersion *version = chosen();
    const ShownVersion *passed = newestPassed();
    m_goBack->setEnabled(m_mayChange && version && version->text != m_present);
    m_toPassed->setEnabled(m_mayChange && passed && passed->text != m_present);
}

/// Where it is narrow the programs lie below the list: in a third of the width a line is cut before
/// what differs.
void VersionsPane::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool stacks = width() < widthOfThree && height() > width() / 2;
    const Qt::Orientation orientation = stacks ? Qt::Vertical : Qt::Horizontal;
    if (orientation == m_parts->orientation())
        return;
    m_parts->setOrientation(orientation);
    m_choice->setDirection(stacks ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_parts->setSizes(stacks ? QList{height() / 4, 3 * height() / 4} : QList{420, 720});
}

bool VersionsPane::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        fitColumns();
    return QWidget::eventFilter(watched, event);
}

void VersionsPane::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        setVersions(m_versions);
    }
    if (event->type() == QEvent::FontChange) // the list has it a little later
        QMetaObject::invokeMethod(this, &VersionsPane::fitColumns, Qt::QueuedConnection);
}

void VersionsPane::retranslate()
{
    setWindowTitle(tr("Versions"));
    m_list->setHeaderLabels({tr("When"), tr("Version"), tr("First difference")});
    m_list->setAccessibleName(tr("Versions of this step's program"));
    m_empty->setText(tr("Every Check keeps a version of your program here, and so do ten minutes "
                        "of writing."));
    m_thenTitle->setText(tr("The version"));
    m_nowTitle->setText(tr("Your program now"));
    m_then->setAccessibleName(tr("The version"));
    m_now->setAccessibleName(tr("Your program now"));
    m_goBack->setText(tr("&Go back to this"));
    m_goBack->setToolTip(tr("Your program now becomes a version, so nothing is lost"));
    m_toPassed->setText(tr("Back to what &passed"));
    m_toPassed->setToolTip(tr("To the newest version that passed this step"));
}

} // namespace cradle
