// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab.h"

#include <QWidget>

#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace cradle {

/// The steps of a lab with what was reached: a tick for passed, a dot for the one that is open, a
/// ring for the rest. Above them, how far the student is, and files that could not be read.
class StepsList final : public QWidget
{
    Q_OBJECT
public:
    explicit StepsList(QWidget *parent = nullptr);

    void setLab(const Lab &lab);
    void setProgress(const std::vector<bool> &passed, int current);

    [[nodiscard]] int heightOf(int rows) const; ///< px, with so many steps in sight
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void stepChosen(int step); ///< another step than the current one

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeLayout();
    void retranslate();
    void showProgress();
    void choose(int step);

    QLabel *m_heading = nullptr;
    QPushButton *m_notice = nullptr;
    QLabel *m_findings = nullptr;
    QListWidget *m_list = nullptr;
    QStringList m_titles;
    std::vector<bool> m_extra;
    std::vector<bool> m_passed;
    std::vector<Error> m_errors;
    int m_current = -1;
};

} // namespace cradle
