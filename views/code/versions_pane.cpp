// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/versions_pane.h"

#include "tasks/text/line_diff.h"
#include "views/code/code_editor.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int leastPart = 120;    ///< px: a small window has no room for what it would like
constexpr int widthOfThree = 900; ///< px, in which the list and two programs lie side by side

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
    , m_list(new VersionsList)
    , m_empty(new QLabel(this))
    , m_thenTitle(new QLabel)
    , m_nowTitle(new QLabel)
    , m_then(new CodeEditor)
    , m_now(new CodeEditor)
    , m_goBack(new QPushButton)
    , m_toPassed(new QPushButton)
{
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
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        setVersions(m_versions, m_present, m_mayChange);
    });
}

void VersionsPane::setVersions(const std::vector<ShownVersion> &versions, const QString &present,
                               bool mayChange)
{
    const QSignalBlocker quiet(m_list); // the choice is shown once, when all of it is there
    const QString before = chosen() ? chosen()->version.id : QString();
    m_versions = versions;
    m_present = present;
    m_mayChange = mayChange;
    m_list->fill(m_versions);
    m_empty->setVisible(m_versions.empty());
    m_list->setVisible(!m_versions.empty());
    for (std::size_t i = 0; i < m_versions.size(); ++i) {
        if (m_versions[i].version.id == before)
            m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(i)));
    }
    if (!chosen() && !m_versions.empty())
        m_list->setCurrentItem(m_list->topLevelItem(0));
    showChosen();
}

void VersionsPane::setPresent(const QString &present, bool mayChange)
{
    if (present == m_present && mayChange == m_mayChange)
        return; // who reads on in a version stays there
    m_present = present;
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

void VersionsPane::retranslate()
{
    setWindowTitle(tr("Versions"));
    m_list->retranslate();
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
