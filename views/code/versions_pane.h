// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/versions_list.h"

#include <QWidget>

#include <vector>

QT_BEGIN_NAMESPACE
class QBoxLayout;
class QLabel;
class QPushButton;
class QSplitter;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;

/// The versions of the open step's program: when, what was found, what changed; the program of the
/// chosen one beside the present one, with the lines that differ marked.
class VersionsPane final : public QWidget
{
    Q_OBJECT
public:
    explicit VersionsPane(QWidget *parent = nullptr);

    /// \param versions   the newest first
    /// \param present    the program as it is now
    /// \param mayChange  whether that can be replaced
    void setVersions(const std::vector<ShownVersion> &versions, const QString &present,
                     bool mayChange);
    /// The same with the versions that there are.
    void setPresent(const QString &present, bool mayChange);
    /// The version that is chosen; nullptr if there is none.
    [[nodiscard]] const ShownVersion *chosen() const;
    [[nodiscard]] QSize sizeHint() const override { return {700, 264}; }

signals:
    void goBackRequested(const QString &text); ///< to this program

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void showChosen();
    void showButtons();
    void retranslate();
    [[nodiscard]] const ShownVersion *newestPassed() const;

    QSplitter *m_parts;
    QBoxLayout *m_choice = nullptr; ///< the list and the buttons
    VersionsList *m_list;
    QLabel *m_empty;
    QLabel *m_thenTitle;
    QLabel *m_nowTitle;
    CodeEditor *m_then;
    CodeEditor *m_now;
    QPushButton *m_goBack;
    QPushButton *m_toPassed;
    std::vector<ShownVersion> m_versions;
    QString m_present;
    bool m_mayChange = false;
};

} // namespace cradle
