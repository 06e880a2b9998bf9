// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_windows.h"

#include "app/language.h"
#include "app/notice_bar.h"
#include "app/workbench.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace cradle {

AuthorWindows::AuthorWindows(Workbench &workbench, NoticeBar &notice, QSettings &settings,
                             QWidget &window)
    : m_workbench(workbench)
    , m_notice(notice)
    , m_settings(settings)
    , m_window(window)
{
}

AuthorWindows::~AuthorWindows()
{
    for (const QPointer<AuthorWindow> &author : std::as_const(m_authors))
        delete author; // its changes were asked about when the student's window was closed
}

AuthorWindow *AuthorWindows::newest() const
{
    const auto last = std::find_if(m_authors.rbegin(), m_authors.rend(),
                                   [](const auto &author) { return !author.isNull(); });
    return last == m_authors.rend() ? nullptr : last->data();
}

void AuthorWindows::authorLab()
{
    const QString folder = m_workbench.lab().folder;
    for (const QPointer<AuthorWindow> &author : std::as_const(m_authors)) {
        if (!author || QFileInfo(author->document().folder()) != QFileInfo(folder))
            continue;
        author->raise();
        author->activateWindow();
        return;
    }
    if (const auto error = open(folder))
        m_notice.showNotice(error->toString());
    else
        newest()->show();
}

std::optional<Error> AuthorWindows::open(const QString &folder)
{
    auto author = std::make_unique<AuthorWindow>(m_settings);
    author->document().setLanguage(currentLanguage()); // the lab's own, if it has no such texts
    if (auto error = author->files().open(folder))
        return error;
    author->setAttribute(Qt::WA_DeleteOnClose);
    connect(author.get(), &AuthorWindow::studentRequested, this,
            [this](const QString &lab, const QString &task) {
                if (const auto error = m_workbench.openLab(lab, currentLanguage()))
                    m_notice.showNotice(error->toString());
                else
                    m_workbench.openTask(task);
                m_window.show();
                m_window.raise();
                m_window.activateWindow();
            });
    m_authors.removeIf([](const auto &window) { return !window; });
    m_authors.append(author.release());
    return std::nullopt;
}

bool AuthorWindows::closeAll()
{
    return std::all_of(m_authors.cbegin(), m_authors.cend(),
                       [](const auto &author) { return !author || author->close(); });
}

} // namespace cradle
