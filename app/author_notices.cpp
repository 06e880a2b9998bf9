// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_notices.h"

#include "app/notice_bar.h"
#include "views/author/author_document.h"

#include <QLocale>

namespace cradle {

AuthorNotices::AuthorNotices(AuthorDocument &document, NoticeBar &notice)
    : m_document(document)
    , m_notice(notice)
{
    connect(&document, &AuthorDocument::opened, this, &AuthorNotices::showWelcome);
    connect(&document, &AuthorDocument::refused, this, &AuthorNotices::report);
    connect(&document, &AuthorDocument::draftTaken, this, &AuthorNotices::showDraft);
    connect(&document, &AuthorDocument::changedOutside, this, &AuthorNotices::offerReload);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (!m_undoableAt || index >= *m_undoableAt)
            return;
        m_undoableAt.reset();
        m_notice.clearNotice();
    });
}

void AuthorNotices::say(const QString &text)
{
    m_saysVisit = false;
    m_notice.showNotice(text);
}

void AuthorNotices::sayUndoable(const QString &text)
{
    say(text);
    m_undoableAt = m_document.undoStack().index();
}

void AuthorNotices::sayVisit(const QString &finding)
{
    say(tr("A scene of the proof, at the moment where it went wrong: %1").arg(finding));
    m_saysVisit = true;
}

void AuthorNotices::endVisit()
{
    if (m_saysVisit)
        clear();
}

void AuthorNotices::clear()
{
    m_saysVisit = false;
    m_notice.clearNotice();
}

void AuthorNotices::showWelcome()
{
    clear();
    if (m_document.isReadOnly())
        sayOfLab(tr("This lab ships with Cradle and stays as it is. Look around, or make a copy of "
                    "it and change that."));
}

void AuthorNotices::report(const Error &error)
{
    sayOfLab(error.toString());
}

/// With the offer of a copy, where the lab stays as it is.
void AuthorNotices::sayOfLab(const QString &text)
{
    std::vector<NoticeBar::Offer> offers;
    if (m_document.isReadOnly())
        offers.push_back({tr("Copy to a folder…"), [this] { emit copyRequested(); }});
    m_saysVisit = false;
    m_notice.showNotice(text, offers);
}

void AuthorNotices::offerReload(const QString &names)
{
    m_saysVisit = false;
    m_notice.showNotice(tr("Changed by another program: %1").arg(names),
                        {{tr("Reload"), [this] { emit reloadRequested(); }}});
}

/// A window was killed, and this is what it had not saved.
void AuthorNotices::showDraft(const QDateTime &when)
{
    std::vector<NoticeBar::Offer> offers;
    if (m_document.undoStack().canUndo())
        offers.push_back({tr("Discard them"), [this] { m_document.undoStack().undo(); }});
    m_notice.warn(tr("Cradle ended without saving this lab. Your changes of %1 are back; they are "
                     "not saved yet.")
                      .arg(QLocale().toString(when.toLocalTime(), QLocale::ShortFormat)),
                  offers);
}

void AuthorNotices::offerUnsavedLab()
{
    m_notice.warn(tr("Cradle ended before a new lab was saved for the first time."),
                  {{tr("Open it"), [this] { emit unsavedLabRequested(); }}});
}

} // namespace cradle
