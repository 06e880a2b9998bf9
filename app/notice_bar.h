// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QStringList>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace cradle {

/// One quiet line above the scene: what to do first, that this is not one's own scene, or what
/// went wrong. Hidden when there is nothing to say.
///
/// A notice gives way to the next. A warning stays until it was read, and covers notices.
class NoticeBar final : public QFrame
{
    Q_OBJECT
public:
    /// What a button of the line does.
    struct Offer {
        QString name{};
        std::function<void()> act{};
    };

    explicit NoticeBar(QWidget *parent = nullptr);

    /// Shows \p text, and a button for every offer.
    void showNotice(const QString &text, const std::vector<Offer> &offers = {});
    /// Takes the notice away; warnings stay.
    void clearNotice();
    /// Shows \p text before all notices until "Got it" or an offer is pressed. Several wait for
    /// each other; one that waits already is not said twice.
    void warn(const QString &text, const std::vector<Offer> &offers = {});
    /// Takes a warning away that is true no more.
    void retract(const QString &text);
    [[nodiscard]] QString text() const; ///< that is seen
    /// Of the notice, which a warning may cover; empty: none.
    [[nodiscard]] QString notice() const { return m_notice.text; }

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Notice {
        QString text{};
        std::vector<Offer> offers{};
    };

    void retranslate();
    void showFirst();
    void closeFirst();
    void addButton(const Offer &offer);

    std::vector<Notice> m_warnings; ///< the one that is shown first
    Notice m_notice;                ///< empty text: none
    QLabel *m_label;
    QPushButton *m_close;
    std::vector<QPushButton *> m_buttons; ///< of the offers
};

} // namespace cradle
