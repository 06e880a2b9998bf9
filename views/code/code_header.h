// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHBoxLayout>
#include <QStringList>
#include <QWidget>

#include <vector>

QT_BEGIN_NAMESPACE
class QLabel;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

class ActionButton;
class CodeActions;

/// The row over the editor: name of the program, buttons, and what has become of the text. With
/// large texts there are two.
class CodeHeader final : public QWidget
{
    Q_OBJECT
public:
    /// \param actions  outlive this one
    explicit CodeHeader(CodeActions &actions, QWidget *parent = nullptr);

    void setTitle(const QString &title);
    /// All texts that setState() may be given, for which there shall be room; the usual one first.
    void setStates(const QStringList &texts);
    /// \param warns  whether the text needs the student's attention
    void setState(const QString &text, bool warns);
    [[nodiscard]] QPushButton &atOnce() { return *m_atOnce; }
    [[nodiscard]] const QPushButton &atOnce() const { return *m_atOnce; }
    void retranslate();
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void arrange();
    void putInRows(bool two);
    [[nodiscard]] bool isInTwoRows() const { return m_lower->count() > 0; }
    void spread(int room);
    void measureAnew();

    QLabel *m_title;
    QPushButton *m_atOnce;
    QLabel *m_state;
    QPushButton *m_more;
    QHBoxLayout *m_row;   ///< the one, or the upper of two
    QHBoxLayout *m_lower; ///< of two: whether the program runs as it is typed, and its state
    std::vector<ActionButton *> m_buttons; ///< those that lose their text first, first
    QString m_stateText;
    QStringList m_states;
    bool m_arranging = false;
};

} // namespace cradle
