// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/author_window.h"
#include "model/world/result.h"

#include <QList>
#include <QObject>
#include <QPointer>

namespace cradle {

class NoticeBar;
class Workbench;

/// The windows in which labs are written, one for each lab.
class AuthorWindows final : public QObject
{
    Q_OBJECT
public:
    /// \param window  the student's, which a lab can be tried in
    AuthorWindows(Workbench &workbench, NoticeBar &notice, QSettings &settings, QWidget &window);
    ~AuthorWindows() override;

    /// That which was opened last, if one is open.
    [[nodiscard]] AuthorWindow *newest() const;
    /// Opens one with the lab in \p folder. \return what is wrong with it
    std::optional<Error> open(const QString &folder);
    /// Closes all, unless somebody wants to go on with one. \return whether all are closed
    [[nodiscard]] bool closeAll();

public slots:
    void authorLab(); ///< shows that of the open lab

private:
    Workbench &m_workbench;
    NoticeBar &m_notice;
    QSettings &m_settings;
    QWidget &m_window;
    QList<QPointer<AuthorWindow>> m_authors; ///< the last that was opened last
};

} // namespace cradle
