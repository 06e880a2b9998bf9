// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace cradle {

class StepDots;

/// The steps of a lab with what was reached: the open one by name above a row of dots, which opens
/// into the list of all, with a field to search it. A tick is for passed, a dot for the one that is
/// open, a ring for the rest. Above the list, files that could not be read.
class StepsList final : public QWidget
{
    Q_OBJECT
public:
    explicit StepsList(QWidget *parent = nullptr);

    void setLab(const Lab &lab);
    void setProgress(const std::vector<bool> &passed, int current);

    void setOpen(bool open); ///< shows the list
    [[nodiscard]] bool isOpen() const;

signals:
    void stepChosen(int step); ///< another step than the current one
    void openChanged(bool open);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeLayout();
    void retranslate();
    void fitTitle();
    void showProgress();
    void choose(int step);
    void search(const QString &text);

    QLabel *m_heading = nullptr;
    QPushButton *m_notice = nullptr;
    QLabel *m_findings = nullptr;
    StepDots *m_dots = nullptr;
    QHBoxLayout *m_titleRow = nullptr;
    QPushButton *m_all = nullptr;
    QLineEdit *m_search = nullptr;
    QListWidget *m_list = nullptr;
    QStringList m_titles;
    std::vector<bool> m_extra;
    std::vector<bool> m_passed;
    std::vector<Error> m_errors;
    int m_current = -1;
};

} // namespace cradle
