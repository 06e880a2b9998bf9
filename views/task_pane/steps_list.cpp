// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/steps_list.h"

#include "views/on_change.h"
#include "views/task_pane/step_delegate.h"
#include "views/task_pane/step_dots.h"
#include "views/theme.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr QMargins titleMargins(12, 4, 4, 4); ///< px, around the name of the step
constexpr int titleEnd = 8;                   ///< px behind what stands beside it

} // namespace

StepsList::StepsList(QWidget *parent)
    : QWidget(parent)
{
    makeLayout();
    keepTranslated(this, &StepsList::retranslate);
}

void StepsList::makeLayout()
{
    m_heading = new QLabel(this);
    m_heading->setContentsMargins(titleMargins);
    setKind(m_heading, "cardTitle");
    m_heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_heading->setTextFormat(Qt::PlainText);
    m_heading->setWordWrap(true);
    m_all = new QPushButton(this);
    m_all->setCheckable(true);
    setKind(m_all, "link");
    m_dots = new StepDots(this);
    m_search = new QLineEdit(this);
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    m_search->hide();
    m_notice = new QPushButton(this);
    m_notice->setIcon(QIcon());
    m_notice->setCheckable(true);
    setKind(m_notice, "link");
    m_notice->hide();
    m_findings = new QLabel(this);
    m_findings->setWordWrap(true);
    m_findings->setTextFormat(Qt::PlainText);
    m_findings->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_findings->setContentsMargins(12, 0, 12, 6);
    setKind(m_findings, "warning");
    m_findings->hide();
    m_list = new QListWidget(this);
    m_list->setItemDelegate(new StepDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMouseTracking(true);
    m_list->setUniformItemSizes(true);
    m_list->setMinimumHeight(3 * StepDelegate::rowHeight);
    m_list->installEventFilter(this);
    m_list->hide();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    auto *noticeRow = new QHBoxLayout;
    noticeRow->setContentsMargins(8, 0, 8, 0);
    noticeRow->addWidget(m_notice);
    m_titleRow = new QHBoxLayout;
    m_titleRow->setContentsMargins(0, 4, titleEnd, 0);
    m_titleRow->addWidget(m_heading, 1);
    m_titleRow->addWidget(m_all, 0, Qt::AlignRight | Qt::AlignVCenter);
    auto *searchRow = new QHBoxLayout;
    searchRow->setContentsMargins(12, 0, 12, 0);
    searchRow->addWidget(m_search);
    column->addLayout(m_titleRow);
    column->addWidget(m_dots);
    column->addLayout(noticeRow);
    column->addWidget(m_findings);
    column->addLayout(searchRow);
    column->addWidget(m_list, 1);
    connect(m_notice, &QPushButton::toggled, m_findings, &QWidget::setVisible);
    const auto chosen = [this](QListWidgetItem *item) { choose(m_list->row(item)); };
    connect(m_list, &QListWidget::itemClicked, this, chosen);
    connect(m_list, &QListWidget::itemActivated, this, chosen);
    connect(m_dots, &StepDots::stepChosen, this, &StepsList::choose);
    connect(m_all, &QPushButton::toggled, this, &StepsList::setOpen);
    connect(m_search, &QLineEdit::textChanged, this, &StepsList::search);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        for (int i = 0; i < m_list->count(); ++i) {
            if (!m_list->item(i)->isHidden())
                return choose(i);
        }
    });
}

bool StepsList::isOpen() const
{
    return m_all->isChecked();
}

void StepsList::setOpen(bool open)
{
    m_all->setChecked(open);
    m_list->setVisible(open);
    m_search->setVisible(open);
    m_search->clear();
    if (open && m_current >= 0 && m_current < m_list->count())
        m_list->scrollToItem(m_list->item(m_current), QAbstractItemView::PositionAtCenter);
    if (open && m_all->hasFocus())
        m_search->setFocus();
    showProgress();
    emit openChanged(open);
}

void StepsList::search(const QString &text)
{
    const QString wanted = text.trimmed();
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setHidden(!m_list->item(i)->text().contains(wanted, Qt::CaseInsensitive));
}

/// Escape closes the list; from the field, Down goes into it.
bool StepsList::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Escape) {
            setOpen(false);
            m_dots->setFocus();
            return true;
        }
        if (key == Qt::Key_Down && watched == m_search) {
            m_list->setFocus();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StepsList::choose(int step)
{
    if (m_all->isChecked())
        setOpen(false);
    if (step >= 0 && step != m_current)
        emit stepChosen(step);
}

void StepsList::setLab(const Lab &lab)
{
    m_titles.clear();
    m_extra.clear();
    for (const Task &task : lab.tasks) {
        m_titles.append(task.title);
        m_extra.push_back(task.extra);
    }
    m_errors = lab.findings;
    m_passed.assign(lab.tasks.size(), false);
    m_current = -1;
    m_notice->setChecked(false);
    m_list->clear();
    for (int i = 0; i < m_titles.size(); ++i)
        m_list->addItem(QStringLiteral("%1 · %2").arg(i + 1).arg(m_titles[i]));
    retranslate();
}

void StepsList::setProgress(const std::vector<bool> &passed, int current)
{
    const bool moved = current != m_current;
    m_passed = passed;
    m_passed.resize(static_cast<std::size_t>(m_list->count()));
    m_current = current;
    showProgress();
    if (moved && current >= 0 && current < m_list->count()) {
        m_list->setCurrentRow(current);
        m_list->scrollToItem(m_list->item(current), QAbstractItemView::PositionAtCenter);
    }
}

void StepsList::showProgress()
{
    using State = StepDelegate::State;
    for (int i = 0; i < m_list->count(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool current = i == m_current;
        const State state = m_passed[k] ? State::Passed : current ? State::Current : State::Open;
        QListWidgetItem *item = m_list->item(i);
        item->setData(StepDelegate::stateRole, static_cast<int>(state));
        item->setData(StepDelegate::currentRole, current);
        item->setData(StepDelegate::tagRole, m_extra[k] ? tr("extra") : QString());
        const QString said = m_passed[k] ? tr("passed") : current ? tr("current") : tr("open");
        item->setData(Qt::AccessibleTextRole, QStringLiteral("%1, %2").arg(item->text(), said));
        item->setToolTip(item->text());
    }
    const auto reached = std::count(m_passed.begin(), m_passed.end(), true);
    m_dots->setSteps(m_titles, m_passed, m_current);
    const QString count = tr("Steps · %1 of %2").arg(reached).arg(m_list->count()); // passed
    const bool named = m_current >= 0 && m_current < m_list->count() && !isOpen();
    m_heading->setText(m_list->count() == 0 ? tr("Steps")
                       : named              ? m_list->item(m_current)->text()
                                            : count);
    m_heading->setToolTip(named ? m_heading->text() : tr("Steps passed"));
    m_all->setText(isOpen() ? tr("Close ▴") : tr("All steps ▾"));
    m_all->setToolTip(m_list->count() == 0 ? QString() : count);
    m_all->setAccessibleName(isOpen() ? tr("Close the list of steps")
                                      : tr("All steps, %1").arg(count));
    m_all->setVisible(m_list->count() > 0);
    fitTitle();
}

/// Large texts may leave no room for a word of the name beside the button: then that stands below.
void StepsList::fitTitle()
{
    const QFontMetrics metrics = m_heading->fontMetrics();
    int widest = titleMargins.left() + titleMargins.right();
    for (const QString &word : m_heading->text().split(QLatin1Char(' ')))
        widest = std::max(widest, metrics.horizontalAdvance(word) + titleMargins.left()
                                      + titleMargins.right());
    const int beside = m_all->sizeHint().width() + m_titleRow->spacing() + titleEnd;
    m_titleRow->setDirection(widest + beside > width() ? QBoxLayout::TopToBottom
                                                       : QBoxLayout::LeftToRight);
}

void StepsList::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitTitle();
}

void StepsList::retranslate()
{
    m_list->setAccessibleName(tr("Steps"));
    m_search->setPlaceholderText(tr("Search the steps"));
    m_search->setAccessibleName(m_search->placeholderText());
    const auto count = static_cast<int>(m_errors.size());
    m_notice->setVisible(count > 0);
    m_notice->setText(count == 1 ? tr("1 file of this lab could not be read")
                                 : tr("%1 files of this lab could not be read").arg(count));
    QStringList lines;
    for (const Error &error : m_errors)
        lines.append(error.toString());
    m_findings->setText(lines.join(QLatin1Char('\n')));
    showProgress();
}

void StepsList::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        fitTitle();
}

} // namespace cradle
