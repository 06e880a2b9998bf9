// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <limits>

namespace cradle {

/// A line in which a number with a unit is typed or spun with Up and Down (Page Up and Page
/// Down: ten steps). It proposes numbers; its owner answers with setValue() or setRefused().
class NumberField final : public QLineEdit
{
    Q_OBJECT
public:
    enum class Spin {
        Add,   ///< Up adds a step
        Double ///< Up doubles, Down halves; the number is written as 1/60 where it is that
    };

    explicit NumberField(const QString &unit, double step, QWidget *parent = nullptr);

    void setSpin(Spin spin) { m_spin = spin; }
    /// Spinning stops at these; what is typed may lie beyond.
    void setSpinRange(double lowest, double highest);

    [[nodiscard]] double value() const { return m_value; }
    [[nodiscard]] bool isRefused() const { return m_refused; }
    /// Whether a number is proposed at this moment and neither taken nor refused yet.
    [[nodiscard]] bool isProposing() const { return m_proposing; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

public slots:
    void setValue(double value);   ///< shows \p value instead of what was typed
    void setRefused(bool refused); ///< marks what was typed as impossible
    void revert();                 ///< back to the value
    /// Proposes what was typed, if it is new. \return whether nothing impossible is left
    bool propose();

signals:
    void valueProposed(double value, bool spinning);
    void notANumber(const QString &text);
    void reverted();

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void spin(int steps);
    void offer(double value, bool spinning);
    void measure();
    [[nodiscard]] QString textOf(double value) const;

    QString m_unit;
    double m_step;
    Spin m_spin = Spin::Add;
    double m_lowest = -std::numeric_limits<double>::infinity();
    double m_highest = std::numeric_limits<double>::infinity();
    double m_value = 0.0;
    bool m_refused = false;
    bool m_proposing = false;
};

} // namespace cradle
