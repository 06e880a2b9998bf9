// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QDateTime>
#include <QObject>

#include <optional>

namespace cradle {

class AuthorDocument;
class NoticeBar;

/// Says what there is to know about the lab that is written, with what can be done about it.
class AuthorNotices final : public QObject
{
    Q_OBJECT
public:
    /// Both outlive this.
    AuthorNotices(AuthorDocument &document, NoticeBar &notice);

    void say(const QString &text);
    /// The same of what Undo brings back, which holds until something is undone.
    void sayUndoable(const QString &text);
    /// That the scene shows a run of the proof, for \p finding.
    void sayVisit(const QString &finding);
    void endVisit(); ///< takes that away, if it is what is said
    void clear();
    void report(const Error &error);
    void offerReload(const QString &names); ///< of files that another program changed
    void offerUnsavedLab();

signals:
    void copyRequested();   ///< of a lab that is read-only
    void reloadRequested(); ///< of the folder's files
    void unsavedLabRequested();

private:
    void showWelcome();
    void sayOfLab(const QString &text);
    void showDraft(const QDateTime &when);

    AuthorDocument &m_document;
    NoticeBar &m_notice;
    std::optional<int> m_undoableAt; ///< index of the undo stack when that was said
    bool m_saysVisit = false;
};

} // namespace cradle
