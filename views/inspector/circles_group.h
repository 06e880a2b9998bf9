// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

#include <QWidget>

class QKeyEvent;
class QLabel;
class QPushButton;
class QSpacerItem;
class QTableView;

namespace cradle {

class CircleDelegate;
class CircleHeader;
class CircleTableModel;

/// The circles of the preset: a table, and buttons that add, duplicate and remove rows or bring
/// the step's own scene back.
class CirclesGroup final : public QWidget
{
    Q_OBJECT
public:
    explicit CirclesGroup(PresetDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] int selected() const; ///< index of a circle; −1 if none is selected
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Where the scene edited is the step's own, there is none to go back to.
    void hideReset();
    void setFault(const QString &pointer); ///< marks the cell of a JSON pointer

public slots:
    void select(int circle); ///< −1 selects none

signals:
    void selectionChanged(int circle);
    void notANumber(const QString &text);
    void reverted();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    static constexpr int rowHeight = 26; ///< px

    void makeTable();
    void makeButtons();
    void retranslate();
    void nameButtons();
    void fitHeight();
    void reload();
    void enableButtons();
    void layOutColumns();
    [[nodiscard]] int columnWidth(int column) const;
    [[nodiscard]] int nameWidth() const;
    [[nodiscard]] int othersWidth() const;
    void selectLast();
    void addCircle();
    void duplicate();
    void remove();
    bool handleKey(QKeyEvent *event);

    PresetDocument &m_document;
    QSpacerItem *m_strut = nullptr; ///< as high as the buttons
    QLabel *m_heading = nullptr;
    CircleTableModel *m_model = nullptr;
    CircleDelegate *m_delegate = nullptr;
    CircleHeader *m_header = nullptr;
    QTableView *m_table = nullptr;
    QPushButton *m_add = nullptr;
    QPushButton *m_duplicate = nullptr;
    QPushButton *m_remove = nullptr;
    QPushButton *m_reset = nullptr;
    int m_announced = -1; ///< the selection last signalled
};

} // namespace cradle
