// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "open_window.h"

namespace cradle::windows {

/// A test of the whole window, which may be closed and opened again on the same folder.
class WindowTest : public QObject
{
protected:
    void takeNewFolder()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        reopen();
    }
    void reopen()
    {
        if (m_open)
            m_open->window.close();
        m_open.reset();
        m_open = std::make_unique<OpenWindow>(*m_folder);
    }

    [[nodiscard]] QDockWidget *pane(const char *name) const
    {
        return m_open->window.findChild<QDockWidget *>(QLatin1String(name));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

} // namespace cradle::windows
