// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

QT_BEGIN_NAMESPACE
class QFrame;
class QLabel;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

/// Goes through the parts of a window: darkens all but one, and says beside it what it is for.
/// Return goes on, Esc ends it. It deletes itself at the end.
class Tour final : public QWidget
{
    Q_OBJECT
public:
    struct Stop {
        QPointer<QWidget> part; ///< of the window, seen now
        QString title{};
        QString text{};
    };

    /// \param window  its parent, which it covers
    Tour(QWidget *window, std::vector<Stop> stops);

    [[nodiscard]] std::size_t at() const { return m_at; }
    [[nodiscard]] QRect partRect() const; ///< of this stop, in the window, px

public slots:
    void next();
    void end();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void showStop();
    void placeCard();

    std::vector<Stop> m_stops;
    std::size_t m_at = 0;
    QFrame *m_card;
    QLabel *m_title;
    QLabel *m_text;
    QPushButton *m_next;
    QPushButton *m_skip;
};

} // namespace cradle
