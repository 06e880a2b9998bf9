// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <git2.h>

#include <QString>

namespace cradle {

/// Answers what a remote asks with what the user's own machine knows: the SSH agent, and the
/// credential helper of git where git is installed. Cradle itself keeps no password.
class CredentialAsker
{
public:
    /// \param refusal  what the other side says to a reference that it does not take
    explicit CredentialAsker(QString &refusal)
        : m_refusal(refusal)
    {
    }

    /// The callback of libgit2; \p payload is a CredentialAsker. Each way is tried once.
    static int ask(git_credential **out, const char *url, const char *user, unsigned allowed,
                   void *payload);

    [[nodiscard]] QString &refusal() { return m_refusal; }

private:
    int askAgent(git_credential **out, const char *user);
    int askHelper(git_credential **out, const char *url);

    QString &m_refusal;
    bool m_agentAsked = false;
    bool m_helperAsked = false;
};

} // namespace cradle
