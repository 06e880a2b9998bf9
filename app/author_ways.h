// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QObject>

namespace cradle {

class AuthorDocument;
class AuthorNotices;
struct AuthorPanes;

/// The ways from what was found to the place that it is about: the step, the tab, and there the
/// program or field.
class AuthorWays final : public QObject
{
    Q_OBJECT
public:
    /// All outlive this.
    AuthorWays(AuthorDocument &document, AuthorPanes &panes, AuthorNotices &notices);

    void openValues(); ///< of the lab and the open step
    void goTo(const Error &finding);

signals:
    void propertiesRequested(); ///< of the lab, which have no tab

private:
    void goToLab(const Error &finding);
    void goToPart(const Error &finding);
    void goToText(const Error &finding);
    void openScene(bool ofSolution);
    void openProgram(const QString &path, int line);
    void showVisit();

    AuthorDocument &m_document;
    AuthorPanes &m_panes;
    AuthorNotices &m_notices;
    QString m_visited; ///< the finding whose run the scene shows
};

} // namespace cradle
