// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

QT_BEGIN_NAMESPACE
class QKeyEvent;
QT_END_NAMESPACE

namespace cradle {

class CallTip;
class CompletionPopup;
class LuaArea;

/// Completes words while they are typed and says what a function takes, over a LuaArea.
class CodeAssistant final : public QObject
{
    Q_OBJECT
public:
    explicit CodeAssistant(LuaArea *area);
    ~CodeAssistant() override;

    /// Shows what may stand at the cursor, or writes it if it is but one word.
    void complete();
    void hide();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void handleCharacter(int character);
    void follow();
    void offer(bool asked);
    void showCall();
    void accept();
    bool handleKey(const QKeyEvent &event);
    bool handlePopupKey(const QKeyEvent &event);
    [[nodiscard]] QRect placeInWindow(long position) const;
    [[nodiscard]] bool isOpen() const;

    LuaArea *m_area;
    // Children of the window, so that they may reach beyond the editor.
    QPointer<CompletionPopup> m_popup;
    QPointer<CallTip> m_tip;
    long m_wordStart = 0; ///< byte where the word begins that is completed
    QString m_begun;      ///< what is typed of it
    bool m_accepting = false;
    bool m_typed = false; ///< the cursor moves because of a character
};

} // namespace cradle
