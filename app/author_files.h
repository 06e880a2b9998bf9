// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QObject>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class AuthorDocument;
class AuthorNotices;
struct AuthorPanes;

/// Opens and saves the lab that is written, and asks what there is to ask before.
class AuthorFiles final : public QObject
{
    Q_OBJECT
public:
    /// All outlive this. \param window  dialogs lie over it
    AuthorFiles(AuthorDocument &document, const AuthorPanes &panes, AuthorNotices &notices,
                QWidget &window);

    /// Opens a lab's folder, or the lab that ships with the program, which stays as it is.
    std::optional<Error> open(const QString &folder);
    /// Asks whether changes are to be saved. \return whether all may go
    bool mayDiscard();

public slots:
    void newLab();
    void openFolder();
    void openFile(); ///< NAME.cradle
    void openDropped(const QString &path);
    bool save();   ///< \return whether all is saved
    bool saveAs(); ///< also makes the copy of a lab that is read-only
    void reload(); ///< takes the folder's files

private:
    void openPath(const QString &path);
    bool saveInto(bool overwrite);
    bool settleWithTheirs(const Error &error);
    void tellRefused();
    bool mayDropRefused();

    AuthorDocument &m_document;
    const AuthorPanes &m_panes;
    AuthorNotices &m_notices;
    QWidget &m_window;
};

} // namespace cradle
