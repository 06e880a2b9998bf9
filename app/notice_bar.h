// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace cradle {

/// One quiet line above the scene: what to do first, that this is not one's own scene, or what
/// went wrong. Hidden when there is nothing to say.
class NoticeBar final : public QFrame
{
    Q_OBJECT
public:
    explicit NoticeBar(QWidget *parent = nullptr);

    /// Shows \p text; with \p action a button of that name, which emits actionTriggered().
    void showNotice(const QString &text, const QString &action = {});
    [[nodiscard]] QString text() const;

signals:
    void actionTriggered();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QLabel *m_label;
    QPushButton *m_action;
    QPushButton *m_close;
};

} // namespace cradle
