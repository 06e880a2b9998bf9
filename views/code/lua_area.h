// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qsci/qsciscintilla.h>

#include <functional>

namespace cradle {

class LuaLexer;

/// The text field of the code editor: its look, its keys, and indentation as Lua has it.
/// Positions are in bytes of UTF-8.
class LuaArea final : public QsciScintilla
{
    Q_OBJECT
public:
    enum Mark {
        SuspectLine,
        ExecutingLine,
        ErrorLine,
        ChangedLine,
        SuspectMark,
        ExecutingMark,
        ErrorMark,
        ChangedMark
    };
    static constexpr int matchIndicator = 8;
    static constexpr int messageStyle = 50;
    static constexpr int smallestZoom = -5;
    static constexpr int largestZoom = 20;

    explicit LuaArea(QWidget *parent);

    /// Shows another document, as one of Lua.
    void showDocument(const QsciDocument &document);
    /// Colours and font of the theme in force.
    void applyLook();
    /// Width for the numbers of all lines at this zoom.
    void fitMargins();

    long send(unsigned int message, unsigned long word = 0, long value = 0) const
    {
        return SendScintilla(message, word, value);
    }
    [[nodiscard]] long cursor() const { return send(SCI_GETCURRENTPOS); }
    [[nodiscard]] QByteArray bytes() const { return text().toUtf8(); }
    [[nodiscard]] QByteArray bytesBefore() const { return bytes().left(cursor()); }
    /// The place of the character at \p position in the viewport, and the height of its line.
    [[nodiscard]] QRect placeOf(long position) const;
    void replaceBytes(long start, long end, const QByteArray &by);
    /// The width of all margins, px.
    [[nodiscard]] int textLeft() const;
    void setTextSize(int zoom);

public slots:
    void paste() override;

signals:
    void helpRequested();
    void escapePressed();
    void contextMenuRequested(QPoint at); ///< in global coordinates

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void inputMethodEvent(QInputMethodEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override;
    void dropEvent(QDropEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    [[nodiscard]] QMimeData *toMimeData(const QByteArray &text, bool rectangular) const override;

private:
    void setUpDocument();
    void setUpMargins();
    void setUpKeys();
    [[nodiscard]] bool isOwnKey(const QKeyEvent &event) const;
    bool handleOwnKey(const QKeyEvent &event);
    void breakLine();
    void reindent(int character);
    void noteWriting(int position, int kind, const char *text, int length);
    void markRuns();
    void takeIn(const QMimeData *source, const std::function<void()> &write);
    [[nodiscard]] bool beginsRun(const QString &written) const;
    void toggleComment();

    LuaLexer *m_lexer;
    bool m_leaving = false;    ///< after Escape: Tab leaves
    bool m_marksLater = false; ///< words from the right have been typed
};

} // namespace cradle
